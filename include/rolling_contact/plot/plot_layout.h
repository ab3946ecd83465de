#ifndef rolling_contact_plot_plot_layout_h
#define rolling_contact_plot_plot_layout_h

#include <rolling_contact/plot/plot_axis.h>
#include <rolling_contact/plot/svg_canvas.h>
#include <rolling_contact/plot/svg_plot.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Where everything of a plot stands and which colours its curves have, as the
   * constructor chooses it; draws nothing. The content must outlive it.
   */
  class PlotLayout
  {
  public:
    static constexpr double figure_width  = 640.;
    static constexpr double figure_height = 420.;
    static constexpr double tick_font     = 12.;
    static constexpr double legend_font   = 12.;
    static constexpr double legend_row    = 19.;
    static constexpr double sample_width  = 28.;

    /** A curve: its unbroken pieces. */
    using Pieces = std::vector<std::vector<PlotPoint>>;

    struct LegendEntry
    {
      PlotText    text;
      std::size_t index;
      bool        is_band;
    };

    explicit PlotLayout(const SvgPlot::Content &content);

    const SvgPlot::Content &content;

    /** Whether no curve has a point that can be drawn. */
    bool                     is_empty;
    PlotAxis                 x_axis;
    PlotAxis                 y_axis;
    std::vector<PlotTick>    x_ticks;
    std::vector<PlotTick>    y_ticks;
    std::vector<std::string> colours;
    std::vector<Pieces>      curve_pieces;
    std::vector<LegendEntry> legend;
    PlotBox                  area;
    PlotBox                  legend_box;
    double                   total_width;

  private:
    std::vector<double>
    drawn_values(const bool of_x) const;
    Pieces
    pieces(const SvgPlot::Curve &curve) const;
    std::vector<PlotPoint>
    obstacles() const;
    void
    choose_colours();
    void
    place_area();
    void
    choose_x_ticks();
    void
    list_legend();
    void
    place_legend();
  };
} // namespace RollingContact

#endif
