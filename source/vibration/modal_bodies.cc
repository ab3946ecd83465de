#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/modal_damping.h>
#include <rolling_contact/modes/rotation.h>
#include <rolling_contact/stability/reduced_pair.h>
#include <rolling_contact/vibration/modal_bodies.h>

namespace RollingContact
{
  RollingConditions::RollingConditions(const PairSpec            &scene,
                                       const StabilityParameters &stability)
    : speed(stability.rotation ? scene.contact.speed.value_or(0.) : 0.)
    , added_damping(stability.added_damping)
    , absorbers(scene.wheel.absorbers())
  {}

  template <int dim>
  ModalBodies<dim>::ModalBodies(const PairSpec         &scene,
                                const ModesParameters  &wanted,
                                const BodyPair<dim>    &rolling,
                                const double            cut_off,
                                RunContext             &context,
                                const ModalBodies<dim> *earlier)
  {
    for (const Side side : both_sides)
      {
        if (!rolling.is_elastic(side))
          continue;
        owners[side] = rolling.shared_body(side);
        if (earlier && earlier->owners[side] == owners[side])
          {
            bodies[side]  = earlier->bodies[side];
            parts[side]   = earlier->parts[side];
            hanging[side] = earlier->hanging[side];
            axles[side]   = earlier->axles[side];
          }
        else
          find(scene, side, wanted, cut_off, context);
      }
  }

  template <int dim>
  void ModalBodies<dim>::find(const PairSpec        &scene,
                              const Side             side,
                              const ModesParameters &wanted,
                              const double           cut_off,
                              RunContext            &context)
  {
    const DirectBody<dim> *direct =
      owners[side] ? owners[side]->with_factor() : nullptr;
    if (direct == nullptr)
      throw InputError("Body solver: modes need the factor of the bodies; "
                       "take direct, on one rank.");
    const auto found = std::make_shared<VibratingBody<dim>>(
      scene, side, wanted, *direct, cut_off, context);
    PhaseTimer::Scope         phase(context.timer, Phase::modes);
    const VibratingBody<dim> &body  = *found;
    const DenseMatrix        &modes = body.modes.shapes;
    Part                      part;
    part.viscous    = in_modes(body.modes, body.C);
    part.H_m        = in_modes(body.modes, body.H);
    part.C_m        = modal_damping_matrix(body.modes, part.H_m, part.viscous);
    hanging[side]   = body.absorbers(wanted.maximum_frequency, context);
    const auto axle = body.parameters.body_shape()->axle();
    if (body.parameters.axle_mass)
      axles[side] =
        std::make_shared<AxleMotion>(*direct,
                                     body.places,
                                     *body.parameters.axle_mass,
                                     axle ? axle->direction
                                          : std::array<double, 3>{{0., 1., 0.}},
                                     modes);
    if constexpr (dim == 3)
      if (side == Side::wheel && axle)
        {
          part.S   = direct->rotation(*axle);
          part.S_m = modal_rotation(part.S, modes);
        }
    bodies[side] = found;
    parts[side]  = std::make_shared<const Part>(std::move(part));
  }

  template <int dim>
  RollingConditions ModalBodies<dim>::standing() const
  {
    RollingConditions conditions;
    if (bodies.wheel)
      conditions.absorbers = bodies.wheel->parameters.absorbers();
    return conditions;
  }

  template <int dim>
  double ModalBodies<dim>::rate(const Side               side,
                                const RollingConditions &conditions) const
  {
    return parts[side] && parts[side]->S_m.size() > 0
             ? conditions.speed / bodies[side]->parameters.radius
             : 0.;
  }

  template <int dim>
  std::vector<double>
  ModalBodies<dim>::damping_ratios(const Side               side,
                                   const RollingConditions &conditions) const
  {
    std::vector<double> ratios = bodies[side]->given_damping();
    for (double &ratio : ratios)
      ratio += conditions.added_damping;
    return ratios;
  }

  template <int dim>
  std::pair<DenseMatrix, DenseMatrix>
  ModalBodies<dim>::modal_matrices(const Side               side,
                                   const RollingConditions &conditions) const
  {
    auto matrices = matrices_of_modes(side, conditions);
    if (hanging[side].n_coordinates() > 0)
      hang_absorbers(hanging[side],
                     conditions.absorbers,
                     rate(side, conditions),
                     matrices.first,
                     matrices.second);
    if (axle(side))
      for (DenseMatrix *matrix : {&matrices.first, &matrices.second})
        axle(side)->join(*matrix);
    return matrices;
  }

  template <int dim>
  DenseMatrix ModalBodies<dim>::loss_stiffness(const Side side) const
  {
    const std::size_t m = n_modes(side) + hanging[side].n_coordinates();
    DenseMatrix       H = DenseMatrix::Zero(m, m);
    H.topLeftCorner(n_modes(side), n_modes(side)) = parts[side]->H_m;
    if (axle(side))
      axle(side)->join(H);
    return H;
  }

  template <int dim>
  std::pair<DenseMatrix, DenseMatrix>
  ModalBodies<dim>::matrices_of_modes(const Side               side,
                                      const RollingConditions &conditions) const
  {
    const std::size_t      m      = n_modes(side);
    const StructuralModes &modes  = bodies[side]->modes;
    const auto             ratios = damping_ratios(side, conditions);
    ReducedPair            alone;
    alone.K_m = DenseMatrix::Zero(m, m);
    alone.C_m = conditions.hysteretic ? parts[side]->viscous : parts[side]->C_m;
    for (std::size_t j = 0; j < m; ++j)
      {
        alone.K_m(j, j) = modes.eigenvalue(j);
        alone.C_m(j, j) += 2 * ratios[j] * 2 * pi * modes.frequencies[j];
      }
    const double turns = rate(side, conditions);
    if (turns != 0.)
      add_rotation(alone, parts[side]->S_m, turns);
    return {std::move(alone.K_m), std::move(alone.C_m)};
  }

  template <int dim>
  std::unique_ptr<FullDynamics>
  ModalBodies<dim>::whole_body(const Side               side,
                               const RollingConditions &conditions) const
  {
    const VibratingBody<dim> &body = *bodies[side];
    const auto [K_m, C_m]          = matrices_of_modes(side, conditions);
    std::optional<AttachedDynamics> attached;
    if (hanging[side].n_coordinates() > 0)
      attached.emplace(AttachedDynamics{
        hanging[side].loads,
        hanging[side].deflected,
        hanging[side].residual,
        hanging[side].motions,
        hanging[side].statics,
        [this, side, conditions](const std::complex<double> s) {
          return absorber_stiffness(hanging[side],
                                    conditions.absorbers,
                                    rate(side, conditions),
                                    s);
        }});
    auto result = std::make_unique<FullDynamics>(
      TurningStructure{
        body.K, body.M, body.C, body.H, parts[side]->S, rate(side, conditions)},
      *body.factor,
      body.modes,
      damping_ratios(side, conditions),
      K_m,
      C_m,
      std::move(attached));
    if (body.harmonics)
      result->take_modes(body.parameters.model.damping.retardation());
    return result;
  }

  template class ModalBodies<2>;
  template class ModalBodies<3>;
} // namespace RollingContact
