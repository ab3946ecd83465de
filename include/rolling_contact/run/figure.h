#ifndef rolling_contact_run_figure_h
#define rolling_contact_run_figure_h

#include <rolling_contact/run/run_context.h>

#include <array>
#include <string>
#include <vector>

namespace RollingContact
{
  enum class CurveStyle
  {
    line,
    dashed,
    points,
    line_and_points,
    /** Black, each dashed in its way; takes no colour of the palette. */
    reference,
    /** A line that stands out of others on which it lies. */
    thick,
    /** From x = 0 to each point, see set_names(). */
    bars,
    /** No point but the label, above each. */
    name_beside,
    /** Small grey points below all others; takes no colour of the palette. */
    marks,
    /** See Figure::add_arrows(). */
    arrows
  };

  enum class MapColours
  {
    from_least,
    /** Colours begin at 0, all below is plain. */
    from_zero
  };

  enum class AxisScale
  {
    linear,
    logarithmic
  };

  /**
   * A picture of curves y(x), shaded bands and maps v(x, y), drawn by gnuplot
   * from a file of data and a script that stay beside it, to be restyled.
   * Values are written as they are given: scale them to the units of the
   * labels. Ranges and ticks follow from the data; points that are not finite,
   * or not positive on a logarithmic axis, leave a gap. Texts are UTF-8.
   */
  class Figure
  {
  public:
    /** Labels carry their units. */
    Figure(const std::string &title,
           const std::string &x_label,
           const std::string &y_label);

    void set_scales(const AxisScale x_scale, const AxisScale y_scale);

    /**
     * One unit of x is as long as one of y, for sections and maps of places.
     * Linear axes only, not for maps.
     */
    void set_equal_scales()
    {
      equal_scales = true;
    }

    /** The axis of y has these names at 1, 2, ..., from the top down. */
    void set_names(const std::vector<std::string> &names);

    /** A curve without label is not in the legend. Throws std::invalid_argument
     * if x and y have different lengths. */
    void add_curve(const std::string         &label,
                   const std::vector<double> &x,
                   const std::vector<double> &y,
                   const CurveStyle           style = CurveStyle::line);

    /**
     * Arrows from (x, y) by (along_x, along_y). Throws std::invalid_argument if
     * their numbers differ.
     */
    void add_arrows(const std::string         &label,
                    const std::vector<double> &x,
                    const std::vector<double> &y,
                    const std::vector<double> &along_x,
                    const std::vector<double> &along_y);

    /** Shades begin <= x <= end behind the curves. */
    void
    add_band(const std::string &label, const double begin, const double end);

    /**
     * Colours the rectangle spanned by x and y, which ascend, according to
     * values[j * x.size() + i] at (x[i], y[j]). The label belongs to the colour
     * bar. Throws std::invalid_argument if the number of values is another.
     */
    void add_map(const std::string         &label,
                 const std::vector<double> &x,
                 const std::vector<double> &y,
                 const std::vector<double> &values,
                 const MapColours           colours = MapColours::from_least);

    /**
     * Puts the curves and bands of another figure, whose title is not shown,
     * into a panel of its own below those there are, over the same x: they have
     * one label of the x axis and should have points at the same x. Not for
     * maps. Throws std::invalid_argument if the labels of x differ, or with
     * maps.
     */
    void add_panel(const Figure &panel);

    /** Add a panel with an x axis of its own, whose label is drawn below it. */
    void add_separate_panel(const Figure &panel);

    /**
     * Tab-separated values with 9 significant digits, one block for each map
     * and then each curve, two empty lines between blocks. Above each block
     * stand the label and the names of its columns, as comments. Curves of more
     * than 10000 points keep the lowest and the highest of each short stretch.
     */
    std::string data() const;

    /** The gnuplot script that draws NAME.svg from NAME.dat. */
    std::string script(const std::string &name) const;

    /**
     * Writes NAME.dat and NAME.gp into the run folder and lets gnuplot draw
     * NAME.svg. Without gnuplot a message, and if it fails or takes longer than
     * a minute a warning, tells how to draw it; there is no old picture then.
     * On other MPI ranks than the root it does nothing.
     */
    void draw(RunContext &context, const std::string &name) const;

  private:
    struct Curve
    {
      std::string         label;
      std::vector<double> x;
      std::vector<double> y;
      CurveStyle          style;
      std::vector<double> along_x, along_y; ///< of arrows
    };

    struct Band
    {
      std::string label;
      double      begin;
      double      end;
    };

    struct Map
    {
      std::string         label;
      std::vector<double> x;
      std::vector<double> y;
      std::vector<double> values;
      MapColours          colours;
    };

    std::string                 block_data() const;
    std::vector<const Figure *> all_panels() const;
    std::string                 layout() const;
    std::string                 panel_layout(const std::size_t index) const;
    double                      bottom_of(const std::size_t index) const;
    bool                        shows_x_axis(const std::size_t index) const;
    std::string equal_ranges(const std::array<double, 2> &pixels) const;
    std::string items(const std::string &name, std::size_t &block) const;
    std::string axis(const char axis, const std::string &label) const;
    std::string names_as_tics() const;

    static bool can_be_drawn(const double value, const AxisScale scale);

    /** For gnuplot, which substitutes nothing between single quotes. */
    static std::string quoted(const std::string &text);

    std::string band(const std::size_t index) const;
    std::string look(const std::size_t index) const;

    std::string              title;
    std::string              x_label;
    std::string              y_label;
    AxisScale                x_scale      = AxisScale::linear;
    AxisScale                y_scale      = AxisScale::linear;
    bool                     equal_scales = false;
    bool                     has_own_x    = false; ///< as a panel
    std::vector<std::string> names;                ///< along y
    std::vector<Curve>       curves;
    std::vector<Band>        bands;
    std::vector<Map>         maps;
    std::vector<Figure>      panels; ///< below this one
  };
} // namespace RollingContact

#endif
