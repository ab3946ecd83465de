#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/mesh/ring_places.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/scene/travelled_distance.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  bool bodies_follow_profiles(const ProfileParameters &profiles,
                              const BodyParameters    &wheel,
                              const BodyParameters    &rail)
  {
    return profiles.in_use() &&
           ((profiles.has_true_sections() && !(wheel.rigid && rail.rigid)) ||
            wheel.is_from_file() || rail.is_from_file());
  }

  PairSpec::PairSpec(const SceneParameters &inputs)
    : dimension(inputs.dimension)
    , body_solver(inputs.body_solver)
    , body_threads(inputs.body_threads)
    , wheel(inputs.wheel)
    , rail(inputs.rail)
    , contact(inputs.contact)
    , solver(inputs.solver)
    , mesh(inputs.mesh)
    , profiles(inputs.profiles)
    , surfaces(inputs.surfaces)
    , wear(inputs.wear)
  {
    if (inputs.moves_axle())
      wheel.hold_axle();
  }

  void PairSpec::take_frame_loads()
  {
    if (motion)
      contact.creepages = frame->creepages(*motion);
    if (frame && contact.vertical_load)
      contact.normal_load =
        *contact.vertical_load / std::cos(frame->angle() - load_angle());
  }

  double PairSpec::load_angle() const
  {
    return contact.vertical_load &&
               frame->kind() == Profiles::SurfaceKind::curved
             ? frame->angle()
             : 0.;
  }

  Situation::Situation(const SceneParameters &asked, const Situation *earlier)
    : PairSpec(asked)
    , inputs(std::make_shared<const SceneParameters>(asked))
  {
    if (earlier && (earlier->dimension != dimension ||
                    earlier->inputs->prm_folder != inputs->prm_folder))
      earlier = nullptr;
    take_meshes(earlier);
    take_frame(earlier);
    if (!earlier)
      check_bodies();
    take_loads();
    take_surfaces(earlier);
  }

  namespace
  {
    /**
     * Whether bodies have the same mesh from a file, under the same kind of
     * surface.
     */
    bool have_same_file(const BodyParameters &one, const BodyParameters &other)
    {
      const auto all = [](const BodyParameters &body) {
        return std::make_tuple(body.is_from_file(),
                               body.shape,
                               body.mesh_file,
                               body.mesh_unit,
                               body.contact_boundary,
                               body.hub_boundary,
                               body.hub == Hub::free,
                               body.is_section() ? body.radius : 0.);
      };
      return all(one) == all(other);
    }
  } // namespace

  void Situation::take_meshes(const Situation *earlier)
  {
    const bool has_profiles = profiles.in_use();
    for (const Side side : both_sides)
      {
        BodySpec &body = side == Side::wheel ? wheel : rail;
        if (earlier && earlier->profiles.in_use() == has_profiles &&
            have_same_file(earlier->body(side), body))
          body.mesh = earlier->body(side).mesh;
        else
          body.read_mesh(dimension, inputs->prm_folder, has_profiles);
      }
  }

  void Situation::take_frame(const Situation *earlier)
  {
    if (!profiles.in_use() || !inputs->analysis.has_bodies)
      return;
    const bool is_at_patch =
                 profiles.surface_kind == Profiles::SurfaceKind::loaded_plane,
               is_same = earlier && earlier->frame &&
                         earlier->wheel.radius == wheel.radius &&
                         profiles.have_frame_of(earlier->profiles) &&
                         (!is_at_patch || pressed() == earlier->pressed());
    if (is_same)
      frame = earlier->frame;
    else
      {
        frame = profiles.find_frame(wheel.radius, inputs->prm_folder);
        if (is_at_patch)
          frame = frame_at_patch(frame, pressed());
      }
    const bool is_same_profile =
      is_same && earlier->profiles.web_bow == profiles.web_bow;
    for (const Side side : both_sides)
      {
        BodySpec &body = side == Side::wheel ? wheel : rail;
        if (!body.is_section() && (!profiles.has_true_sections() || body.rigid))
          continue;
        if (is_same_profile && earlier->body(side).profile)
          body.profile = earlier->body(side).profile;
        else
          body.profile = side == Side::wheel ? profiles.placed_wheel(frame)
                                             : profiles.placed_rail(frame);
      }
  }

  PressedHalfSpaces Situation::pressed() const
  {
    const auto material = [](const BodySpec &body) {
      return body.rigid ? std::optional<Material>() : body.material;
    };
    const ContactParameters &asked = inputs->contact;
    return {material(wheel),
            material(rail),
            asked.normal_load ? asked.normal_load : asked.vertical_load,
            asked.approach.value_or(0.)};
  }

  void Situation::check_bodies() const
  {
    if (!inputs->analysis.has_bodies)
      return;
    for (const BodySpec *body : {&wheel, &rail})
      if (body->mesh || body->profile)
        body->check(dimension);
    if (!wheel.rigid &&
        (inputs->analysis.has_dampers || inputs->has_reduced_bodies()))
      check_ring_places(wheel.absorbers(), wheel.section, *wheel.body_shape());
  }

  void Situation::take_loads()
  {
    motion.reset();
    if (frame && profiles.gives_creepages())
      motion = profiles.motion(contact.rolling_speed());
    take_frame_loads();
    if (!motion)
      contact.creepages = contact.asked_creepages();
  }

  namespace
  {
    /**
     * How far the wheel has rolled at the least and at the most while the run
     * lasts, `Position` included.
     */
    std::array<double, 2> rolled_in(const SceneParameters &scene)
    {
      const double          position = scene.surfaces.position;
      std::array<double, 2> rolled{{position, position}};
      if (!scene.marches())
        return rolled;
      const DrivingFunctions drive =
        scene.time.histories(scene.contact, scene.prm_folder);
      const TimeSteps         steps = scene.time.steps(drive.speed);
      const double            end   = steps.length * steps.number;
      const TravelledDistance travelled(drive.speed,
                                        std::max(steps.length, end / 1000));
      const unsigned int      n = drive.speed.is_constant() ? 1 : 100;
      for (unsigned int k = 1; k <= n; ++k)
        {
          // the shifted law looks half a step beyond the end
          const double now =
            position +
            scene.contact.flow() *
              travelled.value(steps.length * (steps.number + 0.5) * k / n);
          rolled[0] = std::min(rolled[0], now);
          rolled[1] = std::max(rolled[1], now);
        }
      return rolled;
    }

    bool name_same_surfaces(const SurfaceParameters &one,
                            const SurfaceParameters &other)
    {
      const auto all = [](const SurfaceParameters &surfaces) {
        return std::tie(surfaces.height.wheel,
                        surfaces.height.rail,
                        surfaces.friction_share,
                        surfaces.units.position,
                        surfaces.units.height);
      };
      return all(one) == all(other);
    }
  } // namespace

  void Situation::take_surfaces(const Situation *earlier)
  {
    if (!inputs->analysis.has_contact)
      return;
    if (earlier && name_same_surfaces(earlier->surfaces, surfaces) &&
        earlier->contact.roughness == contact.roughness)
      {
        surfaces.standing    = earlier->surfaces.standing;
        surfaces.records     = earlier->surfaces.records;
        surfaces.expressions = earlier->surfaces.expressions;
        surfaces.share       = earlier->surfaces.share;
      }
    else
      surfaces.read(inputs->prm_folder, contact.roughness);
    surfaces.least_rolled = surfaces.most_rolled = surfaces.position;
    if (surfaces.in_use())
      {
        const auto [least, most] = rolled_in(*inputs);
        surfaces.least_rolled    = least;
        surfaces.most_rolled     = most;
      }
  }
} // namespace RollingContact
