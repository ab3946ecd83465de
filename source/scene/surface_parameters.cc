#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/surface_parameters.h>
#include <rolling_contact/surfaces/crown.h>
#include <rolling_contact/surfaces/dent.h>
#include <rolling_contact/surfaces/height_expression.h>

namespace RollingContact
{
  namespace
  {
    const char smooth[] = "Surfaces/Wheel height and Rail height are empty";

    const std::vector<Reader> files{
      {asks<SurfaceParameters, ContactParameters>(
         [](const auto &surfaces, const auto &contact) {
           return surfaces.in_use() || surfaces.has_files(contact.roughness);
         }),
       smooth},
      {asks<SurfaceParameters, ContactParameters>(
         [](const auto &surfaces, const auto &contact) {
           return surfaces.has_files(contact.roughness);
         }),
       "it is for heights from a file, and an expression gives the heights"}};

    std::string otherwise_of_heights()
    {
      return ", " + std::string(kinds_of_surface_files) +
             ", or leave it empty.";
    }

    const char share_otherwise[] =
      " for heights, if(abs(y) < 2e-3, 0.2, 1) for shares, or leave it empty.";
  } // namespace

  void SurfaceParameters::declare(Entries &entries)
  {
    entries.section("Surfaces")
      .read_by(analyses_with_elements())
      .read_by(analyses_of_contact());
    const auto declare_height =
      [&](const Side side, const std::string &name, const std::string &help) {
        entries.add(name, height[side], "m").help =
          help +
          " Empty: smooth. Give an expression in x and y (m) of the frame at "
          "`Position` 0, which moves with the material; or " +
          kinds_of_surface_files +
          ", relative to the .prm file, with positions that count as the wheel "
          "runs. Or, on bodies that are straight across, give a crown: "
          "`lundberg : LOAD` or `johns-gohar : LOAD` (N) for the length of "
          "their contact, `lundberg : LOAD : LENGTH` (m) for a given one. Or "
          "give a dent at x = 0 of the material: `flat : LENGTH` (m) of a disc "
          "or `dip : LENGTH, DEPTH` (m).";
      };
    declare_height(Side::wheel,
                   "Wheel height",
                   "Height of the wheel's surface, positive out of it, over "
                   "the length along its tread; it repeats after a turn.");
    declare_height(Side::rail,
                   "Rail height",
                   "Height of the rail's surface, positive out of it, over "
                   "the length along the track; that of a disc repeats after "
                   "a turn.");
    entries.add("Friction share", friction_share, "1").help =
      "Share of Contact/Friction coefficient at each place, from 0 to 1: an "
      "expression in x and y (m) of the frame at `Position` 0, which moves "
      "with the rail's material. Empty for 1. A strip of grease: if(abs(y) < "
      "2e-3, 0.2, 1).";
    entries.add("Position", position, "m")
      .read_by({asks<SurfaceParameters>([](const auto &surfaces) {
                  return surfaces.in_use() || !surfaces.friction_share.empty();
                }),
                smooth})
      .help =
      "Distance rolled before t = 0. It tells where the surfaces are at the "
      "start and in steady states.";
    entries.add("Shortest wavelength", shortest_wavelength, "m")
      .read_by(files)
      .at_least(0.)
      .help =
      "Shortest wavelength of a file that is kept. Shorter waves are damped, "
      "more and more down to half of this length, below which none is left. "
      "0: 4 elements, the least possible.";
    entries.add("Position unit", units.position, "m")
      .at_least(0.)
      .read_by(files)
      .help =
      "Length of one unit of the positions in the first column of a file; "
      "1e-3 for millimetres.";
    entries.add("Height unit", units.height, "m")
      .at_least(0.)
      .read_by(files)
      .help = "Length of one unit of the heights in a file; 1e-6 for "
              "micrometres.";
  }

  std::string SurfaceParameters::entry(const Side side)
  {
    return side == Side::wheel ? "Surfaces/Wheel height"
                               : "Surfaces/Rail height";
  }

  void SurfaceParameters::check(const unsigned int dimension) const
  {
    for (const auto &[name, unit] : {std::pair("Position unit", units.position),
                                     std::pair("Height unit", units.height)})
      if (!(unit > 0.))
        throw InputError("Surfaces/" + std::string(name) + " = " +
                         text_of(unit) +
                         ": it must be above 0 m, 1e-3 for millimetres, 1e-6 "
                         "for micrometres.");
    if (!friction_share.empty())
      {
        const HeightExpression tried("Surfaces/Friction share",
                                     friction_share,
                                     share_otherwise);
        if (dimension == 2 && tried.depends_on_y())
          throw InputError("Surfaces/Friction share = " + friction_share +
                           ": in 2D there is no y; give an expression in x, "
                           "or take Dimension = 3.");
      }
    for (const Side side : both_sides)
      if (crown_named(entry(side), height[side]))
        {
          if (dimension == 2)
            throw InputError(entry(side) + " = " + height[side] +
                             ": in 2D there are no ends across; take "
                             "Dimension = 3.");
        }
      else if (dent_named(entry(side), height[side]))
        continue;
      else if (names_a_record(height[side]))
        check_dimension_of_file(entry(side), height[side], dimension);
      else if (!height[side].empty())
        {
          const HeightExpression tried(entry(side),
                                       height[side],
                                       otherwise_of_heights());
          if (dimension == 2 && tried.depends_on_y())
            throw InputError(entry(side) + " = " + height[side] +
                             ": in 2D there is no y; give an expression in x, "
                             "or take Dimension = 3.");
        }
  }

  void SurfaceSpec::read(const std::filesystem::path &folder,
                         const std::string           &roughness)
  {
    if (names_a_record(roughness))
      standing = std::make_shared<const SurfaceRecord>(read_surface_record(
        "Contact/Roughness", roughness, folder, units, true));
    share =
      friction_share.empty()
        ? nullptr
        : std::make_shared<const HeightExpression>("Surfaces/Friction share",
                                                   friction_share,
                                                   share_otherwise);
    for (const Side side : both_sides)
      {
        if (height[side].empty() || crown_named(entry(side), height[side]) ||
            dent_named(entry(side), height[side]))
          continue;
        if (names_a_record(height[side]))
          records[side] = std::make_shared<const SurfaceRecord>(
            read_surface_record(entry(side), height[side], folder, units));
        else
          expressions[side] =
            std::make_shared<const HeightExpression>(entry(side),
                                                     height[side],
                                                     otherwise_of_heights());
      }
  }
} // namespace RollingContact
