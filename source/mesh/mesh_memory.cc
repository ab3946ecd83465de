#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/mesh_memory.h>
#include <rolling_contact/parallel/ranks.h>

namespace RollingContact
{
  template <int dim>
  void
  check_mesh_memory(const double       n_cells,
                    const MeshKind     kind,
                    const std::string &remedy)
  {
    const bool   whole = kind == MeshKind::serial;
    const double bytes =
      n_cells * (dim == 2 ? (whole ? 6e3 : 5e3) : (whole ? 45e3 : 15e3));
    const double free =
      whole ? available_memory() : Ranks::minimum(available_memory());
    if (free > 0. && bytes > 0.7 * free)
      throw MemoryError(
        "The mesh of a body would have " + significant(n_cells, 2) +
        " cells or more and need about " + human_bytes(bytes) +
        ", more than 70 % of the " + human_bytes(free) + " free: " + remedy);
  }



  template void
  check_mesh_memory<2>(const double, const MeshKind, const std::string &);
  template void
  check_mesh_memory<3>(const double, const MeshKind, const std::string &);
} // namespace RollingContact
