#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/absorber_places.h>
#include <rolling_contact/modes/body_reflections.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/vibration/mode_controls.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    /// difference of the eigenfrequencies of a pair that is one of rounding
    const double same_frequency = 1e-6;

    /// from an eigenfrequency, over that, from where it is another one
    const double far_frequency = 0.05;

    template <int dim>
    std::unique_ptr<DirectBody<dim>>
    make_body(const BodySpec              &parameters,
              const std::optional<double> &size,
              PhaseTimer                  &timer)
    {
      PhaseTimer::Scope phase(timer, Phase::mesh);
      return std::make_unique<DirectBody<dim>>(
        parameters.body_shape(),
        parameters.material,
        parameters.thickness,
        size ? Grading<dim>::uniform(*size, *size) : Grading<dim>::unrefined(),
        true,
        parameters.model);
    }

    /** Whether K is positive definite. */
    bool is_held(const BodySpec &body, const int dim)
    {
      bool on_springs = body.hub == Hub::elastic;
      for (unsigned int axis = 0; axis < 3; ++axis)
        if (dim == 3 || axis != 1)
          on_springs = on_springs &&
                       body.model.foundation.stiffness[axis] > 0. &&
                       (!body.model.foundation.has_sleepers() ||
                        body.model.foundation.ballast_stiffness[axis] > 0.);
      return body.hub == Hub::clamped || on_springs;
    }
  } // namespace

  template <int dim>
  VibratingBody<dim>::VibratingBody(const PairSpec                  &scene,
                                    const Side                       side,
                                    std::unique_ptr<DirectBody<dim>> own,
                                    const DirectBody<dim>           *body,
                                    const double                     shift)
    : side(side)
    , parameters(scene.body(side))
    , body(body != nullptr ? body : own.get())
    , places(*this->body)
    , shift(shift)
    , factor(nullptr)
    , own_body(std::move(own))
  {}

  template <int dim>
  VibratingBody<dim>::VibratingBody(const PairSpec        &scene,
                                    const Side             side,
                                    const ModesParameters &wanted,
                                    const double           cut_off,
                                    RunContext            &context)
    : VibratingBody(
        scene,
        side,
        make_body<dim>(scene.body(side), wanted.element_size, context.timer),
        nullptr,
        is_held(scene.body(side), dim) ? 0. : shift_of_free_body(cut_off))
  {
    find_matrices(context);
    factorise(context);
    find_modes(wanted, cut_off, context);
    warn_of_pairs(scene.contact.speed, context);
  }

  template <int dim>
  VibratingBody<dim>::VibratingBody(const PairSpec        &scene,
                                    const Side             side,
                                    const ModesParameters &wanted,
                                    const DirectBody<dim> &rolling,
                                    const double           cut_off,
                                    RunContext            &context)
    : VibratingBody(scene, side, nullptr, &rolling, 0.)
  {
    find_matrices(context);
    factor = &rolling.factorisation();
    find_modes(wanted, cut_off, context);
    if (waves)
      take_modes_of_waves(context);
    warn_of_pairs(scene.contact.speed, context);
  }

  template <int dim>
  void VibratingBody<dim>::find_matrices(RunContext &context)
  {
    PhaseTimer::Scope phase(context.timer, Phase::mesh);
    if (is_without_ends() && own_body == nullptr)
      return; // its section vibrates
    K = body->stiffness();
    if (is_without_ends())
      return;
    M = body->mass();
    if (parameters.model.damping.is_viscous())
      C = body->damping();
    H = body->loss_stiffness();
    if (std::all_of(H.values.begin(), H.values.end(), [](const double h) {
          return h == 0.;
        }))
      H = SymmetricSparseMatrix();
  }

  template <int dim>
  void VibratingBody<dim>::factorise(RunContext &context)
  {
    PhaseTimer::Scope phase(context.timer, Phase::condensation);
    own_factor =
      std::make_unique<Factorisation>(shift > 0.
                                        ? linear_combination(1., K, shift, M)
                                        : K,
                                      body->nodes_of_unknowns());
    own_factor->factorise();
    factor = own_factor.get();
  }

  template <int dim>
  void VibratingBody<dim>::find_modes(const ModesParameters &wanted,
                                      const double           cut_off,
                                      RunContext            &context)
  {
    PhaseTimer::Scope phase(context.timer, Phase::modes);
    if (is_without_ends())
      {
        find_waves(wanted, cut_off, context);
        return;
      }
    const ModeControls controls = mode_controls(
      wanted, cut_off, body->n_unknowns(), parameters.section, context.log);
    const unsigned int many = 30000; // unknowns: seconds and more
    if (body->n_unknowns() > many)
      context.log.message(parameters.section + ": looking for the modes of " +
                          std::to_string(body->n_unknowns()) +
                          " unknowns up to " + significant(cut_off, 4) +
                          " Hz.");
    if (parameters.modes == ModeModel::harmonic && dim == 3)
      find_modes_of_section(controls);
    else
      modes = structural_modes(K,
                               M,
                               *factor,
                               shift,
                               body->nodes_of_unknowns(),
                               controls,
                               body_reflections(places, K, M));
    const auto axle = parameters.body_shape()->axle();
    characters      = mode_characters(places, axle, modes);
    const MeasuringPoint contact(*body, {{0., 0., 0.}}, 0.);
    align_pairs(characters, contact, same_frequency, modes);

    report_modes(wanted, context);
  }

  template <int dim>
  void VibratingBody<dim>::find_modes_of_section(const ModeControls &controls)
  {
    const auto shape = parameters.body_shape();
    std::tie(modes, harmonics) =
      harmonic_modes({*shape->section_about_axle(),
                      *shape->axle(),
                      parameters.material,
                      parameters.hub == Hub::clamped},
                     places,
                     body->n_unknowns(),
                     controls);
    modes.find_at_rest(K, M, *factor, shift, controls.cut_off / 4);
  }

  template <int dim>
  std::string VibratingBody<dim>::searched() const
  {
    if (harmonics)
      return std::to_string(modes.n_solves) + " solves with " +
             std::to_string(harmonics->n_unknowns) +
             " unknowns of the section for each of 0 to " +
             std::to_string(harmonics->most_diameters) + " nodal diameters, " +
             human_seconds(modes.lanczos_seconds) +
             "; frequencies are within " +
             significant(harmonics->lower_degree_error, 2) +
             ", what elements of a lower degree differ by";
    return std::to_string(modes.n_solves) + " solves" +
           (modes.n_subspaces > 1 ? " in " + std::to_string(modes.n_subspaces) +
                                      " parts by planes of symmetry, "
                                  : ", ") +
           human_seconds(modes.lanczos_seconds);
  }

  template <int dim>
  void VibratingBody<dim>::report_modes(const ModesParameters &wanted,
                                        RunContext            &context) const
  {
    double worst = 0.;
    for (const double residual : modes.residuals)
      worst = std::max(worst, residual);
    context.log.message(
      parameters.section + ": " + std::to_string(body->n_unknowns()) +
      " unknowns, " + std::to_string(modes.size()) + " modes up to " +
      significant(modes.cut_off, 4) + " Hz" +
      (modes.counted ? ", as many as the inertia counts" : ", not counted") +
      "; residuals below " + significant(worst, 2) + ", orthogonal to " +
      significant(modes.orthogonality, 2) + "; " + searched() + ".");
    // cells at singular corners are small, and residuals measured by forces
    const double allowed =
      harmonics ? std::max(wanted.tolerance, 1e-6) : wanted.tolerance;
    if (worst > allowed)
      context.log.warning(
        parameters.section + ": the residual of a mode is " +
        significant(worst, 2) +
        ", above Modes/Tolerance = " + significant(wanted.tolerance, 2) +
        "; rounding may leave more on meshes with very small cells.");
    context.report.objects.push_back(
      {"factor of the " + name_of(side),
       true,
       factor->size().memory_consumption(),
       factor->size().analysis_s + factor->size().factor_s,
       ""});
    context.report.objects.push_back(
      {"modes of the " + name_of(side) +
         (harmonics ? " by harmonics of its section" : "") +
         ", a Krylov space of " + std::to_string(modes.n_basis),
       true,
       modes.basis_bytes + modes.size() * K.size() * sizeof(double),
       modes.lanczos_seconds,
       ""});
    context.report.objects.push_back(
      {"count of modes by inertia",
       modes.counted.has_value(),
       0,
       modes.count_seconds,
       modes.counted ? "" : "Modes/Count check"});
  }

  template <int dim>
  void VibratingBody<dim>::warn_of_pairs(const std::optional<double> &speed,
                                         RunContext &context) const
  {
    const double radius  = parameters.radius;
    std::size_t  largest = modes.size();
    for (std::size_t j = 0; j < modes.size(); ++j)
      if (characters[j].partner &&
          (largest == modes.size() ||
           characters[j].split > characters[largest].split))
        largest = j;
    if (dim == 2 || side == Side::rail || largest == modes.size() ||
        !(radius > 0.))
      return;
    const double split   = characters[largest].split,
                 f       = modes.frequencies[largest];
    const unsigned int n = *characters[largest].nodal_diameters;
    context.log.detail(parameters.section + ": largest split of a pair " +
                       significant(split, 2) + ", at " + significant(f, 5) +
                       " Hz.");
    const double v = speed.value_or(10.), rotation = n * v / (2 * pi * radius);
    if (split * f > 0.1 * rotation)
      context.log.warning(
        parameters.section + ": the mesh splits the pair with " +
        std::to_string(n) + " nodal diameters at " + significant(f, 5) +
        " Hz by " + significant(split * f, 2) +
        " Hz, more than a tenth of what rotation does to it at " +
        significant(v, 3) + " m/s (" + significant(rotation, 3) +
        " Hz). Equal cells round the axle keep pairs together.");
  }

  template <int dim>
  void
  VibratingBody<dim>::warn_of_diameters(const std::vector<AbsorberRing> &rings,
                                        const double highest,
                                        RunContext  &context) const
  {
    for (const AbsorberRing &ring : rings)
      for (std::size_t j = 0; j < modes.size(); ++j)
        if (modes.frequencies[j] <= highest &&
            characters[j].nodal_diameters.value_or(0) > ring.most_diameters())
          {
            context.log.warning(
              parameters.section + "/Dampers = " + std::to_string(ring.number) +
              ": they are taken as a continuous ring, which needs at least " +
              std::to_string(2 * *characters[j].nodal_diameters + 1) +
              " of them for the mode with " +
              std::to_string(*characters[j].nodal_diameters) +
              " nodal diameters at " + significant(modes.frequencies[j], 5) +
              " Hz; such modes and those with more diameters are not damped "
              "here.");
            break;
          }
  }

  template <int dim>
  AbsorberPlaces VibratingBody<dim>::absorbers(const double highest,
                                               RunContext  &context) const
  {
    const auto rings = parameters.absorbers();
    if (rings.empty())
      return {};
    const auto axle = parameters.body_shape()->axle();
    if (!axle)
      throw InputError(parameters.section +
                       "/Dampers: this wheel has no axle for them to be "
                       "round; take Shape = disc or section, with a Radius "
                       "above 0.");
    PhaseTimer::Scope        phase(context.timer, Phase::modes);
    std::vector<std::string> notes;
    const AbsorberPlaces     result = absorber_places(rings,
                                                  parameters.section,
                                                  places,
                                                  *axle,
                                                  modes,
                                                  characters,
                                                  *factor,
                                                  shift,
                                                  notes);
    for (const std::string &note : notes)
      context.log.message(parameters.section + ": " + note);
    context.log.detail(parameters.section +
                       ": the flexibility that the modes leave out is as soft "
                       "as " +
                       significant(100 * softening(result, rings), 2) +
                       " % of the dampers' springs and acts in series with "
                       "them.");
    warn_of_diameters(rings, highest, context);
    return result;
  }

  template <int dim>
  std::vector<double> VibratingBody<dim>::damping_of_single_modes() const
  {
    std::vector<double> ratios(modes.size(), 0.);
    for (const auto &[f, ratio] : parameters.model.damping.of_modes)
      {
        std::size_t nearest = 0;
        for (std::size_t j = 0; j < modes.size(); ++j)
          if (std::abs(modes.frequencies[j] - f) <
              std::abs(modes.frequencies[nearest] - f))
            nearest = j;
        if (modes.size() == 0 ||
            std::abs(modes.frequencies[nearest] - f) > far_frequency * f)
          throw InputError(
            parameters.section + "/Mode damping: no mode is within 5 % of " +
            significant(f, 6) + " Hz" +
            (modes.size() == 0
               ? ""
               : "; the nearest is at " +
                   significant(modes.frequencies[nearest], 6) + " Hz") +
            ". Analysis = modes lists all.");
        ratios[nearest] += ratio;
        if (characters[nearest].partner)
          ratios[*characters[nearest].partner] += ratio;
      }
    return ratios;
  }

  template <int dim>
  std::vector<double> VibratingBody<dim>::given_damping() const
  {
    if (waves)
      return waves->modes().damping_ratios;
    const std::vector<double> &by_diameters = parameters.model.damping.modal;
    std::vector<double>        ratios       = damping_of_single_modes();
    if (by_diameters.empty())
      return ratios;
    for (std::size_t j = 0; j < modes.size(); ++j)
      ratios[j] += by_diameters[std::min<std::size_t>(
        by_diameters.size() - 1,
        characters[j].nodal_diameters.value_or(by_diameters.size()))];
    return ratios;
  }

  template struct VibratingBody<2>;
  template struct VibratingBody<3>;
} // namespace RollingContact
