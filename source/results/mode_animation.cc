#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/mode_animation.h>
#include <rolling_contact/run/pvd.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const unsigned int n_phases = 24;

    const double shown_of_extent =
      0.05; ///< largest displacement over the extent

    using CellOf2D = DoFHandler<2>::active_cell_iterator;
    using CellOf3D = DoFHandler<3>::active_cell_iterator;

    /** A quadrilateral with the displacement of its corners: the real and the
     * imaginary part. */
    template <int dim, typename Object>
    DataOutBase::Patch<2, dim> patch_of(const Object          &quadrilateral,
                                        const MovingBody<dim> &moving)
    {
      const double               sign = moving.mirrored ? -1. : 1.;
      DataOutBase::Patch<2, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<2>();
      patch.data.reinit(2 * dim, 4);
      for (unsigned int v = 0; v < 4; ++v)
        {
          patch.vertices[v] = quadrilateral->vertex(v);
          patch.vertices[v][dim - 1] *= sign;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const auto   i         = quadrilateral->vertex_dof_index(v, d);
              const double factor    = d + 1 == dim ? sign : 1.;
              patch.data(d, v)       = factor * moving.real[i];
              patch.data(dim + d, v) = moving.imaginary.size() == 0
                                         ? 0.
                                         : factor * moving.imaginary[i];
            }
        }
      return patch;
    }

    void add_patches(const CellOf2D                        &cell,
                     const MovingBody<2>                   &moving,
                     std::vector<DataOutBase::Patch<2, 2>> &patches)
    {
      patches.push_back(patch_of<2>(cell, moving));
    }

    void add_patches(const CellOf3D                        &cell,
                     const MovingBody<3>                   &moving,
                     std::vector<DataOutBase::Patch<2, 3>> &patches)
    {
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          patches.push_back(patch_of<3>(cell->face(f), moving));
    }

    /** The displacement at a phase of the period (rad). */
    template <int dim>
    std::string vtu_of(const std::vector<DataOutBase::Patch<2, dim>> &motion,
                       const double                                   scale,
                       const double                                   phase)
    {
      std::vector<DataOutBase::Patch<2, dim>> patches = motion;
      for (std::size_t i = 0; i < patches.size(); ++i)
        {
          patches[i].patch_index = i;
          patches[i].data.reinit(dim, 4);
          for (unsigned int v = 0; v < 4; ++v)
            for (unsigned int d = 0; d < dim; ++d)
              patches[i].data(d, v) =
                scale * (motion[i].data(d, v) * std::cos(phase) -
                         motion[i].data(dim + d, v) * std::sin(phase));
        }
      DataOutBase::VtkFlags flags;
      flags.print_date_and_time = false;
      flags.compression_level   = DataOutBase::VtkFlags::best_speed;
      std::ostringstream vtu;
      DataOutBase::write_vtu(
        patches,
        std::vector<std::string>(dim, "displacement"),
        {{0,
          dim - 1,
          "displacement",
          DataComponentInterpretation::component_is_part_of_vector}},
        flags,
        vtu);
      return vtu.str();
    }
  } // namespace

  namespace
  {
    /** The largest amplitude of a corner of the patches. */
    template <int dim>
    double
    largest_motion(const std::vector<DataOutBase::Patch<2, dim>> &patches)
    {
      double largest = 0.;
      for (const auto &patch : patches)
        for (unsigned int v = 0; v < 4; ++v)
          {
            double square = 0.;
            for (unsigned int d = 0; d < 2 * dim; ++d)
              square += std::pow(patch.data(d, v), 2);
            largest = std::max(largest, std::sqrt(square));
          }
      return largest;
    }

    /** Longest side of the box around a body. Units: m. */
    template <int dim>
    double largest_side(const Triangulation<dim> &cells)
    {
      const auto box     = GridTools::compute_bounding_box(cells);
      double     largest = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest, box.side_length(d));
      return largest;
    }
  } // namespace

  template <int dim>
  void write_mode_animation(const std::vector<MovingBody<dim>> &bodies,
                            RunFolder                          &folder,
                            const std::string                  &name)
  {
    std::vector<std::vector<DataOutBase::Patch<2, dim>>> motions;
    double largest = 0., extent = std::numeric_limits<double>::infinity();
    for (const MovingBody<dim> &moving : bodies)
      {
        const auto &handler = moving.body->dof_handler();
        motions.emplace_back();
        for (const auto &cell : handler.active_cell_iterators())
          add_patches(cell, moving, motions.back());
        largest = std::max(largest, largest_motion(motions.back()));
        extent  = std::min(extent, largest_side(handler.get_triangulation()));
      }
    const double scale = largest > 0. ? shown_of_extent * extent / largest : 0.;
    std::vector<PvdBlock> blocks;
    for (unsigned int k = 0; k < n_phases; ++k)
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          const double      time = static_cast<double>(k) / n_phases;
          const std::string body =
            name + (bodies[b].name.empty() ? "" : "_" + bodies[b].name);
          const std::string file = body + "_" + zero_padded(k, 2) + ".vtu";
          folder.write_atomically(
            file, vtu_of<dim>(motions[b], scale, 2 * pi * time));
          blocks.push_back({time, b, body, file});
        }
    write_pvd(blocks, folder, name + ".pvd");
  }

  template void write_mode_animation(const std::vector<MovingBody<2>> &,
                                     RunFolder &,
                                     const std::string &);
  template void write_mode_animation(const std::vector<MovingBody<3>> &,
                                     RunFolder &,
                                     const std::string &);
} // namespace RollingContact
