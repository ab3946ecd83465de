#include <rolling_contact/analyses/stability_report.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// fastest decay that the picture shows, over the largest growth or decay
    /// of the vibrations that are listed
    const double shown_decay = 2.;

    /// relative difference of frequencies below which one name is enough
    const double near_by = 0.05;

    /// relative difference of eigenvalues that are the same one
    const double same = 1e-6;

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

  namespace
  {
    /** Whether another vibration of this name, near by and growing more, has it
     * in the picture. */
    bool stands_for_it(const std::vector<Finding>     &findings,
                       const std::vector<std::string> &names,
                       const std::size_t               k)
    {
      for (std::size_t j = 0; j < findings.size(); ++j)
        if (names[j] == names[k] &&
            findings[j].growth() > findings[k].growth() &&
            std::abs(
              findings[j].mode.frequency() / findings[k].mode.frequency() - 1) <
              near_by)
          return true;
      return false;
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

  void plot_growth(const ComplexValues            &eigenvalues,
                   const std::vector<Finding>     &findings,
                   const std::vector<std::string> &names,
                   const double                    lowest,
                   const double                    highest,
                   RunContext                     &context)
  {
    double largest = 0.;
    for (const Finding &finding : findings)
      largest = std::max(largest, std::abs(finding.growth()));
    const auto kilohertz = [](const std::complex<double> s) {
      return s.imag() / (2 * pi * 1000);
    };
    std::vector<double> f, growth;
    for (const auto &s : eigenvalues)
      if (1000 * kilohertz(s) >= lowest && 1000 * kilohertz(s) <= highest &&
          s.real() >= -shown_decay * largest)
        {
          const auto is_same = [&](const Finding &it) {
            return std::abs(it.mode.s - s) <= same * std::abs(s);
          };
          if (std::any_of(findings.begin(), findings.end(), is_same))
            continue;
          f.push_back(kilohertz(s));
          growth.push_back(s.real());
        }
    Figure figure("Vibrations about the steady rolling state",
                  "frequency (kHz)",
                  "growth (1/s)");
    figure.add_curve("",
                     {lowest / 1000, highest / 1000},
                     {0., 0.},
                     CurveStyle::reference);
    // the first colour decays, the second grows
    for (const bool grows : {false, true})
      {
        std::vector<double> all_f      = grows ? std::vector<double>() : f,
                            all_growth = grows ? std::vector<double>() : growth;
        for (const Finding &finding : findings)
          if (finding.unstable() == grows)
            {
              all_f.push_back(finding.mode.frequency() / 1000);
              all_growth.push_back(finding.growth());
            }
        figure.add_curve(grows ? "grow" : "decay",
                         all_f,
                         all_growth,
                         CurveStyle::points);
      }
    for (std::size_t k = 0; k < findings.size(); ++k)
      if (!names[k].empty() && !stands_for_it(findings, names, k))
        figure.add_curve(names[k],
                         {findings[k].mode.frequency() / 1000},
                         {findings[k].growth()},
                         CurveStyle::name_beside);
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
