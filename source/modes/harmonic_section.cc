#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/harmonic_section.h>
#include <rolling_contact/modes/section_elements.h>

#include <algorithm>
#include <limits>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /// of a cell: what facets may leave of a curved edge
    const double beside = 0.1;

    /** Strain of one shape function and one amplitude: yy, rr, tt, yr, rt, yt.
     */
    using Strain = std::array<double, 6>;

    /** @p w, @p w_y, @p w_r: the function and its derivatives; @p k and
     * @p curvature: n / r and 1 / r. */
    std::array<Strain, 3> strains(const double w,
                                  const double w_y,
                                  const double w_r,
                                  const double k,
                                  const double curvature)
    {
      return {{{{w_y, 0., 0., w_r, 0., -k * w}},
               {{0., w_r, curvature * w, w_y, -k * w, 0.}},
               {{0., 0., k * w, 0., w_r - curvature * w, w_y}}}};
    }

    Strain stress(const Strain &strain, const Material &material)
    {
      const double G      = material.shear_modulus(),
                   lambda = material.bulk_modulus() - 2 * G / 3,
                   volume = lambda * (strain[0] + strain[1] + strain[2]);
      return {{volume + 2 * G * strain[0],
               volume + 2 * G * strain[1],
               volume + 2 * G * strain[2],
               G * strain[3],
               G * strain[4],
               G * strain[5]}};
    }

    double product(const Strain &a, const Strain &b)
    {
      double sum = 0.;
      for (unsigned int k = 0; k < a.size(); ++k)
        sum += a[k] * b[k];
      return sum;
    }

    void add(SymmetricSparseMatrix &matrix,
             const int              i,
             const int              j,
             const double           value)
    {
      const auto begin = matrix.row_indices.begin() + matrix.column_starts[j],
                 end = matrix.row_indices.begin() + matrix.column_starts[j + 1];
      matrix
        .values[std::lower_bound(begin, end, i) - matrix.row_indices.begin()] +=
        value;
    }
  } // namespace

  HarmonicSection::HarmonicSection(const SectionMesh &section,
                                   const Material    &material,
                                   const bool         clamped,
                                   const unsigned int degree,
                                   const Axis         axis)
    : elements(
        std::make_unique<SectionElements>(section, material, clamped, degree))
    , is_straight(axis == Axis::straight)
  {
    unsigned int n_free = 0;
    for (unsigned int node = 0; node < elements->dofs.n_dofs(); ++node)
      {
        unknowns.push_back({{-1, -1, -1}});
        if (elements->constraints.is_constrained(node))
          continue;
        for (int &unknown : unknowns.back())
          {
            unknown = node_of_unknown.size();
            node_of_unknown.push_back(n_free);
          }
        ++n_free;
      }
    find_pattern();
  }

  void HarmonicSection::find_pattern()
  {
    DynamicSparsityPattern nodes(elements->dofs.n_dofs());
    DoFTools::make_sparsity_pattern(elements->dofs,
                                    nodes,
                                    elements->constraints,
                                    false);
    pattern.column_starts.push_back(0);
    for (unsigned int column = 0; column < unknowns.size(); ++column)
      if (unknowns[column][0] >= 0)
        for (const int above : unknowns[column])
          {
            for (auto row = nodes.begin(column); row != nodes.end(column);
                 ++row)
              for (const int below : unknowns[row->column()])
                if (below >= above)
                  pattern.row_indices.push_back(below);
            pattern.column_starts.push_back(pattern.row_indices.size());
          }
    pattern.values.assign(pattern.row_indices.size(), 0.);
  }

  HarmonicSection::~HarmonicSection() = default;

  std::pair<SymmetricSparseMatrix, SymmetricSparseMatrix>
  HarmonicSection::matrices(const double waves) const
  {
    const auto                          &element = elements->element;
    const unsigned int                   n_nodes = element.dofs_per_cell;
    std::vector<types::global_dof_index> nodes(n_nodes);

    SymmetricSparseMatrix K = pattern, M = pattern;

    const QGauss<2> quadrature(element.degree + 2);
    FEValues<2>     values(elements->mapping,
                       element,
                       quadrature,
                       update_values | update_gradients | update_JxW_values |
                         update_quadrature_points);
    const double    round = waves == 0. ? 2 * pi : pi; // int cos^2 d theta
    std::vector<std::array<Strain, 3>> strain(n_nodes), force(n_nodes);
    std::vector<std::vector<std::pair<types::global_dof_index, double>>> parts(
      n_nodes);
    FullMatrix<double> K_cell(3 * n_nodes), M_cell(n_nodes);
    for (const auto &cell : elements->dofs.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(nodes);
        K_cell = 0.;
        M_cell = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const double curvature =
                           is_straight ? 0. : 1 / values.quadrature_point(q)[1],
                         k      = is_straight ? waves : waves * curvature,
                         weight = values.JxW(q) *
                                  (is_straight ? 1. : round / curvature);
            for (unsigned int i = 0; i < n_nodes; ++i)
              {
                const auto gradient = values.shape_grad(i, q);
                strain[i]           = strains(values.shape_value(i, q),
                                    gradient[0],
                                    gradient[1],
                                    k,
                                    curvature);
                for (unsigned int a = 0; a < 3; ++a)
                  force[i][a] = stress(strain[i][a], elements->material);
              }
            for (unsigned int i = 0; i < n_nodes; ++i)
              for (unsigned int j = 0; j < n_nodes; ++j)
                {
                  M_cell(i, j) += elements->material.density * weight *
                                  values.shape_value(i, q) *
                                  values.shape_value(j, q);
                  for (unsigned int a = 0; a < 3; ++a)
                    for (unsigned int b = 0; b < 3; ++b)
                      K_cell(3 * i + a, 3 * j + b) +=
                        weight * product(strain[i][a], force[j][b]);
                }
          }
        for (unsigned int i = 0; i < n_nodes; ++i)
          parts[i] = elements->parts_of(nodes[i]);
        const auto add_entries = [&](const unsigned int i,
                                     const unsigned int j) {
          for (const auto &[node_i, weight_i] : parts[i])
            for (const auto &[node_j, weight_j] : parts[j])
              for (unsigned int a = 0; a < 3; ++a)
                for (unsigned int b = 0; b < 3; ++b)
                  {
                    const int row    = unknowns[node_i][a],
                              column = unknowns[node_j][b];
                    if (column < 0 || row < column)
                      continue;
                    const double weight = weight_i * weight_j;
                    add(K, row, column, weight * K_cell(3 * i + a, 3 * j + b));
                    if (a == b)
                      add(M, row, column, weight * M_cell(i, j));
                  }
        };
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int j = 0; j < n_nodes; ++j)
            add_entries(i, j);
      }
    return {std::move(K), std::move(M)};
  }

  SymmetricSparseMatrix
  HarmonicSection::springs(const std::array<double, 3> &stiffness) const
  {
    const auto                          &element = elements->element;
    std::vector<types::global_dof_index> nodes(element.dofs_per_cell);
    SymmetricSparseMatrix                result = pattern;
    FEFaceValues<2>                      values(elements->mapping,
                           element,
                           QGauss<1>(element.degree + 1),
                           update_values | update_JxW_values);
    double                               width = 0.;
    for (const auto &cell : elements->dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (SectionElements::is_of_hub(cell->face(f)))
          {
            values.reinit(cell, f);
            cell->get_dof_indices(nodes);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                width += values.JxW(q);
                std::vector<std::pair<types::global_dof_index, double>> shapes;
                for (unsigned int i = 0; i < nodes.size(); ++i)
                  for (const auto &[node, weight] :
                       elements->parts_of(nodes[i]))
                    shapes.emplace_back(node,
                                        weight * values.shape_value(i, q));
                for (const auto &[row, shape] : shapes)
                  for (const auto &[column, other] : shapes)
                    for (unsigned int a = 0; row >= column && a < 3; ++a)
                      add(result,
                          unknowns[row][a],
                          unknowns[column][a],
                          stiffness[a] * shape * other * values.JxW(q));
              }
          }
    AssertThrow(width > 0., ExcMessage("The section has no hub boundary."));
    for (double &value : result.values)
      value /= width;
    return result;
  }

  std::vector<std::array<double, 2>> HarmonicSection::places() const
  {
    std::vector<Point<2>> points(elements->dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(elements->mapping,
                                         elements->dofs,
                                         points);
    std::vector<std::array<double, 2>> result;
    for (std::size_t node = 0; node < points.size(); ++node)
      if (unknowns[node][0] >= 0)
        result.push_back({{points[node][0], points[node][1]}});
    return result;
  }

  HarmonicSection::Interpolation HarmonicSection::at(const double along,
                                                     const double radius) const
  {
    const Point<2> place(along, radius);
    const auto    &mapping  = elements->mapping;
    double         farthest = std::numeric_limits<double>::max();
    Point<2>       local;
    DoFHandler<2>::active_cell_iterator holder;
    for (const auto &cell : elements->dofs.active_cell_iterators())
      {
        if (cell->center().distance(place) > cell->diameter())
          continue;
        Point<2> here;
        try
          {
            here = mapping.transform_real_to_unit_cell(cell, place);
          }
        catch (const Mapping<2>::ExcTransformationFailed &)
          {
            continue; // far from this cell
          }
        const Point<2> inside = GeometryInfo<2>::project_to_unit_cell(here);
        const double   off    = inside.distance(here) * cell->diameter();
        if (off < farthest)
          {
            farthest = off;
            local    = inside;
            holder   = cell;
          }
      }
    if (holder.state() != IteratorState::valid ||
        farthest >= beside * holder->diameter())
      throw InputError(
        std::string("Model = ") + (is_straight ? "waveguide" : "harmonic") +
        ": the mesh with the patch has a node beside the section, " +
        significant(along, 4) + " m across and " + significant(radius, 5) +
        " m outwards. Take Model = mesh for this place of the contact.");
    Interpolation                        result;
    std::vector<types::global_dof_index> nodes(elements->element.dofs_per_cell);
    holder->get_dof_indices(nodes);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (const auto &[node, weight] : elements->parts_of(nodes[i]))
        {
          result.weights.push_back(weight *
                                   elements->element.shape_value(i, local));
          result.unknowns.push_back(unknowns[node]);
        }
    return result;
  }
} // namespace RollingContact
