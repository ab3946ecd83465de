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
    const unsigned int most_parts = 64; ///< of a face along an edge

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

    /** How many parts keep steps along x below @p step, along s and t. */
    template <int dim, typename Face>
    std::array<unsigned int, 2> parts_of(const Face &face, const double step)
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
                 const double                                          step,
                 const std::function<void(const FacePoint<dim> &)>    &action)
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
                             const std::function<void(const FacePoint<2> &)> &);
  template void integrate<3>(const DoFHandler<3>::active_face_iterator &,
                             const double,
                             const std::function<void(const FacePoint<3> &)> &);
  template Tensor<2, 2> hub_axes(const DoFHandler<2> &);
  template Tensor<2, 3> hub_axes(const DoFHandler<3> &);
} // namespace RollingContact
