#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"
#include "time_run.h"
#include <hdf5.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/surfaces/filtered_record.h>
#include <rolling_contact/surfaces/height_expression.h>
#include <rolling_contact/surfaces/height_map.h>
#include <rolling_contact/surfaces/record_notes.h>

#include <cmath>
#include <random>
#include <set>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(height_maps)

namespace
{
  const char entry[] = "Surfaces/Rail height";

  using Height = std::function<double(const double, const double)>;

  /** Points of a map: places and numbers along x and y. */
  struct Grid
  {
    double      x, y, dx, dy;
    std::size_t n_x, n_y;

    double x_of(const std::size_t i) const
    {
      return x + dx * i;
    }

    double y_of(const std::size_t j) const
    {
      return y + dy * j;
    }

    /** One whose middle is at (0, 0). */
    static Grid about_0(const double      dx,
                        const double      dy,
                        const std::size_t n_x,
                        const std::size_t n_y)
    {
      return {-dx * (n_x - 1.) / 2, -dy * (n_y - 1.) / 2, dx, dy, n_x, n_y};
    }
  };

  /** Text of a file after ISO 25178-71. */
  std::string sdf_of(const Grid &grid, const Height &height)
  {
    std::ostringstream text;
    text.precision(17);
    text << "aISO-1.0\nManufacID = none\nNumPoints = " << grid.n_x
         << "\nNumProfiles = " << grid.n_y << "\nXscale = " << grid.dx
         << "\nYscale = " << grid.dy
         << "\nZscale = 1e-6\nCompression = 0\nCheckType = 0\n*\n";
    for (std::size_t j = 0; j < grid.n_y; ++j)
      {
        for (std::size_t i = 0; i < grid.n_x; ++i)
          text << 1e6 * height(grid.x_of(i), grid.y_of(j)) << ' ';
        text << '\n';
      }
    text << "*\n<OperatorName> A </OperatorName>\n*\n";
    return text.str();
  }

  /** Text of a grid: y in the first row, x in the first column. */
  std::string grid_of(const Grid &grid, const Height &height)
  {
    std::ostringstream text;
    text.precision(17);
    text << "x_m";
    for (std::size_t j = 0; j < grid.n_y; ++j)
      text << ", " << grid.y_of(j);
    for (std::size_t i = 0; i < grid.n_x; ++i)
      {
        text << '\n' << grid.x_of(i);
        for (std::size_t j = 0; j < grid.n_y; ++j)
          text << ", " << height(grid.x_of(i), grid.y_of(j));
      }
    text << '\n';
    return text.str();
  }

