#ifndef rolling_contact_pair_body_pair_h
#define rolling_contact_pair_body_pair_h

#include <rolling_contact/base/broadcast.h>
#include <rolling_contact/base/side.h>
#include <rolling_contact/bodies/elastic_body.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/pair/pair_demands.h>
#include <rolling_contact/pair/split_choice.h>
#include <rolling_contact/scene/pair_spec.h>

#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * The elastic bodies of a scene and the ranks they live on: spread over all
   * ranks (distributed) or each on one (direct). Only what the scene needs is
   * built: nothing for a rigid body, and one body for two that are mirror
   * images of each other (twins). What is said about the bodies is known on all
   * ranks; the bodies themselves are only where body() says so.
   */
  template <int dim>
  class BodyPair
  {
  public:
    /**
     * Mesh the bodies, and assemble and prepare the solution of K as well if
     * @p statics are wanted. Throws InputError, before meshing, if the zone of
     * contact nodes does not fit on the bodies, or if there are more ranks than
     * direct bodies. Collective; @p scene and @p grading are the same on all
     * ranks.
     */
    BodyPair(const PairSpec     &scene,
             const Grading<dim> &grading,
             const PairDemands  &demands,
             const bool          statics);

    /**
     * Free the memory of the factors or preconditioners of K, which only static
     * solutions need.
     */
    void release_statics();

    /**
     * Give all ranks the @p object of the rank of a direct body, such as its
     * motion. Distributed and rigid bodies are taken to have it on all ranks
     * already, and nothing is sent for them. Collective.
     */
    template <typename Object>
    Object on_all_ranks(const Side side, Object object) const
    {
      if (solver == BodySolver::direct && is_elastic(side))
        Ranks::broadcast(object, rank_of(side));
      return object;
    }

    /**
     * True for an elastic body, false for a rigid one.
     */
    bool is_elastic(const Side side) const
    {
      return elastic[side];
    }

    /**
     * True for an elastic body but the rail of twins, which is the body of the
     * wheel.
     */
    bool has_own_body(const Side side) const
    {
      return is_elastic(side) && !(side == Side::rail && are_twins);
    }

    /**
     * The body, and for both sides of twins the same one; nullptr for a rigid
     * body and on ranks that hold nothing of it.
     */
    ElasticBody<dim> *body(const Side side) const
    {
      return bodies[side].get();
    }

    /** The body, to be kept beyond the life of this; see body(). */
    std::shared_ptr<const ElasticBody<dim>> shared_body(const Side side) const
    {
      return bodies[side];
    }

    /**
     * The rank that holds a direct body, or the model of a distributed one.
     */
    unsigned int rank_of(const Side side) const
    {
      return ranks[side];
    }

    /**
     * True if both bodies are meshed by the program with the same geometry,
     * material and model.
     */
    bool twins() const
    {
      return are_twins;
    }

    /**
     * True if the bodies are SplitBody, which have the nodes of the interface.
     */
    bool is_split() const
    {
      return compliance.split;
    }

    /**
     * Why the program did not split the compliance, a part of a sentence; empty
     * if it did or was not asked to.
     */
    const std::string &reason_against_split() const
    {
      return compliance.reason;
    }

    /**
     * Number of threads, 1 or 2, for work on both bodies: MPI may be used by
     * one thread only, which rules out a second one for distributed bodies.
     */
    unsigned int n_threads() const
    {
      return are_twins || solver != BodySolver::direct ? 1 : body_threads;
    }

    /**
     * Sum over the bodies on all ranks; twins count once.
     */
    std::size_t n_unknowns() const
    {
      return total_unknowns;
    }

    /**
     * How K is solved: direct or distributed.
     */
    BodySolver body_solver() const
    {
      return solver;
    }

    /**
     * Why the program took this body solver, a part of a sentence; empty if the
     * scene or the number of ranks decided.
     */
    const std::string &reason_for_solver() const
    {
      return reason;
    }

  private:
    /**
     * Build the bodies with the solver the scene asks for. Where that is
     * `automatic`, on one rank, direct bodies are built, and replaced by
     * distributed ones if their factors do not fit into the memory.
     */
    void choose_and_build(const PairSpec     &scene,
                          const Grading<dim> &grading,
                          const PairDemands  &demands,
                          const bool          statics);

    /**
     * Mesh the bodies of this rank and prepare K for the given solver.
     */
    void build(const PairSpec     &scene,
               const Grading<dim> &grading,
               const PairDemands  &demands,
               const bool          statics);

    /**
     * Bytes of the factors of direct bodies, known if K was @p analysed, else
     * predicted.
     */
    double factor_memory(const bool analysed) const;

    ComplianceChoice                           compliance;
    BodySolver                                 solver;
    std::string                                reason;
    unsigned int                               body_threads;
    bool                                       are_twins;
    std::size_t                                total_unknowns = 0;
    PerSide<bool>                              elastic;
    PerSide<unsigned int>                      ranks;
    PerSide<std::shared_ptr<ElasticBody<dim>>> bodies;
  };
} // namespace RollingContact

#endif
