#include "drawing_run.h"

#include <rolling_contact/base/child_process.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/run/figure.h>

#include <cmath>
#include <limits>

namespace
{
  using namespace RollingContact;
  namespace fs = std::filesystem;
  using Values = std::vector<double>;
} // namespace

BOOST_AUTO_TEST_SUITE(figures)

BOOST_FIXTURE_TEST_CASE(data_and_script, DrawingRun)
{
  Figure figure("it's \x01 p < q & \"r\" \\ `touch x`", "x_1 (m)", "p \xB5");
  figure.set_scales(AxisScale::linear, AxisScale::logarithmic);
  figure.add_band("stick", -1., 0.5);
  figure.add_curve("first", {0., 1., 2.}, {1., std::nan(""), 1. / 3.});
  figure.add_curve("", {0., 4.}, {1., 2e6}, CurveStyle::line_and_points);
  figure.add_curve("reference", {0., 4.}, {1., 1.}, CurveStyle::reference);
  figure.add_curve("guess", {0., 4.}, {1., 3.}, CurveStyle::dashed);
  BOOST_TEST(figure.data() ==
             "# it's   p < q & \"r\" \\ `touch x`\n"
             "# first\n# x_1 (m)\tp \uFFFD\n0\t1\n1\tNaN\n2\t0.333333333\n\n\n"
             "# \n# x_1 (m)\tp \uFFFD\n0\t1\n4\t2000000\n\n\n"
             "# reference\n# x_1 (m)\tp \uFFFD\n0\t1\n4\t1\n\n\n"
             "# guess\n# x_1 (m)\tp \uFFFD\n0\t1\n4\t3\n\n\n");

  figure.draw(drawing, "history");
  BOOST_TEST(said.str() == "");
  BOOST_TEST(is_drawn("history"));
  for (
    const char *line :
    {"set title '{/:Bold=15 it''s   p < q \\& \"r\" \\\\ `touch x`}'\n",
     "set xlabel 'x_1 (m)' noenhanced\n",
     "set logscale y\n",
     "from first -1, graph 0 to first 0.5, graph 1 behind",
     "plot 'history.dat' index 0 using 1:2 with lines linetype 1 title 'first', \\\n",
     "'history.dat' index 1 using 1:2 with linespoints linetype 2 pointsize 0.55 "
     "notitle, \\\n",
     "'history.dat' index 2 using 1:2 with lines linewidth 1.4 linecolor "
     "\"#222222\" dashtype (9,6) title 'reference'",
     "'history.dat' index 3 using 1:2 with lines linetype 3 dashtype (9,6) title "
     "'guess'",
     "title 'stick'\n"})
    BOOST_TEST(contains(script("history"), line), line);
  BOOST_TEST(!contains(script("history"), "logscale x"));
  BOOST_TEST(!fs::exists(files.folder / "x"));

  const std::string svg = read(files.folder / "history.svg");
  BOOST_TEST(contains(svg, "<title>it's   p &lt; q &amp; "));
  for (const char *text : {"it's ", "x_1 (m)", "first", "stick"})
    BOOST_TEST(contains(svg, text), text);
}

BOOST_FIXTURE_TEST_CASE(degenerate_data, DrawingRun)
{
  const double infinity   = std::numeric_limits<double>::infinity();
  const double not_number = std::nan("");
  const std::vector<std::pair<Values, Values>> cases{
    {{}, {}},
    {{3.}, {5.}},
    {{0.}, {0.}},
    {{0., 1.}, {7., 7.}},
    {{not_number, 1.}, {1., infinity}},
    {{-1e299, 1e299}, {1e-310, 3e-310}},
    {{1e9, 1e9 + 1e-6}, {1e-20, 1e20}}};

  unsigned int n_drawn = 0;
  for (const auto scale : {AxisScale::linear, AxisScale::logarithmic})
    for (const auto &[x, y] : cases)
      {
        Figure figure("", "x", "y");
        figure.set_scales(scale, scale);
        figure.add_band("band", -infinity, infinity);
        figure.add_band("", not_number, 0.);
        figure.add_curve("curve", x, y, CurveStyle::points);
        figure.add_curve("again", x, y);
        const std::string name = "table_" + std::to_string(n_drawn++);
        figure.draw(drawing, name);
        BOOST_TEST(is_drawn(name), name);
      }
  BOOST_TEST(said.str() == "");
  BOOST_CHECK_THROW(Figure("", "", "").add_curve("", {1.}, {}),
                    std::invalid_argument);
  BOOST_CHECK_THROW(Figure("", "", "").add_map("", {1.}, {2.}, {}),
                    std::invalid_argument);
}