  /** Write a dataset of lines across with its spacings. */
  void write_hdf5(const std::filesystem::path &file,
                  const Grid                  &grid,
                  const Height                &height,
                  const double                 x_spacing)
  {
    std::vector<double> values;
    for (std::size_t j = 0; j < grid.n_y; ++j)
      for (std::size_t i = 0; i < grid.n_x; ++i)
        values.push_back(height(grid.x_of(i), grid.y_of(j)));
    const hsize_t sizes[]{grid.n_y, grid.n_x};
    const hid_t   made =
      H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space  = H5Screate_simple(2, sizes, nullptr),
                scalar = H5Screate(H5S_SCALAR);
    const hid_t set    = H5Dcreate2(made,
                                 "/scan",
                                 H5T_NATIVE_DOUBLE,
                                 space,
                                 H5P_DEFAULT,
                                 H5P_DEFAULT,
                                 H5P_DEFAULT);
    H5Dwrite(
      set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    for (const auto &[name, value] :
         {std::pair("x_spacing", x_spacing), std::pair("y_spacing", grid.dy)})
      {
        const hid_t attribute = H5Acreate2(
          set, name, H5T_NATIVE_DOUBLE, scalar, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
        H5Aclose(attribute);
      }
    H5Dclose(set);
    H5Sclose(scalar);
    H5Sclose(space);
    H5Fclose(made);
  }

  struct Maps : public ScratchFolder
  {
    SurfaceRecord read_map(const std::string &name,
                           const std::string &text,
                           const std::string &named  = "",
                           const RecordUnits &units  = {},
                           const bool         stands = false) const
    {
      write(scratch / name, text);
      return read_surface_record(
        entry, named.empty() ? name : named, scratch, units, stands);
    }

    std::string complaint_of(const std::string &name,
                             const std::string &text,
                             const std::string &named = "") const
    {
      return complaint([&]() { read_map(name, text, named); });
    }

    /** A wheel on a straight rail, with a map in a file. */
    SceneParameters scene_with(const std::string &name, const std::string &text)
    {
      write(scratch / name, text);
      SceneParameters scene;
      scene.dimension           = 3;
      scene.prm_folder          = scratch;
      scene.contact.normal_load = 100e3;
      scene.rail.shape          = "block";
      scene.rail.radius         = 0.;
      scene.rail.lateral_radius = 0.3;
      return scene;
    }
  };

  const Grid small = Grid::about_0(1e-4, 2e-4, 21, 11);

  /** A bump that is no mirror image of itself, 1 um high. */
  double bump(const double x, const double y)
  {
    return 1e-6 * std::exp(-std::pow((x - 3e-4) / 5e-4, 2) -
                           std::pow((y - 4e-4) / 6e-4, 2));
  }

  double largest_difference(const std::vector<double> &one,
                            const std::vector<double> &other)
  {
    BOOST_TEST_REQUIRE(one.size() == other.size());
    double largest = 0.;
    for (std::size_t k = 0; k < one.size(); ++k)
      largest = std::max(largest, std::abs(one[k] - other[k]));
    return largest;
  }
} // namespace

/** The three kinds of files hold the same; units, places, marks, names. */
BOOST_FIXTURE_TEST_CASE(maps_are_read_from_three_kinds_of_files, Maps)
{
  const auto record = read_map("map.sdf", sdf_of(small, bump));
  BOOST_TEST(record.n_along() == 21u);
  BOOST_TEST(record.n_lines == 11u);
  BOOST_TEST(record.begin == 0.);
  BOOST_TEST(std::abs(record.first_line + 1e-3) < 1e-18);
  BOOST_TEST(std::abs(record.line_spacing - 2e-4) < 1e-18);
  const double x = small.x_of(4), y = small.y_of(7);
  const double plane =
    record.mean + record.slope_along * x + record.slope_across * y;
  BOOST_TEST(std::abs(record.heights[7 * 21 + 4] + plane - bump(x, y)) < 1e-20);
  BOOST_TEST(record.mean > 1e-8);
  BOOST_TEST(std::abs(record.slope_across) > 1e-6);

  const auto grid = read_map("map.csv", grid_of(small, bump), "grid: map.csv");
  BOOST_TEST(std::abs(grid.begin + 1e-3) < 1e-18);
  BOOST_TEST(largest_difference(grid.heights, record.heights) < 1e-20);
  // without what stands over the x; in mm and um
  std::string bare =
    grid_of({-1., -1., 0.1, 0.2, 21, 11}, [](const double x, const double y) {
      return 1e6 * bump(1e-3 * x, 1e-3 * y);
    });
  bare.erase(0, bare.find(',') + 1);
  const auto other =
    read_map("other.csv", bare, "grid: other.csv", {1e-3, 1e-6});
  BOOST_TEST(largest_difference(other.heights, record.heights) < 1e-20);
  BOOST_TEST(std::abs(other.spacing - 1e-4) < 1e-18);

  write_hdf5(scratch / "map.h5", small, bump, small.dx);
  const auto hdf5 =
    read_surface_record(entry, "map.h5:/scan", scratch, {}, true);
  BOOST_TEST(std::abs(hdf5.begin + 1e-3) < 1e-18);
  BOOST_TEST(largest_difference(hdf5.heights, record.heights) < 1e-20);
  BOOST_TEST(hdf5.fingerprint() != record.fingerprint());

  std::string windows = sdf_of(small, bump);
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos;
       at += 2)
    windows.replace(at, 1, "\r\n");
  BOOST_TEST(largest_difference(read_map("windows.sdf", windows).heights,
                                record.heights) < 1e-25);
  BOOST_TEST(names_a_record("a b.SDF"));
  BOOST_TEST(names_a_record("mirrored: x"));
  BOOST_TEST(!names_a_record("1e-6*cos(x)"));
  BOOST_TEST(names_a_map("a.hdf5:/b"));
  BOOST_TEST(!names_a_map("middle line: a.sdf"));
  BOOST_TEST(!names_a_map("a.csv"));
}

/** Planes go, and whole waves have no mean. */
BOOST_FIXTURE_TEST_CASE(planes_are_taken_out, Maps)
{
  const auto plane =
    read_map("plane.sdf", sdf_of(small, [](const double x, const double y) {
               return 3e-6 + 0.01 * x - 0.02 * y;
             }));
  BOOST_TEST(plane.mean == 3e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(plane.slope_along == 0.01, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(plane.slope_across == -0.02, boost::test_tools::tolerance(1e-12));
  for (const double height : plane.heights)
    BOOST_TEST(std::abs(height) < 1e-19);
  const auto wave =
    read_map("wave.sdf", sdf_of(small, [](const double x, const double y) {
               return 1e-6 * std::cos(2e3 * pi * x) +
                      2e-6 * std::cos(1e3 * pi * (y - 1e-3));
             }));
  BOOST_TEST(std::abs(wave.mean) < 1e-20);
  BOOST_TEST(std::abs(wave.slope_along) < 1e-15);
}

/** The other way round across; its line next to y = 0 alone. */
BOOST_FIXTURE_TEST_CASE(maps_are_mirrored_or_cut, Maps)
{
  const std::string text = grid_of(small, bump);
  const auto        map  = read_map("map.csv", text, "grid: map.csv"),
             mirrored    = read_map("map.csv", text, "mirrored: grid: map.csv"),
             line = read_map("map.csv", text, "middle line: grid: map.csv");
  BOOST_TEST(mirrored.first_line == map.first_line,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mirrored.slope_across == -map.slope_across);
  for (std::size_t j = 0; j < 11; ++j)
    for (std::size_t i = 0; i < 21; ++i)
      BOOST_TEST(mirrored.heights[j * 21 + i] ==
                 map.heights[(10 - j) * 21 + i]);
  BOOST_TEST(!line.is_map());
  BOOST_TEST_REQUIRE(line.heights.size() == 21u);
  double sum = 0.;
  for (std::size_t i = 0; i < 21; ++i)
    {
      sum += line.heights[i];
      BOOST_TEST(std::abs(line.heights[i] - line.heights[0] -
                          (map.heights[5 * 21 + i] - map.heights[5 * 21])) <
                 1e-20);
    }
  BOOST_TEST(std::abs(sum) < 1e-18);
  const auto said = complaint_of("map.csv", text, "middle line: map.csv");
  BOOST_TEST(contains(said, "stand in front of a map"), said);
  Grid beside      = small;
  beside.y         = 1e-3;
  const auto aside = complaint_of("map.csv",
                                  grid_of(beside, bump),
                                  "middle line: grid: map.csv");
  BOOST_TEST(contains(aside, "from y = 0.001 to 0.003 m: none is at y = 0"),
             aside);
}

/** Linear heights come back exactly, others as their harmonic mean. */
BOOST_AUTO_TEST_CASE(missing_points_are_filled_from_around)
{
  MeasuredMap map;
  map.n_x           = 30;
  map.n_y           = 20;
  map.dx            = 1e-4;
  map.dy            = 2.5e-4;
  const auto height = [](const std::size_t i, const std::size_t j) {
    return 1e-6 * (1. + 0.3 * i - 0.2 * j);
  };
  for (std::size_t j = 0; j < 20; ++j)
    for (std::size_t i = 0; i < 30; ++i)
      map.heights.push_back(height(i, j));
  const std::vector<std::array<std::size_t, 2>> holes{
    {5, 7}, {6, 7}, {6, 8}, {7, 8}, {20, 3}};
  for (const auto &[i, j] : holes)
    map.heights[j * 30 + i] = not_measured;
  BOOST_TEST(fill_missing(map) == holes.size());
  for (const auto &[i, j] : holes)
    BOOST_TEST(map.heights[j * 30 + i] == height(i, j),
               boost::test_tools::tolerance(1e-12));
  BOOST_TEST(fill_missing(map) == 0u);
  // neighbours count by how near they are: one of four across stands out
  map.heights[2 * 30 + 20] += 1e-6;
  map.heights[3 * 30 + 20] = not_measured;
  fill_missing(map);
  const double across = std::pow(1e-4 / 2.5e-4, 2);
  BOOST_TEST(map.heights[3 * 30 + 20] - height(20, 3) ==
               1e-6 * across / (2 + 2 * across),
             boost::test_tools::tolerance(1e-9));
  // at a corner of the map
  map.heights[0] = not_measured;
  fill_missing(map);
  BOOST_TEST(map.heights[0] ==
               (height(1, 0) + across * height(0, 1)) / (1 + across),
             boost::test_tools::tolerance(1e-12));
}

/** Few are filled, and said; from 1 % on they are refused. */
BOOST_FIXTURE_TEST_CASE(many_missing_points_are_refused, Maps)
{
  std::string text =
    sdf_of(small, [](const double, const double) { return 2e-6; });
  const auto miss = [&]() {
    const std::string mark = "2 2 ";
    text.replace(text.rfind(mark), mark.size(), "BAD 2 ");
  };
  miss();
  miss();
  const auto record = read_map("map.sdf", text);
  BOOST_TEST(record.n_interpolated == 2u);
  BOOST_TEST(record.mean == 2e-6, boost::test_tools::tolerance(1e-12));
  miss();
  const auto said = complaint_of("map.sdf", text);
  BOOST_TEST(contains(said, "3 of its 231 points were not measured (1.3 %)"),
             said);
}

/** What is wrong is named with its line. */
BOOST_FIXTURE_TEST_CASE(bad_maps_are_refused_by_their_line, Maps)
{
  const std::string sdf = sdf_of(small, bump);
  const auto        with =
    [](std::string text, const std::string &old, const std::string &other) {
      const auto at = text.find(old);
      BOOST_TEST_REQUIRE(at != std::string::npos, old);
      return text.replace(at, old.size(), other);
    };
  const auto refused = [&](const std::string &text, const std::string &part) {
    const std::string said = complaint_of("map.sdf", text);
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "Surfaces/Rail height = map.sdf: \""), said);
  };
  BOOST_TEST(complaint_of("map.sdf", sdf) == "");
  refused("", "\"\" is no beginning of a file after ISO 25178-71");
  refused(with(sdf, "aISO", "bISO"), "line 1: it is binary");
  refused(with(sdf, "aISO", "xISO"), "line 1: \"xISO-1.0\" is no beginning");
  refused(with(sdf, "Xscale = 0.0001", "Xscale = 0"), "line 5: Xscale = 0: it");
  refused(with(sdf, "Xscale = 0.0001", "Xscale = nan"), "line 5: Xscale = nan");
  refused(with(sdf, "Xscale = 0.0001", "Xscale = 1e300"),
          "its points are 1e+300 m apart, 1e-9 to 1 m are taken");
  refused(with(sdf, "Zscale = 1e-6", "Zscale = -1"), "line 7: Zscale = -1");
  refused(with(sdf, "Yscale", "Wscale"), "line 10: the header has no Yscale");
  refused(with(sdf, "NumPoints = 21", "NumPoints = 2.5"), "line 3: NumPoints");
  refused(with(sdf, "NumPoints = 21", "NumPoints = 99999999999999"),
          "99999999999999 times 11 points; at most 16777216");
  refused(with(sdf, "NumPoints = 21", "NumPoints = 22"),
          "line 22: there are 231 heights, and NumPoints times NumProfiles are "
          "22 times 11");
  refused(with(sdf, "NumPoints = 21", "NumPoints = 20"),
          "line 21: there are more heights");
  refused(with(sdf, "NumPoints = 21", "NumPoints = 21\nNumPoints = 21"),
          "line 4: NumPoints is given twice");
  refused(with(sdf, "Compression = 0", "Compression = 1"),
          "line 8: Compression = 1: only 0");
  refused(with(sdf, "ManufacID = none", "garbage"), "line 2: \"garbage\"");
  refused(sdf.substr(0, 90), "it ends within the header: it is cut off");
  refused(sdf.substr(0, sdf.find("\n*\n<Op")), "it ends without a line of *");
  refused(with(sdf, "*\n", "*\nnan "), "line 11: \"nan\" is no finite height");
  refused(with(sdf, "Zscale = 1e-6", "Zscale = 1"),
          "m about the plane, point 14 along and 8 across, is too large for "
          "a surface");
  refused(sdf_of({0., 0., 1e-4, 1e-4, 9, 30}, bump), "10 by 4 are the least");

  const std::string grid = grid_of(small, bump);
  const auto no_grid = [&](const std::string &text, const std::string &part) {
    const std::string said = complaint_of("map.csv", text, "grid: map.csv");
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "Surfaces/Rail height = grid: map.csv: \""),
               said);
  };
  no_grid("", "it has 0 points along by 0 across");
  no_grid(with(grid, "-0.001, ", ""), "line 2: it has 12 cells");
  no_grid(with(grid, "-0.001", "here"), "line 1: \"here\" is no finite y");
  no_grid(with(grid, "\n-0.001", "\nthere"),
          "line 2: \"there\" is no finite x");
  no_grid(with(grid, "\n-0.001", "\n-0.0009"), "line 3: x does not rise");
  no_grid(with(grid, "\n-0.001", "\n-0.00105"), "line 3: x = ");
  no_grid(with(grid, ", -0.00080000000000000004", ", -0.0007"),
          "line 1: y = -0.0007 is not where points of equal spacing are");
  no_grid(with(grid, "\n0.001", "\ninf"), "is no finite x");
  no_grid(grid + "0.0011, 1, 2\n", "line 23: it has 3 cells");
  no_grid(with(grid, "\n-0.001, ", "\n-0.001, 1, "), "line 2: it has 13 cells");
  no_grid(grid_of(small,
                  [](const double x, const double y) {
                    return x < -9.5e-4 && y < -9e-4 ? 1. : 0.;
                  }),
          "line 2: a height of ");
  no_grid(with(grid, "\n-0.001,", "\n-0.001, NaN,"), "line 2: it has 13 cells");

  write_hdf5(scratch / "map.h5", small, bump, 0.);
  const auto no_set = [&](const std::string &name, const std::string &part) {
    const auto said =
      complaint([&]() { read_surface_record(entry, name, scratch, {}); });
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "Surfaces/Rail height = " + name + ": \""), said);
  };
  no_set("map.h5:/scan", "/scan: x_spacing = 0 m: it is above 0");
  no_set("map.h5:/other", "/other: there is no such array");
  no_set("map.csv.h5:/scan", "there is no such file");
  write(scratch / "text.h5", sdf);
  no_set("text.h5:/scan", "is no file of HDF5");
  write_hdf5(
    scratch / "inf.h5",
    small,
    [](const double x, const double) { return 1 / (x * 0.); },
    1e-4);
  no_set("inf.h5:/scan", "/scan has infinite heights");
}

