#include <fmt/format.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace RollingContact
{
  namespace
  {
    /**
     * The look of all pictures. Colours: palette of Okabe and Ito without black
     * and yellow, violet, brown; maps: viridis. All can be told apart by people
     * who are colour-blind.
     */
    const char look_of_all[] = R"(set encoding utf8
set minussign
set border linewidth 0.9 linecolor "#222222"
set tics nomirror out scale 0.5,0.3 textcolor "#222222"
set xtics offset 0,0.3
set xlabel offset 0,0.5
set title offset 0,-0.3
set format "%h"
set grid xtics ytics mxtics mytics linetype 1 linewidth 0.6 \
  linecolor "#D9D9D9", linetype 1 linewidth 0.4 linecolor "#EEEEEE"
set xzeroaxis linetype 1 linewidth 0.9 linecolor "#9A9A9A"
set yzeroaxis linetype 1 linewidth 0.9 linecolor "#9A9A9A"
set autoscale noextend
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set linetype 1 linecolor "#0072B2" linewidth 1.8 pointtype 7
set linetype 2 linecolor "#D55E00" linewidth 1.8 pointtype 5
set linetype 3 linecolor "#009E73" linewidth 1.8 pointtype 9
set linetype 4 linecolor "#CC79A7" linewidth 1.8 pointtype 13
set linetype 5 linecolor "#E69F00" linewidth 1.8 pointtype 7
set linetype 6 linecolor "#56B4E9" linewidth 1.8 pointtype 5
set linetype 7 linecolor "#5E3C99" linewidth 1.8 pointtype 9
set linetype 8 linecolor "#8C510A" linewidth 1.8 pointtype 13
set linetype cycle 8
)";

    const std::vector<std::string> map_colours{"#440154",
                                               "#472D7B",
                                               "#3B528B",
                                               "#2C728E",
                                               "#21918C",
                                               "#28AE80",
                                               "#5EC962",
                                               "#ADDC30",
                                               "#FDE725"};
    const std::vector<std::string> band_colours{"#E3EBF4",
                                                "#F6ECDC",
                                                "#E4F1E7"};
    const std::vector<std::string> dashes{"(9,6)", "(3,4)", "(12,5,3,5)"};

    // pixels; a panel below the first one and its distance from the one above
    constexpr double plot_width = 640., figure_height = 430.,
                     figure_bottom = 60., figure_top = 386.,
                     panel_height = 150., panel_step = 170., left_edge = 96.,
                     right_edge = 618., x_axis_height = 56.;
    constexpr unsigned int many_points = 80;

    /** Viridis over [0, largest], with plain grey below if that is wanted. */
    std::string palette(const double largest, const std::string &below)
    {
      std::string colours;
      for (std::size_t k = 0; k < map_colours.size(); ++k)
        colours += fmt::format("{}{} \"{}\"",
                               k == 0 ? "" : ", ",
                               largest * k / (map_colours.size() - 1),
                               map_colours[k]);
      return "set palette defined (" + below + colours + ")\n";
    }

    std::string palette_from_zero(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        if (std::isfinite(value))
          largest = std::max(largest, value);
      if (largest == 0.)
        return "set palette defined (0 \"#DDDDDD\", 1 \"#DDDDDD\")\n";
      const double plain = largest / 12;
      return fmt::format("set cbrange [{}:{}]\n", -plain, largest) +
             palette(largest,
                     fmt::format("{} \"#DDDDDD\", 0 \"#DDDDDD\", ", -plain));
    }

    /** The text itself, also where gnuplot reads marks of its own. */
    std::string enhanced(const std::string &text)
    {
      std::string result;
      for (const char character : text)
        result += (std::strchr("\\{}_^@&~", character) != nullptr ? "\\" : "") +
                  std::string(1, character);
      return result;
    }
  } // namespace

  std::string Figure::script(const std::string &name) const
  {
    std::string text =
      fmt::format(
        "# Draws {0}.svg from {0}.dat, in this folder: gnuplot {0}.gp\n"
        "if (!exists(\"picture\")) picture = \"{0}.svg\"\n",
        name) +
      look_of_all + layout() + "set title " +
      quoted("{/:Bold=15 " + enhanced(title) + '}') + '\n';
    if (!panels.empty())
      text += "set multiplot\n";
    std::size_t block = 0;
    const auto  all   = all_panels();
    for (std::size_t k = 0; k < all.size(); ++k)
      {
        if (!panels.empty())
          text += panel_layout(k);
        text += all[k]->axis('x', shows_x_axis(k) ? all[k]->x_label : "") +
                all[k]->axis('y', all[k]->y_label) + all[k]->names_as_tics();
        if (!shows_x_axis(k) && all[k]->x_scale == AxisScale::logarithmic)
          text += "set xtics autofreq\nset format x \"\"\n";
        if (all[k]->equal_scales)
          text += all[k]->equal_ranges(
            {{right_edge - left_edge, figure_top - figure_bottom}});
        for (std::size_t i = 0; i < all[k]->bands.size(); ++i)
          text += all[k]->band(i);
        text += all[k]->items(name, block);
      }
    return text + (panels.empty() ? "" : "unset multiplot\n");
  }

  std::string Figure::items(const std::string &name, std::size_t &block) const
  {
    const bool  is_map = !maps.empty();
    std::string text, items;
    if (is_map)
      // gnuplot leaves no room for the label of y
      text += "unset grid\nset view map\nset pm3d corners2color mean\n"
              "unset xzeroaxis\nunset yzeroaxis\nset lmargin at screen 0.13\n";
    const auto add = [&](const std::string &item) {
      items += (items.empty() ? "" : ", \\\n  ") + item;
    };
    for (const Map &map : maps)
      {
        // cells without a value are of the map as well; with the digits of the
        // data, or the outer cells would be cut
        if (!map.x.empty() && !map.y.empty())
          text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n",
                              significant(map.x.front(), 9),
                              significant(map.x.back(), 9),
                              significant(map.y.front(), 9),
                              significant(map.y.back(), 9));
        text += map.colours == MapColours::from_zero
                  ? palette_from_zero(map.values)
                  : palette(1., "");
        text += "set cblabel " + quoted(map.label) + " noenhanced offset 1,0\n";
        add(fmt::format("'{}.dat' index {} with pm3d notitle", name, block++));
      }
    // black lines are seen on dark colours as well
    if (is_map)
      for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].style == CurveStyle::reference)
          add(fmt::format("'{}.dat' index {} using 1:2:(0) with lines "
                          "linewidth 3.4 linecolor \"#FFFFFF\" notitle",
                          name,
                          block + i));
    // marks in expressions are read twice
    for (std::size_t i = 0; i < curves.size(); ++i)
      add(fmt::format(
        "'{}.dat' index {} using {} {} {}",
        name,
        block++,
        is_map                                ? "1:2:(0)"
        : curves[i].style == CurveStyle::bars ? "1:2:(0):1:($2-0.17):($2+0.17)"
        : curves[i].style == CurveStyle::name_beside
          ? "1:2:(" + quoted(enhanced(enhanced(curves[i].label))) + ')'
        : curves[i].style == CurveStyle::arrows ? "1:2:3:4"
                                                : "1:2",
        look(i),
        curves[i].label.empty() || curves[i].style == CurveStyle::name_beside
          ? "notitle"
          : "title " + quoted(curves[i].label)));
    if (items.empty())
      add("NaN notitle");
    for (std::size_t i = 0; i < bands.size(); ++i)
      if (!bands[i].label.empty() && !is_map)
        add(fmt::format("keyentry with boxes fillstyle solid noborder "
                        "linecolor \"{}\" title {}",
                        band_colours[i % band_colours.size()],
                        quoted(bands[i].label)));
    return text + (is_map ? "splot " : "plot ") + items + '\n';
  }

  std::string Figure::layout() const
  {
    std::size_t longest = 0;
    for (const Figure *panel : all_panels())
      {
        for (const Curve &curve : panel->curves)
          if (curve.style != CurveStyle::name_beside)
            longest = std::max(longest, n_characters(curve.label));
        for (const Band &band : panel->bands)
          longest = std::max(longest, n_characters(band.label));
      }
    const bool   has_legend = longest > 0 && maps.empty();
    const double width      = plot_width + (has_legend     ? 60. + 7. * longest
                                            : maps.empty() ? 0.
                                                           : 110.),
                 first      = bottom_of(0),
                 height     = figure_height - figure_bottom + first;
    return fmt::format(
      "set terminal svg size {0},{1} font \"Helvetica,Arial,sans-serif,13\" "
      "background \"white\"\n"
      "set output picture\n"
      "set rmargin at screen {6}./{0}\n{3}"
      "set bmargin at screen {2}./{1}\nset tmargin at screen {4}./{1}\n{5}",
      width,
      height,
      first,
      panels.empty() && !equal_scales
        ? ""
        : fmt::format("set lmargin at screen {}./{}\n", left_edge, width),
      figure_top - figure_bottom + first,
      has_legend ? "set key at graph 1.03, graph 1 left top Left reverse "
                   "noenhanced samplen 2.2 spacing 1.2\n"
                 : "unset key\n",
      right_edge);
  }

  /** Pixels from the bottom of the picture to that of a panel. */
  double Figure::bottom_of(const std::size_t index) const
  {
    double bottom = figure_bottom;
    for (std::size_t k = index; k < panels.size(); ++k)
      bottom += panel_step + (panels[k].has_own_x ? x_axis_height : 0.);
    return bottom;
  }

  /** Panels over the same x have the axis of the lowest of them. */
  bool Figure::shows_x_axis(const std::size_t index) const
  {
    return index == panels.size() || panels[index].has_own_x;
  }

  std::string Figure::panel_layout(const std::size_t index) const
  {
    const double height = figure_height - figure_bottom + bottom_of(0);
    std::string  text;
    if (index > 0)
      text +=
        fmt::format("unset title\nunset object\nunset logscale\nunset mxtics\n"
                    "unset mytics\nset autoscale\nset autoscale noextend\n"
                    "set bmargin at screen {}./{}\n"
                    "set tmargin at screen {}./{}\n",
                    bottom_of(index),
                    height,
                    bottom_of(index) + panel_height,
                    height);
    return text + (shows_x_axis(index)
                     ? "set format \"%h\"\n"
                     : "set format x \"\"\nset format y \"%h\"\n");
  }

  std::string Figure::band(const std::size_t index) const
  {
    const Band &band = bands[index];
    if (std::isnan(band.begin) || std::isnan(band.end) ||
        (x_scale == AxisScale::logarithmic && band.end <= 0.))
      return "";
    const auto position = [&](const double value, const char *otherwise) {
      return can_be_drawn(value, x_scale) ? "first " + significant(value, 9)
                                          : std::string(otherwise);
    };
    return fmt::format("set object rectangle from {}, graph 0 to {}, graph 1 "
                       "behind fillcolor \"{}\" fillstyle solid noborder\n",
                       position(band.begin, "graph 0"),
                       position(band.end, "graph 1"),
                       band_colours[index % band_colours.size()]);
  }

  std::string Figure::look(const std::size_t index) const
  {
    const Curve &curve = curves[index];
    if (curve.style == CurveStyle::bars)
      return fmt::format("with boxxyerror fillstyle solid noborder linetype {}",
                         index + 1);
    if (curve.style == CurveStyle::name_beside)
      return "with labels center offset 0,0.7 font \",11\" "
             "textcolor \"#222222\"";
    const auto n_before = [&](const CurveStyle style) {
      return std::count_if(curves.begin(),
                           curves.begin() + index,
                           [&](const Curve &c) { return c.style == style; });
    };
    if (curve.style == CurveStyle::reference)
      return fmt::format(
        "with lines linewidth 1.4 linecolor \"#222222\" dashtype {}",
        dashes[n_before(CurveStyle::reference) % dashes.size()]);
    if (curve.style == CurveStyle::marks)
      return "with points pointtype 7 pointsize 0.3 linecolor \"#9A9A9A\"";
    const auto colour =
      index - n_before(CurveStyle::reference) - n_before(CurveStyle::marks) + 1;
    if (curve.style == CurveStyle::arrows)
      return fmt::format("with vectors head filled size screen 0.008,18 "
                         "linetype {} linewidth 1.2",
                         colour);

    const bool has_points = curve.style == CurveStyle::points ||
                            curve.style == CurveStyle::line_and_points ||
                            curve.x.size() == 1,
               has_line = curve.style != CurveStyle::points;
    return fmt::format("with {}{} linetype {}{}{}{}",
                       has_line ? "lines" : "",
                       has_points ? "points" : "",
                       colour,
                       curve.style == CurveStyle::dashed
                         ? " dashtype " + dashes[0]
                         : "",
                       curve.style == CurveStyle::thick ? " linewidth 5.5" : "",
                       !has_points                    ? ""
                       : curve.x.size() > many_points ? " pointsize 0.35"
                                                      : " pointsize 0.55");
  }
} // namespace RollingContact
