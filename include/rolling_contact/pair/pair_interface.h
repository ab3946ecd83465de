#ifndef rolling_contact_pair_pair_interface_h
#define rolling_contact_pair_pair_interface_h

#include <rolling_contact/contact/surface_coupling.h>
#include <rolling_contact/contact/trace.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/scene/pair_spec.h>

#include <vector>

namespace RollingContact
{
  /**
   * The interface between the bodies of a pair, on all ranks: the nodes and
   * elements where the contact laws hold, and how each body is coupled to them.
   * Bodies that the program meshes have the interface's nodes on their surface;
   * a body from a mesh file, or with a section from one, is coupled by a mortar
   * projection.
   */
  template <int dim>
  struct PairInterface
  {
    using Nodes = std::vector<typename ElasticBody<dim>::SurfaceNode>;

    /**
     * Find the interface of @p bodies in the zone of contact nodes. Throws
     * InputError if the contact surface of a mesh file does not suit it, see
     * couple_to_interface(). Collective; @p scene and @p grading are the same
     * on all ranks.
     */
    PairInterface(const PairSpec      &scene,
                  const Grading<dim>  &grading,
                  const BodyPair<dim> &bodies);

    /**
     * The surface nodes of the generated bodies, or a mesh of its own if both
     * bodies are read from files or split.
     */
    Trace trace;

    /**
     * Contact nodes of each body, on the ranks that hold a part of it.
     */
    PerSide<Nodes> nodes;

    /**
     * From the contact nodes of each body to those of the interface and back.
     * Where the surface of contact is curved and a body has the section of its
     * profile, nodes of the interface are turned against its axes; a plain body
     * is flat along the surface.
     */
    PerSide<SurfaceCoupling> coupling;

    /**
     * Height of the undeformed surface at the interface's nodes, in the body's
     * frame, if the nodes of a mesh file give it; empty if radii do. Units: m.
     */
    PerSide<std::vector<double>> heights;

    /**
     * The axes of the interface in those of each body.
     */
    PerSide<AxesOfContact> axes;

    /**
     * What the log tells of the coupling of a mesh file; else empty.
     */
    PerSide<SurfaceNote> note;

    /**
     * Whether nodes are turned against a body, which mixes normal and
     * tangential components.
     */
    bool turns_nodes() const
    {
      return nodes_turned;
    }

  private:
    /**
     * Turn the nodes against the elastic bodies whose surface is that of
     * contact, and against bodies that keep the axes of their files.
     */
    void turn_nodes(const PairSpec &scene, const BodyPair<dim> &bodies);

    bool nodes_turned = false;

    /**
     * Give split bodies the nodes of a mesh that is on neither of them.
     */
    void take_nodes_of_interface(const Grading<dim>  &grading,
                                 const BodyPair<dim> &bodies);

    /**
     * Take the nodes of a generated body; its surface, on all ranks.
     */
    Trace surface_of(const Side           side,
                     const Grading<dim>  &grading,
                     const BodyPair<dim> &bodies);
  };
} // namespace RollingContact

#endif
