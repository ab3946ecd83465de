#include <deal.II/distributed/tria.h>

#include <p4est.h>

#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/mesh/mesh_memory.h>
#include <rolling_contact/parallel/ranks.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::string generated_remedy =
      "take fewer Mesh/Elements across patch, a larger Mesh/Growth or a "
      "smaller Mesh/Candidate zone.";



    /**
     * The largest power-of-two multiple of @p element_size not above @p limit.
     */
    double
    coarse_size(const double element_size, const double limit)
    {
      return std::ldexp(
        element_size,
        std::max(0, int(std::floor(std::log2(limit / element_size)))));
    }



    /**
     * Break points in [begin, end]: multiples of @p size from @p origin; the
     * first and last interval take the remainder, at least half a @p size long.
     */
    std::vector<double>
    break_points(const double begin,
                 const double end,
                 const double origin,
                 const double size)
    {
      std::vector<double> points{begin};
      const int           first = std::ceil((begin - origin) / size);
      for (int k = first; origin + k * size < end; ++k)
        if (origin + k * size > begin + size / 2 &&
            origin + k * size < end - size / 2)
          points.push_back(origin + k * size);
      points.push_back(end);
      return points;
    }



    std::vector<double>
    equal_parts(const double begin, const double end, const unsigned int n)
    {
      std::vector<double> points(n + 1);
      for (unsigned int i = 0; i <= n; ++i)
        points[i] = begin + (end - begin) * i / n;
      return points;
    }



    /**
     * Break points along x: of a disc around the whole rim from the begin of
     * the sector of @p n_sector cells, in the manifold's x; of a block from end
     * to end.
     */
    template <int dim>
    std::vector<double>
    break_points_x(const BodyGeometry   &geometry,
                   const BodyChart<dim> &chart,
                   const double          origin,
                   const double          size,
                   const unsigned int    n_sector)
    {
      if (geometry.shape == Shape::block)
        return break_points(-geometry.length / 2,
                            geometry.length / 2,
                            origin,
                            size);
      const double       sector = n_sector * size;
      const unsigned int n_rest =
        std::max(4., std::round((chart.period() - sector) / size));
      std::vector<double> points = equal_parts(0., sector, n_sector);
      points.pop_back();
      for (const double x : equal_parts(sector, chart.period(), n_rest))
        points.push_back(x);
      return points;
    }



    /**
     * Number the vertices of the boxes and glue the seam of a disc.
     */
    template <int dim>
    void
    create_coarse_mesh(const std::array<std::vector<double>, dim> &breaks,
                       const BodyChart<dim>                       &chart,
                       Triangulation<dim> &triangulation)
    {
      const bool           closed = chart.period() > 0.;
      std::array<int, dim> n_cells, n_points;
      for (int d = 0; d < dim; ++d)
        {
          n_cells[d]  = breaks[d].size() - 1;
          n_points[d] = n_cells[d] + (d == 0 && closed ? 0 : 1);
        }
      const auto number = [&](const std::array<int, dim> &index) {
        unsigned int result = 0;
        for (int d = dim - 1; d >= 0; --d)
          result = result * n_points[d] + index[d] % n_points[d];
        return result;
      };
      const auto for_each = [](const std::array<int, dim> &extent,
                               const auto                 &action) {
        int total = 1;
        for (const int n : extent)
          total *= n;
        for (int position = 0; position < total; ++position)
          {
            std::array<int, dim> index;
            for (int d = 0, rest = position; d < dim; rest /= extent[d++])
              index[d] = rest % extent[d];
            action(index);
          }
      };

      std::vector<Point<dim>> vertices;
      for_each(n_points, [&](const std::array<int, dim> &index) {
        Point<dim> point;
        for (int d = 0; d < dim; ++d)
          point[d] = breaks[d][index[d]];
        vertices.push_back(chart.push_forward(point));
      });
      std::vector<CellData<dim>> cells;
      for_each(n_cells, [&](const std::array<int, dim> &index) {
        CellData<dim> cell;
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          {
            std::array<int, dim> corner = index;
            for (int d = 0; d < dim; ++d)
              corner[d] += (v >> d) & 1;
            cell.vertices[v] = number(corner);
          }
        cells.push_back(cell);
      });
      triangulation.create_triangulation(vertices, cells, SubCellData());
    }



    template <int dim>
    void
    set_boundary_ids(const BodyGeometry   &geometry,
                     const BodyChart<dim> &chart,
                     Triangulation<dim>   &triangulation)
    {
      const double tolerance = 1e-6 * geometry.thickness_below();
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              bool on_surface = true, on_hub = true;
              for (const unsigned int v : cell->face(f)->vertex_indices())
                {
                  const double w =
                    chart.pull_back(cell->face(f)->vertex(v))[dim - 1];
                  on_surface = on_surface && std::abs(w) < tolerance;
                  on_hub     = on_hub &&
                           std::abs(w + geometry.thickness_below()) < tolerance;
                }
              cell->face(f)->set_boundary_id(
                on_surface ? contact_boundary
                           : (on_hub ? hub_boundary : free_boundary));
            }
    }
  } // namespace



  template <int dim>
  std::pair<Point<dim>, Point<dim>>
  BodyMesh<dim>::chart_box(
    const typename Triangulation<dim>::cell_iterator &cell) const
  {
    Point<dim> lower = chart->pull_back(cell->vertex(0)), upper = lower;
    lower[0] = upper[0] = chart->centred_x(lower[0]);
    const double period = chart->period(), reference = lower[0];
    for (const unsigned int v : cell->vertex_indices())
      {
        Point<dim> corner = chart->pull_back(cell->vertex(v));
        corner[0]         = chart->centred_x(corner[0]);
        if (period > 0.)
          corner[0] -= period * std::round((corner[0] - reference) / period);
        for (int d = 0; d < dim; ++d)
          {
            lower[d] = std::min(lower[d], corner[d]);
            upper[d] = std::max(upper[d], corner[d]);
          }
      }
    // a corner opposite the contact may be on either side of the seam, by
    // rounding: the middle decides
    if (period > 0.)
      {
        const double shift =
          period * std::round((lower[0] + upper[0]) / (2 * period));
        lower[0] -= shift;
        upper[0] -= shift;
      }
    return {lower, upper};
  }



  namespace
  {
    /**
     * p4est says nothing unless it is told before its first use.
     */
    void
    start_p4est()
    {
      static bool started = false;
      if (started)
        return;
      started = true;
      Ranks::start();
      sc_init(Ranks::communicator(), 0, 0, nullptr, SC_LP_SILENT);
      p4est_init(nullptr, SC_LP_SILENT);
    }



    template <int dim>
    std::unique_ptr<Triangulation<dim>>
    make_triangulation(const MeshKind kind)
    {
      const auto smoothing =
        Triangulation<dim>::limit_level_difference_at_vertices;
      if (kind == MeshKind::serial)
        return std::make_unique<Triangulation<dim>>(smoothing);
      start_p4est();
      return std::make_unique<parallel::distributed::Triangulation<dim>>(
        Ranks::communicator(), smoothing);
    }



    /**
     * Refine until no cell is larger than @p grading allows.
     */
    template <int dim>
    void
    refine(const Grading<dim> &grading, BodyMesh<dim> &mesh)
    {
      Triangulation<dim> &cells     = *mesh.triangulation;
      double              n_flagged = 1.;
      while (n_flagged > 0.)
        {
          n_flagged = 0.;
          for (const auto &cell : cells.active_cell_iterators())
            if (cell->is_locally_owned())
              {
                const auto box = mesh.chart_box(cell);
                if (grading.refine(box.first, box.second))
                  {
                    cell->set_refine_flag();
                    ++n_flagged;
                  }
              }
          if (mesh.kind == MeshKind::distributed)
            n_flagged = Ranks::sum(n_flagged);
          check_mesh_memory<dim>(cells.n_global_active_cells() +
                                   (std::pow(2., dim) - 1) * n_flagged,
                                 mesh.kind,
                                 generated_remedy);
          if (n_flagged > 0.)
            cells.execute_coarsening_and_refinement();
        }
    }



    /**
     * Of coarse cells of this @p size, in depth and across; cells never deeper
     * than long, so that x alone decides on the surface nodes.
     */
    template <int dim>
    std::array<std::vector<double>, dim>
    break_points_below(const BodyGeometry &geometry,
                       const Grading<dim> &grading,
                       const double        size)
    {
      const double thickness = geometry.thickness_below();
      std::array<std::vector<double>, dim> breaks;
      breaks[dim - 1] =
        equal_parts(-thickness,
                    0.,
                    std::max(1., std::ceil(thickness / size - 1e-6)));
      if (dim == 3)
        breaks[1] =
          break_points(-geometry.width / 2,
                       geometry.width / 2,
                       0.,
                       size * grading.element_size_y / grading.element_size_x);
      return breaks;
    }
  } // namespace



  template <int dim>
  BodyMesh<dim>
  make_body_mesh(const BodyGeometry &geometry,
                 const Grading<dim> &grading,
                 const MeshKind      kind)
  {
    if (geometry.shape == Shape::mesh_file)
      return file_body_mesh<dim>(geometry);
    const double thickness = geometry.thickness_below();
    const double limit     = geometry.shape == Shape::disc
                               ? std::min(0.4 * geometry.radius, thickness)
                               : std::min(geometry.length / 3, thickness);
    const double limit_y =
      dim == 3
        ? geometry.width / 3 * grading.element_size_x / grading.element_size_y
        : limit;
    const double size =
      coarse_size(grading.element_size_x, std::min(limit, limit_y));
    const double origin = grading.offset * grading.element_size_x;

    BodyMesh<dim> mesh;
    mesh.kind = kind;
    // the sector covers the zone of contact nodes and stays off the equator
    const double half_sector =
      std::max(1.,
               std::min(std::ceil(1.2 * grading.zone_x / size),
                        std::floor(0.97 * std::abs(geometry.radius) / size)));
    mesh.chart         = std::make_unique<BodyChart<dim>>(geometry,
                                                  origin - half_sector * size,
                                                  origin + half_sector * size);
    mesh.triangulation = make_triangulation<dim>(kind);

    std::array<std::vector<double>, dim> breaks =
      break_points_below<dim>(geometry, grading, size);
    breaks[0] =
      break_points_x(geometry, *mesh.chart, origin, size, 2 * half_sector);
    double n_cells = 1.;
    for (const auto &points : breaks)
      n_cells *= points.size() - 1.;
    check_mesh_memory<dim>(n_cells, kind, generated_remedy);
    create_coarse_mesh<dim>(breaks, *mesh.chart, *mesh.triangulation);
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, *mesh.chart);
    set_boundary_ids(geometry, *mesh.chart, *mesh.triangulation);

    refine(grading, mesh);
    return mesh;
  }



  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
  template BodyMesh<2>
  make_body_mesh(const BodyGeometry &, const Grading<2> &, const MeshKind);
  template BodyMesh<3>
  make_body_mesh(const BodyGeometry &, const Grading<3> &, const MeshKind);
} // namespace RollingContact
