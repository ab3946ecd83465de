#include <rolling_contact/mesh/cover_cells.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// elements through a cover under the contact
    const double least_elements = 6.;

    std::vector<double> upwards(std::vector<double> breaks)
    {
      std::reverse(breaks.begin(), breaks.end());
      return breaks;
    }

    /** The breaks of the core, and those of the cover above them. */
    std::vector<double> joined(std::vector<double>        core,
                               const std::vector<double> &cover)
    {
      core.insert(core.end(), cover.begin() + 1, cover.end());
      return core;
    }
  } // namespace

  std::vector<double> breaks_in_depth(const BodyShape   &shape,
                                      const CoarseCells &down,
                                      const double       n_elements)
  {
    const double depth = shape.thickness_below(),
                 cover = shape.cover_thickness();
    if (cover == 0.)
      return upwards(growing_parts(0., -depth, down));
    std::vector<double> of_cover = upwards(growing_parts(0., -cover, down));
    const unsigned int  least    = std::ceil(least_elements / n_elements);
    if (of_cover.size() < least + 1)
      of_cover = equal_parts(-cover, 0., least);
    return joined(upwards(growing_parts(-cover, -depth, down)), of_cover);
  }

  std::vector<double> equal_breaks_in_depth(const BodyShape &shape,
                                            const double     longest)
  {
    const double depth = shape.thickness_below(),
                 cover = shape.cover_thickness();
    const auto parts   = [&](const double begin, const double end) {
      return equal_parts(begin, end, fewest_parts(end - begin, longest));
    };
    return cover == 0. ? parts(-depth, 0.)
                       : joined(parts(-depth, -cover), parts(-cover, 0.));
  }
} // namespace RollingContact
