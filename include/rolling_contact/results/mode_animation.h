#ifndef rolling_contact_results_mode_animation_h
#define rolling_contact_results_mode_animation_h

#include <rolling_contact/bodies/elastic_body.h>
#include <rolling_contact/run/run_folder.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A body and how it moves: Re[(real + i imaginary) exp(i omega t)].
   */
  template <int dim>
  struct MovingBody
  {
    const ElasticBody<dim> *body;
    BodyField               real, imaginary; ///< imaginary: empty for 0
    bool                    mirrored; ///< shown as its mirror image in z, as a
                                      ///< wheel is
    std::string name;                 ///< in those of files; empty for one body
  };

  /**
   * Writes NAME.pvd and, for each body, NAME_00.vtu or NAME_BODY_00.vtu and so
   * on: the surfaces of bodies (in 2D the bodies) displaced in 24 phases of a
   * period, whose times are those of a period of 1 s. The largest displacement
   * of all is 5 % of the smallest body's extent: warp by the vector with a
   * factor of 1. Throws InputError if a file cannot be written.
   */
  template <int dim>
  void write_mode_animation(const std::vector<MovingBody<dim>> &bodies,
                            RunFolder                          &folder,
                            const std::string                  &name);
} // namespace RollingContact

#endif
