#ifndef rolling_contact_pair_body_pair_h
#define rolling_contact_pair_body_pair_h

#include <rolling_contact/distributed/make_body.h>
#include <rolling_contact/interface/surface_coupling.h>
#include <rolling_contact/interface/trace.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/parallel/broadcast.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  enum class Side
  {
    wheel,
    rail
  };

  inline std::string
  name_of(const Side side)
  {
    return side == Side::wheel ? "wheel" : "rail";
  }

  /**
   * What an analysis demands of the bodies, beyond what the scene says.
   */
  struct PairDemands
  {
    /** Displacements inside the bodies will be asked for. */
    bool displacements = false;
    /** The compliance must be exact: bodies are factorised. */
    bool factors = false;
  };

  /**
   * The elastic bodies of a scene, the interface between them, and the ranks
   * they live on: spread over all (distributed) or on one each (direct). Bodies
   * that the program meshes carry the interface's nodes, one from a file is
   * coupled to them. Builds only what the scene needs: a rigid body has none,
   * mirror-identical bodies share one. The same on every rank.
   */
  template <int dim>
  class BodyPair
  {
  public:
    /**
     * Mesh; assemble K and prepare its solution as well if @p statics are
     * wanted. Throws InputError, before meshing, if the zone does not fit
     * on the bodies.
     */
    BodyPair(const SceneParameters &scene,
             const Grading<dim>    &grading,
             const PairDemands     &demands,
             const bool             statics);

    /**
     * Give back what only static solutions need.
     */
    void
    release_statics();

    /**
     * Give all ranks the @p object of the rank of a body, such as its motion.
     * Distributed and rigid bodies have it on all ranks already, and nothing is
     * sent. Collective.
     */
    template <typename Object>
    Object
    on_all_ranks(const Side side, Object object) const
    {
      if (solver == BodySolver::direct && is_elastic(side))
        Ranks::broadcast(object, rank_of(side));
      return object;
    }

    /**
     * False for a rigid body.
     */
    bool
    is_elastic(const Side side) const
    {
      return parts[static_cast<int>(side)].elastic;
    }

    /**
     * nullptr for a rigid body, and on ranks that hold nothing of the body;
     * the same pointer for both sides of twins.
     */
    ElasticBody<dim> *
    body(const Side side) const
    {
      return parts[static_cast<int>(side)].body.get();
    }

    /**
     * The rank that speaks for a body.
     */
    unsigned int
    rank_of(const Side side) const
    {
      return parts[static_cast<int>(side)].rank;
    }

    bool
    twins() const
    {
      return are_twins;
    }

    /**
     * For work on both bodies: distributed ones use MPI, from one thread only.
     */
    unsigned int
    n_threads() const
    {
      return twins() || solver != BodySolver::direct ? 1 : scene.body_threads;
    }

    /**
     * Of all bodies, one of twins.
     */
    std::size_t
    n_unknowns() const
    {
      return total_unknowns;
    }

    /**
     * How K is solved.
     */
    BodySolver
    body_solver() const
    {
      return solver;
    }

    /**
     * Why, if the scene left it open; else empty.
     */
    const std::string &
    reason_for_solver() const
    {
      return reason;
    }

    /**
     * The interface: the surface nodes of the generated bodies, or a grid of
     * its own if all are read from files.
     */
    const Trace &
    trace() const
    {
      return contact_trace;
    }

    /**
     * From a body's contact nodes to the interface and back.
     */
    const SurfaceCoupling &
    coupling(const Side side) const
    {
      return part(side).coupling;
    }

    /**
     * How a body from a file hangs together with the interface, for the log;
     * empty for others.
     */
    const SurfaceNote &
    note_on_surface(const Side side) const
    {
      return part(side).note;
    }

  protected:
    using Nodes = std::vector<typename ElasticBody<dim>::SurfaceNode>;

    const Nodes &
    nodes(const Side side) const
    {
      return part(side).nodes;
    }

    const BodyParameters &
    parameters(const Side side) const
    {
      return side == Side::wheel ? scene.wheel : scene.rail;
    }

    /**
     * Height of the undeformed surface at the interface's nodes, in the body's
     * frame, where it is not given by radii; else empty. Units: m.
     */
    const std::vector<double> &
    heights(const Side side) const
    {
      return part(side).heights;
    }

    const SceneParameters scene;

  private:
    struct Part
    {
      bool                              elastic = false;
      unsigned int                      rank    = 0;
      std::shared_ptr<ElasticBody<dim>> body;
      Nodes                             nodes;
      SurfaceCoupling                   coupling;
      std::vector<double>               heights;
      SurfaceNote                       note;
    };

    Part &
    part(const Side side)
    {
      return parts[static_cast<int>(side)];
    }

    const Part &
    part(const Side side) const
    {
      return parts[static_cast<int>(side)];
    }

    /**
     * Mesh the bodies and prepare K.
     */
    void
    build(const Grading<dim> &grading, const bool statics);

    /**
     * `automatic`: direct on one rank if the bodies fit.
     */
    void
    choose_and_build(const Grading<dim> &grading, const bool statics);

    /**
     * Bytes of the factors, known from their analysis or predicted.
     */
    double
    factor_memory(const bool analysed) const;

    void
    pair_surfaces(const Grading<dim> &zone);

    /**
     * True if no other way than a factorisation will do.
     */
    bool
    needs_factors() const;

    PairDemands demands;
    BodySolver  solver;
    std::string reason;
    bool        are_twins;
    std::size_t total_unknowns = 0;
    Part        parts[2];
    Trace       contact_trace;
  };
} // namespace RollingContact

#endif
