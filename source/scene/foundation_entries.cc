#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/entries.h>

namespace RollingContact
{
  namespace
  {
    const std::array<std::string, 3> along_axes{{"x", "y", "z"}};

    bool lies_on_springs(const BodyParameters &body)
    {
      return !body.rigid && body.hub == Hub::elastic;
    }

    bool lies_on_pads(const BodyParameters &body)
    {
      return body.model.foundation.pad_spacing != 0.;
    }

    bool lies_on_sleepers(const BodyParameters &body)
    {
      return body.model.foundation.has_sleepers();
    }
  } // namespace

  void BodyParameters::declare_foundation(Entries &entries)
  {
    Foundation  &foundation = model.foundation;
    const Reader springs =
                   reader(lies_on_springs,
                          "an elastic body with Hub = elastic reads it"),
                 pads     = reader(lies_on_pads,
                               "the layer is continuous, Pad spacing = 0"),
                 sleepers = reader(lies_on_sleepers,
                                   "there are no sleepers, Sleeper mass = 0");
    for (unsigned int c = 0; c < 3; ++c)
      entries
        .add("Foundation stiffness " + along_axes[c],
             foundation.stiffness[c],
             "N/m^2")
        .at_least(0.)
        .read_by(c == 1 ? std::vector{scenes_in_3d(), springs}
                        : std::vector{springs})
        .help = "Stiffness of the layer or the pads of Hub = elastic along " +
                along_axes[c] + (c == 1 ? ", 3D only" : "") +
                ": force per displacement and per metre of length along x, "
                "spread evenly over the hub.";
    entries.add("Foundation loss factor", foundation.loss_factor, "1")
      .at_least(0.)
      .read_by(springs)
      .read_by(readers_of_damping())
      .help = "Loss factor of the layer or the pads of Hub = elastic; see "
              "Loss frequency.";
    entries.add("Pad spacing", foundation.pad_spacing, "m")
      .at_least(0.)
      .read_by(springs)
      .help =
      "Distance between pads, which replace the layer. The stiffness of one "
      "pad is Foundation stiffness times this distance. 0: a continuous layer.";
    entries.add("Pad length", foundation.pad_length, "m")
      .at_least(0.)
      .read_by({springs, pads})
      .help = "Length of each pad along x.";
    entries.add("Pad offset", foundation.pad_offset, "m")
      .read_by({springs, pads})
      .help =
      "x of the middle of a pad. 0: a pad lies under the contact; half of Pad "
      "spacing: the contact is midway between two pads.";
    entries.add("Sleeper mass", foundation.sleeper_mass, "kg")
      .at_least(0.)
      .read_by({springs, pads})
      .help =
      "Mass of the sleeper below each pad, which moves without turning. 0: "
      "the pads lie on the ground.";
    for (unsigned int c = 0; c < 3; ++c)
      entries
        .add("Ballast stiffness " + along_axes[c],
             foundation.ballast_stiffness[c],
             "N/m^2")
        .at_least(0.)
        .read_by(c == 1 ? std::vector{scenes_in_3d(), springs, sleepers}
                        : std::vector{springs, sleepers})
        .help = "Stiffness between sleepers and ground along " + along_axes[c] +
                (c == 1 ? ", 3D only" : "") +
                ", per metre of length as Foundation stiffness.";
    entries.add("Ballast loss factor", foundation.ballast_loss_factor, "1")
      .at_least(0.)
      .read_by({springs, sleepers})
      .read_by(readers_of_damping())
      .help = "Loss factor of the ballast under sleepers; see Loss frequency.";
  }
} // namespace RollingContact
