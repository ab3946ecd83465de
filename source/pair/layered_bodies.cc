#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/pair/patch_estimate.h>

#include <limits>

namespace RollingContact
{
  namespace
  {
    References::LayeredPlane layered_plane(const BodySpec &body)
    {
      return {body.has_cover() ? body.cover_thickness : 0.,
              body.cover.young_modulus,
              body.cover.poisson_ratio,
              body.rigid ? std::numeric_limits<double>::infinity()
                         : body.material.young_modulus,
              body.material.poisson_ratio};
    }

    /** What a cover is too thin for, naming the thinner one of two. */
    [[noreturn]] void refuse_thin_cover(const PairSpec &scene)
    {
      const BodySpec &wheel = scene.wheel, &rail = scene.rail,
                     &body = !rail.has_cover() ||
                                 (wheel.has_cover() &&
                                  wheel.cover_thickness < rail.cover_thickness)
                               ? wheel
                               : rail;
      throw InputError(
        body.section + "/Cover thickness = " + text_of(body.cover_thickness) +
        " m: it is less than a hundredth of the half-width of the patch, which "
        "is known down to that; take a thicker cover, or 0 m for none.");
    }
  } // namespace

  References::LayeredPair layered_pair(const PairSpec &scene)
  {
    return {{layered_plane(scene.wheel), layered_plane(scene.rail)}};
  }

  References::LayeredLine
  layered_line_contact(const PairSpec                &scene,
                       const double                   load_per_length,
                       const References::LineFriction friction)
  {
    try
      {
        return References::layered_line(load_per_length,
                                        layered_pair(scene),
                                        pair_constants(scene).relative_radius,
                                        friction);
      }
    catch (const InputError &)
      {
        refuse_thin_cover(scene);
      }
  }

  References::LayeredLine
  layered_line_contact_of_half_width(const PairSpec &scene,
                                     const double    half_width)
  {
    return References::layered_line_of_half_width(
      half_width,
      layered_pair(scene),
      pair_constants(scene).relative_radius,
      References::LineFriction::none);
  }
} // namespace RollingContact
