#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/elasticity/elastic_body.h>

#include <algorithm>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  ElasticBody<dim>::ElasticBody(const BodyGeometry &geometry,
                                const Material     &material,
                                const double        thickness,
                                const Grading<dim> &grading)
    : material(material)
    , thickness(thickness)
    , hub_clamped(geometry.hub_clamped)
    , body_mesh(make_body_mesh<dim>(geometry, grading))
    , element(FE_Q<dim>(1), dim)
    , dofs(*body_mesh.triangulation)
  {
    const Stopwatch watch;
    distribute();
    assembly_s = watch.seconds();
  }



  template <int dim>
  void
  ElasticBody<dim>::distribute()
  {
    dofs.distribute_dofs(element);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    if (hub_clamped)
      DoFTools::make_zero_boundary_constraints(dofs, hub_boundary, constraints);
    constraints.close();

    unknown_of_dof.assign(dofs.n_dofs(), -1);
    int unknown = 0;
    for (types::global_dof_index i = 0; i < dofs.n_dofs(); ++i)
      if (constraints.is_constrained(i))
        ++n_constrained;
      else
        {
          unknown_of_dof[i]    = unknown++;
          const bool same_node = i % dim != 0 && !node_of_unknown.empty() &&
                                 unknown_of_dof[i - 1] >= 0;
          node_of_unknown.push_back(
            node_of_unknown.empty() ? 0 : node_of_unknown.back() + !same_node);
        }
  }



  namespace
  {
    using Combination = std::vector<std::pair<types::global_dof_index, double>>;

    template <int dim>
    Point<dim - 1>
    without_depth(const Point<dim> &chart_point)
    {
      Point<dim - 1> result;
      for (int d = 0; d < dim - 1; ++d)
        result[d] = chart_point[d];
      return result;
    }



    /**
     * True if the middle of a box lies in the zone of contact nodes, by a
     * margin that keeps rounding from deciding.
     */
    template <int dim>
    bool
    in_zone(const Point<dim>   &lower,
            const Point<dim>   &upper,
            const Grading<dim> &zone)
    {
      const std::array<double, 2> semi_axes{{zone.semi_axis_x(), zone.zone_y}},
        centre{{zone.centre_x(), 0.}};
      double sum = 0.;
      for (int d = 0; d < dim - 1; ++d)
        {
          const double middle = std::abs((lower[d] + upper[d]) / 2 - centre[d]),
                       margin = 0.01 * (upper[d] - lower[d]);
          sum += std::pow(std::max(0., middle - margin) / semi_axes[d], 2);
        }
      return sum <= 1.;
    }



    /**
     * The keys of @p positions by ascending x, then y.
     */
    template <int dim>
    std::vector<types::global_dof_index>
    sorted(const std::map<types::global_dof_index, Point<dim>> &positions,
           const std::array<double, 2>                         &scale)
    {
      std::vector<types::global_dof_index> order;
      for (const auto &entry : positions)
        order.push_back(entry.first);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        const auto &p = positions.at(a), &q = positions.at(b);
        for (int d = 0; d < dim; ++d)
          if (std::abs(p[d] - q[d]) > 1e-9 * scale[d])
            return p[d] < q[d];
        return false;
      });
      return order;
    }
  } // namespace



  template <int dim>
  void
  ElasticBody<dim>::for_each_surface_face(
    const std::function<void(const CellIterator &, const unsigned int)> &action)
    const
  {
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == contact_boundary)
          action(cell, f);
  }



  template <int dim>
  void
  ElasticBody<dim>::surface(const Grading<dim>       &zone,
                            std::vector<SurfaceNode> &nodes,
                            std::vector<SurfaceFace> &faces) const
  {
    const std::array<double, 2> extent{{zone.zone_x, zone.zone_y}};
    std::map<types::global_dof_index, Point<dim - 1>> vertices, used;
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          Point<dim> at = body_mesh.chart->pull_back(cell->face(f)->vertex(v));
          at[0]         = body_mesh.chart->centred_x(at[0]);
          vertices[cell->face(f)->vertex_dof_index(v, 0)] = without_depth(at);
        }
    });

    std::vector<std::vector<Combination>> corners;
    faces.clear();
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      const auto box = body_mesh.chart_box(cell);
      if (!in_zone(box.first, box.second, zone))
        return;
      faces.push_back(
        {without_depth(box.first), without_depth(box.second), {}});
      corners.emplace_back();
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const auto  dof  = cell->face(f)->vertex_dof_index(v, 0);
          const auto *line = constraints.get_constraint_entries(dof);
          corners.back().push_back(line == nullptr ? Combination{{dof, 1.}}
                                                   : *line);
          for (const auto &entry : corners.back().back())
            used[entry.first] = vertices.at(entry.first);
        }
    });

    std::map<types::global_dof_index, unsigned int> number;
    nodes.clear();
    for (const auto dof : sorted(used, extent))
      {
        number[dof] = nodes.size();
        SurfaceNode node;
        node.position = used[dof];
        for (int d = 0; d < dim; ++d)
          node.dofs[d] = dof + d;
        nodes.push_back(node);
      }
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const Combination &corner : corners[f])
        {
          faces[f].corners.emplace_back();
          for (const auto &entry : corner)
            faces[f].corners.back().emplace_back(number.at(entry.first),
                                                 entry.second);
        }
  }



  template <int dim>
  Discretisation<dim>
  ElasticBody<dim>::discretisation() const
  {
    return {
      dofs, constraints, unknown_of_dof, n_unknowns(), material, thickness};
  }



  template <int dim>
  SymmetricSparseMatrix
  ElasticBody<dim>::stiffness() const
  {
    return assemble_stiffness(discretisation());
  }



  template <int dim>
  SymmetricSparseMatrix
  ElasticBody<dim>::mass(const MassKind kind) const
  {
    return assemble_mass(discretisation(), kind);
  }



  template <int dim>
  std::vector<std::size_t>
  ElasticBody<dim>::unknowns(const std::vector<SurfaceNode>  &nodes,
                             const std::vector<unsigned int> &components) const
  {
    std::vector<std::size_t> result;
    for (const unsigned int component : components)
      for (const SurfaceNode &node : nodes)
        result.push_back(unknown_of_dof[node.dofs[component]]);
    return result;
  }



  template <int dim>
  std::vector<double>
  ElasticBody<dim>::uniform(const unsigned int component,
                            const double       value) const
  {
    std::vector<double> result(n_unknowns(), 0.);
    for (std::size_t i = 0; i < unknown_of_dof.size(); ++i)
      if (unknown_of_dof[i] >= 0 && i % dim == component)
        result[unknown_of_dof[i]] = value;
    return result;
  }



  template <int dim>
  Vector<double>
  ElasticBody<dim>::field(const std::vector<double> &values) const
  {
    Vector<double> result(dofs.n_dofs());
    for (std::size_t i = 0; i < unknown_of_dof.size(); ++i)
      if (unknown_of_dof[i] >= 0)
        result[i] = values[unknown_of_dof[i]];
    constraints.distribute(result);
    return result;
  }



  template <int dim>
  void
  ElasticBody<dim>::analyse()
  {
    if (factor != nullptr)
      return;
    if (!hub_clamped)
      throw InputError("Hub = free: a body that nothing holds has no static "
                       "compliance; take Hub = clamped.");
    const Stopwatch watch;
    factor = std::make_unique<Factorisation>(stiffness(), node_of_unknown);
    assembly_s += watch.seconds() - factor->size().analysis_s;
  }



  template <int dim>
  DenseMatrix
  ElasticBody<dim>::compliance(const std::vector<SurfaceNode>  &nodes,
                               const std::vector<unsigned int> &components,
                               const bool                       recovers)
  {
    analyse();
    factor->factorise();
    DenseMatrix W = factor->condense(unknowns(nodes, components));
    if (!recovers)
      factor->release();
    return W;
  }



  template <int dim>
  Vector<double>
  ElasticBody<dim>::recover(const std::vector<SurfaceNode>  &nodes,
                            const std::vector<unsigned int> &components,
                            const std::vector<double>       &forces) const
  {
    std::vector<double> right_hand_side(n_unknowns(), 0.);
    const auto          loaded = unknowns(nodes, components);
    for (std::size_t i = 0; i < loaded.size(); ++i)
      right_hand_side[loaded[i]] += forces[i];
    return field(factor->solve(right_hand_side));
  }



  template class ElasticBody<2>;
  template class ElasticBody<3>;
} // namespace RollingContact
