#include <rolling_contact/analyses/stability_report.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// largest damping ratio that the picture shows (%)
    const double shown_damping = 1.;

    /** By how much the lateral force leads the normal one: the phase of their
     * sums over the patch. */
    double phase_of_forces(const LinearContact &contact,
                           const ComplexVector &unknowns)
    {
      const unsigned int  N = contact.n_nodes, T = contact.n_tangential;
      const ComplexVector forces = contact.forces * unknowns;
      return std::arg(forces.segment((T - 1) * N, N).sum() /
                      forces.segment(T * N, N).sum());
    }

    template <int dim>
    void set_nearest(const Side                 side,
                     const RollingModes<dim>   &rolling,
                     const std::vector<double> &shares,
                     ResultsTable              &table)
    {
      const ModalBodies<dim> &bodies  = rolling.bodies();
      const auto              nearest = rolling.nearest_mode(side, shares);
      const std::string       name    = name_of(side);
      if (!nearest)
        {
          for (const char *what :
               {"_mode", "_mode_Hz", "_mode_share", "_mode_name"})
            table.leave_empty(name + what);
          return;
        }
      const auto [mode, share] = *nearest;
      table.set(name + "_mode", mode + 1);
      table.set(name + "_mode_Hz", bodies.body(side)->modes.frequencies[mode]);
      table.set(name + "_mode_share", share);
      table.set(name + "_mode_name",
                bodies.body(side)->characters[mode].name());
    }
  } // namespace

  template <int dim>
  void add_row(const Finding           &finding,
               const LinearContact     &contact,
               const RollingModes<dim> &rolling,
               ResultsTable            &table)
  {
    const StabilityMode &mode = finding.mode;
    table.set("frequency_Hz", mode.frequency());
    table.set("growth_1/s", mode.growth());
    table.set("damping_ratio", mode.damping_ratio());
    if (finding.corrected)
      {
        const CorrectedMode &corrected = *finding.corrected;
        table.set("corrected_frequency_Hz",
                  std::abs(corrected.s.imag()) / (2 * pi));
        table.set("corrected_growth_1/s", corrected.growth());
        table.set("uncertainty_1/s", corrected.uncertainty);
        table.set("reduced_backward_error", corrected.first_backward_error);
        table.set("backward_error", corrected.backward_error);
        table.set("undecided", corrected.undecided());
        table.set("damping_needed", corrected.damping_needed);
      }
    else
      for (const char *column : {"corrected_frequency_Hz",
                                 "corrected_growth_1/s",
                                 "uncertainty_1/s",
                                 "reduced_backward_error",
                                 "backward_error",
                                 "undecided",
                                 "damping_needed"})
        table.leave_empty(column);
    table.set("unstable", finding.unstable());
    const std::vector<double> shares = mode.participation();
    for (const Side side : both_sides)
      set_nearest(side, rolling, shares, table);
    if (contact.n_tangential > 0)
      table.set("force_phase_rad", phase_of_forces(contact, mode.unknowns));
    table.end_row();
  }

  std::string verdict(const Situation            &scene,
                      const std::vector<Finding> &findings,
                      const std::string          &counted)
  {
    const Finding *fastest = nullptr;
    std::size_t    n       = 0;
    for (const Finding &finding : findings)
      if (finding.unstable())
        {
          ++n;
          if (fastest == nullptr || finding.growth() > fastest->growth())
            fastest = &finding;
        }
    if (fastest == nullptr)
      return "no vibration grows between " +
             significant(scene.inputs->stability.lowest_frequency, 4) +
             " and " + significant(scene.inputs->modes.maximum_frequency, 5) +
             " Hz" + counted;
    return std::to_string(n) + (n == 1 ? " mode grows" : " modes grow") +
           counted + "; the fastest at " +
           significant(fastest->mode.frequency(), 5) + " Hz by " +
           significant(fastest->growth(), 3) + " 1/s" +
           (fastest->corrected
              ? ", needs a damping ratio of " +
                  significant(fastest->corrected->damping_needed, 2) + " more"
              : "");
  }

  void plot_eigenvalues(const ComplexValues        &eigenvalues,
                        const std::vector<Finding> &findings,
                        const double                lowest,
                        const double                highest,
                        RunContext                 &context)
  {
    std::vector<double> f, zeta, unstable_f, unstable_zeta;
    for (const auto &s : eigenvalues)
      if (s.imag() / (2 * pi) >= lowest && s.imag() / (2 * pi) <= highest)
        {
          const double ratio = -100 * s.real() / std::abs(s);
          if (ratio > shown_damping)
            continue;
          f.push_back(s.imag() / (2 * pi * 1000));
          zeta.push_back(ratio);
        }
    for (const Finding &finding : findings)
      if (finding.unstable())
        {
          unstable_f.push_back(finding.mode.frequency() / 1000);
          unstable_zeta.push_back(100 * finding.mode.damping_ratio());
        }
    Figure figure("Vibrations about the steady rolling state",
                  "frequency (kHz)",
                  "damping ratio (%)");
    figure.add_curve("below 1 %", f, zeta, CurveStyle::points);
    if (!unstable_f.empty())
      figure.add_curve("unstable",
                       unstable_f,
                       unstable_zeta,
                       CurveStyle::points);
    figure.draw(context, "stability");
  }

  template void add_row(const Finding &,
                        const LinearContact &,
                        const RollingModes<2> &,
                        ResultsTable &);
  template void add_row(const Finding &,
                        const LinearContact &,
                        const RollingModes<3> &,
                        ResultsTable &);
} // namespace RollingContact
