#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/surfaces/filtered_record.h>

#include <algorithm>

using namespace RollingContact;

namespace
{
  const char entry[] = "Surfaces/Rail height";

  /** Written in m at its own spacing it must be read as the same. */
  void write_and_read(const SurfaceRecord &record)
  {
    std::string text = "position,height\n";
    double      size = 0.;
    for (std::size_t k = 0; k < record.heights.size(); ++k)
      {
        text += written(record.begin + k * record.spacing) + ',' +
                written(record.heights[k]) + '\n';
        size = std::max(size, std::abs(record.heights[k]));
      }
    write_part("again.csv", {text}, 0);
    const auto again = read_surface_record(entry, "again.csv", "", {1., 1.});
    must(again.heights.size() == record.heights.size(), "another size");
    for (std::size_t k = 0; k < record.heights.size(); ++k)
      must(std::abs(again.heights[k] + again.mean - record.heights[k]) <=
             1e-9 * size,
           "another height");
  }

  /** Filtered, as a rail's and as that of a wheel it goes once around. */
  void check_filtered(const SurfaceRecord &record)
  {
    const Signals::CutOff cut_off{4 * record.spacing, 2 * record.spacing};
    for (const double around : {0., record.end() - record.begin})
      {
        const FilteredRecord surface(record, cut_off, around);
        for (const double where : {-3.1, 0., 0.4, 1., 7.3})
          must(std::isfinite(surface.value(
                 record.begin + where * (record.end() - record.begin))),
               "the filtered surface is not finite");
        must(surface.rms <= highest_surface, "the filtered surface is high");
      }
  }
} // namespace

/** Parts: the text of the entry and of another one that names the units
 * (u: micrometres over millimetres), surface.csv. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  auto parts = input_parts(data, size);
  if (parts.size() < 3 || parts[0].find('/') != std::string::npos)
    return 0;
  write_part("surface.csv", parts, 2);
  const RecordUnits units =
    parts[1] == "u" ? RecordUnits{1e-3, 1e-6} : RecordUnits{1., 1.};
  SurfaceRecord record;
  try
    {
      record = read_surface_record(entry, parts[0], "", units);
    }
  catch (const InputError &error)
    {
      must_name(error, entry);
      return 0;
    }
  must(std::isfinite(record.begin) && std::isfinite(record.end()) &&
         record.spacing > 0.,
       "the positions are none");
  for (const double height : record.heights)
    must(std::abs(height) <= 2 * highest_surface, "a height is none");
  write_and_read(record);
  check_filtered(record);
  return 0;
}
