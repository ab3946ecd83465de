#include <rolling_contact/modes/section_outline.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /** The point of an edge of a quadrilateral at 0 to 1. */
    SectionPoint on_edge(const SectionMesh &section,
                         const unsigned int quad,
                         const unsigned int edge,
                         const double       t)
    {
      return edge < 2 ? section.at(quad, edge, t)
                      : section.at(quad, t, edge - 2.);
    }
  } // namespace

  std::vector<OutlinePoint> outline_of(const SectionMesh &section,
                                       const unsigned int parts)
  {
    const auto ends = [&](const unsigned int quad, const unsigned int edge) {
      auto result = section.ends_of_edge(quad, edge);
      std::sort(result.begin(), result.end());
      return result;
    };
    std::map<std::array<unsigned int, 2>, unsigned int> n_quads;
    const unsigned int n = section.quads().size();
    for (unsigned int quad = 0; quad < n; ++quad)
      for (unsigned int edge = 0; edge < 4; ++edge)
        ++n_quads[ends(quad, edge)];
    std::vector<OutlinePoint> outline;
    const double              gauss = std::sqrt(1. / 3);
    for (unsigned int quad = 0; quad < n; ++quad)
      for (unsigned int edge = 0; edge < 4; ++edge)
        if (n_quads.at(ends(quad, edge)) == 1 &&
            section.quads()[quad].boundary[edge] != SectionBoundary::hub)
          for (unsigned int part = 0; part < parts; ++part)
            {
              const double       h     = 1. / parts;
              const SectionPoint begin = on_edge(section, quad, edge, part * h),
                                 end =
                                   on_edge(section, quad, edge, (part + 1) * h);
              const double along_0 = end[0] - begin[0],
                           along_1 = end[1] - begin[1],
                           length  = std::hypot(along_0, along_1);
              for (const double at : {-gauss, gauss})
                outline.push_back(
                  {on_edge(section, quad, edge, (part + 0.5 + at / 2) * h),
                   {{-along_1 / length, along_0 / length}},
                   length / 2});
            }
    return outline;
  }
} // namespace RollingContact
