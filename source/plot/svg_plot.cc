#include <rolling_contact/plot/plot_axis.h>
#include <rolling_contact/plot/plot_layout.h>
#include <rolling_contact/plot/svg_canvas.h>
#include <rolling_contact/plot/svg_plot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    constexpr double label_font = 13.5;
    constexpr double title_font = 15.;

    const std::string text_colour = "#222222";

    const std::array<std::string, 3> band_colours{
      {"#E3EBF4", "#F6ECDC", "#E4F1E7"}};

    /** Of the references, which have one colour. */
    const std::array<std::string, 3> dash_patterns{{"6 4", "2 2.5", "8 3 2 3"}};



    /** Writes one plot. */
    class Drawing
    {
    public:
      explicit Drawing(const SvgPlot::Content &content)
        : content(content)
        , layout(content)
        , canvas(layout.total_width,
                 PlotLayout::figure_height,
                 plain_text(content.title),
                 text_colour)
      {}

      std::string
      svg();

    private:
      using Anchor = SvgCanvas::Anchor;

      void
      draw_bands();
      void
      draw_grid();
      void
      draw_frame();
      void
      draw_labels();
      void
      draw_curve(const std::size_t index);
      void
      draw_marker(const std::size_t index,
                  const PlotPoint  &point,
                  const double      radius);
      void
      draw_legend();

      std::string
      stroke(const std::size_t index) const;
      std::string
      dashes(const std::size_t index) const;

      const SvgPlot::Content &content;
      const PlotLayout        layout;
      SvgCanvas               canvas;
    };



    std::string
    Drawing::svg()
    {
      draw_bands();
      draw_grid();
      for (std::size_t i = 0; i < content.curves.size(); ++i)
        draw_curve(i);
      draw_frame();
      draw_labels();
      if (!layout.legend.empty())
        draw_legend();
      return canvas.svg();
    }



    void
    Drawing::draw_bands()
    {
      for (std::size_t i = 0; i < content.bands.size(); ++i)
        {
          if (std::isnan(content.bands[i].begin) ||
              std::isnan(content.bands[i].end))
            continue;
          const double left =
            layout.x_axis.clamped_position(content.bands[i].begin);
          const double right =
            layout.x_axis.clamped_position(content.bands[i].end);
          if (right > left)
            canvas.rectangle({left, layout.area.top, right, layout.area.bottom},
                             "fill=\"" + band_colours[i % band_colours.size()] +
                               '"');
        }
    }



    void
    Drawing::draw_grid()
    {
      const auto shade = [](const PlotTick &tick) {
        const bool is_zero = tick.value == 0.;
        return std::string("stroke=\"") + (is_zero ? "#9A9A9A" : "#000000") +
               "\" stroke-opacity=\"" +
               (is_zero ? "1" : (tick.is_major ? "0.12" : "0.05")) +
               "\" stroke-width=\"0.8\"";
      };
      for (const PlotTick &tick : layout.x_ticks)
        {
          const double x = layout.x_axis.position(tick.value);
          canvas.line({x, layout.area.top},
                      {x, layout.area.bottom},
                      shade(tick));
        }
      for (const PlotTick &tick : layout.y_ticks)
        {
          const double y = layout.y_axis.position(tick.value);
          canvas.line({layout.area.left, y},
                      {layout.area.right, y},
                      shade(tick));
        }
    }



    void
    Drawing::draw_frame()
    {
      const std::string thin =
        "stroke=\"" + text_colour + "\" stroke-width=\"0.9\"";
      canvas.rectangle(layout.area, "fill=\"none\" " + thin);
      for (const PlotTick &tick : layout.x_ticks)
        {
          const double x      = layout.x_axis.position(tick.value);
          const double length = tick.is_major ? 5. : 3.;
          canvas.line({x, layout.area.bottom},
                      {x, layout.area.bottom + length},
                      thin);
          canvas.text(tick.label,
                      {x, layout.area.bottom + 19.},
                      PlotLayout::tick_font,
                      Anchor::middle);
        }
      for (const PlotTick &tick : layout.y_ticks)
        {
          const double y      = layout.y_axis.position(tick.value);
          const double length = tick.is_major ? 5. : 3.;
          canvas.line({layout.area.left - length, y},
                      {layout.area.left, y},
                      thin);
          canvas.text(tick.label,
                      {layout.area.left - 9., y + 4.},
                      PlotLayout::tick_font,
                      Anchor::end);
        }
    }



    void
    Drawing::draw_labels()
    {
      const PlotPoint centre{(layout.area.left + layout.area.right) / 2.,
                             (layout.area.top + layout.area.bottom) / 2.};
      canvas.text(plain_text(content.title),
                  {centre.x, 26.},
                  title_font,
                  Anchor::middle,
                  "font-weight=\"bold\"");
      canvas.text(plain_text(content.x_label),
                  {centre.x, layout.area.bottom + 43.},
                  label_font,
                  Anchor::middle);
      canvas.text(plain_text(content.y_label),
                  {20., centre.y},
                  label_font,
                  Anchor::middle,
                  "transform=\"rotate(-90 20 " + pixels(centre.y) + ")\"");

      if (layout.x_axis.exponent() != 0)
        canvas.text(power_of_ten("\u00D7", layout.x_axis.exponent()),
                    {layout.area.right, layout.area.bottom + 43.},
                    PlotLayout::tick_font,
                    Anchor::end);
      if (layout.y_axis.exponent() != 0)
        canvas.text(power_of_ten("\u00D7", layout.y_axis.exponent()),
                    {layout.area.left, layout.area.top - 7.},
                    PlotLayout::tick_font,
                    Anchor::start);
      if (layout.is_empty)
        canvas.text(plain_text("no data"), centre, label_font, Anchor::middle);
    }



    std::string
    Drawing::dashes(const std::size_t index) const
    {
      const CurveStyle style = content.curves[index].style;
      if (style != CurveStyle::dashed && style != CurveStyle::reference)
        return "";
      std::size_t n_before = 0;
      if (style == CurveStyle::reference)
        for (std::size_t i = 0; i < index; ++i)
          n_before += content.curves[i].style == CurveStyle::reference;
      return " stroke-dasharray=\"" +
             dash_patterns[n_before % dash_patterns.size()] + '"';
    }



    std::string
    Drawing::stroke(const std::size_t index) const
    {
      const CurveStyle style = content.curves[index].style;
      return "fill=\"none\" stroke=\"" + layout.colours[index] +
             "\" stroke-width=\"" +
             (style == CurveStyle::reference ? "1.4" : "1.8") +
             "\" stroke-linejoin=\"round\"" + dashes(index);
    }



    void
    Drawing::draw_curve(const std::size_t index)
    {
      const CurveStyle style = content.curves[index].style;
      const bool       has_points =
        style == CurveStyle::points || style == CurveStyle::line_and_points;
      const double spacing =
        (layout.area.right - layout.area.left) / content.curves[index].x.size();
      const double radius = std::clamp(0.4 * spacing, 1.8, 3.2);

      for (const std::vector<PlotPoint> &piece : layout.curve_pieces[index])
        {
          if (style != CurveStyle::points && piece.size() > 1)
            canvas.polyline(piece, stroke(index));
          if (has_points || piece.size() == 1)
            for (const PlotPoint &point : piece)
              draw_marker(index, point, radius);
        }
    }



    void
    Drawing::draw_marker(const std::size_t index,
                         const PlotPoint  &point,
                         const double      radius)
    {
      const std::string look = "fill=\"" + layout.colours[index] +
                               "\" stroke=\"white\" stroke-width=\"0.6\"";
      const auto polygon = [&](std::vector<PlotPoint> corners) {
        for (PlotPoint &corner : corners)
          corner = {point.x + 1.2 * radius * corner.x,
                    point.y + 1.2 * radius * corner.y};
        canvas.polygon(corners, look);
      };

      switch (index % 4)
        {
          case 0:
            canvas.circle(point, radius, look);
            break;
          case 1:
            polygon({{-.8, -.8}, {.8, -.8}, {.8, .8}, {-.8, .8}});
            break;
          case 2:
            polygon({{0., -1.1}, {1., .8}, {-1., .8}});
            break;
          default:
            polygon({{0., -1.15}, {1.15, 0.}, {0., 1.15}, {-1.15, 0.}});
        }
    }



    void
    Drawing::draw_legend()
    {
      canvas.rectangle(layout.legend_box,
                       "fill=\"white\" fill-opacity=\"0.9\" stroke=\"#D0D0D0\" "
                       "stroke-width=\"0.8\" rx=\"2\"");
      double y = layout.legend_box.top + 4. + PlotLayout::legend_row / 2.;
      for (const PlotLayout::LegendEntry &entry : layout.legend)
        {
          const double left  = layout.legend_box.left + 8.;
          const double right = left + PlotLayout::sample_width;
          if (entry.is_band)
            canvas.rectangle({left, y - 6., right, y + 6.},
                             "fill=\"" +
                               band_colours[entry.index % band_colours.size()] +
                               '"');
          else
            {
              const CurveStyle style = content.curves[entry.index].style;
              if (style != CurveStyle::points)
                canvas.line({left, y}, {right, y}, stroke(entry.index));
              if (style == CurveStyle::points ||
                  style == CurveStyle::line_and_points)
                draw_marker(entry.index, {(left + right) / 2., y}, 3.2);
            }
          canvas.text(entry.text,
                      {right + 8., y + 4.},
                      PlotLayout::legend_font,
                      Anchor::start);
          y += PlotLayout::legend_row;
        }
    }
  } // namespace



  SvgPlot::SvgPlot(const std::string &title,
                   const std::string &x_label,
                   const std::string &y_label)
    : content{title, x_label, y_label}
  {}



  void
  SvgPlot::set_scales(const AxisScale x_scale, const AxisScale y_scale)
  {
    content.x_scale = x_scale;
    content.y_scale = y_scale;
  }



  void
  SvgPlot::add_curve(const std::string         &label,
                     const std::vector<double> &x,
                     const std::vector<double> &y,
                     const CurveStyle           style)
  {
    if (x.size() != y.size())
      throw std::invalid_argument("Curve \"" + label +
                                  "\" has unequal numbers of x and y.");
    content.curves.push_back({label, x, y, style});
  }



  void
  SvgPlot::add_band(const std::string &label,
                    const double       begin,
                    const double       end)
  {
    content.bands.push_back({label, begin, end});
  }



  std::string
  SvgPlot::svg() const
  {
    return Drawing(content).svg();
  }



  void
  SvgPlot::write(RunFolder &folder, const std::string &file_name) const
  {
    folder.write_atomically(file_name, svg());
  }
} // namespace RollingContact
