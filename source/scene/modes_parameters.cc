#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/modes_parameters.h>

namespace RollingContact
{
  void ModesParameters::declare(Entries &entries)
  {
    entries.section("Modes").read_with_reduced_bodies(
      "Analysis = modes, receptance, stability, stability map, corrugation and "
      "rolling noise and Time/Bodies = reduced read that section");
    entries.add("Maximum frequency", maximum_frequency, "Hz")
      .at_least(0.)
      .help = "All modes up to this frequency are found.";
    entries.add("Cut-off ratio", cut_off_ratio, "1").at_least(0.).help =
      "Receptances take all modes up to this ratio times the highest "
      "frequency that is asked for.";
    entries.add("Tolerance", tolerance, "1").at_least(0.).help =
      "Largest residual of a mode, |K phi - lambda M phi| over lambda |M "
      "phi|, as far as rounding allows.";
    entries.add("Count check", count).help =
      "Whether the modes below the cut-off are counted by the inertia of K - "
      "omega^2 M (Sylvester), so that none is missed. It takes about a fifth "
      "of the time.";
    entries.add("Element size", element_size, "m").help =
      "Longest edge of the cells in bodies that the program meshes without a "
      "contact. The cells are equal, with equal angles round an axle. Empty: "
      "as few cells as resolve the shape. Sections and meshes from files are "
      "taken as they are.";
    entries.add("Animated modes", animated, "1").at_least(0).help =
      "Number of modes of each body, from the first, whose moving surface is "
      "written for ParaView, in 24 phases of a period. For Analysis = "
      "stability: number of vibrations, those that grow fastest, with both "
      "bodies.";
  }

  void ModesParameters::check() const
  {
    if (!(maximum_frequency > 0.))
      throw InputError(
        "Modes/Maximum frequency = " + text_of(maximum_frequency) +
        ": it must be above 0 Hz; squeal is below 6000 Hz.");
    if (!(cut_off_ratio >= 1.))
      throw InputError("Modes/Cut-off ratio = " + text_of(cut_off_ratio) +
                       ": it must be at least 1; 2 is good.");
    if (!(tolerance > 0. && tolerance <= 1e-3))
      throw InputError("Modes/Tolerance = " + text_of(tolerance) +
                       ": it must be above 0 and at most 1e-3.");
    if (element_size && !(*element_size > 0.))
      throw InputError("Modes/Element size = " + text_of(*element_size) +
                       ": it must be above 0 m; 0.02 gives two cells through "
                       "the web of a wheel.");
  }
} // namespace RollingContact