/** Cut, changed or with bytes of anything a file is read or refused; no other
 * exception leaves. */
BOOST_FIXTURE_TEST_CASE(mutated_maps_never_crash, Maps)
{
  std::mt19937          random(7);
  const std::string     parts[]{"nan",
                                "inf",
                                "-1",
                                "0",
                                "1e308",
                                "99999999999",
                                "*",
                                "=",
                                "\n",
                                ",",
                                "BAD",
                                "\xff\xfe",
                                std::string("\0", 1),
                                "1e-400"};
  std::set<std::string> said_of;
  unsigned int          n_refused = 0, n = 0;
  write_hdf5(scratch / "map.h5", small, bump, small.dx);
  for (const auto &[name, text, named] :
       {std::tuple<std::string, std::string, std::string>("map.sdf",
                                                          sdf_of(small, bump),
                                                          "map.sdf"),
        {"map.csv", grid_of(small, bump), "grid: map.csv"},
        {"map.h5", read(scratch / "map.h5"), "map.h5:/scan"}})
    for (unsigned int k = 0; k < 200; ++k)
      {
        std::string mutant = text;
        const auto  at     = random() % text.size();
        switch (k % 5)
          {
            case 0:
              mutant.resize(at);
              break;
            case 1:
              mutant[at] = static_cast<char>(random());
              break;
            case 2:
              mutant.insert(at, parts[random() % std::size(parts)]);
              break;
            case 3:
              mutant.erase(at, random() % 40);
              break;
            default:
              mutant.replace(at, 3, parts[random() % std::size(parts)]);
          }
        std::string said;
        BOOST_REQUIRE_NO_THROW(said = complaint_of(name, mutant, named));
        ++n;
        if (said.empty())
          continue;
        ++n_refused;
        BOOST_TEST(contains(said, named + ": \""), said);
        said_of.insert(said.substr(said.rfind(':')));
      }
  BOOST_TEST_MESSAGE(n_refused << " of " << n << " mutants were refused, for "
                               << said_of.size() << " reasons");
  BOOST_TEST(n_refused > 150u);
  BOOST_TEST(said_of.size() > 20u);
}

