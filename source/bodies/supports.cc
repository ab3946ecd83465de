#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/hub_faces.h>
#include <rolling_contact/bodies/supports.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Points of integration over the length of a pad, at least. */
    const unsigned int points_of_pad = 32;
  } // namespace

  template <int dim>
  Supports<dim>::Supports(const DoFHandler<dim> &dofs,
                          const Hub              hub,
                          const BodyModel       &model)
    : foundation(model.foundation)
    , hub_mass(model.hub_mass)
    , first_extra(dofs.n_dofs())
  {
    if (hub == Hub::elastic || hub == Hub::mass)
      axes = hub_axes(dofs);
    if (hub == Hub::elastic)
      find_pads(dofs);
    if (hub == Hub::mass)
      find_hub(dofs);
  }

  template <int dim>
  void Supports<dim>::find_pads(const DoFHandler<dim> &dofs)
  {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const auto &face : hub_faces(dofs))
      {
        for (const unsigned int v : face->vertex_indices())
          {
            first = std::min(first, face->vertex(v)[0]);
            last  = std::max(last, face->vertex(v)[0]);
          }
      }
    const double spacing = foundation.pad_spacing,
                 reach   = foundation.pad_length / 2;
    const auto pad_at    = [&](const double x) {
      return spacing > 0. ? std::lround((x - foundation.pad_offset) / spacing)
                             : 0l;
    };
    const auto middle = [&](const long pad) {
      return spacing > 0. ? foundation.pad_offset + pad * spacing
                          : (first + last) / 2;
    };
    const double step = spacing > 0. ? 2 * foundation.pad_length / points_of_pad
                                     : std::numeric_limits<double>::infinity();
    std::map<long, std::map<Dof, double>> areas;
    for (const auto &face : hub_faces(dofs))
      {
        integrate<dim>(face, step, [&](const FacePoint<dim> &point) {
          const long pad = pad_at(point.at[0]);
          if (spacing > 0. && std::abs(point.at[0] - middle(pad)) > reach)
            return;
          for (unsigned int v = 0; v < point.shape.size(); ++v)
            areas[pad][face->vertex_dof_index(v, 0)] +=
              point.shape[v] * point.area;
        });
      }
    const double rounding = 1e-9 * (last - first);
    for (const auto &[pad, nodes] : areas)
      if (spacing == 0. || (middle(pad) - reach > first - rounding &&
                            middle(pad) + reach < last + rounding))
        {
          springs.push_back(
            {middle(pad), spacing > 0. ? spacing : last - first, {}});
          double area = 0.;
          for (const auto &node : nodes)
            area += node.second;
          for (const auto &node : nodes)
            springs.back().shares.emplace_back(node.first, node.second / area);
        }
    if (springs.empty())
      throw InputError(
        "Pad spacing = " + significant(spacing, 4) +
        " m, Pad length = " + significant(foundation.pad_length, 4) +
        " m, Pad offset = " + significant(foundation.pad_offset, 4) +
        " m: no pad lies wholly under the body, whose hub boundary reaches "
        "from x = " +
        significant(first, 4) + " to " + significant(last, 4) +
        " m; take a shorter spacing or a longer body.");
  }

  template <int dim>
  void Supports<dim>::find_hub(const DoFHandler<dim> &dofs)
  {
    std::map<Dof, Point<dim>> nodes;
    Point<dim>                centre;
    double                    area = 0.;
    for (const auto &face : hub_faces(dofs))
      {
        for (const unsigned int v : face->vertex_indices())
          nodes[face->vertex_dof_index(v, 0)] = face->vertex(v);
        integrate<dim>(face,
                       std::numeric_limits<double>::infinity(),
                       [&](const FacePoint<dim> &point) {
                         centre += point.area * point.at;
                         area += point.area;
                       });
      }
    centre /= area;
    lever = 0.;
    for (const auto &[dof, at] : nodes)
      {
        hub_nodes.emplace_back(dof, at - centre);
        lever = std::max(lever, hub_nodes.back().second.norm());
      }
  }

  template <int dim>
  Tensor<2, dim>
  Supports<dim>::along_axes(const std::array<double, 3> &values) const
  {
    Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result += values[c == dim - 1 ? 2 : c] * outer_product(axes[c], axes[c]);
    return result;
  }

  template <int dim>
  unsigned int Supports<dim>::n_translations() const
  {
    if (is_tied())
      return dim;
    return foundation.has_sleepers() ? dim * springs.size() : 0;
  }

  template <int dim>
  unsigned int Supports<dim>::n_extra() const
  {
    return n_translations() + (is_tied() ? (dim == 2 ? 1 : 3) : 0);
  }

  template <int dim>
  double Supports<dim>::x_of_translation(const unsigned int i) const
  {
    return is_tied() ? 0. : springs[i / dim].x;
  }

  template <int dim>
  void Supports<dim>::tie_hub(AffineConstraints<double> &constraints) const
  {
    const Dof turn = first_extra + dim;
    for (const auto &[dof, arm] : hub_nodes)
      {
        if (constraints.is_constrained(dof))
          continue;
        const auto r = arm / lever;
        for (unsigned int c = 0; c < dim; ++c)
          {
            constraints.add_line(dof + c);
            constraints.add_entry(dof + c, first_extra + c, 1.);
          }
        if constexpr (dim == 2) // about y: z turns to x
          {
            constraints.add_entry(dof, turn, r[1]);
            constraints.add_entry(dof + 1, turn, -r[0]);
          }
        else
          for (unsigned int c = 0; c < 3; ++c)
            {
              const unsigned int next = (c + 1) % 3, last = (c + 2) % 3;
              constraints.add_entry(dof + c, turn + next, r[last]);
              constraints.add_entry(dof + c, turn + last, -r[next]);
            }
      }
  }

  template <int dim>
  void
  Supports<dim>::add_couplings(const AffineConstraints<double> &constraints,
                               DynamicSparsityPattern          &pattern) const
  {
    if (n_extra() == 0)
      return;
    const unsigned int block = is_tied() ? n_extra() : dim;
    for (unsigned int i = 0; i < n_extra(); ++i)
      for (unsigned int j = i - i % block; j < i - i % block + block; ++j)
        pattern.add(first_extra + i, first_extra + j);
    std::vector<Dof> ends(2 * dim);
    for (std::size_t p = 0; p < springs.size(); ++p)
      for (const auto &share : springs[p].shares)
        {
          for (unsigned int c = 0; c < dim; ++c)
            {
              ends[c]       = share.first + c;
              ends[dim + c] = first_extra + p * dim + c;
            }
          constraints.add_entries_local_to_global(ends, pattern, false);
        }
  }

  template <int dim>
  void
  Supports<dim>::add_stiffness(const AffineConstraints<double> &constraints,
                               const double                     of_foundation,
                               const double                     of_ballast,
                               SparseMatrix<double>            &K) const
  {
    const Tensor<2, dim> layer   = along_axes(foundation.stiffness),
                         ballast = along_axes(foundation.ballast_stiffness);
    const unsigned int n         = foundation.has_sleepers() ? 2 * dim : dim;
    FullMatrix<double> spring(n, n);
    std::vector<Dof>   ends(n);
    for (std::size_t p = 0; p < springs.size(); ++p)
      {
        for (unsigned int i = dim; i < n; ++i)
          for (unsigned int j = dim; j < n; ++j)
            K.add(first_extra + p * dim + i - dim,
                  first_extra + p * dim + j - dim,
                  of_ballast * springs[p].length * ballast[i - dim][j - dim]);
        for (const auto &[node, share] : springs[p].shares)
          {
            const double part = of_foundation * share * springs[p].length;
            for (unsigned int i = 0; i < n; ++i)
              {
                ends[i] = i < dim ? node + i : first_extra + p * dim + i - dim;
                for (unsigned int j = 0; j < n; ++j)
                  spring(i, j) = (i / dim == j / dim ? part : -part) *
                                 layer[i % dim][j % dim];
              }
            constraints.distribute_local_to_global(spring, ends, K);
          }
      }
  }

  template <int dim>
  auto Supports<dim>::masses() const -> std::vector<Entry>
  {
    std::vector<Entry> result;
    for (unsigned int i = 0; i < n_translations(); ++i)
      result.push_back(
        {i, i, is_tied() ? hub_mass.mass : foundation.sleeper_mass});
    if (!is_tied())
      return result;
    const double scale = 1 / (lever * lever);
    if constexpr (dim == 2)
      result.push_back({dim, dim, scale * hub_mass.inertia[1]});
    else
      {
        const Tensor<2, dim> inertia = along_axes(hub_mass.inertia);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.push_back({dim + i, dim + j, scale * inertia[i][j]});
      }
    return result;
  }

  template class Supports<2>;
  template class Supports<3>;
} // namespace RollingContact
