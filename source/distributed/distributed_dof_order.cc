#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/distributed/distributed_dof_order.h>
#include <rolling_contact/elasticity/portable_dof_order.h>

#include <map>

namespace RollingContact
{
  using namespace dealii;

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
    return in_portable_order(std::move(values));
  }



  template std::vector<types::global_dof_index>
  unknowns_here(const DistributedDiscretisation<2> &);
  template std::vector<std::size_t>
  portable_dof_order(const DistributedDiscretisation<2> &, const bool);
  template std::vector<types::global_dof_index>
  unknowns_here(const DistributedDiscretisation<3> &);
  template std::vector<std::size_t>
  portable_dof_order(const DistributedDiscretisation<3> &, const bool);
} // namespace RollingContact