/** Waves pass by their length in any direction, counted in elements; what the
 * filter took and the slopes of what is left are told. */
BOOST_FIXTURE_TEST_CASE(maps_are_filtered_in_both_directions, Maps)
{
  // whole waves of mirror images: 6.4 mm by 4.8 mm
  const Grid grid = Grid::about_0(5e-5, 5e-5, 129, 97);
  const auto wave = [&](const unsigned int k, const unsigned int l) {
    return [k, l](const double x, const double y) {
      return 1e-6 * std::cos(pi * k * (x + 3.2e-3) / 6.4e-3) *
             std::cos(pi * l * (y + 2.4e-3) / 4.8e-3);
    };
  };
  const double          stretch = 1.5;
  const Signals::CutOff cut_off{4e-4, 2e-4};
  for (const auto &[k, l] : {std::pair(10u, 0u),
                             {0u, 12u},
                             {30u, 10u},
                             {40u, 0u},
                             {0u, 22u},
                             {12u, 30u},
                             {33u, 17u}})
    {
      const SurfaceRecord record =
        read_map("map.sdf", sdf_of(grid, wave(k, l)));
      const FilteredRecord filtered(record, cut_off, 0., stretch);
      const double         a = k / 12.8e-3, b = l / 9.6e-3;
      const double         gain = cut_off.gain(std::hypot(a, stretch * b));
      const double         left =
        1e-6 * (k > 0 ? std::sqrt(0.5) : 1.) * (l > 0 ? std::sqrt(0.5) : 1.);
      // at the points to rounding, with half the weight at borders
      double worst = 0.;
      for (std::size_t j = 0; j < grid.n_y; ++j)
        for (std::size_t i = 0; i < grid.n_x; ++i)
          worst =
            std::max(worst,
                     std::abs(
                       filtered.value(record.begin + i * 5e-5, grid.y_of(j)) +
                       gain * record.mean -
                       gain * wave(k, l)(grid.x_of(i), grid.y_of(j))));
      BOOST_TEST(worst < 2e-20);
      BOOST_TEST(std::abs(filtered.removed_rms - (1 - gain) * left) <
                 0.02 * left);
      BOOST_TEST(
        std::abs(filtered.rms_slope - gain * 2 * pi * std::hypot(a, b) * left) <
        0.06 * 2 * pi * std::hypot(a, b) * left);
    }
}

