#include <Eigen/SparseCholesky>

#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/height_map.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::size_t least_along = 10, least_lines = 4;

    const double most_missing = 0.01; // of the points

    const double least_spacing = 1e-9, most_spacing = 1.; // m

    /** A point beside another one, and the weight of their difference. */
    struct Neighbour
    {
      std::size_t point;
      double      weight;
    };

    std::vector<Neighbour> neighbours(const MeasuredMap &map,
                                      const std::size_t  point)
    {
      const std::size_t      i = point % map.n_x, j = point / map.n_x;
      const double           along = 1., across = std::pow(map.dx / map.dy, 2);
      std::vector<Neighbour> found;
      if (i > 0)
        found.push_back({point - 1, along});
      if (i + 1 < map.n_x)
        found.push_back({point + 1, along});
      if (j > 0)
        found.push_back({point - map.n_x, across});
      if (j + 1 < map.n_y)
        found.push_back({point + map.n_x, across});
      return found;
    }

    void check_size_and_measured(const SurfaceFile &file,
                                 const MeasuredMap &map)
    {
      for (const double spacing : {map.dx, map.dy})
        if (map.n_x > 1 && map.n_y > 1 &&
            !(spacing >= least_spacing && spacing <= most_spacing))
          file.reject("its points are " + significant(spacing, 4) +
                      " m apart, 1e-9 to 1 m are taken. Check Surfaces/"
                      "Position unit, 1e-3 for millimetres, or the scales of "
                      "the file, in m.");
      if (map.n_x < least_along || map.n_y < least_lines)
        file.reject("it has " + std::to_string(map.n_x) + " points along by " +
                    std::to_string(map.n_y) + " across; " +
                    std::to_string(least_along) + " by " +
                    std::to_string(least_lines) + " are the least.");
      const auto n_missing =
        std::count_if(map.heights.begin(),
                      map.heights.end(),
                      [](const double height) { return std::isnan(height); });
      if (n_missing >= most_missing * map.heights.size())
        file.reject(std::to_string(n_missing) + " of its " +
                    std::to_string(map.heights.size()) +
                    " points were not measured (" +
                    significant(100. * n_missing / map.heights.size(), 2) +
                    " %); below 1 % are filled. Measure it anew, cut it or "
                    "fill it.");
    }

    /** Mean and slopes of the plane about the middle of the map. */
    std::array<double, 3> plane_of(const MeasuredMap &map)
    {
      std::array<double, 3> sums{}, squares{};
      const auto weight = [](const std::size_t k, const std::size_t n) {
        return k == 0 || k + 1 == n ? 0.5 : 1.;
      };
      for (std::size_t j = 0; j < map.n_y; ++j)
        for (std::size_t i = 0; i < map.n_x; ++i)
          {
            const double w = weight(i, map.n_x) * weight(j, map.n_y);
            const std::array<double, 3> shapes{
              {1.,
               map.dx * (i - (map.n_x - 1.) / 2),
               map.dy * (j - (map.n_y - 1.) / 2)}};
            for (unsigned int d = 0; d < 3; ++d)
              {
                sums[d] += w * shapes[d] * map.heights[j * map.n_x + i];
                squares[d] += w * shapes[d] * shapes[d];
              }
          }
      for (unsigned int d = 0; d < 3; ++d)
        sums[d] /= squares[d];
      return sums;
    }

    void take_plane_out(const std::array<double, 3> &plane, MeasuredMap &map)
    {
      for (std::size_t j = 0; j < map.n_y; ++j)
        for (std::size_t i = 0; i < map.n_x; ++i)
          map.heights[j * map.n_x + i] -=
            plane[0] + plane[1] * map.dx * (i - (map.n_x - 1.) / 2) +
            plane[2] * map.dy * (j - (map.n_y - 1.) / 2);
    }

    void check_heights_of_map(const SurfaceFile &file, const MeasuredMap &map)
    {
      const auto highest =
        std::max_element(map.heights.begin(),
                         map.heights.end(),
                         [](const double one, const double other) {
                           return std::abs(one) < std::abs(other);
                         });
      // it is written so that no number is refused as well
      if (std::abs(*highest) <= highest_surface)
        return;
      const std::size_t point = highest - map.heights.begin();
      file.reject(
        "a height of " + significant(*highest, 4) +
          " m about the plane, point " + std::to_string(point % map.n_x + 1) +
          " along and " + std::to_string(point / map.n_x + 1) +
          " across, is too large for a surface that a wheel rolls on (at most "
          "5e-3 m). Check Surfaces/Height unit, 1e-6 for micrometres, or the "
          "Zscale of an .sdf, in m.",
        map.text_lines.empty()     ? 0
        : map.a_text_line_is_one_x ? map.text_lines[point % map.n_x]
                                   : map.text_lines[point / map.n_x]);
    }

    void mirror(SurfaceRecord &record)
    {
      const std::size_t n = record.n_along();
      for (std::size_t j = 0; j < record.n_lines / 2; ++j)
        std::swap_ranges(record.heights.begin() + j * n,
                         record.heights.begin() + (j + 1) * n,
                         record.heights.end() - (j + 1) * n);
      record.first_line   = -record.last_line();
      record.slope_across = -record.slope_across;
    }
  } // namespace

  std::size_t fill_missing(MeasuredMap &map)
  {
    const std::size_t        none = map.heights.size();
    std::vector<std::size_t> unknowns, unknown_of(none, none);
    for (std::size_t point = 0; point < none; ++point)
      if (std::isnan(map.heights[point]))
        {
          unknown_of[point] = unknowns.size();
          unknowns.push_back(point);
        }
    if (unknowns.empty())
      return 0;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd                     known =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      for (const auto &[point, weight] : neighbours(map, unknowns[k]))
        {
          entries.emplace_back(k, k, weight);
          if (unknown_of[point] == none)
            known[k] += weight * map.heights[point];
          else
            entries.emplace_back(k, unknown_of[point], -weight);
        }
    Eigen::SparseMatrix<double> matrix(known.size(), known.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd filled =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(known);
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      map.heights[unknowns[k]] = filled[k];
    return unknowns.size();
  }

  SurfaceRecord
  surface_of_map(const SurfaceFile &file, MeasuredMap map, const bool stands)
  {
    check_size_and_measured(file, map);
    SurfaceRecord record;
    record.n_interpolated = fill_missing(map);
    const auto plane      = plane_of(map);
    take_plane_out(plane, map);
    check_heights_of_map(file, map);
    record.mean         = plane[0];
    record.slope_along  = plane[1];
    record.slope_across = plane[2];
    record.spacing      = map.dx;
    record.line_spacing = map.dy;
    record.n_lines      = map.n_y;
    record.begin        = map.x;
    record.first_line   = map.y;
    if (!map.has_places)
      {
        record.begin      = stands ? -map.dx * (map.n_x - 1.) / 2 : 0.;
        record.first_line = -map.dy * (map.n_y - 1.) / 2;
      }
    record.heights = std::move(map.heights);
    if (file.source.mirrored)
      mirror(record);
    return record;
  }
} // namespace RollingContact
