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

  namespace
  {
    template <typename Face>
    std::pair<double, double> range_along_x(const Face &face)
    {
      double from = face->vertex(0)[0], to = from;
      for (const unsigned int v : face->vertex_indices())
        {
          from = std::min(from, face->vertex(v)[0]);
          to   = std::max(to, face->vertex(v)[0]);
        }
      return {from, to};
    }

    /** Add what a pad between two values of x has of a face. */
    template <int dim, typename Face>
    void add_face(const Face                  &face,
                  const double                 from,
                  const double                 to,
                  typename Supports<dim>::Pad &pad)
    {
      const unsigned int              n = face->n_vertices();
      typename Supports<dim>::PadFace part{{},
                                           std::vector<double>(n, 0.),
                                           FullMatrix<double>(n, n)};
      double                          area = 0.;
      integrate<dim>(face, from, to, [&](const FacePoint<dim> &point) {
        area += point.area;
        for (unsigned int v = 0; v < n; ++v)
          {
            part.shares[v] += point.shape[v] * point.area;
            for (unsigned int w = 0; w < n; ++w)
              part.products(v, w) +=
                point.shape[v] * point.shape[w] * point.area;
          }
      });
      for (unsigned int v = 0; v < n; ++v)
        part.nodes.push_back(face->vertex_dof_index(v, 0));
      if (area > 0.)
        pad.faces.push_back(std::move(part));
    }

    /**
     * What the ends of springs, nodes and the sleeper behind them, have of the
     * stiffness: integrals of (N_i - 1_sleeper) (N_j - 1_sleeper).
     */
    template <typename Face>
    FullMatrix<double> parts_of_ends(const Face &face, const bool has_sleeper)
    {
      const unsigned int n = face.nodes.size(), size = has_sleeper ? n + 1 : n;
      FullMatrix<double> parts(size, size);
      parts.fill(face.products);
      for (unsigned int v = 0; size > n && v < n; ++v)
        {
          parts(v, n) = parts(n, v) = -face.shares[v];
          parts(n, n) += face.shares[v];
        }
      return parts;
    }
  } // namespace

  template <int dim>
  void Supports<dim>::find_pads(const DoFHandler<dim> &dofs)
  {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const auto &face : hub_faces(dofs))
      {
        const auto [from, to] = range_along_x(face);
        first                 = std::min(first, from);
        last                  = std::max(last, to);
      }
    const double spacing    = foundation.pad_spacing,
                 everywhere = std::numeric_limits<double>::max(),
                 reach      = foundation.pad_length / 2,
                 offset     = foundation.pad_offset;
    std::map<long, Pad> pads;
    for (const auto &face : hub_faces(dofs))
      if (spacing > 0.)
        {
          const auto [from, to] = range_along_x(face);
          for (long k = std::lround((from - offset) / spacing);
               k <= std::lround((to - offset) / spacing);
               ++k)
            add_face<dim>(face,
                          offset + k * spacing - reach,
                          offset + k * spacing + reach,
                          pads[k]);
        }
      else
        add_face<dim>(face, -everywhere, everywhere, pads[0]);
    const double rounding = 1e-9 * (last - first);
    for (auto &[k, pad] : pads)
      {
        pad.x      = spacing > 0. ? offset + k * spacing : (first + last) / 2;
        pad.length = spacing > 0. ? spacing : last - first;
        const bool is_cut = spacing > 0. && (pad.x - reach < first - rounding ||
                                             pad.x + reach > last + rounding);
        if (is_cut || pad.faces.empty())
          continue;
        double area = 0.;
        for (const PadFace &face : pad.faces)
          for (const double share : face.shares)
            area += share;
        for (PadFace &face : pad.faces)
          {
            for (double &share : face.shares)
              share /= area;
            face.products /= area;
          }
        springs.push_back(std::move(pad));
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
                       -std::numeric_limits<double>::max(),
                       std::numeric_limits<double>::max(),
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
    for (std::size_t p = 0; p < springs.size(); ++p)
      for (const PadFace &face : springs[p].faces)
        constraints.add_entries_local_to_global(ends_of(face, p),
                                                pattern,
                                                false);
  }

  template <int dim>
  auto Supports<dim>::ends_of(const PadFace &face, const std::size_t pad) const
    -> std::vector<Dof>
  {
    std::vector<Dof> ends;
    for (const Dof node : face.nodes)
      for (unsigned int c = 0; c < dim; ++c)
        ends.push_back(node + c);
    for (unsigned int c = 0; foundation.has_sleepers() && c < dim; ++c)
      ends.push_back(first_extra + pad * dim + c);
    return ends;
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
    for (std::size_t p = 0; p < springs.size(); ++p)
      {
        const double length = springs[p].length;
        for (unsigned int i = 0; foundation.has_sleepers() && i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            K.add(first_extra + p * dim + i,
                  first_extra + p * dim + j,
                  of_ballast * length * ballast[i][j]);
        for (const PadFace &face : springs[p].faces)
          {
            const std::vector<Dof>   ends = ends_of(face, p);
            const FullMatrix<double> parts =
              parts_of_ends(face, foundation.has_sleepers());
            FullMatrix<double> spring(ends.size(), ends.size());
            for (unsigned int i = 0; i < ends.size(); ++i)
              for (unsigned int j = 0; j < ends.size(); ++j)
                spring(i, j) = of_foundation * length *
                               parts(i / dim, j / dim) *
                               layer[i % dim][j % dim];
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