/** The spline's error falls as the fourth power of the spacing; what is beyond
 * the kept lines needs no memory and changes nothing. */
BOOST_FIXTURE_TEST_CASE(maps_are_smooth_between_points, Maps)
{
  const auto wave = [](const double x, const double y) {
    return 1e-6 * std::cos(2 * pi * (x + 3.2e-3) / 3.2e-3) *
           std::cos(2 * pi * (y + 2.4e-3) / 2.4e-3);
  };
  double before = 0.;
  for (const std::size_t n : {16, 32, 64})
    {
      const double step = 6.4e-3 / n;
      const Grid   grid = Grid::about_0(step, step, n + 1, 3 * n / 4 + 1);
      const FilteredRecord filtered(read_map("map.csv",
                                             grid_of(grid, wave),
                                             "grid: map.csv"),
                                    {2.1 * step, 1.05 * step},
                                    0.);
      FilteredRecord       strip = filtered;
      strip.keep_across(-0.4e-3, 0.3e-3);
      double worst = 0.;
      for (double y = -0.4e-3; y < 0.3e-3; y += 0.037e-3)
        for (double x = -3.2e-3; x < 3.2e-3; x += 0.041e-3)
          {
            worst =
              std::max(worst, std::abs(filtered.value(x, y) - wave(x, y)));
            BOOST_TEST(strip.value(x, y) == filtered.value(x, y));
          }
      BOOST_TEST_MESSAGE(n / 2 << " points a wave along: " << worst / 1e-6
                               << " of the amplitude off");
      if (before > 0.)
        BOOST_TEST(std::log2(before / worst) > 3.8);
      before = worst;
    }
  BOOST_TEST(before < 1e-6 * 2e-5);
}

