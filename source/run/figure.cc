#include <fmt/format.h>

#include <rolling_contact/base/child_process.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/base/xml_text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr unsigned int most_points = 10000;

    /** In one line, and valid UTF-8. */
    std::string printable(const std::string &text)
    {
      std::string result = valid_utf8(text);
      for (char &character : result)
        if (static_cast<unsigned char>(character) < 0x20)
          character = ' ';
      return result;
    }

    std::string number(const double value)
    {
      return std::isfinite(value) ? significant(value, 9) : "NaN";
    }

    /** The positions of the points that show the course of the values. */
    std::vector<std::size_t> shown_points(const std::vector<double> &values)
    {
      const std::size_t stride =
        values.size() <= most_points ? 1 : 2 * values.size() / most_points + 1;
      std::vector<std::size_t> shown;
      for (std::size_t begin = 0; begin < values.size(); begin += stride)
        {
          const auto first = values.begin() + begin;
          const auto range = std::minmax_element(
            first, first + std::min(stride, values.size() - begin));
          const auto ends = std::minmax(
            {range.first - values.begin(), range.second - values.begin()});
          shown.push_back(ends.first);
          if (ends.second != ends.first)
            shown.push_back(ends.second);
        }
      return shown;
    }

    void require(const bool fits, const std::string &label)
    {
      if (!fits)
        throw std::invalid_argument('"' + label +
                                    "\" has unequal numbers of coordinates "
                                    "and values.");
    }
  } // namespace

  Figure::Figure(const std::string &title,
                 const std::string &x_label,
                 const std::string &y_label)
    : title(printable(title))
    , x_label(printable(x_label))
    , y_label(printable(y_label))
  {}

  void Figure::set_scales(const AxisScale x_scale, const AxisScale y_scale)
  {
    this->x_scale = x_scale;
    this->y_scale = y_scale;
  }

  void Figure::set_names(const std::vector<std::string> &names)
  {
    for (const std::string &name : names)
      this->names.push_back(printable(name));
  }

  std::string Figure::quoted(const std::string &text)
  {
    std::string result = "'";
    for (const char character : text)
      result += character == '\'' ? "''" : std::string(1, character);
    return result + '\'';
  }

  std::string Figure::names_as_tics() const
  {
    if (names.empty())
      return "";
    std::string tics;
    for (std::size_t k = 0; k < names.size(); ++k)
      tics +=
        fmt::format("{}{} {}", k == 0 ? "" : ", ", quoted(names[k]), k + 1);
    return fmt::format("set yrange [{}:0.4]\nset ytics ({}) noenhanced\n"
                       "unset mytics\n",
                       names.size() + 0.6,
                       tics);
  }

  void Figure::add_curve(const std::string         &label,
                         const std::vector<double> &x,
                         const std::vector<double> &y,
                         const CurveStyle           style)
  {
    require(x.size() == y.size(), label);
    curves.push_back({printable(label), x, y, style, {}, {}});
  }

  void Figure::add_arrows(const std::string         &label,
                          const std::vector<double> &x,
                          const std::vector<double> &y,
                          const std::vector<double> &along_x,
                          const std::vector<double> &along_y)
  {
    require(x.size() == y.size() && x.size() == along_x.size() &&
              x.size() == along_y.size(),
            label);
    curves.push_back(
      {printable(label), x, y, CurveStyle::arrows, along_x, along_y});
  }

  void Figure::add_band(const std::string &label,
                        const double       begin,
                        const double       end)
  {
    bands.push_back({printable(label), begin, end});
  }

  void Figure::add_map(const std::string         &label,
                       const std::vector<double> &x,
                       const std::vector<double> &y,
                       const std::vector<double> &values,
                       const MapColours           colours)
  {
    require(x.size() * y.size() == values.size(), label);
    maps.push_back({printable(label), x, y, values, colours});
  }

  void Figure::add_panel(const Figure &panel)
  {
    if (panel.x_label != x_label || !maps.empty() || !panel.maps.empty() ||
        !panel.panels.empty())
      throw std::invalid_argument('"' + panel.y_label +
                                  "\" cannot be a panel of this figure.");
    panels.push_back(panel);
  }

  void Figure::add_separate_panel(const Figure &panel)
  {
    if (!maps.empty() || !panel.maps.empty() || !panel.panels.empty())
      throw std::invalid_argument('"' + panel.y_label +
                                  "\" cannot be a panel of this figure.");
    panels.push_back(panel);
    panels.back().has_own_x = true;
  }

  std::vector<const Figure *> Figure::all_panels() const
  {
    std::vector<const Figure *> all{this};
    for (const Figure &panel : panels)
      all.push_back(&panel);
    return all;
  }

  std::string Figure::data() const
  {
    std::string text = "# " + title + '\n';
    for (const Figure *panel : all_panels())
      text += panel->block_data();
    return text;
  }

  std::string Figure::block_data() const
  {
    std::string text;
    for (const Map &map : maps)
      {
        text += fmt::format(
          "# {}\n# {}\t{}\t{}\n", map.label, x_label, y_label, map.label);
        for (std::size_t k = 0; k < map.values.size(); ++k)
          text += fmt::format("{}\t{}\t{}{}\n",
                              number(map.x[k % map.x.size()]),
                              number(map.y[k / map.x.size()]),
                              number(map.values[k]),
                              (k + 1) % map.x.size() == 0 ? "\n" : "");
        text += '\n';
      }
    for (const Curve &curve : curves)
      {
        const bool has_arrows = curve.style == CurveStyle::arrows;
        text += fmt::format("# {}\n# {}\t{}{}\n",
                            curve.label,
                            x_label,
                            y_label,
                            has_arrows ? "\tarrow along x\talong y" : "");
        for (const std::size_t i : shown_points(curve.y))
          text += number(curve.x[i]) + '\t' + number(curve.y[i]) +
                  (has_arrows ? '\t' + number(curve.along_x[i]) + '\t' +
                                  number(curve.along_y[i])
                              : "") +
                  '\n';
        text += curve.x.empty() ? "NaN\tNaN\n\n\n" : "\n\n";
      }
    return text;
  }

  void Figure::draw(RunContext &context, const std::string &name) const
  {
    if (!Ranks::is_root())
      return;
    RunFolder        &folder  = context.folder;
    const std::string picture = name + ".svg";
    remove_file(folder.get_path() / picture);
    folder.write_atomically(name + ".dat", data());
    folder.write_atomically(name + ".gp", script(name));
    const std::string how = fmt::format("\"gnuplot {}.gp\" in \"{}\" draws {}.",
                                        name,
                                        folder.get_path().string(),
                                        picture);

    static const fs::path gnuplot = find_program("gnuplot");
    if (gnuplot.empty())
      {
        context.log.message("No picture without gnuplot: " + how);
        return;
      }
    const fs::path file = folder.temporary(picture);
    write_temporary(file, "", file); // gnuplot would follow a link
    const bool worked =
      run_program(gnuplot,
                  {"-d",
                   "-e",
                   fmt::format("picture = '{}'", file.filename().string()),
                   name + ".gp"},
                  folder.get_path(),
                  60.);
    std::string       svg      = read_bytes(file);
    const std::string no_title = "<title>Gnuplot</title>";
    const auto        at       = svg.find(no_title);
    if (!worked || svg.find("</svg>") == std::string::npos)
      {
        context.log.warning("gnuplot did not draw: " + how);
        return;
      }
    if (at != std::string::npos)
      svg.replace(at,
                  no_title.size(),
                  "<title>" + xml_escaped(title) + "</title>");
    folder.write_atomically(picture, svg);
  }
} // namespace RollingContact
