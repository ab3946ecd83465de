#ifndef rolling_contact_results_mode_sections_h
#define rolling_contact_results_mode_sections_h

#include <rolling_contact/bodies/elastic_body.h>
#include <rolling_contact/run/run_context.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A mode as the picture of sections shows it.
   */
  struct ShownMode
  {
    std::string name;
    BodyField   shape;
  };

  /**
   * Draws the outline of the section of a body at x = 0, on the contact's side,
   * at rest and displaced by each of some modes, as NAME.svg. Does nothing if
   * the mesh has no edges there. The largest displacement of the body
   * is a tenth of the section's height. @p mirrored: shown as its mirror image
   * in z.
   */
  void plot_mode_sections(const ElasticBody<3>         &body,
                          const std::vector<ShownMode> &modes,
                          const bool                    mirrored,
                          const std::string            &title,
                          RunContext                   &context,
                          const std::string            &name);
} // namespace RollingContact

#endif
