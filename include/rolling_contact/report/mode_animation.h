#ifndef rolling_contact_report_mode_animation_h
#define rolling_contact_report_mode_animation_h

#include <rolling_contact/elasticity/elastic_body.h>
#include <rolling_contact/run/run_folder.h>

#include <string>

namespace RollingContact
{
  /**
   * Writes NAME.pvd and NAME_00.vtu, ..., the surface of a body (in 2D the
   * body) displaced by a mode in 24 phases of a period, whose times are those
   * of a period of 1 s. The largest displacement is 5 % of the body's extent:
   * warp by the vector with a factor of 1. @p mirrored: the body is shown as
   * its mirror image in z, as a wheel is. Throws InputError if a file cannot be
   * written.
   */
  template <int dim>
  void
  write_mode_animation(const ElasticBody<dim> &body,
                       const BodyField        &shape,
                       const bool              mirrored,
                       RunFolder              &folder,
                       const std::string      &name);
} // namespace RollingContact

#endif
