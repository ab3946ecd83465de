#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/surfaces/filtered_record.h>

#include <algorithm>

using namespace RollingContact;

namespace
{
  const char entry[] = "Surfaces/Rail height";

  /** Written in m at its own spacing it must be read as the same, a line and a
   * map. */
  void write_and_read(const SurfaceRecord &record)
  {
    std::string text = record.is_map() ? "x" : "position,height";
    double      size = 0.;
    for (std::size_t j = 0; record.is_map() && j < record.n_lines; ++j)
      text += ',' + written(record.first_line + j * record.line_spacing);
    for (std::size_t k = 0; k < record.n_along(); ++k)
      {
        text += '\n' + written(record.begin + k * record.spacing);
        for (std::size_t j = 0; j < record.n_lines; ++j)
          {
            const double height = record.heights[j * record.n_along() + k];
            text += ',' + written(height);
            size = std::max(size, std::abs(height));
          }
      }
    write_part("again.csv", {text + '\n'}, 0);
    const auto again = read_surface_record(
      entry, record.is_map() ? "grid: again.csv" : "again.csv", "", {1., 1.});
    must(again.heights.size() == record.heights.size() &&
           again.n_lines == record.n_lines,
         "another size");
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
                 record.begin + where * (record.end() - record.begin),
                 record.first_line + where * record.line_spacing)),
               "the filtered surface is not finite");
        must(surface.rms <= highest_surface, "the filtered surface is high");
      }
  }
} // namespace

/** Parts: the text of the entry and of another one that names the units
 * (u: micrometres over millimetres), the file: surface.csv, .sdf or .h5. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  auto parts = input_parts(data, size);
  if (parts.size() < 3 || parts[0].find('/') != std::string::npos)
    return 0;
  for (const std::string ending : {"csv", "sdf", "h5"})
    write_part("surface." + ending, parts, 2);
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
  // single slopes of a map's line may be steeper than those of a record
  if (parts[0].find("middle line:") == std::string::npos)
    write_and_read(record);
  check_filtered(record);
  return 0;
}
