#ifndef rolling_contact_contact_overlap_h
#define rolling_contact_contact_overlap_h

#include <rolling_contact/contact/trace.h>

namespace RollingContact
{
  using Point2 = std::array<double, 2>;

  /**
   * A point where an interface cell and a face of a surface overlap, for
   * integrals over the overlap: weight in m or m^2, and the shape functions of
   * the face there.
   */
  struct OverlapPoint
  {
    Point2                at;
    double                weight;
    std::array<double, 4> shapes;
  };

  /**
   * Quadrature points on the overlap of a cell with a face, a segment with
   * corners 0, 1 or a convex quadrilateral with corners 0, 1, 2, 3 as those of
   * a cell. Exact for products of shape functions of both if the face is a
   * parallelogram; otherwise those of the face are rational functions, and the
   * error is below 1e-12 for moderately distorted ones. Empty if they do not
   * overlap.
   */
  std::vector<OverlapPoint> overlap_points(const Trace::Cell           &cell,
                                           const std::array<Point2, 4> &face,
                                           const unsigned int n_dimensions);

  /**
   * True if the corners 0, 1, 2, 3 of @p face, ordered as those of a cell, are
   * those of a convex quadrilateral.
   */
  bool is_convex(const std::array<Point2, 4> &face);
} // namespace RollingContact

#endif