BOOST_FIXTURE_TEST_CASE(maps, DrawingRun)
{
  Figure figure("Pressure", "x (mm)", "y (mm)");
  figure.add_map("p (MPa)", {0., 1., 3.}, {5., 6.}, {1., 2., 3., 4., 5., 6.});
  figure.add_curve("edge", {0., 3.}, {5., 6.});
  figure.draw(drawing, "stability_map");
  BOOST_TEST(is_drawn("stability_map"));
  BOOST_TEST(contains(figure.data(),
                      "# x (mm)\ty (mm)\tp (MPa)\n0\t5\t1\n1\t5\t2\n3\t5\t3\n\n"
                      "0\t6\t4\n1\t6\t5\n3\t6\t6\n\n\n"));
  BOOST_TEST(contains(script("stability_map"), "set cblabel 'p (MPa)'"));
  BOOST_TEST(
    contains(script("stability_map"),
             "splot 'stability_map.dat' index 0 with pm3d notitle, \\\n"
             "  'stability_map.dat' index 1 using 1:2:(0) with lines"));
  // a reference lies on white, to be seen on dark colours
  figure.add_curve("", {0., 3.}, {6., 5.}, CurveStyle::reference);
  figure.draw(drawing, "stability_map");
  BOOST_TEST(contains(
    script("stability_map"),
    "index 0 with pm3d notitle, \\\n  'stability_map.dat' index 2 using "
    "1:2:(0) with lines linewidth 3.4 linecolor "
    "\"#FFFFFF\" notitle, \\\n  'stability_map.dat' index 1 using"));
  BOOST_TEST(is_drawn("stability_map"));
  // ranges to the digit of the data, or gnuplot cuts the outer cells
  Figure thirds("", "x", "y");
  thirds.add_map("v", {1 / 3., 2 / 3.}, {8 / 9., 5000 / 3.}, {1., 2., 3., 4.});
  thirds.draw(drawing, "growth");
  BOOST_TEST(contains(script("growth"),
                      "set xrange [0.333333333:0.666666667]\n"
                      "set yrange [0.888888889:1666.66667]\n"));
  BOOST_TEST(contains(thirds.data(), "\n0.666666667\t1666.66667\t4\n"));
}

/** Names stand above their points, and not in the legend. */
BOOST_FIXTURE_TEST_CASE(names_of_points, DrawingRun)
{
  Figure figure("", "x", "y");
  figure.add_curve("", {1., 2.}, {3., 4.}, CurveStyle::points);
  figure.add_curve("it's_0L3", {2.}, {4.}, CurveStyle::name_beside);
  figure.draw(drawing, "gaps");
  BOOST_TEST(said.str() == "");
  BOOST_TEST(is_drawn("gaps"));
  BOOST_TEST(
    contains(script("gaps"),
             "index 1 using 1:2:('it''s\\\\\\_0L3') with labels center"));
  BOOST_TEST(contains(script("gaps"), "unset key"));
  BOOST_TEST(contains(read(files.folder / "gaps.svg"), "s_0L3"));
}

/** The course of a long curve stays, its extremes included. */
BOOST_AUTO_TEST_CASE(long_curves)
{
  Values x, y;
  for (int i = 0; i < 1000000; ++i)
    {
      x.push_back(i);
      y.push_back(i == 345678 ? 100. : i == 345679 ? -100. : i % 7);
    }
  Figure figure("", "x", "y");
  figure.add_curve("", x, y);
  const std::string data = figure.data();
  BOOST_TEST(contains(data, "345678\t100\n345679\t-100\n"));
  const auto n_lines = std::count(data.begin(), data.end(), '\n');
  BOOST_TEST(n_lines > 5000);
  BOOST_TEST(n_lines < 10010);
}

