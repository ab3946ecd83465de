#include <rolling_contact/analyses/pad_places.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>

namespace RollingContact
{
  namespace
  {
    bool lies_on_pads(const BodyParameters &rail)
    {
      return !rail.rigid && rail.hub == Hub::elastic &&
             rail.model.foundation.pad_spacing > 0.;
    }
  } // namespace

  PadPlaces::PadPlaces(const std::string &section, const std::string &text)
    : entry(section + "/Pad offsets")
    , text(text)
    , offsets(text.empty() ? std::vector<double>() : number_list(entry, text))
  {}

  void PadPlaces::check(const BodyParameters &rail) const
  {
    if (!offsets.empty() && !lies_on_pads(rail))
      throw InputError(entry + " = " + text +
                       ": the rail lies on no pads; give Rail/Hub = elastic "
                       "and Pad spacing, or leave Pad offsets empty.");
  }

  std::vector<Situation> PadPlaces::situations(const Situation &scene) const
  {
    std::vector<Situation> places;
    for (const double offset : offsets)
      {
        auto inputs                             = *scene.inputs;
        inputs.rail.model.foundation.pad_offset = offset;
        inputs.check();
        places.emplace_back(inputs, &scene);
        places.back().check_bodies();
      }
    if (offsets.empty())
      places.push_back(scene);
    return places;
  }

  std::vector<TableAxis> PadPlaces::axes() const
  {
    if (offsets.empty())
      return {};
    return {{entry, "Rail/Pad offset", offsets}};
  }

  std::optional<double> pad_offset_of(const PairSpec &scene)
  {
    return lies_on_pads(scene.rail)
             ? std::optional<double>(scene.rail.model.foundation.pad_offset)
             : std::optional<double>();
  }
} // namespace RollingContact
