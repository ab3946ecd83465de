#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/mesh_memory.h>

#include <limits>

namespace RollingContact
{
  namespace
  {
    const double usable_memory = 0.7; ///< of what is free

    /**
     * What a cell took in runs: mesh and stiffness, with factor and
     * condensation (serial) or the multigrid levels (distributed).
     */
    template <int dim>
    double bytes_of_cell(const MeshKind kind)
    {
      if (kind == MeshKind::serial)
        return dim == 2 ? 6e3 : 45e3;
      return dim == 2 ? 5e3 : 15e3;
    }
  } // namespace

  namespace
  {
    double free_memory(const MeshKind kind)
    {
      return kind == MeshKind::serial ? available_memory()
                                      : Ranks::minimum(available_memory());
    }
  } // namespace

  template <int dim>
  double largest_mesh(const MeshKind kind)
  {
    const double free = free_memory(kind);
    return free > 0. ? usable_memory * free / bytes_of_cell<dim>(kind)
                     : std::numeric_limits<double>::infinity();
  }

  template <int dim>
  void check_mesh_memory(const double       n_cells,
                         const MeshKind     kind,
                         const std::string &remedy,
                         const std::string &what)
  {
    const double bytes = n_cells * bytes_of_cell<dim>(kind),
                 free  = free_memory(kind);
    if (free > 0. && bytes > usable_memory * free)
      throw MemoryError(what + " would have " + significant(n_cells, 2) +
                        " cells or more and need about " + human_bytes(bytes) +
                        ", more than 70 % of the " + human_bytes(free) +
                        " free: " + remedy);
  }

  template double largest_mesh<2>(const MeshKind);
  template double largest_mesh<3>(const MeshKind);
  template void   check_mesh_memory<2>(const double,
                                     const MeshKind,
                                     const std::string &,
                                     const std::string &);
  template void   check_mesh_memory<3>(const double,
                                     const MeshKind,
                                     const std::string &,
                                     const std::string &);
} // namespace RollingContact