BOOST_FIXTURE_TEST_CASE(programs_are_found_and_stopped, ScratchFolder)
{
  const fs::path shell = find_program("sh");
  BOOST_TEST(shell.is_absolute());
  BOOST_TEST(find_program("no_such_program").empty());
  BOOST_TEST(
    run_program(shell, {"-c", "echo $0 > said", "a b; c"}, scratch, 9.));
  BOOST_TEST(read(scratch / "said") == "a b; c\n");
  BOOST_TEST(!run_program(shell, {"-c", "exit 3"}, scratch, 9.));
  BOOST_TEST(!run_program(scratch / "none", {}, scratch, 9.));
  const Stopwatch watch;
  BOOST_TEST(!run_program(shell, {"-c", "sleep 60; true"}, scratch, 0.1));
  BOOST_TEST(watch.seconds() < 9.);
}

/** A millimetre is as long in both directions; another panel may be over
 * another x. */
BOOST_FIXTURE_TEST_CASE(equal_scales_and_separate_panels, DrawingRun)
{
  Figure figure("", "y (mm)", "height (mm)");
  figure.set_equal_scales();
  figure.add_curve("wide", {0., 522.}, {10., 20.}, CurveStyle::thick);
  Figure panel("", "along the rail (mm)", "p (MPa)");
  panel.add_curve("p", {-5., 5.}, {0., 900.});
  figure.add_separate_panel(panel);
  figure.draw(drawing, "history");
  BOOST_TEST(is_drawn("history"));
  // 522 pixels by 326, 1.08 units for each
  BOOST_TEST(contains(script("history"), "set xrange [-20.88:542.88]\n"));
  BOOST_TEST(contains(script("history"), "set yrange [-161.04:191.04]\n"));
  BOOST_TEST(
    contains(script("history"), "linetype 1 linewidth 5.5 title 'wide'"));
  const std::string svg = read(files.folder / "history.svg");
  for (const char *label : {"y (mm)", "along the rail (mm)", "p (MPa)"})
    BOOST_TEST(contains(svg, label), label);
  BOOST_CHECK_THROW(figure.add_panel(panel), std::invalid_argument);
  Figure with_map("", "x", "y");
  with_map.add_map("", {1., 2.}, {1., 2.}, {1., 2., 3., 4.});
  BOOST_CHECK_THROW(figure.add_separate_panel(with_map), std::invalid_argument);
}

/** Panels over one logarithmic x have its numbers once, up to 20000 in full,
 * and the lower one, linear in y, no marks of tenths. */
BOOST_FIXTURE_TEST_CASE(panels_over_one_frequency, DrawingRun)
{
  Figure figure("", "frequency (Hz)", "receptance (m/N)");
  figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
  figure.add_curve("a", {150., 1200., 5000.}, {1e-9, 1e-7, 1e-8});
  Figure phase("", "frequency (Hz)", "phase");
  phase.set_scales(AxisScale::logarithmic, AxisScale::linear);
  phase.add_curve("a", {150., 1200., 5000.}, {-10., -90., -170.});
  figure.add_panel(phase);
  figure.draw(drawing, "history");
  BOOST_TEST(is_drawn("history"));
  const std::string svg   = read(files.folder / "history.svg");
  const auto        times = [&](std::string text) {
    // gnuplot puts a blank before some
    unsigned int n = 0;
    for (const char *blank : {">", "> "})
      for (std::size_t at = 0;
           (at = svg.find(blank + text + "<", at)) != std::string::npos;
           ++at)
        ++n;
    return n;
  };
  BOOST_TEST(times("200") == 1);
  BOOST_TEST(times("5000") == 1);
  const std::string gnuplot = script("history");
  BOOST_TEST(gnuplot.rfind("unset mytics") != std::string::npos);
  BOOST_TEST(gnuplot.rfind("unset mytics") > gnuplot.rfind("set mytics 10"));
}

BOOST_AUTO_TEST_SUITE_END()
