#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/elasticity/supports.h>
#include <rolling_contact/mesh/body_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Points of integration over the length of a pad, at least. */
    const unsigned int points_of_pad = 32;
    const unsigned int most_parts    = 64; ///< of a face along an edge



    /** Number of component @p c of @p dim among x, y, z. */
    template <int dim>
    unsigned int
    axis(const unsigned int c)
    {
      return c == dim - 1 ? 2 : c;
    }



    template <int dim>
    void
    for_each_hub_face(
      const DoFHandler<dim> &dofs,
      const std::function<
        void(const typename DoFHandler<dim>::active_face_iterator &)> &action)
    {
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == hub_boundary)
            action(cell->face(f));
    }



    /**
     * A point of integration of a face: where it is, its area, what its corners
     * have of it.
     */
    template <int dim>
    struct FacePoint
    {
      Point<dim>          at;
      double              area;
      std::vector<double> shape;
    };



    /** d at / d s and the like of a straight-sided face at (s, t). */
    template <int dim, typename Face>
    FacePoint<dim>
    face_point(const Face &face, const double s, const double t)
    {
      FacePoint<dim> point;
      Tensor<1, dim> along_s, along_t;
      for (const unsigned int v : face->vertex_indices())
        {
          const double of_s = v & 1 ? s : 1 - s,
                       of_t = dim == 2 ? 1. : (v & 2 ? t : 1 - t);
          point.shape.push_back(of_s * of_t);
          point.at += of_s * of_t * face->vertex(v);
          along_s += (v & 1 ? 1. : -1.) * of_t * face->vertex(v);
          along_t += (v & 2 ? 1. : -1.) * of_s * face->vertex(v);
        }
      if constexpr (dim == 2)
        point.area = along_s.norm();
      else
        point.area = cross_product_3d(along_s, along_t).norm();
      return point;
    }



    /** How many parts keep steps along x below @p step, along s and t. */
    template <int dim, typename Face>
    std::array<unsigned int, 2>
    parts_of(const Face &face, const double step)
    {
      std::array<unsigned int, 2> parts{{1, 1}};
      for (unsigned int d = 0; d + 1 < dim; ++d)
        for (const unsigned int v : face->vertex_indices())
          if (!((v >> d) & 1))
            {
              const double length =
                std::abs(face->vertex(v + (1 << d))[0] - face->vertex(v)[0]);
              parts[d] =
                std::clamp<unsigned int>(std::ceil(std::min(length / step,
                                                            1. * most_parts)),
                                         parts[d],
                                         most_parts);
            }
      return parts;
    }



    /** Gauss's two points in each part of a face. */
    template <int dim, typename Face, typename Action>
    void
    integrate(const Face &face, const double step, const Action &action)
    {
      const auto   parts = parts_of<dim>(face, step);
      const double gauss = std::sqrt(1. / 12);
      const auto   place = [&](const unsigned int k, const unsigned int n) {
        return (k / 2 + 0.5 + (k % 2 ? gauss : -gauss)) / n;
      };
      for (unsigned int i = 0; i < 2 * parts[0]; ++i)
        for (unsigned int j = 0; j < (dim == 2 ? 1 : 2 * parts[1]); ++j)
          {
            FacePoint<dim> point =
              face_point<dim>(face, place(i, parts[0]), place(j, parts[1]));
            point.area /= 2 * parts[0] * (dim == 2 ? 1. : 2. * parts[1]);
            action(point);
          }
    }
  } // namespace



  template <int dim>
  Supports<dim>::Supports(const DoFHandler<dim> &dofs,
                          const Hub              hub,
                          const BodyModel       &model)
    : foundation(model.foundation)
    , hub_mass(model.hub_mass)
    , first_extra(dofs.n_dofs())
  {
    if (hub == Hub::elastic)
      find_pads(dofs);
    if (hub == Hub::mass)
      find_hub(dofs);
  }



  template <int dim>
  void
  Supports<dim>::find_pads(const DoFHandler<dim> &dofs)
  {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for_each_hub_face<dim>(dofs, [&](const auto &face) {
      for (const unsigned int v : face->vertex_indices())
        {
          first = std::min(first, face->vertex(v)[0]);
          last  = std::max(last, face->vertex(v)[0]);
        }
    });
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
    for_each_hub_face<dim>(dofs, [&](const auto &face) {
      integrate<dim>(face, step, [&](const FacePoint<dim> &point) {
        const long pad = pad_at(point.at[0]);
        if (spacing > 0. && std::abs(point.at[0] - middle(pad)) > reach)
          return;
        for (unsigned int v = 0; v < point.shape.size(); ++v)
          areas[pad][face->vertex_dof_index(v, 0)] +=
            point.shape[v] * point.area;
      });
    });
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
  void
  Supports<dim>::find_hub(const DoFHandler<dim> &dofs)
  {
    std::map<Dof, Point<dim>> nodes;
    Point<dim>                centre;
    double                    area = 0.;
    for_each_hub_face<dim>(dofs, [&](const auto &face) {
      for (const unsigned int v : face->vertex_indices())
        nodes[face->vertex_dof_index(v, 0)] = face->vertex(v);
      integrate<dim>(face,
                     std::numeric_limits<double>::infinity(),
                     [&](const FacePoint<dim> &point) {
                       centre += point.area * point.at;
                       area += point.area;
                     });
    });
    centre /= area;
    lever = 0.;
    for (const auto &[dof, at] : nodes)
      {
        hub_nodes.emplace_back(dof, at - centre);
        lever = std::max(lever, hub_nodes.back().second.norm());
      }
  }



  template <int dim>
  unsigned int
  Supports<dim>::n_translations() const
  {
    if (is_tied())
      return dim;
    return foundation.has_sleepers() ? dim * springs.size() : 0;
  }



  template <int dim>
  unsigned int
  Supports<dim>::n_extra() const
  {
    return n_translations() + (is_tied() ? (dim == 2 ? 1 : 3) : 0);
  }



  template <int dim>
  double
  Supports<dim>::x_of_translation(const unsigned int i) const
  {
    return is_tied() ? 0. : springs[i / dim].x;
  }



  template <int dim>
  void
  Supports<dim>::tie_hub(AffineConstraints<double> &constraints) const
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
    for (Dof i = first_extra; i < first_extra + n_extra(); ++i)
      for (Dof j = first_extra; j < first_extra + n_extra(); ++j)
        if (is_tied() || i == j)
          pattern.add(i, j);
    for (std::size_t p = 0; p < springs.size(); ++p)
      for (const auto &share : springs[p].shares)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const Dof              sleeper = first_extra + p * dim + c;
            const std::vector<Dof> ends{share.first + c, sleeper};
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
    const bool         has_sleepers = foundation.has_sleepers();
    FullMatrix<double> spring(has_sleepers ? 2 : 1, has_sleepers ? 2 : 1);
    std::vector<Dof>   ends(spring.m());
    for (std::size_t p = 0; p < springs.size(); ++p)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double stiffness = of_foundation * springs[p].length *
                                   foundation.stiffness[axis<dim>(c)];
          if (has_sleepers)
            {
              ends[1] = first_extra + p * dim + c;
              K.add(ends[1],
                    ends[1],
                    of_ballast * springs[p].length *
                      foundation.ballast_stiffness[axis<dim>(c)]);
            }
          for (const auto &[node, share] : springs[p].shares)
            {
              ends[0] = node + c;
              for (unsigned int i = 0; i < spring.m(); ++i)
                for (unsigned int j = 0; j < spring.m(); ++j)
                  spring(i, j) = (i == j ? 1. : -1.) * share * stiffness;
              constraints.distribute_local_to_global(spring, ends, K);
            }
        }
  }



  template <int dim>
  std::vector<double>
  Supports<dim>::masses() const
  {
    if (!is_tied())
      return std::vector<double>(n_extra(), foundation.sleeper_mass);
    std::vector<double> result(dim, hub_mass.mass);
    for (unsigned int c = 0; c < 3; ++c)
      if (dim == 3 || c == 1)
        result.push_back(hub_mass.inertia[c] / (lever * lever));
    return result;
  }



  template class Supports<2>;
  template class Supports<3>;
} // namespace RollingContact
