#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/bodies/distributed_dof_order.h>
#include <rolling_contact/bodies/portable_dof_order.h>

#include <map>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Degrees of freedom that this rank owns and that are not constrained.
     */
    template <int dim>
    std::vector<types::global_dof_index>
    unknowns_here(const DistributedDiscretisation<dim> &body)
    {
      std::vector<types::global_dof_index> result;
      for (const auto dof : body.dofs.locally_owned_dofs())
        if (!body.constraints.is_constrained(dof))
          result.push_back(dof);
      return result;
    }

    /**
     * With the unknowns_here() of all ranks counted rank by rank, the number of
     * the unknown that stands at each place of BodyMotion: on all ranks, or
     * only on the first one and empty on others. Collective.
     */
    template <int dim>
    std::vector<std::size_t>
    portable_dof_order(const DistributedDiscretisation<dim> &body,
                       const bool                            on_all_ranks)
    {
      std::map<types::global_dof_index, Point<dim>> positions;
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                           body.dofs,
                                           positions);
      std::vector<double> numbers;
      for (const auto dof : unknowns_here(body))
        {
          for (unsigned int d = 0; d < dim; ++d)
            numbers.push_back(positions.at(dof)[d]);
          numbers.push_back(dof % dim);
        }
      const MPI_Comm              communicator = body.dofs.get_communicator();
      const auto                  parts        = on_all_ranks
                                                   ? Utilities::MPI::all_gather(communicator, numbers)
                                                   : Utilities::MPI::gather(communicator, numbers);
      std::vector<NodeValue<dim>> values;
      for (const std::vector<double> &part : parts)
        for (auto number = part.begin(); number != part.end();)
          {
            NodeValue<dim> value;
            for (unsigned int d = 0; d < dim; ++d)
              value.position[d] = *number++;
            value.component = *number++;
            value.place     = values.size();
            values.push_back(value);
          }
      return RollingContact::in_portable_order(std::move(values));
    }

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
  BodyMotion in_portable_order(const DistributedDiscretisation<dim> &body,
                               const DistributedVector &displacement,
                               const DistributedVector &velocity)
  {
    const auto dofs  = unknowns_here(body);
    const auto order = portable_dof_order(body, false);
    return {gathered(displacement, dofs, order),
            gathered(velocity, dofs, order)};
  }

  template <int dim>
  std::pair<DistributedVector, DistributedVector>
  from_portable_order(const DistributedDiscretisation<dim> &body,
                      const BodyMotion                     &motion)
  {
    const auto  here  = unknowns_here(body);
    std::size_t first = 0; // of this rank among all unknowns
    const auto  sizes =
      Utilities::MPI::all_gather(Ranks::communicator(), here.size());
    for (unsigned int rank = 0; rank < Ranks::rank(); ++rank)
      first += sizes[rank];
    DistributedVector u(body.dofs.locally_owned_dofs(),
                        body.dofs.get_communicator()),
      v(u);
    const auto order = portable_dof_order(body, true);
    for (std::size_t k = 0; k < order.size(); ++k)
      if (order[k] >= first && order[k] < first + here.size())
        {
          u(here[order[k] - first]) = motion.displacement[k];
          v(here[order[k] - first]) = motion.velocity[k];
        }
    return {u, v};
  }

  template BodyMotion in_portable_order(const DistributedDiscretisation<2> &,
                                        const DistributedVector &,
                                        const DistributedVector &);
  template std::pair<DistributedVector, DistributedVector>
  from_portable_order(const DistributedDiscretisation<2> &, const BodyMotion &);
  template BodyMotion in_portable_order(const DistributedDiscretisation<3> &,
                                        const DistributedVector &,
                                        const DistributedVector &);
  template std::pair<DistributedVector, DistributedVector>
  from_portable_order(const DistributedDiscretisation<3> &, const BodyMotion &);
} // namespace RollingContact
