#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/modes/body_places.h>

#include <map>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  BodyPlaces::BodyPlaces(const DirectBody<dim> &body)
  {
    // numbers of degrees of freedom, counted from 1, as a field
    const auto &dofs = body.dof_handler();
    // with entries of its own for masses attached, which stay 0
    BodyField numbers = body.field(std::vector<double>(body.n_unknowns(), 0.));
    for (types::global_dof_index i = 0; i < dofs.n_dofs(); ++i)
      numbers[i] = i + 1.;
    const std::vector<double>   dof_of_unknown = body.unknowns_of(numbers);
    const SymmetricSparseMatrix M              = body.mass(MassKind::lumped);
    std::vector<Point<dim>>     positions(dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(), dofs, positions);

    std::map<types::global_dof_index, std::size_t> node_of_first_dof;
    for (std::size_t i = 0; i < dof_of_unknown.size(); ++i)
      {
        if (dof_of_unknown[i] < 0.5)
          continue;
        const auto dof = static_cast<types::global_dof_index>(
                           dof_of_unknown[i] + 0.5) -
                         1,
                   component = dof % dim;
        const auto found =
          node_of_first_dof.try_emplace(dof - component, nodes.size());
        if (found.second)
          {
            const Point<dim> &at = positions[dof];
            nodes.push_back({{{at[0], dim == 3 ? at[1] : 0., at[dim - 1]}}});
          }
        Node &node = nodes[found.first->second];
        node.unknowns[component == dim - 1 ? 2 : component] = i;
        node.mass = M.values[M.column_starts[i]];
      }
  }

  template BodyPlaces::BodyPlaces(const DirectBody<2> &);
  template BodyPlaces::BodyPlaces(const DirectBody<3> &);
} // namespace RollingContact
