#include <rolling_contact/base/constants.h>
#include <rolling_contact/mesh/running_surfaces.h>
#include <rolling_contact/mesh/section_strip.h>
#include <rolling_contact/mesh/wheel_section_mesh.h>
#include <rolling_contact/mesh/wheel_web.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace RollingContact
{
  using Profiles::Outline;
  using Profiles::ProfileCurve;

  namespace
  {
    using Row = std::vector<SectionPoint>;

    /// the back of the flange begins so far below the tape circle, and a new
    /// one is straight up to there
    const double back_begin = -4 * mm, back_end = 9.5 * mm;

    /// where the strip under the surface turns into the rim, and the inner
    /// corner there: across, over the tape circle
    const Outline::Point flange_root{{-36.5 * mm, 8.4 * mm}},
      inner_root{{-43.5 * mm, -2 * mm}};

    /// of the flange's inside: its core's upper and lower end
    const Outline::Point flange_core{{-58 * mm, 15 * mm}},
      rim_core{{-61 * mm, -6 * mm}};

    const std::vector<Outline::Point> inner_line{{{-53 * mm, 14 * mm}},
                                                 {{-49.5 * mm, 7 * mm}},
                                                 {{-45 * mm, 0.}},
                                                 {{-39 * mm, -8 * mm}},
                                                 {{-31 * mm, -14.5 * mm}},
                                                 {{-20 * mm, -19 * mm}},
                                                 {{-5 * mm, -22 * mm}}};

    /// length across over which the inner line is not opposite the tread
    const double fading = 25 * mm, strip_depth = 22 * mm, largest_slope = 0.3;

    /// of the length between two points of the tread, between those under them
    const double least_room = 0.4;

    const unsigned int rim_rows = 3, web_columns = 4, hub_rows = 2,
                       hub_columns = 3;

    /**
     * Where a line that runs towards the field side reaches a place across.
     */
    double length_at(const Outline &line, const double across)
    {
      double lower = 0., upper = line.length();
      for (unsigned int round = 0; round < 60; ++round)
        {
          const double middle                           = (lower + upper) / 2;
          (line.at(middle)[0] < across ? lower : upper) = middle;
        }
      return upper;
    }

    class WheelMesher
    {
    public:
      WheelMesher(const PlacedProfile  &placed,
                  const RunningSurface &surface,
                  const WheelMeasures  &measures,
                  const double          rolling_radius,
                  const CoarseCells    &across,
                  const double          deepest);

      SectionMesh mesh();

    private:
      SectionPoint at(const double across, const double outwards) const
      {
        return {{across, outwards, rolling_radius}};
      }

      SectionPoint over_tape(const Outline::Point &point) const
      {
        return at(point[0], measures.radius + point[1]);
      }

      double slope(const unsigned int i) const;

      Outline back_of_flange() const;

      void add_tread();

      void add_flange();

      void add_rim();

      void add_web();

      void add_hub();

      Row web_row(const double outwards) const;

      const PlacedProfile  &placed;
      const RunningSurface &surface;
      const WheelMeasures   measures;
      const double          rolling_radius;
      std::vector<double>   breaks;
      unsigned int          root; ///< break
      double                rim_end;
      double                deepest; ///< cell of the strip
      unsigned int          strip_rows = 1;
      Row                   inner; ///< line of the strip
      Row                   web_at_rim, hub_of_web;
      SectionMesh           result;
    };

    WheelMesher::WheelMesher(const PlacedProfile  &placed,
                             const RunningSurface &surface,
                             const WheelMeasures  &measures,
                             const double          rolling_radius,
                             const CoarseCells    &across,
                             const double          deepest)
      : placed(placed)
      , surface(surface)
      , measures(measures)
      , rolling_radius(rolling_radius)
      , breaks(strip_breaks(surface.ends()[0], surface.ends()[1], across))
      , root(std::clamp<unsigned int>(
          nearest_break(breaks, surface.nearest(flange_root)),
          2,
          breaks.size() - 2))
      , rim_end(surface.at(surface.ends()[1])[0])
      , deepest(deepest)
    {}

    void WheelMesher::add_tread()
    {
      std::vector<Outline::Point> points = inner_line;
      points.push_back({{rim_end, -24 * mm}});
      const Outline      line(points);
      const double       corner = line.nearest(inner_root);
      const unsigned int n      = breaks.size() - 1;
      inner                     = {over_tape(flange_core)};
      for (unsigned int i = 1; i < root; ++i)
        inner.push_back(over_tape(line.at(corner * (i - 1) / (root - 1))));
      // under the tread along its normals, as skew cells are less accurate,
      // with what the corner is beside the root fading away
      const double root_across = surface.at(breaks[root])[0],
                   beside      = line.at(corner)[0] - root_across;
      double before            = line.at(corner)[0];
      for (unsigned int i = root; i < n; ++i)
        {
          const double across = surface.at(breaks[i])[0],
                       share =
                         std::max(0., 1 - (across - root_across) / fading),
                       to_side =
                         share * beside + (1 - share) * strip_depth * slope(i),
                       from_last =
                         i == root ? 0. : across - surface.at(breaks[i - 1])[0];
          // normals of a hollow tread would cross, and pass the rim's end
          before = std::clamp(across + to_side,
                              before + least_room * from_last,
                              rim_end - least_room * (rim_end - across));
          inner.push_back(over_tape(line.at(length_at(line, before))));
        }
      inner.push_back(over_tape(line.at(line.length())));
      const auto on_surface =
        [running = std::make_shared<const RunningSurface>(surface),
         radius  = measures.radius](const double c) {
          const auto   point = running->at(c);
          const double r     = radius + point[1];
          return SectionPoint{{point[0], r, r}};
        };
      strip_rows = rows_of_strip(breaks, inner, on_surface, deepest);
      add_strip(breaks, inner, on_surface, strip_rows, result);
    }

    /**
     * Slope of the tread at a break, positive where the radius grows towards
     * the field side.
     */
    double WheelMesher::slope(const unsigned int i) const
    {
      const double step = 0.5 * mm;
      const auto   here = surface.at(breaks[i] - step),
                 there  = surface.at(breaks[i] + step);
      return std::clamp((there[1] - here[1]) / (there[0] - here[0]),
                        -largest_slope,
                        largest_slope);
    }

    /**
     * From the rim to the tip of the flange, across and outwards.
     */
    Outline WheelMesher::back_of_flange() const
    {
      const auto                 &profile = placed.profile;
      const double                tip     = flange_tip(profile);
      std::vector<Outline::Point> points{
        {{measures.flange_back, measures.radius + back_begin}}};
      if (profile.at(0.).z > back_end + 0.1 * mm)
        points.push_back({{measures.flange_back, measures.radius + back_end}});
      for (std::size_t k = 0; k < profile.points().size(); ++k)
        if (profile.arc_lengths()[k] < tip)
          points.push_back(
            {{profile.points()[k].y, measures.radius + profile.points()[k].z}});
      const auto end = profile.at(tip);
      points.push_back({{end.y, measures.radius + end.z}});
      return Outline(points);
    }

    void WheelMesher::add_flange()
    {
      const Outline      back = back_of_flange();
      const unsigned int n    = root - 1;
      const Row          core =
        equal_parts(over_tape(rim_core), over_tape(flange_core), n);
      const SectionPoint tip = [&]() {
        const auto point = surface.at(breaks[0]);
        return SectionPoint{
          {point[0], measures.radius + point[1], measures.radius + point[1]}};
      }();
      // the radius of x goes over to that of the tip along the back
      const auto on_back =
        [back, tip, radius = rolling_radius](const double length) {
          const auto   point = back.at(length);
          const double t     = length / back.length();
          return SectionPoint{
            {point[0], point[1], (1 - t) * radius + t * tip[2]}};
        };
      for (unsigned int j = 0; j < n; ++j)
        {
          const double begin = back.length() * j / n,
                       end   = back.length() * (j + 1) / n;
          add_ring_cells(
            core[j],
            core[j + 1],
            [=](const double t) { return on_back(begin + t * (end - begin)); },
            strip_rows,
            result);
          result.add(
            {{core[j], inner[root - j], core[j + 1], inner[root - j - 1]}});
        }
    }

    void WheelMesher::add_rim()
    {
      Row top =
        equal_parts(at(measures.flange_back, measures.radius + back_begin),
                    over_tape(rim_core),
                    strip_rows);
      top.insert(top.end(), inner.begin() + root, inner.end());
      const unsigned int n = top.size() - 1;
      const auto [middle, half] =
        wheel_web(measures, placed.bow, measures.rim_inside);
      const double left = middle - half, right = middle + half;
      const double share =
        (left - measures.flange_back) / (rim_end - measures.flange_back);
      const unsigned int first =
        std::clamp<int>(std::lround(n * share), 1, n - 1 - web_columns);
      const unsigned int last = first + web_columns;
      std::vector<Row>   rows(rim_rows + 1);
      for (unsigned int i = 0; i <= n; ++i)
        {
          const auto part = [](const double a,
                               const double b,
                               const double k,
                               const double of) {
            return a + (b - a) * k / of;
          };
          const double across =
            i < first   ? part(measures.flange_back, left, i, first)
            : i <= last ? part(left, right, i - first, web_columns)
                        : part(right, rim_end, i - last, n - last);
          const SectionPoint low = at(across, measures.rim_inside);
          for (unsigned int j = 0; j <= rim_rows; ++j)
            rows[j].push_back(between(low, top[i], double(j) / rim_rows));
        }
      add_rows(rows, result);
      web_at_rim.assign(rows[0].begin() + first, rows[0].begin() + last + 1);
    }

    /**
     * Points of the web from side to side.
     */
    Row WheelMesher::web_row(const double outwards) const
    {
      const auto [middle, half] = wheel_web(measures, placed.bow, outwards);
      return equal_parts(at(middle - half, outwards),
                         at(middle + half, outwards),
                         web_columns);
    }

    void WheelMesher::add_web()
    {
      const std::vector<double> radii = radii_of_web(measures);
      std::vector<Row>          rows{web_at_rim};
      for (std::size_t j = 1; j < radii.size(); ++j)
        rows.push_back(web_row(radii[j]));
      add_rows(rows, result);
      hub_of_web = rows.back();
    }

    void WheelMesher::add_hub()
    {
      const SectionPoint left  = at(measures.hub_begin, measures.hub_outside),
                         right = at(measures.hub_end, measures.hub_outside);
      Row top = equal_parts(left, hub_of_web.front(), hub_columns);
      top.insert(top.end(), hub_of_web.begin() + 1, hub_of_web.end());
      const Row rest = equal_parts(hub_of_web.back(), right, hub_columns);
      top.insert(top.end(), rest.begin() + 1, rest.end());
      std::vector<Row> rows(hub_rows + 1);
      for (unsigned int j = 0; j <= hub_rows; ++j)
        for (const SectionPoint &point : top)
          rows[j].push_back(
            at(point[0],
               measures.bore +
                 (measures.hub_outside - measures.bore) * j / hub_rows));
      const unsigned int first = result.quads().size();
      add_rows(rows, result);
      for (unsigned int i = 0; i + 1 < top.size(); ++i)
        result.set_boundary(first + i,
                            rows[0][i],
                            rows[0][i + 1],
                            SectionBoundary::hub);
    }

    SectionMesh WheelMesher::mesh()
    {
      add_tread();
      add_flange();
      add_rim();
      add_web();
      add_hub();
      return std::move(result);
    }
  } // namespace

  WheelMeasures::WheelMeasures(const double radius, const double bore)
    : radius(radius)
    , bore(bore)
    , rim_inside(radius - rim_depth)
    , hub_outside(bore + hub_depth)
  {}

  SectionMesh wheel_section_mesh(const PlacedProfile  &placed,
                                 const RunningSurface &surface,
                                 const WheelMeasures  &measures,
                                 const double          rolling_radius,
                                 const CoarseCells    &across,
                                 const double          deepest)
  {
    return WheelMesher(
             placed, surface, measures, rolling_radius, across, deepest)
      .mesh();
  }
} // namespace RollingContact
