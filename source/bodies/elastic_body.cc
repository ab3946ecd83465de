#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/bodies/elastic_body.h>

#include <algorithm>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Throws unless every degree of freedom i on this rank is one of component
     * i modulo dim, which saves a table of components.
     */
    template <int dim>
    void check_component_numbers(const DoFHandler<dim> &dofs)
    {
      const auto                          &element = dofs.get_fe();
      std::vector<types::global_dof_index> cell_dofs(element.dofs_per_cell);
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(cell_dofs);
            for (unsigned int i = 0; i < cell_dofs.size(); ++i)
              AssertThrow(cell_dofs[i] % dim ==
                            element.system_to_component_index(i).first,
                          ExcMessage("Degrees of freedom are not numbered node "
                                     "by node."));
          }
    }
  } // namespace

  template <int dim>
  ElasticBody<dim>::ElasticBody(const std::shared_ptr<const BodyShape> &shape,
                                const Materials    &materials,
                                const double        thickness,
                                const Grading<dim> &grading,
                                const MeshKind      kind,
                                const BodyModel    &model)
    : materials(materials)
    , thickness(thickness)
    , hub(shape->hub())
    , model(model)
    , body_mesh(make_body_mesh<dim>(shape, grading, kind))
    , element(FE_Q<dim>(1), dim)
    , dofs(*body_mesh.triangulation)
  {
    const Stopwatch watch;
    dofs.distribute_dofs(element);
    check_component_numbers(dofs);
    DoFTools::extract_locally_relevant_dofs(dofs, relevant_dofs);
    if (kind == MeshKind::serial)
      supports = Supports<dim>(dofs, hub, model);
    constraints.reinit(
      supports.n_extra() == 0
        ? relevant_dofs
        : complete_index_set(dofs.n_dofs() + supports.n_extra()));
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    if (hub == Hub::clamped)
      DoFTools::make_zero_boundary_constraints(dofs, hub_boundary, constraints);
    supports.tie_hub(constraints);
    constraints.close();
    assembly_s = watch.seconds();
  }

  template <int dim>
  void ElasticBody<dim>::require_held() const
  {
    if (is_loose(hub))
      throw InputError(
        "Hub = " + std::string(hub == Hub::free ? "free" : "mass") +
        ": a body that nothing holds has no static compliance; "
        "take Hub = clamped or elastic.");
    if (hub != Hub::elastic)
      return;
    const std::string axes = "xyz";
    for (int c = 0; c < 3; ++c)
      if (c != 1 || dim == 3)
        {
          if (model.foundation.stiffness[c] == 0.)
            throw InputError("Foundation stiffness " + axes.substr(c, 1) +
                             " = 0: nothing holds the body along " + axes[c] +
                             " and it has no static compliance; give N/m^2.");
          if (model.foundation.has_sleepers() &&
              model.foundation.ballast_stiffness[c] == 0.)
            throw InputError("Ballast stiffness " + axes.substr(c, 1) +
                             " = 0: nothing holds the sleepers along " +
                             axes[c] +
                             " and the body has no static compliance; give "
                             "N/m^2.");
        }
  }

  namespace
  {
    using Combination = std::vector<std::pair<types::global_dof_index, double>>;

    /// of the zone: nodes closer than this along x are of one x
    const double same_coordinate = 1e-9;

    template <int dim>
    Point<dim - 1> without_depth(const Point<dim> &chart_point)
    {
      Point<dim - 1> result;
      for (int d = 0; d < dim - 1; ++d)
        result[d] = chart_point[d];
      return result;
    }

    /**
     * The corner of a box where a vertex is, x fastest.
     */
    template <int dim>
    unsigned int corner_of_box(const Point<dim - 1> &vertex,
                               const Point<dim - 1> &lower,
                               const Point<dim - 1> &upper)
    {
      unsigned int corner = 0;
      for (int d = 0; d < dim - 1; ++d)
        corner += (vertex[d] > (lower[d] + upper[d]) / 2) << d;
      return corner;
    }

    /**
     * True if @p p comes before @p q in ascending x, then y.
     */
    template <int dim>
    bool comes_before(const Point<dim>            &p,
                      const Point<dim>            &q,
                      const std::array<double, 2> &scale)
    {
      for (int d = 0; d < dim; ++d)
        if (std::abs(p[d] - q[d]) > same_coordinate * scale[d])
          return p[d] < q[d];
      return false;
    }

    /**
     * A face of the zone as a rank knows it: corners by degrees of freedom.
     */
    template <int dim>
    struct ZoneFace
    {
      Point<dim - 1>           lower, upper;
      std::vector<Combination> corners;

      template <typename Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &lower &upper &corners;
      }
    };

    /**
     * What a rank sees of the zone: its faces and the nodes they touch.
     */
    template <int dim>
    struct ZonePart
    {
      std::vector<ZoneFace<dim>>                        faces;
      std::map<types::global_dof_index, Point<dim - 1>> nodes;

      template <typename Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &faces &nodes;
      }

      void add(const ZonePart &other)
      {
        faces.insert(faces.end(), other.faces.begin(), other.faces.end());
        nodes.insert(other.nodes.begin(), other.nodes.end());
      }

      void sort_faces(const std::array<double, 2> &scale)
      {
        std::sort(faces.begin(),
                  faces.end(),
                  [&](const auto &a, const auto &b) {
                    return comes_before(a.lower, b.lower, scale);
                  });
      }

      /**
       * The nodes by ascending x, then y.
       */
      std::vector<types::global_dof_index>
      sorted_nodes(const std::array<double, 2> &scale) const
      {
        std::vector<types::global_dof_index> order;
        for (const auto &entry : nodes)
          order.push_back(entry.first);
        std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
          return comes_before(nodes.at(a), nodes.at(b), scale);
        });
        return order;
      }
    };
  } // namespace

  template <int dim>
  void ElasticBody<dim>::for_each_surface_face(
    const std::function<void(const CellIterator &, const unsigned int)> &action)
    const
  {
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == contact_boundary)
            action(cell, f);
  }

  namespace
  {
    /**
     * Nodes and faces of the whole zone, with nodes by their numbers.
     */
    template <int dim>
    void
    number_nodes(ZonePart<dim>                                       &whole,
                 const std::array<double, 2>                         &extent,
                 std::vector<typename ElasticBody<dim>::SurfaceNode> &nodes,
                 std::vector<typename ElasticBody<dim>::SurfaceFace> &faces)
    {
      std::map<types::global_dof_index, unsigned int> number;
      nodes.clear();
      for (const auto dof : whole.sorted_nodes(extent))
        {
          number[dof] = nodes.size();
          typename ElasticBody<dim>::SurfaceNode node;
          node.position = whole.nodes[dof];
          for (int d = 0; d < dim; ++d)
            node.dofs[d] = dof + d;
          nodes.push_back(node);
        }
      faces.clear();
      for (const ZoneFace<dim> &face : whole.faces)
        {
          faces.push_back({face.lower, face.upper, {}});
          for (const Combination &corner : face.corners)
            {
              faces.back().corners.emplace_back();
              for (const auto &entry : corner)
                faces.back().corners.back().emplace_back(number.at(entry.first),
                                                         entry.second);
            }
        }
    }
  } // namespace

  template <int dim>
  void ElasticBody<dim>::surface(const Grading<dim>       &zone,
                                 std::vector<SurfaceNode> &nodes,
                                 std::vector<SurfaceFace> &faces) const
  {
    std::map<types::global_dof_index, Point<dim - 1>> vertices;
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const Point<dim> at = body_mesh.chart_point(
            cell, GeometryInfo<dim>::face_to_cell_vertices(f, v));
          vertices[cell->face(f)->vertex_dof_index(v, 0)] = without_depth(at);
        }
    });

    ZonePart<dim> here, whole;
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      const auto box   = body_mesh.chart_box(cell);
      const auto lower = without_depth(box.first),
                 upper = without_depth(box.second);
      if (!cell->is_locally_owned() || !zone.in_zone(lower, upper))
        return;
      here.faces.push_back({lower, upper, {}});
      auto &corners = here.faces.back().corners;
      corners.resize(cell->face(f)->n_vertices());
      for (const unsigned int v : cell->face(f)->vertex_indices())
        {
          const auto   dof  = cell->face(f)->vertex_dof_index(v, 0);
          const auto  *line = constraints.get_constraint_entries(dof);
          Combination &corner =
            corners[corner_of_box<dim>(vertices.at(dof), lower, upper)];
          corner = line == nullptr ? Combination{{dof, 1.}} : *line;
          for (const auto &entry : corner)
            here.nodes[entry.first] = vertices.at(entry.first);
        }
    });
    for (const auto &part :
         Utilities::MPI::all_gather(body_mesh.triangulation->get_communicator(),
                                    here))
      whole.add(part);
    const std::array<double, 2> extent{{zone.zone_x, zone.zone_y}};
    whole.sort_faces(extent);
    number_nodes(whole, extent, nodes, faces);
  }

  template <int dim>
  std::vector<typename ElasticBody<dim>::SurfaceNode>
  ElasticBody<dim>::nodes_at(const std::vector<unsigned int> &vertices) const
  {
    std::map<unsigned int, SurfaceNode> found;
    for_each_surface_face([&](const CellIterator &cell, const unsigned int f) {
      const auto face = cell->face(f);
      for (const unsigned int v : face->vertex_indices())
        {
          SurfaceNode &node = found[face->vertex_index(v)];
          node.position     = without_depth(face->vertex(v));
          for (unsigned int d = 0; d < dim; ++d)
            node.dofs[d] = face->vertex_dof_index(v, d);
        }
    });
    std::vector<SurfaceNode> nodes;
    for (const unsigned int vertex : vertices)
      {
        nodes.push_back(found.at(vertex));
        AssertThrow(!constraints.is_constrained(nodes.back().dofs[0]),
                    ExcMessage("A contact node of a body is constrained."));
      }
    return nodes;
  }

  template class ElasticBody<2>;
  template class ElasticBody<3>;
} // namespace RollingContact