/** A map that goes once around a wheel comes again along, not across. */
BOOST_FIXTURE_TEST_CASE(a_map_of_a_turn_comes_again, Maps)
{
  const double turn   = 0.12;
  const auto   height = [&](const double x, const double y) {
    return 1e-6 * std::sin(6 * pi * x / turn) * std::cos(pi * y / 4e-3) +
           1e-6 * std::cos(2 * pi * x / turn);
  };
  for (const std::size_t n : {240, 241})
    {
      const SurfaceRecord record =
        read_map("map.csv",
                 grid_of({0., -4e-3, 5e-4, 5e-4, n, 17}, height),
                 "grid: map.csv");
      const FilteredRecord filtered(record, {2e-3, 1e-3}, turn);
      BOOST_TEST(filtered.is_periodic());
      for (const double x : {0.0007, 0.0412, 0.1198})
        for (const double y : {-1.3e-3, 0., 2.2e-3})
          {
            BOOST_TEST(std::abs(filtered.value(x, y) -
                                filtered.value(x + 2 * turn, y)) < 1e-18);
            // the slope of a turn comes back; a point more has little mean
            BOOST_TEST(std::abs(filtered.value(x, y) - height(x, y)) < 6e-9);
          }
    }
}

/** Lines of a turn that do not meet are warned of, not steps between lines. */
BOOST_FIXTURE_TEST_CASE(the_ends_of_each_line_meet, Maps)
{
  for (const double drift : {0., 30e-6})
    {
      const auto record =
        read_map("map.csv",
                 grid_of({0., -4e-3, 1e-3, 1e-3, 100, 9},
                         [&](const double x, const double y) {
                           return 20e-6 * std::sin(2 * pi * x / 0.1) +
                                  5e-6 * std::sin(9e3 * y) +
                                  drift * x * y / 1e-4;
                         }),
                 "grid: map.csv");
      BOOST_TEST(doubt_of_ends(record).empty() == (drift == 0.));
    }
}

/** Positions count as the wheel runs, y is the frame's; the range is named. */
BOOST_FIXTURE_TEST_CASE(maps_move_with_the_flow, Maps)
{
  const ZoneSizes sizes{{0.5e-3, 0.5e-3}, {8e-3, 6e-3}};
  const auto      hill = [](const double x, const double y) {
    return 10e-6 * std::exp(-std::pow((x - 0.1) / 0.004, 2) -
                            std::pow((y - 1.5e-3) / 0.003, 2));
  };
  SceneParameters scene =
    scene_with("map.csv",
               grid_of({0.06, -9e-3, 0.5e-3, 0.5e-3, 201, 37}, hill));
  scene.surfaces.height.rail = "grid: map.csv";
  scene.surfaces.position    = 0.09;
  using Place                = std::array<double, 2>;
  const auto top_at = [&](const MovingSurfaces &surfaces, const double s) {
    double best = 0.;
    Place  at{{0., 0.}};
    for (double x = -6e-3; x <= 6e-3; x += 1e-4)
      for (double y = -4e-3; y <= 4e-3; y += 1e-4)
        if (surfaces.height(x, y, s) > best)
          best = surfaces.height(x, y, s), at = {{x, y}};
    return at;
  };
  for (const double flow : {1., -1.})
    {
      scene.contact.speed        = 20. * flow;
      scene.surfaces.height.rail = "grid: map.csv";
      const MovingSurfaces surfaces(Situation(scene), sizes);
      BOOST_TEST(std::abs(top_at(surfaces, flow * 0.012)[0] - flow * 0.002) <
                 2e-4);
      BOOST_TEST(std::abs(top_at(surfaces, flow * 0.012)[1] - 1.5e-3) < 2e-4);
      scene.surfaces.height.rail = "mirrored: grid: map.csv";
      const MovingSurfaces mirrored(Situation(scene), sizes);
      BOOST_TEST(std::abs(top_at(mirrored, flow * 0.012)[1] + 1.5e-3) < 2e-4);
      BOOST_TEST(surfaces.resolved.has_value());
      BOOST_TEST(surfaces.resolved->shortest[1] == 2e-3);
    }
  // slopes of both bodies add up as random ones; a line has no waves across
  const double of_rail =
    MovingSurfaces(Situation(scene), sizes).resolved->rms_slope;
  scene.surfaces.height.wheel = "grid: map.csv";
  BOOST_TEST(MovingSurfaces(Situation(scene), sizes).resolved->rms_slope ==
               std::sqrt(2.) * of_rail,
             boost::test_tools::tolerance(1e-9));
  scene.surfaces.height.wheel = "middle line: grid: map.csv";
  BOOST_TEST(MovingSurfaces(Situation(scene), sizes).resolved->shortest[1] ==
             2e-3);
  scene.surfaces.height.rail = "";
  BOOST_TEST(MovingSurfaces(Situation(scene), sizes).resolved->shortest[1] ==
             0.);
  scene.surfaces.height.wheel = "";
  // as roughness it stands, and its positions are x
  scene.surfaces.height.rail = "";
  scene.contact.roughness    = "grid: stands.csv";
  write(scratch / "stands.csv",
        grid_of(Grid::about_0(0.5e-3, 0.5e-3, 33, 33),
                [&](const double x, const double y) {
                  return hill(x + 0.098, y);
                }));
  const Situation      situation(scene);
  const MovingSurfaces stands(situation, sizes);
  BOOST_TEST(!stands.in_use());
  BOOST_TEST(stands.height(2e-3, 1.5e-3, 0.) == 0.);
  BOOST_TEST(stands.standing_height(2e-3, 1.5e-3) > 0.7e-5);
  BOOST_TEST(stands.standing_height(-4e-3, 1.5e-3) < 0.3e-5);
  scene.contact.roughness    = "";
  scene.surfaces.height.rail = "grid: map.csv";

  const auto refused = [&](const ZoneSizes &zone, const std::string &part) {
    const auto said =
      complaint([&]() { MovingSurfaces(Situation(scene), zone); });
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "map.csv"), said);
  };
  scene.surfaces.position = 0.155;
  refused(sizes,
          "it goes from 0.06 to 0.16 m, and what may touch reaches from "
          "0.1465 to 0.1635 m of it");
  scene.surfaces.position = 0.1;
  refused({{0.5e-3, 0.5e-3}, {8e-3, 10e-3}},
          "it goes from y = -0.009 to 0.009 m, and what may touch reaches from "
          "-0.01 to 0.01 m");
  // a node outside of it, too, wherever it is
  const MovingSurfaces surfaces(Situation(scene), sizes);
  BOOST_TEST(contains(complaint([&]() { surfaces.height(0., 9.2e-3, 0.); }),
                      "reaches to 0.0092 m"));
  scene.surfaces.shortest_wavelength = 2.1e-3;
  BOOST_TEST(contains(
    complaint([&]() {
      MovingSurfaces(Situation(scene), {{0.5e-3, 0.6e-3}, {8e-3, 6e-3}});
    }),
    "at least 4 elements make a wave, 0.0024 m"));
  scene.surfaces.shortest_wavelength = 0.;
  write(scratch / "map.csv",
        grid_of({0.06, -9e-3, 0.5e-3, 0.5e-3, 201, 37},
                [](const double x, const double) {
                  return 4e-4 * std::sin(2 * pi * x / 4e-3);
                }));
  refused(sizes, "the waves that the elements follow have a slope of ");
  const auto flat = complaint([&]() {
    scene.dimension = 2;
    scene.surfaces.check(2);
  });
  BOOST_TEST(contains(flat, "write `middle line:` in front"), flat);
}

