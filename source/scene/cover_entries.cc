#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/entries.h>

namespace RollingContact
{
  void BodyParameters::declare_cover(Entries &entries)
  {
    entries.add("Cover thickness", cover_thickness, "m").at_least(0.).help =
      "Thickness of a layer of another material that is bonded on the body "
      "where it touches the other one, such as rubber on a roller: a ring at "
      "the rim of a disc, or the top of a block. Radius, Hub radius and Block "
      "depth include it. 0: none.";
    const Reader covered =
      reader([](const BodyParameters &body) { return body.has_cover(); },
             "Cover thickness = 0 is no cover");
    entries.add("Cover Young modulus", cover.young_modulus, "Pa")
      .at_least(0.)
      .read_by(covered)
      .help = "Young's modulus of the cover.";
    entries.add("Cover Poisson ratio", cover.poisson_ratio, "1")
      .between(0., 0.5)
      .read_by(covered)
      .help = "Poisson's ratio of the cover, at least 0 and below 0.5; rubber "
              "has 0.49 to 0.4999.";
    entries.add("Cover density", cover.density, "kg/m^3")
      .at_least(0.)
      .read_by(covered)
      .help = "Mass density of the cover, for analyses with inertia.";
  }

  void BodyParameters::check_cover() const
  {
    if (cover_thickness == 0.)
      return;
    require(!rigid,
            "Cover thickness",
            cover_thickness,
            "Rigid = true has no mesh to cover; set Rigid = false and give the "
            "core a large Young modulus, or take 0 m.");
    if (shape != "disc" && shape != "block")
      throw InputError(section + "/Cover thickness = " +
                       text_of(cover_thickness) + " and Shape = " + shape +
                       ": discs and blocks have covers; take one of them, or "
                       "0 m.");
    const double room = shape == "disc" ? radius - hub_radius : block_depth,
                 most = 0.9;
    require(cover_thickness <= most * room,
            "Cover thickness",
            cover_thickness,
            "it may be at most " + text_of(most) + " times the " +
              (shape == "disc" ? "rim's height over the hub, Radius - Hub "
                                 "radius"
                               : "Block depth") +
              ", " + text_of(most * room) + " m.");
    require(cover.young_modulus > 0.,
            "Cover Young modulus",
            cover.young_modulus,
            "it must be above 0 Pa.");
    require(cover.poisson_ratio < 0.5,
            "Cover Poisson ratio",
            cover.poisson_ratio,
            "it must be below 0.5; 0.4999 is as good as incompressible.");
    require(cover.density > 0.,
            "Cover density",
            cover.density,
            "it must be above 0 kg/m^3.");
    if (model.elements == ElementKind::enhanced)
      throw InputError(section + "/Elements = enhanced and Cover thickness = " +
                       text_of(cover_thickness) +
                       ": such elements are too stiff in a cover that hardly "
                       "changes its volume; take B-bar.");
  }
} // namespace RollingContact
