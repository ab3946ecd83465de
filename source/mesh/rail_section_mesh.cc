#include <rolling_contact/base/constants.h>
#include <rolling_contact/mesh/rail_section_mesh.h>
#include <rolling_contact/mesh/rail_web.h>
#include <rolling_contact/mesh/section_strip.h>
#include <rolling_contact/surfaces/rail_section.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace RollingContact
{
  using Profiles::Outline;
  using Profiles::rail_60e1_height;

  namespace
  {
    using Row = std::vector<SectionPoint>;

    /// where a corner of the core is opposite that of the head
    const Outline::Point head_corner{{31.6 * mm, 168.9 * mm}};

    /// of the core of the head; its columns are closer at the sides, by this,
    /// so that the strip's cells in the middle are nearly upright
    const double crowding  = 0.45;
    const double core_half = 20 * mm, core_bottom = 141 * mm,
                 core_top = 157 * mm;

    /// the middle of the neck between core and web
    const double neck_half = 15 * mm, neck_height = 132.5 * mm,
                 neck_on_outline = 0.62;

    /// of web and foot
    const double longest_web_cell = 5.5 * mm;
    const double web_top = RailWeb::top, web_bottom = RailWeb::bottom;

    SectionPoint at(const double across, const double up)
    {
      return {{across, up, 0.}};
    }

    SectionMesh::Curve curve_on(const Outline &line,
                                const double   begin,
                                const double   end,
                                const double   side)
    {
      return [=](const double t) {
        const auto point = line.at(begin + t * (end - begin));
        return at(side * point[0], point[1]);
      };
    }

    /** Points from head to foot that the parts of the mesh share. */
    class RailMesher
    {
    public:
      RailMesher(const RunningSurface &surface,
                 const CoarseCells    &across,
                 const double          deepest);

      SectionMesh mesh();

    private:
      void divide_sides(const CoarseCells &across);

      void add_head();

      void add_neck();

      void add_web();

      void add_foot();

      /**
       * Add the wings of the foot on both sides of its middle, whose bottom row
       * of points is @p sole.
       */
      void add_wings(const Row &sole);

      const RunningSurface &surface;
      const Outline         half;
      const RailWeb         web;
      double                deepest; ///< cell of the strip
      unsigned int          strip_rows = 1;
      std::vector<double>   breaks;
      unsigned int          first_corner, last_corner; ///< breaks
      std::vector<double>   columns; ///< of the core, from -1 to 1
      SectionMesh           result;
    };

    RailMesher::RailMesher(const RunningSurface &surface,
                           const CoarseCells    &across,
                           const double          deepest)
      : surface(surface)
      , half(Profiles::half_section_60e1())
      , web(half)
      , deepest(deepest)
    {
      divide_sides(across);
      for (unsigned int i = first_corner; i <= last_corner; ++i)
        {
          const double u = 2 * (breaks[i] - breaks[first_corner]) /
                             (breaks[last_corner] - breaks[first_corner]) -
                           1;
          columns.push_back(u + crowding * (u - u * u * u));
        }
    }

    /**
     * Breaks of the strip, as many at the one side of the head as at the other:
     * at that away from the contact they are no multiples of the size.
     */
    void RailMesher::divide_sides(const CoarseCells &across)
    {
      const auto ends   = surface.ends();
      breaks            = strip_breaks(ends[0], ends[1], across);
      const double drop = rail_60e1_height - head_corner[1];
      first_corner      = std::max(
        1u, nearest_break(breaks, surface.nearest({{-head_corner[0], drop}})));
      last_corner = std::min<unsigned int>(
        breaks.size() - 2,
        nearest_break(breaks, surface.nearest({{head_corner[0], drop}})));
      const unsigned int n_before = first_corner,
                         n_after  = breaks.size() - 1 - last_corner;
      if (n_before == n_after)
        return;
      const bool contact_before = -breaks[first_corner] < breaks[last_corner];
      const unsigned int  n     = contact_before ? n_before : n_after;
      std::vector<double> other;
      if (contact_before)
        {
          other = equal_parts(breaks[last_corner], ends[1], n);
          breaks.resize(last_corner);
          breaks.insert(breaks.end(), other.begin(), other.end());
        }
      else
        {
          other = equal_parts(ends[0], breaks[first_corner], n);
          breaks.erase(breaks.begin(), breaks.begin() + first_corner + 1);
          breaks.insert(breaks.begin(), other.begin(), other.end());
          last_corner += n - first_corner;
          first_corner = n;
        }
    }

    void RailMesher::add_head()
    {
      const unsigned int n = breaks.size() - 1, rows = first_corner;
      Row                inner;
      for (unsigned int i = 0; i <= n; ++i)
        if (i <= first_corner)
          inner.push_back(between(at(-core_half, core_bottom),
                                  at(-core_half, core_top),
                                  double(i) / first_corner));
        else if (i >= last_corner)
          inner.push_back(between(at(core_half, core_bottom),
                                  at(core_half, core_top),
                                  double(n - i) / (n - last_corner)));
        else
          inner.push_back(at(core_half * columns[i - first_corner], core_top));
      const auto on_surface = [running = std::make_shared<const RunningSurface>(
                                 surface)](const double c) {
        const auto point = running->at(c);
        return at(point[0], rail_60e1_height - point[1]);
      };
      strip_rows = rows_of_strip(breaks, inner, on_surface, deepest);
      add_strip(breaks, inner, on_surface, strip_rows, result);
      std::vector<Row> core;
      for (unsigned int j = 0; j <= rows; ++j)
        {
          core.emplace_back();
          for (const double column : columns)
            core.back().push_back(
              at(core_half * column,
                 core_bottom + (core_top - core_bottom) * j / rows));
        }
      add_rows(core, result);
    }

    void RailMesher::add_neck()
    {
      std::vector<Row> rows(3);
      for (const double column : columns)
        {
          rows[0].push_back(at(core_half * column, core_bottom));
          rows[1].push_back(at(neck_half * column, neck_height));
        }
      const Row top = web.row(web_top, columns, strip_rows);
      rows[2].assign(top.begin() + strip_rows, top.end() - strip_rows);
      add_rows(rows, result);
      const double begin =
                     half.nearest(Profiles::landmarks_60e1().lower_corner),
                   end = half.nearest({{web.half(web_top), web_top}});
      for (const double side : {-1., 1.})
        for (unsigned int k = 0; k < 2; ++k)
          {
            const double cut[3]{begin,
                                begin + neck_on_outline * (end - begin),
                                end};
            const auto   curve     = curve_on(half, cut[k], cut[k + 1], side);
            const auto   on_column = [&](const unsigned int row) {
              return side < 0 ? rows[row].front() : rows[row].back();
            };
            add_ring_cells(
              on_column(k), on_column(k + 1), curve, strip_rows, result);
          }
    }

    void RailMesher::add_web()
    {
      // where fillets begin and end, rows are ends of rows
      const std::vector<double> levels{
        web_top, 108 * mm, 92.37 * mm, 60.4 * mm, 44 * mm, web_bottom};
      std::vector<double> heights{levels[0]};
      for (std::size_t k = 1; k < levels.size(); ++k)
        {
          const auto part = equal_parts(levels[k - 1],
                                        levels[k],
                                        std::ceil((levels[k - 1] - levels[k]) /
                                                  longest_web_cell));
          heights.insert(heights.end(), part.begin() + 1, part.end());
        }
      for (std::size_t j = 1; j < heights.size(); ++j)
        {
          const double upper = heights[j - 1], lower = heights[j];
          const Row    above = web.row(upper, columns, strip_rows),
                    below    = web.row(lower, columns, strip_rows);
          for (std::size_t i = 0; i + 1 < above.size(); ++i)
            {
              const unsigned int quad =
                result.add({{below[i], below[i + 1], above[i], above[i + 1]}});
              const auto side_curve = [&](const double side) {
                return [side, lower, upper, outline = web](const double t) {
                  const double height = lower + t * (upper - lower);
                  return at(side * outline.half(height), height);
                };
              };
              if (i == 0)
                result.set_curve(quad,
                                 below.front(),
                                 above.front(),
                                 side_curve(-1.));
              if (i + 2 == above.size())
                result.set_curve(quad,
                                 below.back(),
                                 above.back(),
                                 side_curve(1.));
            }
        }
    }

    void RailMesher::add_foot()
    {
      const Row top  = web.row(web_bottom, columns, strip_rows);
      const Row sole = row_with_sides(
        at(-17 * mm, 0.), at(17 * mm, 0.), 8.5 * mm, columns, strip_rows);
      Row middle;
      for (std::size_t i = 0; i < top.size(); ++i)
        middle.push_back(between(top[i], sole[i], 0.5));
      for (std::size_t i = 0; i + 1 < top.size(); ++i)
        {
          const unsigned int quad =
            result.add({{sole[i], sole[i + 1], middle[i], middle[i + 1]}});
          result.set_boundary(quad, sole[i], sole[i + 1], SectionBoundary::hub);
        }
      add_rows({middle, top}, result);
      add_wings(sole);
    }

    void RailMesher::add_wings(const Row &sole)
    {
      const double first  = half.nearest({{web.half(web_bottom), web_bottom}}),
                   toe    = half.nearest({{74.2 * mm, 10.5 * mm}}),
                   edge   = half.nearest({{75 * mm, 5.5 * mm}}),
                   corner = half.nearest({{74.4 * mm, 0.6 * mm}});
      const std::vector<double> cut{first,
                                    half.nearest({{27 * mm, 21.7 * mm}}),
                                    half.nearest({{41 * mm, 16.6 * mm}}),
                                    half.nearest({{57 * mm, 12.8 * mm}}),
                                    toe};
      for (const double side : {-1., 1.})
        {
          const auto on_outline = [&](const double length) {
            return curve_on(half, length, length, side)(0.);
          };
          Row upper, lower{side < 0 ? sole.front() : sole.back()};
          for (const double length : cut)
            upper.push_back(on_outline(length));
          for (const double across : {27., 41., 57.})
            lower.push_back(at(side * across * mm, 0.));
          lower.push_back(on_outline(corner));
          for (unsigned int k = 0; k < 4; ++k)
            {
              const auto half_way = [&](const unsigned int i) {
                return i == 4 ? on_outline(edge)
                              : between(upper[i], lower[i], 0.5);
              };
              const SectionPoint m0 = half_way(k), m1 = half_way(k + 1);
              const unsigned int above = result.add(
                                   {{m0, m1, upper[k], upper[k + 1]}}),
                                 below = result.add(
                                   {{lower[k], lower[k + 1], m0, m1}});
              result.set_curve(above,
                               upper[k],
                               upper[k + 1],
                               curve_on(half, cut[k], cut[k + 1], side));
              result.set_boundary(below,
                                  lower[k],
                                  lower[k + 1],
                                  SectionBoundary::hub);
              if (k < 3)
                continue;
              result.set_curve(above,
                               upper[4],
                               m1,
                               curve_on(half, toe, edge, side));
              result.set_curve(below,
                               m1,
                               lower[4],
                               curve_on(half, edge, corner, side));
              result.set_curve(
                below,
                lower[3],
                lower[4],
                curve_on(half, half.nearest({{57 * mm, 0.}}), corner, side));
            }
        }
    }

    SectionMesh RailMesher::mesh()
    {
      add_head();
      add_neck();
      add_web();
      add_foot();
      return std::move(result);
    }
  } // namespace

  SectionMesh rail_section_mesh(const RunningSurface &surface,
                                const CoarseCells    &across,
                                const double          deepest)
  {
    return RailMesher(surface, across, deepest).mesh();
  }
} // namespace RollingContact
