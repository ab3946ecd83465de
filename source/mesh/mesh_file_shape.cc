#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/mesh_file_shape.h>

#include <algorithm>

namespace RollingContact
{
  void MeshFileShape::check(const unsigned int, const bool rigid) const
  {
    const std::string &section = parameters.section;
    if (parameters.mesh_file.empty())
      throw InputError(section +
                       "/Mesh file = : Shape = mesh file needs the name of a "
                       ".msh or .inp file.");
    if (rigid)
      throw InputError(section +
                       "/Shape = mesh file: a rigid body has no mesh; take "
                       "disc or block with its radii.");
    parameters.require(parameters.mesh_unit > 0.,
                       "Mesh unit",
                       parameters.mesh_unit,
                       "it must be above 0 m; 0.001 for millimetres.");
    if (hub() != Hub::free &&
        parameters.contact_boundary == parameters.hub_boundary)
      throw InputError(section + "/Contact boundary id and " + section +
                       "/Hub boundary id are both " +
                       std::to_string(parameters.hub_boundary) +
                       ": the hub must be another part of the boundary.");
  }

  double MeshFileShape::thickness_below() const
  {
    return parameters.mesh->depth;
  }

  std::optional<Axle> MeshFileShape::axle() const
  {
    if (parameters.section != "Wheel" || !(parameters.radius > 0.))
      return std::nullopt;
    return Axle{{{0., 0., -parameters.radius}}, {{0., 1., 0.}}};
  }

  double MeshFileShape::reach_x() const
  {
    return std::min(-parameters.mesh->lower[0], parameters.mesh->upper[0]);
  }

  double MeshFileShape::reach_y() const
  {
    return std::min(-parameters.mesh->lower[1], parameters.mesh->upper[1]);
  }

  std::shared_ptr<const FileMesh> MeshFileShape::mesh() const
  {
    return parameters.mesh;
  }

  std::vector<double> MeshFileShape::dimensions() const
  {
    return {};
  }
} // namespace RollingContact
