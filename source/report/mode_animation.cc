#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/report/mode_animation.h>
#include <rolling_contact/run/pvd.h>

#include <cmath>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const unsigned int n_phases = 24;

    const double shown = 0.05; ///< largest displacement over the extent



    using CellOf2D = DoFHandler<2>::active_cell_iterator;
    using CellOf3D = DoFHandler<3>::active_cell_iterator;



    /** A quadrilateral with the displacement of its corners. */
    template <int dim, typename Object>
    DataOutBase::Patch<2, dim>
    patch_of(const Object &quadrilateral, const BodyField &shape, double sign)
    {
      DataOutBase::Patch<2, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<2>();
      patch.data.reinit(dim, 4);
      for (unsigned int v = 0; v < 4; ++v)
        {
          patch.vertices[v] = quadrilateral->vertex(v);
          patch.vertices[v][dim - 1] *= sign;
          for (unsigned int d = 0; d < dim; ++d)
            patch.data(d, v) = (d + 1 == dim ? sign : 1.) *
                               shape[quadrilateral->vertex_dof_index(v, d)];
        }
      return patch;
    }



    void
    add_patches(const CellOf2D                        &cell,
                const BodyField                       &shape,
                const double                           sign,
                std::vector<DataOutBase::Patch<2, 2>> &patches)
    {
      patches.push_back(patch_of<2>(cell, shape, sign));
    }



    void
    add_patches(const CellOf3D                        &cell,
                const BodyField                       &shape,
                const double                           sign,
                std::vector<DataOutBase::Patch<2, 3>> &patches)
    {
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          patches.push_back(patch_of<3>(cell->face(f), shape, sign));
    }



    template <int dim>
    std::string
    vtu_of(std::vector<DataOutBase::Patch<2, dim>> patches, const double factor)
    {
      for (std::size_t i = 0; i < patches.size(); ++i)
        {
          patches[i].patch_index = i;
          for (unsigned int v = 0; v < 4; ++v)
            for (unsigned int d = 0; d < dim; ++d)
              patches[i].data(d, v) *= factor;
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



  template <int dim>
  void
  write_mode_animation(const ElasticBody<dim> &body,
                       const BodyField        &shape,
                       const bool              mirrored,
                       RunFolder              &folder,
                       const std::string      &name)
  {
    std::vector<DataOutBase::Patch<2, dim>> patches;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      add_patches(cell, shape, mirrored ? -1. : 1., patches);
    double largest = 0.;
    for (const auto &patch : patches)
      for (unsigned int v = 0; v < 4; ++v)
        {
          double square = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            square += std::pow(patch.data(d, v), 2);
          largest = std::max(largest, std::sqrt(square));
        }
    const double extent =
      GridTools::diameter(body.dof_handler().get_triangulation());
    const double          scale = largest > 0. ? shown * extent / largest : 0.;
    std::vector<PvdBlock> blocks;
    for (unsigned int k = 0; k < n_phases; ++k)
      {
        const double      time = static_cast<double>(k) / n_phases;
        const std::string file = name + "_" + zero_padded(k, 2) + ".vtu";
        folder.write_atomically(file,
                                vtu_of<dim>(patches,
                                            scale * std::cos(2 * pi * time)));
        blocks.push_back({time, 0, name, file});
      }
    write_pvd(blocks, folder, name + ".pvd");
  }



  template void
  write_mode_animation(const ElasticBody<2> &,
                       const BodyField &,
                       const bool,
                       RunFolder &,
                       const std::string &);
  template void
  write_mode_animation(const ElasticBody<3> &,
                       const BodyField &,
                       const bool,
                       RunFolder &,
                       const std::string &);
} // namespace RollingContact
