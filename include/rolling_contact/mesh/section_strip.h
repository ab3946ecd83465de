#ifndef rolling_contact_mesh_section_strip_h
#define rolling_contact_mesh_section_strip_h

#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/mesh/surface_chart.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Quadrilaterals between the straight line from @p begin to @p end and a
   * curve that runs beside it, in so many @p rows; returns them, the one at the
   * curve last. Adds them to @p mesh.
   */
  std::vector<unsigned int> add_ring_cells(const SectionPoint       &begin,
                                           const SectionPoint       &end,
                                           const SectionMesh::Curve &outside,
                                           const unsigned int        rows,
                                           SectionMesh              &mesh);

  /**
   * The strip of quadrilaterals under a running surface at the coordinates @p
   * breaks, down to the points of an inner line; @p surface is the point at a
   * coordinate. Adds them to @p mesh.
   */
  void add_strip(const std::vector<double>                       &breaks,
                 const std::vector<SectionPoint>                 &inner,
                 const std::function<SectionPoint(const double)> &surface,
                 const unsigned int                               rows,
                 SectionMesh                                     &mesh);

  /**
   * Rows that a strip needs for cells no deeper than @p deepest.
   */
  unsigned int
  rows_of_strip(const std::vector<double>                       &breaks,
                const std::vector<SectionPoint>                 &inner,
                const std::function<SectionPoint(const double)> &surface,
                const double                                     deepest);

  /**
   * Rows of quadrilaterals between rows of points, all of one length.
   */
  void add_rows(const std::vector<std::vector<SectionPoint>> &rows,
                SectionMesh                                  &mesh);

  /**
   * Lattice points of @p cells, multiples of their size, that are at least half
   * a cell inside of [begin, end], and the ends.
   */
  std::vector<double>
  strip_breaks(const double begin, const double end, const CoarseCells &cells);

  SectionPoint
  between(const SectionPoint &p, const SectionPoint &q, const double t);

  /**
   * The ends of @p n equal parts of the line from p to q.
   */
  std::vector<SectionPoint> equal_parts(const SectionPoint &p,
                                        const SectionPoint &q,
                                        const unsigned int  n);

  /**
   * The break nearest to a coordinate.
   */
  unsigned int nearest_break(const std::vector<double> &breaks,
                             const double               coordinate);
} // namespace RollingContact

#endif
