#ifndef rolling_contact_mesh_grading_h
#define rolling_contact_mesh_grading_h

#include <deal.II/base/point.h>

#include <rolling_contact/base/side.h>
#include <rolling_contact/mesh/zone_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace RollingContact
{
  /**
   * A box of the chart, x counted from the contact point, in which elements
   * have at most the given size in x; those next to it have at most twice that,
   * and sizes grow from there as in the rest of the mesh. Units: m.
   */
  template <int dim>
  struct RefinedBox
  {
    dealii::Point<dim> lower, upper;
    double             size;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[lower, upper, size] = *this;
      archive &lower &upper &size;
    }
  };

  /**
   * Element sizes around the patch, the same for both bodies. The nodes that
   * may touch are those of zone_boxes or, where there are none, of the ellipse
   * with semi-axes zone_x and zone_y, longer by an element on its upstream
   * side. Elements have size element_size[] in it
   * and one element around it, to zone_depth, growing by @p growth times the
   * distance from there, and beyond far_distance by far_growth. Towards the rim
   * of the patch, sizes are halved up to rim_levels more times, the leading
   * edge alone if leading_edge_only. Refined boxes come on top. A uniform
   * grading has no zone. Units: m, shifts in elements.
   */
  template <int dim>
  struct Grading
  {
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    double       element_size_x  = 0.;
    double       element_size_y  = 0.; ///< 3D only
    double       zone_x          = 0.; ///< how far the zone reaches from the
    double       zone_y          = 0.; ///< origin
    int          upstream        = 0;  ///< its side: sign of x, 0 for none
    double       zone_depth      = 0.;
    double       growth          = 0.5;
    double       far_distance    = infinity; ///< from where on sizes grow by
    double       far_growth      = 0.5;      ///< this instead
    double       offset          = 0.; ///< shift of the mesh in +x, in elements
    unsigned int rim_levels      = 0;
    double       leading_edge_x  = 0.; ///< where the rim is refined
    double       trailing_edge_x = 0.;
    bool         leading_edge_only = true;
    double       rim_width         = 0.; ///< half-width of the refined band

    std::vector<RefinedBox<dim>> boxes;
    std::vector<ZoneBox>         zone_boxes;

    /**
     * Where bodies that keep their mesh for several places of the contact have
     * small elements, in the charts of their coarse cells; empty for the zone
     * alone. See BodyShape::on_surface().
     */
    PerSide<std::vector<ZoneBox>> strips;

    double deeper = 1.; ///< elements, see element_size_z()

    bool is_alone   = false; ///< no nodes of contact are on the body
    bool is_uniform = false; ///< all cells alike, of at most the element sizes

    /**
     * Without a contact zone, for analyses of a body alone: cells all along x
     * alike, with equal angles round an axle, none longer than @p along nor, in
     * the section, than @p across. Units: m.
     */
    static Grading uniform(const double along, const double across)
    {
      Grading grading;
      grading.element_size_x = along;
      grading.element_size_y = across;
      grading.is_uniform     = true;
      return grading;
    }

    /**
     * Uniform, with as few cells as resolve the shape; a section from a file is
     * swept as it is.
     */
    static Grading unrefined()
    {
      return uniform(infinity, infinity);
    }

    /**
     * Grading of a body which is coupled by a mortar to an interface of this
     * grading: elements shorter than the interface's, in a zone larger by some
     * of them, so that none hangs where they are coupled. Its cells are halved
     * in all directions at once: some more depth saves many. The zone reaches
     * as far downstream as upstream, as a body that is its own mirror image has
     * its modes found in halves.
     */
    Grading of_coupled_body() const;

    /**
     * Elements across the patch that the mesh was made for.
     */
    unsigned int elements_across() const
    {
      return std::lround(2 * std::abs(leading_edge_x) / element_size_x);
    }

    /**
     * Size of the elements in depth: that along x, but at most a few times that
     * across, as stresses fade over the width of a slender patch; @p deeper
     * times that.
     */
    double element_size_z() const
    {
      const double largest = 2.5;
      return deeper * (dim == 3 && element_size_y > 0.
                         ? std::min(element_size_x, largest * element_size_y)
                         : element_size_x);
    }

    /**
     * Centre and semi-axis in x of the ellipse of nodes that may touch.
     */
    double centre_x() const
    {
      return upstream * element_size_x / 2;
    }

    double semi_axis_x() const
    {
      return zone_x + std::abs(centre_x());
    }

    /**
     * True if the middle of a box of the surface lies in the zone of nodes that
     * may touch, by a margin that keeps rounding from deciding.
     */
    bool in_zone(const dealii::Point<dim - 1> &lower,
                 const dealii::Point<dim - 1> &upper) const;

    /**
     * The first and the last coordinate along x of nodes that may touch.
     */
    std::array<double, 2> zone_along() const
    {
      return zone_boxes.empty()
               ? std::array<double, 2>{{centre_x() - semi_axis_x(),
                                        centre_x() + semi_axis_x()}}
               : ends_of_boxes(0);
    }

    /**
     * The first and the last coordinate across of nodes that may touch.
     */
    std::array<double, 2> zone_across() const
    {
      return zone_boxes.empty() ? std::array<double, 2>{{-zone_y, zone_y}}
                                : ends_of_boxes(1);
    }

    /**
     * Let more nodes touch: the zone grows by @p n_elements on each side.
     */
    void enlarge_zone(const unsigned int n_elements)
    {
      zone_x += n_elements * element_size_x;
      zone_y += n_elements * element_size_y;
      for (ZoneBox &box : zone_boxes)
        box =
          box.grown(n_elements * element_size_x, n_elements * element_size_y);
    }

    /**
     * True if a cell that fills the box [lower, upper] of the chart (x from the
     * contact point) is too large.
     */
    bool refine(const dealii::Point<dim> &lower,
                const dealii::Point<dim> &upper) const;

    /**
     * Size of a cell, or of a face of the surface, measured in x: the largest
     * of its extents over the element sizes, times that in x.
     */
    double size_in_x(const dealii::Point<dim> &lower,
                     const dealii::Point<dim> &upper) const;

    /**
     * Size allowed by the zone, without rim and boxes, at the point of the box
     * [lower, upper] nearest to it.
     */
    double allowed_size(const dealii::Point<dim> &lower,
                        const dealii::Point<dim> &upper) const;

  private:
    /**
     * The first and the last coordinate along @p d of the zone's boxes.
     */
    std::array<double, 2> ends_of_boxes(const unsigned int d) const
    {
      std::array<double, 2> ends{{infinity, -infinity}};
      for (const ZoneBox &box : zone_boxes)
        {
          ends[0] = std::min(ends[0], box.lower[d]);
          ends[1] = std::max(ends[1], box.upper[d]);
        }
      return ends;
    }

    /**
     * The zone longer by an element on its downstream side too.
     */
    void make_even_in_x();

    /**
     * Distance of the box [lower, upper] of the chart from the zone along the
     * surface, measured in x.
     */
    double outside_zone(const dealii::Point<dim> &lower,
                        const dealii::Point<dim> &upper) const;

    bool exceeds_rim(const double              size,
                     const dealii::Point<dim> &lower,
                     const dealii::Point<dim> &upper) const;

    bool exceeds_boxes(const double              size,
                       const dealii::Point<dim> &lower,
                       const dealii::Point<dim> &upper) const;
  };
} // namespace RollingContact

#endif
