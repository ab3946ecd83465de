#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/operators.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  const std::vector<OperatorChoice<ContactMatrices>> &contact_matrices_choices()
  {
    static const std::vector<OperatorChoice<ContactMatrices>> choices{
      {"lumped", "row sums", ContactMatrices::lumped},
      {"consistent", "Lai et al. 2017", ContactMatrices::consistent},
      {"balanced",
       "lumped, with smoother pressures where element sizes change but less "
       "exact forces",
       ContactMatrices::balanced}};
    return choices;
  }

  const std::vector<OperatorChoice<SlipOperatorKind>> &slip_operator_choices()
  {
    static const std::vector<OperatorChoice<SlipOperatorKind>> choices{
      {"upwind 1", "first order", SlipOperatorKind::upwind_1},
      {"upwind 2", "second order", SlipOperatorKind::upwind_2},
      {"calibrated",
       "upwind 2 corrected at the edges of the contact",
       SlipOperatorKind::calibrated},
      {"galerkin", "Lai et al. 2017", SlipOperatorKind::galerkin}};
    return choices;
  }

  const std::string &name_of(const SlipOperatorKind kind)
  {
    const auto &choices = slip_operator_choices();
    return std::find_if(choices.begin(),
                        choices.end(),
                        [&](const auto &it) { return it.kind == kind; })
      ->name;
  }

  namespace
  {
    /**
     * Integrals over one element, by directions: N_a N_b, and N_a dN_b/dx.
     */
    double
    mass_integral(const double size, const unsigned int a, const unsigned int b)
    {
      return size * (a == b ? 1. / 3 : 1. / 6);
    }

    double derivative_integral(const unsigned int b)
    {
      return b == 1 ? 0.5 : -0.5;
    }

    /**
     * Sum element integrals into a matrix, corners replaced by the nodes they
     * hang on. @p integral(cell, a, b) is the one of corners a and b.
     */
    template <typename Integral>
    SparseRows assemble(const Trace &trace, const Integral &integral)
    {
      SparseRows matrix(trace.nodes.size());
      for (const Trace::Cell &cell : trace.cells)
        for (unsigned int a = 0; a < cell.corners.size(); ++a)
          for (unsigned int b = 0; b < cell.corners.size(); ++b)
            for (const auto &row : cell.corners[a])
              for (const auto &column : cell.corners[b])
                matrix.add(row.first,
                           column.first,
                           row.second * column.second * integral(cell, a, b));
      return matrix;
    }

    double extent(const Trace::Cell &cell, const unsigned int d)
    {
      return cell.upper[d] - cell.lower[d];
    }

    SparseRows mass_matrix(const Trace &trace, const double thickness)
    {
      return assemble(trace,
                      [&](const Trace::Cell &cell,
                          const unsigned int a,
                          const unsigned int b) {
                        double value = thickness;
                        for (unsigned int d = 0; d < trace.n_dimensions; ++d)
                          value *= mass_integral(extent(cell, d),
                                                 (a >> d) & 1,
                                                 (b >> d) & 1);
                        return value;
                      });
    }

    SparseRows row_sums(const SparseRows &matrix)
    {
      SparseRows lumped(matrix.size());
      for (unsigned int i = 0; i < matrix.size(); ++i)
        for (const auto &entry : matrix[i])
          lumped.add(i, i, entry.second);
      return lumped;
    }

    /**
     * Moments of a nodal shape function about its node: integral of
     * N_i (x - x_i), and a spread of the neighbours it overlaps, sum of m_ij
     * (x_j - x_i)(x_j - x_i)^T.
     */
    struct ShapeMoments
    {
      ShapeMoments(const Trace           &trace,
                   const SparseRows::Row &mass_row,
                   const unsigned int     i)
      {
        for (const auto &entry : mass_row)
          for (unsigned int d = 0; d < trace.n_dimensions; ++d)
            {
              const double arm =
                trace.nodes[entry.first][d] - trace.nodes[i][d];
              first[d] += entry.second * arm;
              for (unsigned int e = 0; e < trace.n_dimensions; ++e)
                spread[d][e] +=
                  entry.second * arm *
                  (trace.nodes[entry.first][e] - trace.nodes[i][e]);
            }
        if (trace.n_dimensions == 1)
          spread[1][1] = spread[0][0];
      }

      /**
       * first^T spread^-1, or none for a symmetric shape function.
       */
      std::optional<std::array<double, 2>> imbalance(const double area) const
      {
        const double tolerance =
          1e-9 * std::sqrt(area * (spread[0][0] + spread[1][1]));
        if (std::abs(first[0]) + std::abs(first[1]) < tolerance)
          return {};
        const double determinant =
          spread[0][0] * spread[1][1] - spread[0][1] * spread[1][0];
        return {
          {{(spread[1][1] * first[0] - spread[0][1] * first[1]) / determinant,
            (spread[0][0] * first[1] - spread[1][0] * first[0]) /
              determinant}}};
      }

      std::array<double, 2>                first{};
      std::array<std::array<double, 2>, 2> spread{};
    };

    /**
     * Row sums, made exact on linear fields: where element sizes change at a
     * node, its shape function is lopsided, and a nodal force in proportion to
     * the nodal value alone is that of a load moved aside. What a linear field
     * lacks, first moment times gradient, is added with the gradient fitted to
     * the neighbours. On equal elements nothing is added.
     */
    SparseRows balanced_row_sums(const Trace &trace, const SparseRows &mass)
    {
      SparseRows lumped = row_sums(mass);
      const auto border = trace.border_nodes();
      for (unsigned int i = 0; i < mass.size(); ++i)
        {
          const auto imbalance =
            ShapeMoments(trace, mass[i], i).imbalance(lumped[i][0].second);
          if (border[i] || !imbalance)
            continue;
          for (const auto &entry : mass[i])
            {
              double weight = 0.;
              for (unsigned int d = 0; d < trace.n_dimensions; ++d)
                weight += entry.second * (*imbalance)[d] *
                          (trace.nodes[entry.first][d] - trace.nodes[i][d]);
              lumped.add(i, entry.first, weight);
              lumped.add(i, i, -weight);
            }
        }
      return lumped;
    }

    void add_scaled(SparseRows            &matrix,
                    const unsigned int     i,
                    const SparseRows::Row &weights,
                    const double           factor)
    {
      for (const auto &entry : weights)
        matrix.add(i, entry.first, factor * entry.second);
    }
  } // namespace

  SparseRows contact_matrix(const Trace          &trace,
                            const ContactMatrices kind,
                            const double          thickness)
  {
    const SparseRows mass = mass_matrix(trace, thickness);
    switch (kind)
      {
        case ContactMatrices::consistent:
          return mass;
        case ContactMatrices::balanced:
          return balanced_row_sums(trace, mass);
        default:
          return row_sums(mass);
      }
  }

  namespace
  {
    bool contains(const SparseRows::Row &row, const unsigned int i)
    {
      return std::any_of(row.begin(), row.end(), [i](const auto &entry) {
        return entry.first == i;
      });
    }
  } // namespace

  UpstreamRows upstream_rows(const Trace &trace, const int flow)
  {
    const unsigned int n = trace.nodes.size();
    UpstreamRows       rows{SparseRows(n),
                      SparseRows(n),
                      SparseRows(n),
                      SparseRows(n),
                      std::vector<bool>(n)};
    for (unsigned int i = 0; i < n; ++i)
      {
        auto size = trace.element_size(i, -flow);
        if (!size)
          continue;
        const double x = trace.nodes[i][0], y = trace.nodes[i][1];
        auto         near = trace.interpolation(x - flow * *size, y);
        while (near && contains(*near, i))
          {
            *size *= 2;
            near = trace.interpolation(x - flow * *size, y);
          }
        if (!near)
          continue;
        rows.near[i]   = *near;
        const auto far = trace.interpolation(x - 2 * flow * *size, y);
        if (!far)
          continue;
        rows.far[i]       = *far;
        rows.defined[i]   = true;
        const double unit = flow / *size;
        rows.order_1.add(i, i, unit);
        add_scaled(rows.order_1, i, *near, -unit);
        rows.order_2.add(i, i, 1.5 * unit);
        add_scaled(rows.order_2, i, *near, -2 * unit);
        add_scaled(rows.order_2, i, *far, 0.5 * unit);
      }
    return rows;
  }

  SparseRows galerkin_rows(const Trace &trace, const ContactMatrices kind)
  {
    const SparseRows derivative = assemble(
      trace,
      [&](const Trace::Cell &cell, const unsigned int a, const unsigned int b) {
        double value = derivative_integral(b & 1);
        for (unsigned int d = 1; d < trace.n_dimensions; ++d)
          value *= mass_integral(extent(cell, d), (a >> d) & 1, (b >> d) & 1);
        return value;
      });
    const SparseRows H = contact_matrix(trace, kind, 1.);
    SparseRows       rows(trace.nodes.size());
    if (kind != ContactMatrices::consistent)
      {
        const auto areas = H.multiply(std::vector<double>(rows.size(), 1.));
        for (unsigned int i = 0; i < rows.size(); ++i)
          add_scaled(rows, i, derivative[i], 1 / areas[i]);
        return rows;
      }
    DenseMatrix mass = H.dense(), solution = derivative.dense();
    if (!solve_positive_definite(mass, solution))
      throw ConvergenceError("The contact matrix H is not positive definite.");
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < rows.size(); ++j)
        rows[i].emplace_back(j, solution(i, j));
    return rows;
  }
} // namespace RollingContact
