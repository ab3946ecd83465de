#ifndef rolling_contact_pair_packed_surface_h
#define rolling_contact_pair_packed_surface_h

#include <rolling_contact/elasticity/elastic_body.h>
#include <rolling_contact/interface/trace.h>

namespace RollingContact
{
  /**
   * Nodes and faces of a surface as numbers, to be sent.
   */
  template <int dim>
  std::vector<double>
  packed(const std::vector<typename ElasticBody<dim>::SurfaceNode> &nodes,
         const std::vector<typename ElasticBody<dim>::SurfaceFace> &faces);

  /**
   * The inverse of packed(), a trace without the borders of its zone.
   */
  template <int dim>
  Trace
  unpacked(const std::vector<double> &numbers);
} // namespace RollingContact

#endif
