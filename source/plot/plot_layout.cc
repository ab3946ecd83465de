#include <rolling_contact/plot/plot_layout.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::string reference_colour = "#222222";

    /** Palette of Okabe and Ito, without black and yellow; violet and brown. */
    const std::array<std::string, 8> palette{{"#0072B2",
                                              "#D55E00",
                                              "#009E73",
                                              "#CC79A7",
                                              "#E69F00",
                                              "#56B4E9",
                                              "#5E3C99",
                                              "#8C510A"}};



    bool
    can_be_drawn(const double value, const AxisScale scale)
    {
      return std::abs(value) < 1e300 &&
             (scale == AxisScale::linear || value > 1e-300);
    }



    /** Whether no point is in the box or within a few pixels of it. */
    bool
    is_clear(const PlotBox &box, const std::vector<PlotPoint> &points)
    {
      const PlotBox with_margin{box.left - 6.,
                                box.top - 6.,
                                box.right + 6.,
                                box.bottom + 6.};
      return std::none_of(points.begin(),
                          points.end(),
                          [&](const PlotPoint &point) {
                            return with_margin.contains(point);
                          });
    }
  } // namespace



  PlotLayout::PlotLayout(const SvgPlot::Content &content)
    : content(content)
    , is_empty(drawn_values(true).empty())
    , x_axis(content.x_scale, drawn_values(true))
    , y_axis(content.y_scale, drawn_values(false))
    , y_ticks(y_axis.ticks(6))
    , total_width(figure_width)
  {
    choose_colours();
    place_area();
    choose_x_ticks();
    for (const SvgPlot::Curve &curve : content.curves)
      curve_pieces.push_back(pieces(curve));
    list_legend();
    place_legend();
  }



  std::vector<double>
  PlotLayout::drawn_values(const bool of_x) const
  {
    std::vector<double> values;
    for (const SvgPlot::Curve &curve : content.curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (can_be_drawn(curve.x[i], content.x_scale) &&
            can_be_drawn(curve.y[i], content.y_scale))
          values.push_back(of_x ? curve.x[i] : curve.y[i]);
    return values;
  }



  PlotLayout::Pieces
  PlotLayout::pieces(const SvgPlot::Curve &curve) const
  {
    Pieces result;
    bool   is_broken = true;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      {
        const bool is_drawn = can_be_drawn(curve.x[i], content.x_scale) &&
                              can_be_drawn(curve.y[i], content.y_scale);
        if (is_drawn && is_broken)
          result.emplace_back();
        if (is_drawn)
          result.back().push_back(
            {x_axis.position(curve.x[i]), y_axis.position(curve.y[i])});
        is_broken = !is_drawn;
      }
    return result;
  }



  void
  PlotLayout::choose_colours()
  {
    std::size_t n_used = 0;
    for (const SvgPlot::Curve &curve : content.curves)
      colours.push_back(curve.style == CurveStyle::reference
                          ? reference_colour
                          : palette[n_used++ % palette.size()]);
  }



  void
  PlotLayout::place_area()
  {
    double label_width = 0.;
    for (const PlotTick &tick : y_ticks)
      label_width = std::max(label_width, tick_font * tick.label.width);

    const double title_space    = content.title.empty() ? 0. : 28.;
    const double exponent_space = y_axis.exponent() != 0 ? 16. : 0.;
    area                        = {label_width + 44.,
                                   16. + title_space + exponent_space,
                                   figure_width - 22.,
                                   figure_height - 56.};
    x_axis.set_pixels(area.left, area.right);
    y_axis.set_pixels(area.bottom, area.top);
  }



  /** As many ticks as their labels leave room for. */
  void
  PlotLayout::choose_x_ticks()
  {
    for (const unsigned int n_wanted : {7, 5, 4, 3, 2})
      {
        x_ticks = x_axis.ticks(n_wanted);

        double label_width = 0.;
        for (const PlotTick &tick : x_ticks)
          label_width += tick_font * (tick.label.width + 1.) * tick.is_major;
        if (label_width < area.right - area.left)
          return;
      }
  }



  /** Where data are: points along all curves, a few pixels apart. */
  std::vector<PlotPoint>
  PlotLayout::obstacles() const
  {
    std::vector<PlotPoint> points;
    for (const Pieces &pieces : curve_pieces)
      for (const std::vector<PlotPoint> &piece : pieces)
        for (std::size_t i = 0; i < piece.size(); ++i)
          {
            const PlotPoint from  = piece[i == 0 ? 0 : i - 1];
            const PlotPoint step  = {piece[i].x - from.x, piece[i].y - from.y};
            const double n_points = std::ceil(std::hypot(step.x, step.y) / 4.);
            for (double j = 0; j <= n_points; ++j)
              {
                const double part = n_points > 0. ? j / n_points : 0.;
                points.push_back(
                  {from.x + part * step.x, from.y + part * step.y});
              }
          }
    return points;
  }



  void
  PlotLayout::list_legend()
  {
    for (std::size_t i = 0; i < content.curves.size(); ++i)
      if (!content.curves[i].label.empty())
        legend.push_back({plain_text(content.curves[i].label), i, false});
    for (std::size_t i = 0; i < content.bands.size(); ++i)
      if (!content.bands[i].label.empty())
        legend.push_back({plain_text(content.bands[i].label), i, true});
  }



  /** In the first corner of the area without data, or right of it. */
  void
  PlotLayout::place_legend()
  {
    double text_width = 0.;
    for (const LegendEntry &entry : legend)
      text_width = std::max(text_width, legend_font * entry.text.width);
    const double width  = text_width + sample_width + 26.;
    const double height = legend_row * legend.size() + 8.;

    const auto box_at = [&](const double left, const double top) {
      return PlotBox{left, top, left + width, top + height};
    };
    const double                 left   = area.left + 10.;
    const double                 right  = area.right - width - 10.;
    const double                 top    = area.top + 10.;
    const double                 bottom = area.bottom - height - 10.;
    const std::array<PlotBox, 4> corners{{box_at(right, top),
                                          box_at(left, top),
                                          box_at(right, bottom),
                                          box_at(left, bottom)}};

    const std::vector<PlotPoint> points = obstacles();
    const auto                   corner =
      std::find_if(corners.begin(), corners.end(), [&](const PlotBox &box) {
        return is_clear(box, points);
      });
    const bool fits = width < 0.6 * (area.right - area.left) &&
                      height < 0.8 * (area.bottom - area.top);
    if (corner != corners.end() && fits)
      legend_box = *corner;
    else
      {
        legend_box  = box_at(area.right + 12., area.top);
        total_width = legend_box.right + 10.;
      }
  }
} // namespace RollingContact