namespace
{
  /** A state of two crowned discs that roll. */
  SteadyState<3> rolling_state(const std::function<void(SceneParameters &)> &it)
  {
    return SceneRun<3>(standard<3>,
                       [&](SceneParameters &scene) {
                         scene.contact.creepages.x = 0.0007;
                         it(scene);
                       })
      .steady;
  }

  void same_digits(const Resultants &one,
                   const Resultants &other,
                   const double      tolerance)
  {
    BOOST_TEST(one.normal_force == other.normal_force,
               boost::test_tools::tolerance(tolerance));
    BOOST_TEST(one.force_x == other.force_x,
               boost::test_tools::tolerance(100 * tolerance));
    BOOST_TEST(one.max_pressure == other.max_pressure,
               boost::test_tools::tolerance(10 * tolerance));
  }
} // namespace

/** From points of the mesh a plane wave is that of the expression to all
 * digits; from points between them to the error of the spline. */
BOOST_FIXTURE_TEST_CASE(a_plane_wave_is_its_expression, Maps)
{
  const SteadyState<3> smooth = rolling_state([](SceneParameters &) {});
  const double         h_x    = smooth.grading.element_size_x,
               h_y            = smooth.grading.element_size_y;
  const auto &at              = smooth.problem.operators.positions();
  // any node, and lines of nodes that reach beyond the zone
  const Grid   grid{at[0][0] - 24 * h_x, at[0][1] - 24 * h_y, h_x, h_y, 49, 49};
  const double from_x = grid.x, from_y = grid.y, length = 8 * h_x,
               width = 12 * h_y;
  const auto height  = [&](const double x, const double y) {
    return 2e-6 * std::cos(2 * pi * (x - from_x) / length) +
           1e-6 * std::cos(2 * pi * (y - from_y) / width);
  };
  const auto text = [](const double number) { return scientific(number, 17); };
  const std::string expression = "2e-6*cos(2*pi*(x-(" + text(from_x) + "))/" +
                                 text(length) + ")+1e-6*cos(2*pi*(y-(" +
                                 text(from_y) + "))/" + text(width) + ")";
  write(scratch / "nodes.csv", grid_of(grid, height));
  const auto with_file = [&](const std::string &name) {
    return rolling_state([&](SceneParameters &scene) {
             scene.prm_folder        = scratch;
             scene.contact.roughness = name;
           })
      .result;
  };
  const Resultants written = rolling_state([&](SceneParameters &scene) {
                               scene.contact.roughness =
                                 "-(" + expression + ")";
                             }).result,
                   read    = with_file("grid: nodes.csv");
  same_digits(read, written, 1e-11);
  BOOST_TEST(std::abs(read.normal_force / smooth.result.normal_force - 1) >
             1e-3);
  // in motion: what lies there after 3 elements, for either flow
  for (const double flow : {1., -1.})
    {
      const double position = 3 * h_x;
      const Grid   there{
        flow > 0. ? -(grid.x + 48 * h_x) : grid.x, grid.y, h_x, h_y, 49, 49};
      write(scratch / "moves.csv",
            grid_of(there, [&](const double p, const double y) {
              return height(-flow * p, y);
            }));
      const auto moves = [&](const std::string &name) {
        return rolling_state([&](SceneParameters &scene) {
                 scene.prm_folder           = scratch;
                 scene.contact.speed        = 10. * flow;
                 scene.surfaces.position    = position;
                 scene.surfaces.height.rail = name;
               })
          .result;
      };
      same_digits(moves("grid: moves.csv"), moves(expression), 1e-11);
    }
  // four points an element of the same map: as far off as the spline
  write(scratch / "fine.csv",
        grid_of({grid.x, grid.y, h_x / 4, h_y / 4, 193, 193}, height));
  same_digits(with_file("grid: fine.csv"), written, 1e-11);
  write(scratch / "between.csv",
        grid_of({grid.x, grid.y, h_x / 3.5, h_y / 3.5, 169, 169},
                [&](const double x, const double y) { return height(x, y); }));
  const Resultants between = with_file("grid: between.csv");
  BOOST_TEST_MESSAGE("28 and 42 points a wave: N "
                     << between.normal_force / written.normal_force - 1
                     << " off");
  same_digits(between, written, 1e-6);
}

