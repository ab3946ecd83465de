#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * E at the surface in Pa, infinite for a rigid body.
     */
    double young_modulus(const BodySpec &body)
    {
      return body.rigid ? std::numeric_limits<double>::infinity()
                        : body.surface_material().young_modulus;
    }

    double finite_or_flat(const double radius)
    {
      return radius == 0. ? std::numeric_limits<double>::infinity() : radius;
    }

    /**
     * Approximate compression of a body between patch and hub, without that of
     * a cover. Units: m.
     */
    double compression(const BodySpec              &body,
                       const References::HertzLine &contact)
    {
      return body.rigid ? 0.
                        : body.body_shape()->line_compression(
                            contact,
                            body.material.young_modulus,
                            body.material.poisson_ratio);
    }

    /**
     * Largest half-width of the patch to look for: no larger than the relative
     * radius and the bodies. Units: m.
     */
    double largest_half_width(const PairSpec &scene,
                              const double    relative_radius)
    {
      double largest = relative_radius;
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (!body->rigid)
          largest = std::min(largest, body->body_shape()->largest_half_width());
      return largest;
    }
  } // namespace

  PairConstants pair_constants(const PairSpec &scene)
  {
    const BodySpec &wheel = scene.wheel, &rail = scene.rail;
    const double E_wheel = young_modulus(wheel), E_rail = young_modulus(rail),
                 nu_wheel = wheel.surface_material().poisson_ratio,
                 nu_rail  = rail.surface_material().poisson_ratio;
    PairConstants constants;
    constants.contact_modulus =
      References::contact_modulus(E_wheel, nu_wheel, E_rail, nu_rail);
    constants.elasticity =
      References::combined_elasticity(E_wheel, nu_wheel, E_rail, nu_rail);
    constants.dundurs_beta =
      References::dundurs_beta(E_wheel, nu_wheel, E_rail, nu_rail);
    constants.relative_radius =
      References::relative_radius(finite_or_flat(wheel.radius),
                                  finite_or_flat(rail.radius));
    if (scene.dimension == 3 && !scene.profiles.in_use() &&
        !scene.touches_in_line())
      constants.lateral_relative_radius =
        References::relative_radius(finite_or_flat(wheel.lateral_radius),
                                    finite_or_flat(rail.lateral_radius));
    return constants;
  }

  namespace
  {
    PatchEstimate estimate_ellipse(const PairSpec              &scene,
                                   const std::optional<double> &load)
    {
      const PairConstants constants = pair_constants(scene);
      const double        A         = 0.5 / constants.relative_radius,
                   B                = 0.5 / constants.lateral_relative_radius;
      PatchEstimate estimate;
      const auto    take = [&](const double modulus) {
        estimate.normal_force = load.value_or(References::load_of_hertz_ellipse(
          scene.contact.approach.value_or(0.), A, B, modulus));
        if (!(estimate.normal_force > 0.))
          return;
        const References::HertzEllipse hertz =
          References::hertz_ellipse(estimate.normal_force, A, B, modulus);
        estimate.half_width_x = hertz.half_width_x;
        estimate.half_width_y = hertz.half_width_y;
      };
      double modulus = constants.contact_modulus;
      take(modulus);
      // under a cover the modulus depends on the size of the patch
      const unsigned int n_rounds = 30;
      for (unsigned int k = 0;
           k < n_rounds && scene.has_covers() && estimate.normal_force > 0.;
           ++k)
        {
          modulus = std::sqrt(modulus * References::layered_contact_modulus(
                                          std::sqrt(estimate.half_width_x *
                                                    estimate.half_width_y),
                                          layered_pair(scene)));
          take(modulus);
        }
      return estimate;
    }
  } // namespace

  namespace
  {
    /// rad, of the normals over one plane of contact
    const double largest_turn = 0.53;

    PatchEstimate estimate_of_profiles(const PairSpec              &scene,
                                       const std::optional<double> &load)
    {
      const ProfilePatch patch =
        profile_patch(*scene.frame,
                      pair_constants(scene).contact_modulus,
                      load,
                      scene.contact.approach.value_or(0.),
                      scene.load_angle());
      const double degree = std::acos(-1.) / 180;
      if (patch.turn_of_normal > largest_turn)
        throw InputError(
          "Profiles/Lateral shift = " + significant(scene.profiles.shift, 6) +
          " m: the rail's normal turns by " +
          significant(patch.turn_of_normal / degree, 3) +
          " degrees over the contact, as where tread and flange touch at the "
          "same time; one plane of contact holds for " +
          significant(largest_turn / degree, 2) +
          " degrees. Take Profiles/Contact surface = curved, another shift or a "
          "smaller load.");
      return {patch.half_width_x,
              patch.half_width_y,
              patch.normal_force,
              patch.boxes,
              patch.shortest_x,
              patch.narrowest_y};
    }
  } // namespace

  bool PatchEstimate::contains(const double x, const double y) const
  {
    // a node at the very edge must not depend on rounding
    const double inside = 1 - 1e-6;
    if (boxes.empty())
      return std::hypot(x / half_width_x,
                        half_width_y > 0. ? y / half_width_y : 0.) < inside;
    return std::any_of(boxes.begin(), boxes.end(), [&](const ZoneBox &box) {
      return box.contains(x, y);
    });
  }

  PatchEstimate estimate_patch(const PairSpec &scene)
  {
    return estimate_patch(scene, scene.contact.normal_load);
  }

  bool bodies_touch(const PairSpec &scene)
  {
    return scene.profiles.in_use() ? scene.contact.normal_load.value_or(
                                       scene.contact.approach.value_or(0.)) > 0.
                                   : estimate_patch(scene).half_width_x > 0.;
  }

  namespace
  {
    /** The rectangle of a line contact of this length (m). */
    void set_ends(const double length, PatchEstimate &estimate)
    {
      const double a = estimate.half_width_x, w = length / 2;
      estimate.half_width_y = estimate.narrowest_y = w;
      estimate.shortest_x                          = a;
      estimate.boxes = {ZoneBox{{{-a, -w}}, {{a, w}}}};
    }

    /**
     * Largest half-width for which covers are not too thin. Units: m.
     */
    double largest_under_cover(const PairSpec &scene)
    {
      const double most = 99.; // over the thickness of a cover
      double       largest =
        largest_half_width(scene, pair_constants(scene).relative_radius);
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (body->has_cover())
          largest = std::min(largest, most * body->cover_thickness);
      return largest;
    }

    /**
     * The exact line contact of half-planes with covers; under an approach that
     * of their cores as bodies is added.
     */
    PatchEstimate estimate_under_cover(const PairSpec              &scene,
                                       const std::optional<double> &load,
                                       const double                 length)
    {
      PatchEstimate estimate;
      const auto    compressed = [&](const double half_width) {
        const auto line = layered_line_contact_of_half_width(scene, half_width);
        const References::HertzLine hertz{half_width, line.pressure_terms[0]};
        return line.approach_of_layers + compression(scene.wheel, hertz) +
               compression(scene.rail, hertz);
      };
      if (load && *load > 0.)
        estimate.half_width_x =
          layered_line_contact(scene,
                               *load / length,
                               References::LineFriction::none)
            .half_width;
      else if (!load && *scene.contact.approach > 0.)
        estimate.half_width_x =
          References::half_width_of_approach(compressed,
                                             largest_under_cover(scene),
                                             *scene.contact.approach);
      if (!(estimate.half_width_x > 0.))
        return estimate;
      estimate.normal_force =
        length *
        layered_line_contact_of_half_width(scene, estimate.half_width_x)
          .load_per_length();
      if (scene.dimension == 3)
        set_ends(length, estimate);
      return estimate;
    }
  } // namespace

  PatchEstimate estimate_patch(const PairSpec              &scene,
                               const std::optional<double> &load)
  {
    if (scene.profiles.in_use())
      return estimate_of_profiles(scene, load);
    if (scene.dimension == 3 && !scene.touches_in_line())
      return estimate_ellipse(scene, load);
    const double length =
      scene.dimension == 2 ? scene.thickness() : 2 * narrower_reach(scene);
    const PairConstants constants = pair_constants(scene);
    const auto          hertz     = [&](const double half_width) {
      return References::hertz_line_of_half_width(half_width,
                                                  constants.relative_radius,
                                                  constants.contact_modulus);
    };
    // of a thin layer that keeps its volume, where what is known of the bodies
    // falls off (Johnson 1985, 5.8)
    const auto least_approach = [&](const double half_width) {
      return half_width * half_width / (6 * constants.relative_radius);
    };
    if (scene.has_covers())
      return estimate_under_cover(scene, load, length);
    PatchEstimate estimate;
    if (load)
      {
        if (*load > 0.)
          estimate.half_width_x =
            References::hertz_line(*load / length,
                                   constants.relative_radius,
                                   constants.contact_modulus)
              .half_width;
      }
    else
      estimate.half_width_x = References::half_width_of_approach(
        [&](const double half_width) {
          return std::max(compression(scene.wheel, hertz(half_width)) +
                            compression(scene.rail, hertz(half_width)),
                          least_approach(half_width));
        },
        largest_half_width(scene, constants.relative_radius),
        *scene.contact.approach);
    if (estimate.half_width_x > 0.)
      estimate.normal_force =
        hertz(estimate.half_width_x).load_per_length() * length;
    if (scene.dimension == 3 && estimate.half_width_x > 0.)
      set_ends(length, estimate);
    return estimate;
  }
} // namespace RollingContact
