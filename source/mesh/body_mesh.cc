#include <deal.II/distributed/tria.h>

#include <p4est.h>
#include <p8est.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/cell_count.h>
#include <rolling_contact/mesh/coarse_boxes.h>
#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/mesh/material.h>
#include <rolling_contact/mesh/mesh_memory.h>
#include <rolling_contact/mesh/swept_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const double on_boundary = 1e-6; ///< of the thickness, a vertex may be off

    const std::string generated_remedy =
      "take fewer Mesh/Elements across patch, a larger Mesh/Growth (in 3D 16 "
      "and 0.4 are usual) or a smaller Mesh/Candidate zone.";
    const std::string file_remedy =
      "take a coarser Mesh file or fewer Cells along, or, with a contact zone, "
      "fewer Mesh/Elements across patch.";

    /**
     * Number the vertices of the boxes and glue the seam of a closed surface;
     * those above the bottom of the @p cover are of its material.
     */
    template <int dim>
    void create_coarse_mesh(const std::array<std::vector<double>, dim> &breaks,
                            const BodyChart<dim>                       &chart,
                            const double                                cover,
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
        const int    k      = index[dim - 1];
        const double middle = (breaks[dim - 1][k] + breaks[dim - 1][k + 1]) / 2;
        cell.material_id    = middle > -cover ? cover_material : core_material;
        cells.push_back(cell);
      });
      triangulation.create_triangulation(vertices, cells, SubCellData());
    }

    template <int dim>
    void set_boundary_ids(const double          thickness,
                          const BodyChart<dim> &chart,
                          Triangulation<dim>   &triangulation)
    {
      const double tolerance = on_boundary * thickness;
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
                  on_hub     = on_hub && std::abs(w + thickness) < tolerance;
                }
              cell->face(f)->set_boundary_id(
                on_surface ? contact_boundary
                           : (on_hub ? hub_boundary : free_boundary));
            }
    }
  } // namespace

  template <int dim>
  Point<dim> BodyMesh<dim>::chart_point(const CellIterator &cell,
                                        const unsigned int  vertex) const
  {
    if constexpr (dim == 3)
      if (swept)
        return swept_chart_point(*swept, cell, vertex);
    Point<dim> point = chart->pull_back(cell->vertex(vertex));
    point[0]         = chart->centred_x(point[0]);
    return point;
  }

  template <int dim>
  std::pair<Point<dim>, Point<dim>>
  BodyMesh<dim>::chart_box(const CellIterator &cell) const
  {
    if constexpr (dim == 3)
      if (swept)
        return swept_chart_box(*swept, cell);
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
    void start_p4est()
    {
      static std::once_flag once;
      std::call_once(once, []() {
        Ranks::start();
        sc_init(Ranks::communicator(), 0, 0, nullptr, SC_LP_SILENT);
        p4est_init(nullptr, SC_LP_SILENT);
      });
    }

    template <int dim>
    std::unique_ptr<Triangulation<dim>> make_triangulation(const MeshKind kind)
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
    void refine(const Grading<dim> &grading,
                const std::string  &remedy,
                BodyMesh<dim>      &mesh)
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
                                 remedy);
          if (n_flagged > 0.)
            cells.execute_coarsening_and_refinement();
        }
    }
  } // namespace

  namespace
  {
    /**
     * Throws InputError if p4est cannot halve cells of this @p size often
     * enough.
     */
    template <int dim>
    void check_levels(const double size, const double element_size)
    {
      const int possible = dim == 2 ? P4EST_QMAXLEVEL : P8EST_QMAXLEVEL,
                needed   = std::lround(std::log2(size / element_size));
      if (needed > possible)
        throw InputError(
          "Body solver = distributed: elements of " +
          significant(element_size, 2) + " m are cells of " +
          significant(size, 2) + " m halved " + std::to_string(needed) +
          " times, and p4est halves them " + std::to_string(possible) +
          " times: take fewer Mesh/Elements across patch, a greater load or "
          "approach, or Body solver = direct.");
    }
  } // namespace

  template <int dim>
  double least_cells(const std::shared_ptr<const BodyShape> &shape,
                     const Grading<dim>                     &grading,
                     const double                            enough)
  {
    if constexpr (dim == 3)
      if (shape->is_swept())
        return fewest_swept_cells(shape, grading, enough).second;
    return fewest_cells<dim>(shape, grading, enough).second;
  }

  namespace
  {
    BodyMesh<3> swept_body_mesh(const std::shared_ptr<const BodyShape> &shape,
                                const Grading<3>                       &grading,
                                const MeshKind                          kind)
    {
      const auto [coarse, n_cells] =
        fewest_swept_cells(shape, grading, largest_mesh<3>(kind));
      if (kind == MeshKind::distributed)
        check_levels<3>(coarse->size(), grading.element_size_x);
      const std::string &remedy =
        shape->has_own_cells() ? file_remedy : generated_remedy;
      check_mesh_memory<3>(n_cells, kind, remedy);
      BodyMesh<3> mesh;
      mesh.kind          = kind;
      mesh.swept         = coarse;
      mesh.triangulation = make_triangulation<3>(kind);
      create_swept_cells(*coarse, *mesh.triangulation);
      refine(grading_of_body(*shape, grading), remedy, mesh);
      move_vertices(*coarse, *mesh.triangulation);
      return mesh;
    }
  } // namespace

  template <int dim>
  BodyMesh<dim> make_body_mesh(const std::shared_ptr<const BodyShape> &shape,
                               const Grading<dim>                     &grading,
                               const MeshKind                          kind)
  {
    if (shape->mesh())
      return file_body_mesh<dim>(*shape->mesh());
    if constexpr (dim == 3)
      if (shape->is_swept())
        return swept_body_mesh(shape, grading, kind);
    auto [coarse, n_cells] =
      fewest_cells<dim>(shape, grading, largest_mesh<dim>(kind));
    if (kind == MeshKind::distributed)
      check_levels<dim>(coarse.size, grading.element_size_x);
    check_mesh_memory<dim>(n_cells, kind, generated_remedy);
    BodyMesh<dim> mesh;
    mesh.kind          = kind;
    mesh.chart         = std::move(coarse.chart);
    mesh.triangulation = make_triangulation<dim>(kind);
    create_coarse_mesh<dim>(coarse.breaks,
                            *mesh.chart,
                            shape->cover_thickness(),
                            *mesh.triangulation);
    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(0, *mesh.chart);
    set_boundary_ids(shape->thickness_below(),
                     *mesh.chart,
                     *mesh.triangulation);

    refine(grading, generated_remedy, mesh);
    return mesh;
  }

  template double least_cells<2>(const std::shared_ptr<const BodyShape> &,
                                 const Grading<2> &,
                                 const double);
  template double least_cells<3>(const std::shared_ptr<const BodyShape> &,
                                 const Grading<3> &,
                                 const double);
  template struct BodyMesh<2>;
  template struct BodyMesh<3>;
  template BodyMesh<2> make_body_mesh(const std::shared_ptr<const BodyShape> &,
                                      const Grading<2> &,
                                      const MeshKind);
  template BodyMesh<3> make_body_mesh(const std::shared_ptr<const BodyShape> &,
                                      const Grading<3> &,
                                      const MeshKind);
} // namespace RollingContact
