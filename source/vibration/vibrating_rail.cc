#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/vibration/vibrating_body.h>

namespace RollingContact
{
  namespace
  {
    /// of receptances, that modes may be off without a warning
    const double largest_misfit = 0.2;
  } // namespace

  template <int dim>
  void VibratingBody<dim>::find_waves(const ModesParameters &wanted,
                                      const double           cut_off,
                                      RunContext            &context)
  {
    WaveRange range;
    range.highest = cut_off / wanted.cut_off_ratio;
    range.cut_off = cut_off;
    waves =
      std::make_unique<RailWaves>(parameters, range, throw_if_interrupted);
    const WaveguideSize &size = waves->waveguide().size();
    modes.cut_off             = cut_off;
    context.log.message(
      parameters.section + ": a rail without ends by waves in its section, " +
      std::to_string(size.n_along) + " fields along it and " +
      std::to_string(size.n_across) + " across of " +
      std::to_string(size.n_unknowns) + " unknowns; at rest by its mesh of " +
      std::to_string(body->n_unknowns()) + ".");
  }

  template <int dim>
  void VibratingBody<dim>::take_modes_of_waves(RunContext &context)
  {
    PhaseTimer::Scope phase(context.timer, Phase::modes);
    waves->find_modes(throw_if_interrupted);
    const FittedModes &fit = waves->modes();
    modes.frequencies      = fit.frequencies;
    modes.residuals.assign(modes.size(), 0.);
    characters.resize(modes.size());
    context.log.message(
      parameters.section + ": " + std::to_string(modes.size()) +
      " modes stand for its waves, fitted to receptances at " +
      std::to_string(waves->n_sampled()) + " frequencies; they are off by " +
      significant(100 * fit.error, 2) + " % at most, at " +
      significant(fit.error_at, 4) + " Hz.");
    if (fit.error > largest_misfit)
      context.log.warning(
        parameters.section +
        "/Model = waveguide: modes that stand for waves "
        "are off by " +
        significant(100 * fit.error, 2) + " % at " +
        significant(fit.error_at, 4) +
        " Hz, where a wave sets in that hardly anything damps. Growth is "
        "corrected (Stability/Full model), motion in time is not; give the "
        "rail a Loss factor or Rayleigh stiffness, or a lower Modes/Maximum "
        "frequency.");
    context.report.errors.push_back(
      {"receptance of the rail by modes",
       fit.error,
       "that at the frequency",
       "its waves, at " + significant(fit.error_at, 4) + " Hz",
       false,
       "growth is corrected by the waves themselves"});
    context.report.errors.push_back(
      {"waves of the rail",
       waves->lower_degree_error(throw_if_interrupted),
       "the receptance at that frequency",
       "a coarser section",
       false,
       ""});
  }

  template <int dim>
  const DenseMatrix &VibratingBody<dim>::mode_shapes() const
  {
    if (!waves)
      return modes.shapes;
    std::call_once(has_shapes, [&]() {
      shapes_of_waves = at_unknowns(waves->shapes(points()));
    });
    return shapes_of_waves;
  }

  template <int dim>
  template <class Matrix>
  Matrix VibratingBody<dim>::at_unknowns(const Matrix &moved) const
  {
    Matrix result = Matrix::Zero(body->n_unknowns(), moved.cols());
    for (std::size_t p = 0; p < places.nodes.size(); ++p)
      for (unsigned int c = 0; c < 3; ++c)
        if (const int unknown = places.nodes[p].unknowns[c]; unknown >= 0)
          result.row(unknown) = moved.row(3 * p + c);
    return result;
  }

  template <int dim>
  std::vector<RailWaves::Place> VibratingBody<dim>::points() const
  {
    std::vector<RailWaves::Place> result;
    for (const BodyPlaces::Node &node : places.nodes)
      result.push_back(node.point);
    return result;
  }

  template void VibratingBody<2>::find_waves(const ModesParameters &,
                                             const double,
                                             RunContext &);
  template void VibratingBody<2>::take_modes_of_waves(RunContext &);
  template const DenseMatrix            &VibratingBody<2>::mode_shapes() const;
  template std::vector<RailWaves::Place> VibratingBody<2>::points() const;
  template ComplexMatrix
                VibratingBody<2>::at_unknowns(const ComplexMatrix &) const;
  template void VibratingBody<3>::find_waves(const ModesParameters &,
                                             const double,
                                             RunContext &);
  template void VibratingBody<3>::take_modes_of_waves(RunContext &);
  template const DenseMatrix            &VibratingBody<3>::mode_shapes() const;
  template std::vector<RailWaves::Place> VibratingBody<3>::points() const;
  template ComplexMatrix
  VibratingBody<3>::at_unknowns(const ComplexMatrix &) const;
} // namespace RollingContact
