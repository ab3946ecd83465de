#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/modes/axle_motion.h>

namespace RollingContact
{
  namespace
  {
    using Vector3 = Eigen::Vector3d;

    Vector3 vector_of(const std::array<double, 3> &point)
    {
      return {point[0], point[1], point[2]};
    }

    /** Displacements of a point by translations along x, y and z and by turns
     * about axes through @p centre, 3 x 6 values. */
    Eigen::Matrix<double, 3, 6> rigid_motions_at(const Vector3 &point,
                                                 const Vector3 &centre)
    {
      Eigen::Matrix<double, 3, 6> R;
      R.leftCols<3>().setIdentity();
      for (int c = 0; c < 3; ++c)
        R.col(3 + c) = Vector3::Unit(c).cross(point - centre);
      return R;
    }

    /** The moments of inertia of an axle along x, y and z. */
    Eigen::Matrix3d inertia_of(const HubMass &axle, const Vector3 &axis)
    {
      Eigen::Matrix3d axes;
      axes.col(1) = axis.normalized();
      axes.col(2) = Vector3::UnitX().cross(axes.col(1)).normalized();
      axes.col(0) = axes.col(1).cross(axes.col(2));
      const Vector3 principal = vector_of(axle.inertia);
      return axes * principal.asDiagonal() * axes.transpose();
    }
  } // namespace

  template <int dim>
  AxleMotion::AxleMotion(const DirectBody<dim>       &body,
                         const BodyPlaces            &places,
                         const HubMass               &axle,
                         const std::array<double, 3> &axis,
                         const DenseMatrix           &shapes)
  {
    const std::vector<PointMass> hub    = body.clamped_masses();
    Vector3                      centre = Vector3::Zero();
    double                       weight = 0.;
    for (const PointMass &mass : hub)
      {
        centre += mass.mass * vector_of(mass.point);
        weight += mass.mass;
      }
    centre /= weight;
    // in 2D along x and z and about y
    const std::vector<int> chosen =
      dim == 3 ? std::vector<int>{0, 1, 2, 3, 4, 5} : std::vector<int>{0, 2, 4};
    const Eigen::Index q = chosen.size();
    DenseMatrix        all(6, 6);
    all.setZero();
    all.diagonal().head<3>().setConstant(axle.mass);
    all.bottomRightCorner<3, 3>() = inertia_of(axle, vector_of(axis));
    const auto add                = [&](const std::array<double, 3> &point,
                         const double                 mass) {
      const auto R = rigid_motions_at(vector_of(point), centre);
      all += mass * R.transpose() * R;
    };
    for (const PointMass &mass : hub)
      add(mass.point, mass.mass);
    fields = DenseMatrix::Zero(body.n_unknowns(), q);
    DenseMatrix forces(fields.rows(), q); // M R
    forces.setZero();
    for (const BodyPlaces::Node &node : places.nodes)
      {
        const auto R = rigid_motions_at(vector_of(node.point), centre);
        add(node.point, node.mass);
        for (int c = 0; c < 3; ++c)
          if (const int i = node.unknowns[c]; i >= 0)
            for (Eigen::Index j = 0; j < q; ++j)
              {
                fields(i, j) = R(c, chosen[j]);
                forces(i, j) = node.mass * R(c, chosen[j]);
              }
      }
    rigid.resize(q, q);
    for (Eigen::Index i = 0; i < q; ++i)
      for (Eigen::Index j = 0; j < q; ++j)
        rigid(i, j) = all(chosen[i], chosen[j]);
    const DenseMatrix             P = shapes.transpose() * forces;
    const Eigen::LLT<DenseMatrix> root(rigid - P.transpose() * P);
    if (root.info() != Eigen::Success)
      throw InputError(
        "Wheel/Hub mass: wheel and axle are too light, or turn too "
        "easily, for the inertia that the modes of the wheel "
        "have; give Hub mass in kg and Hub inertia in kg m^2.");
    unit       = root.matrixL().transpose().solve(DenseMatrix::Identity(q, q));
    held       = P * unit;
    along_z    = dim - 1; // x, z and a turn, or x, y, z and turns
    coupling_z = column_of(P, along_z);
  }

  std::vector<double>
  AxleMotion::relative_to_axle(const std::vector<double> &coordinates) const
  {
    const auto      all = as_vector(coordinates);
    Eigen::VectorXd eta = all.head(held.rows()) - held * all.tail(unit.cols());
    return {eta.data(), eta.data() + eta.size()};
  }

  double AxleMotion::velocity_along_z(const std::vector<double> &rates) const
  {
    const Eigen::VectorXd axle = unit * as_vector(rates).tail(unit.cols());
    return (dot(coupling_z, relative_to_axle(rates)) +
            rigid.row(along_z).dot(axle)) /
           rigid(along_z, along_z);
  }

  void AxleMotion::join(DenseMatrix &matrix) const
  {
    const Eigen::Index m = held.rows(), n = matrix.rows(), q = unit.cols();
    DenseMatrix        more = DenseMatrix::Zero(n, q); // of eta, by z
    more.topRows(m)         = -held;
    DenseMatrix all(n + q, n + q);
    all << matrix, matrix * more, more.transpose() * matrix,
      more.transpose() * matrix * more;
    matrix = std::move(all);
  }

  void AxleMotion::join(DenseMatrix       &shapes,
                        const DenseMatrix &of_motions) const
  {
    DenseMatrix all(shapes.rows(), shapes.cols() + unit.cols());
    all << shapes, of_motions * unit - shapes.leftCols(held.rows()) * held;
    shapes = std::move(all);
  }

  template AxleMotion::AxleMotion(const DirectBody<2> &,
                                  const BodyPlaces &,
                                  const HubMass &,
                                  const std::array<double, 3> &,
                                  const DenseMatrix &);
  template AxleMotion::AxleMotion(const DirectBody<3> &,
                                  const BodyPlaces &,
                                  const HubMass &,
                                  const std::array<double, 3> &,
                                  const DenseMatrix &);
} // namespace RollingContact
