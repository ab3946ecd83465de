#include <deal.II/base/mpi.h>

#include <rolling_contact/distributed/distributed_dof_order.h>
#include <rolling_contact/distributed/distributed_motion.h>
#include <rolling_contact/parallel/ranks.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Values at the @p dofs of all ranks in the given order, on the first rank.
     * Collective.
     */
    std::vector<double>
    gathered(const DistributedVector                    &field,
             const std::vector<types::global_dof_index> &dofs,
             const std::vector<std::size_t>             &order)
    {
      std::vector<double> here, all, ordered;
      for (const auto dof : dofs)
        here.push_back(field(dof));
      for (const auto &part :
           Utilities::MPI::gather(Ranks::communicator(), here))
        all.insert(all.end(), part.begin(), part.end());
      for (const std::size_t i : order)
        ordered.push_back(all[i]);
      return ordered;
    }
  } // namespace



  template <int dim>
  BodyMotion
  DistributedMotion<dim>::save() const
  {
    const auto dofs  = unknowns_here(body.discretisation());
    const auto order = portable_dof_order(body.discretisation(), false);
    return {gathered(u, dofs, order), gathered(v, dofs, order)};
  }



  template <int dim>
  void
  DistributedMotion<dim>::restore(const BodyMotion &motion)
  {
    require_size(motion, body.n_unknowns());
    const auto  here  = unknowns_here(body.discretisation());
    std::size_t first = 0; // of this rank among all unknowns
    const auto  sizes =
      Utilities::MPI::all_gather(Ranks::communicator(), here.size());
    for (unsigned int rank = 0; rank < Ranks::rank(); ++rank)
      first += sizes[rank];
    DistributedVector displacement = body.vector(), velocity = body.vector();
    const auto        order = portable_dof_order(body.discretisation(), true);
    for (std::size_t k = 0; k < order.size(); ++k)
      if (order[k] >= first && order[k] < first + here.size())
        {
          displacement(here[order[k] - first]) = motion.displacement[k];
          velocity(here[order[k] - first])     = motion.velocity[k];
        }
    set_state(displacement, velocity);
  }



  template BodyMotion
  DistributedMotion<2>::save() const;
  template BodyMotion
  DistributedMotion<3>::save() const;
  template void
  DistributedMotion<2>::restore(const BodyMotion &);
  template void
  DistributedMotion<3>::restore(const BodyMotion &);
} // namespace RollingContact
