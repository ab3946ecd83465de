#include <rolling_contact/bodies/hub_faces.h>
#include <rolling_contact/mesh/body_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** d at / d s and the like of a straight-sided face at (s, t). */
    template <int dim, typename Face>
    FacePoint<dim> face_point(const Face &face, const double s, const double t)
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

    /** How far the edges of a face along one of its directions go along x. */
    template <int dim, typename Face>
    double reach_along_x(const Face &face, const unsigned int direction)
    {
      double reach = 0.;
      for (const unsigned int v : face->vertex_indices())
        if (!((v >> direction) & 1))
          reach = std::max(reach,
                           std::abs(face->vertex(v + (1 << direction))[0] -
                                    face->vertex(v)[0]));
      return reach;
    }

    /** Part of the way from x_0 to x_1 that is between two values. */
    std::array<double, 2> part_between(const double x_0,
                                       const double x_1,
                                       const double from,
                                       const double to)
    {
      const double rounding = 1e-12;
      if (std::abs(x_1 - x_0) <=
          rounding * std::max(std::abs(x_0), std::abs(x_1)))
        return {{0., from <= x_0 && x_0 <= to ? 1. : 0.}};
      const double a = (from - x_0) / (x_1 - x_0), b = (to - x_0) / (x_1 - x_0);
      return {{std::max(0., std::min(a, b)), std::min(1., std::max(a, b))}};
    }
  } // namespace

  template <int dim>
  std::vector<typename DoFHandler<dim>::active_face_iterator>
  hub_faces(const DoFHandler<dim> &dofs)
  {
    std::vector<typename DoFHandler<dim>::active_face_iterator> faces;
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            cell->face(f)->boundary_id() == hub_boundary)
          faces.push_back(cell->face(f));
    return faces;
  }

  template <int dim>
  void integrate(const typename DoFHandler<dim>::active_face_iterator &face,
                 const double                                          from,
                 const double                                          to,
                 const std::function<void(const FacePoint<dim> &)>    &action)
  {
    const double gauss[2] = {0.5 - std::sqrt(1. / 12),
                             0.5 + std::sqrt(1. / 12)};
    const double along[2] = {reach_along_x<dim>(face, 0),
                             dim == 3 ? reach_along_x<dim>(face, 1) : 0.};
    // the direction that goes along x is cut exactly, the other in parts
    const unsigned int cut     = along[1] > along[0] ? 1 : 0,
                       n_parts = along[1 - cut] > 1e-9 * along[cut] ? 16 : 1;
    for (unsigned int j = 0; j < (dim == 2 ? 1 : 2 * n_parts); ++j)
      {
        const double across   = (j / 2 + gauss[j % 2]) / n_parts;
        const auto   point_at = [&](const double place) {
          return cut == 0 ? face_point<dim>(face, place, across)
                            : face_point<dim>(face, across, place);
        };
        const auto [a, b] =
          part_between(point_at(0.).at[0], point_at(1.).at[0], from, to);
        for (unsigned int i = 0; a < b && i < 2; ++i)
          {
            FacePoint<dim> point = point_at(a + (b - a) * gauss[i]);
            point.area *= (b - a) / 2 / (dim == 2 ? 1. : 2. * n_parts);
            action(point);
          }
      }
  }

  namespace
  {
    /** Axes of the body that differ by less are its own. */
    const double same_axis = 1e-6;

    /**
     * Unit vectors by rows from one of them, number @p given, and as near to
     * the body's axes as that allows.
     */
    Tensor<2, 3> completed(const Tensor<1, 3> &direction,
                           const unsigned int  given)
    {
      Tensor<2, 3> axes;
      Tensor<1, 3> x;
      x[0]        = 1.;
      axes[given] = direction / direction.norm();
      x -= (x * axes[given]) * axes[given];
      axes[0] = x / x.norm();
      if (given == 2)
        axes[1] = cross_product_3d(axes[2], axes[0]);
      else
        axes[2] = cross_product_3d(axes[0], axes[1]);
      return axes;
    }

    /**
     * Axes of a hub whose outward normals have this mean and mean square.
     */
    Tensor<2, 3> axes_of_hub(const Tensor<1, 3>          &normal,
                             const SymmetricTensor<2, 3> &square)
    {
      const double flat = 0.7, round = 0.1;
      if (normal.norm() > flat && std::abs(normal[0]) < flat)
        return completed(-normal, 2);
      const auto smallest = eigenvectors(square)[2];
      if (smallest.first < round * trace(square) &&
          std::abs(smallest.second[1]) > round)
        return completed(smallest.second[1] > 0. ? smallest.second
                                                 : -smallest.second,
                         1);
      return unit_symmetric_tensor<3>();
    }
  } // namespace

  template <int dim>
  Tensor<2, dim> hub_axes(const DoFHandler<dim> &dofs)
  {
    Tensor<2, dim> axes = unit_symmetric_tensor<dim>();
    if constexpr (dim == 3)
      {
        Tensor<1, 3>          mean;
        SymmetricTensor<2, 3> square;
        double                area = 0.;
        for (const auto &cell : dofs.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == hub_boundary)
              {
                const auto   face = cell->face(f);
                Tensor<1, 3> normal =
                  cross_product_3d(face->vertex(3) - face->vertex(0),
                                   face->vertex(2) - face->vertex(1)) /
                  2;
                if (normal * (face->center() - cell->center()) < 0.)
                  normal = -normal;
                mean += normal;
                square +=
                  symmetrize(outer_product(normal, normal)) / normal.norm();
                area += normal.norm();
              }
        axes = axes_of_hub(mean / area, square / area);
        if ((axes - unit_symmetric_tensor<3>()).norm() < same_axis)
          axes = unit_symmetric_tensor<3>();
      }
    return axes;
  }

  template std::vector<DoFHandler<2>::active_face_iterator>
  hub_faces(const DoFHandler<2> &);
  template std::vector<DoFHandler<3>::active_face_iterator>
                hub_faces(const DoFHandler<3> &);
  template void integrate<2>(const DoFHandler<2>::active_face_iterator &,
                             const double,
                             const double,
                             const std::function<void(const FacePoint<2> &)> &);
  template void integrate<3>(const DoFHandler<3>::active_face_iterator &,
                             const double,
                             const double,
                             const std::function<void(const FacePoint<3> &)> &);
  template Tensor<2, 2> hub_axes(const DoFHandler<2> &);
  template Tensor<2, 3> hub_axes(const DoFHandler<3> &);
} // namespace RollingContact