/** Bodies and map turned by 90 degrees: the same state, turned, as far as the
 * bodies have one; in either the digits of the expression. */
BOOST_FIXTURE_TEST_CASE(a_map_turns_with_the_bodies, Maps)
{
  // waves of a map from -1 to 1 cm without mean and slope
  const auto wave = [](const std::string &x, const unsigned int halves) {
    return "cos(pi*" + std::to_string(halves) + "*(" + x + "+0.01)/0.02)";
  };
  const auto expression = [&](const std::string &x, const std::string &y) {
    return "3e-6*" + wave(x, 9) + "*" + wave(y, 3) + "+4e-6*" + wave(x, 5) +
           "*" + wave(y, 2);
  };
  const auto state = [&](const bool turned, const std::string &roughness) {
    return SceneRun<3>(standard<3>,
                       [&](SceneParameters &scene) {
                         scene.prm_folder           = scratch;
                         scene.wheel.rigid          = true;
                         scene.wheel.radius         = turned ? 0.3 : 0.46;
                         scene.wheel.lateral_radius = turned ? 0.46 : 0.3;
                         scene.rail.shape           = "block";
                         scene.rail.radius          = 0.;
                         scene.rail.lateral_radius  = 0.;
                         scene.rail.block_length    = 0.1;
                         scene.rail.width           = 0.1;
                         scene.rail.block_depth     = 0.05;
                         scene.contact.friction_coefficient = 0.;
                         scene.contact.approach             = 0.05e-3;
                         scene.mesh.elements_across_patch   = 12;
                         scene.contact.roughness            = roughness;
                       })
      .steady.result;
  };
  std::array<Resultants, 2> found;
  for (const bool turned : {false, true})
    {
      const std::string text =
        turned ? expression("y", "(-x)") : expression("x", "y");
      const HeightExpression height(entry, text, "");
      write(scratch / "map.csv",
            grid_of(Grid::about_0(0.25e-3, 0.25e-3, 81, 81),
                    [&](const double x, const double y) {
                      return height.value(x, y);
                    }));
      found[turned]            = state(turned, "grid: map.csv");
      const Resultants written = state(turned, "-(" + text + ")");
      BOOST_TEST_MESSAGE(
        "N = " << found[turned].normal_force << " N, centre "
               << found[turned].centre_x << ", " << found[turned].centre_y
               << " m; "
               << found[turned].normal_force / written.normal_force - 1
               << " off the expression");
      BOOST_TEST(found[turned].normal_force == written.normal_force,
                 boost::test_tools::tolerance(2e-5));
    }
  const auto &[here, there] = found;
  BOOST_TEST(here.normal_force == there.normal_force,
             boost::test_tools::tolerance(4e-3));
  BOOST_TEST(here.max_pressure == there.max_pressure,
             boost::test_tools::tolerance(2e-2));
  const double near = 3e-6; // of a half-width of 5.7 mm
  BOOST_TEST(std::abs(here.centre_x - there.centre_y) < near);
  BOOST_TEST(std::abs(here.centre_y + there.centre_x) < near);
  BOOST_TEST(std::abs(here.centre_x) > 10 * near);
}

BOOST_AUTO_TEST_SUITE_END()
