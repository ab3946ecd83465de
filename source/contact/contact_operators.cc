#include <rolling_contact/contact/contact_operators.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Correct the diagonal block of W that starts at @p first so that it takes
     * @p forces to @p displacement, unless it does to within @p error.
     */
    void correct_block(const std::size_t          first,
                       const std::vector<double> &forces,
                       const std::vector<double> &displacement,
                       const double               error,
                       DenseMatrix               &W)
    {
      const std::size_t   n = forces.size();
      std::vector<double> d = block_product(W, first, first, n, forces);
      for (std::size_t i = 0; i < n; ++i)
        d[i] = displacement[i] - d[i];
      const double size = norm(d), force = norm(forces), work = dot(forces, d);
      if (force == 0. || size <= error)
        return;
      const bool   rank_one = work > 1e-3 * force * size;
      const double square   = force * force;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          W(first + i, first + j) +=
            rank_one ? d[i] * d[j] / work
                     : (d[i] * forces[j] + forces[i] * d[j] -
                        work / square * forces[i] * forces[j]) /
                         square;
    }
  } // namespace

  ContactOperators::ContactOperators(Positions         positions,
                                     SparseRows        H,
                                     ContactCompliance W,
                                     SlipOperator      slip_operator,
                                     const NormalTangentialCoupling &coupling,
                                     const NodalForces               forces)
    : n_tangential_components(W.rows() / H.size() - 1)
    , node_positions(std::move(positions))
    , contact_matrix(std::move(H))
    , H_columns(contact_matrix.transposed())
    , B1(std::move(slip_operator))
    , normal_tangential(coupling)
    , forces(forces)
    , node_areas(contact_matrix.multiply(std::vector<double>(n_nodes(), 1.)))
  {
    set_compliance(std::move(W));
  }

  void ContactOperators::set_frames(SurfaceFrames frames)
  {
    surface_frames = std::move(frames);
    shares.clear();
    for (const SurfaceFrames::Node &node : surface_frames.nodes)
      shares.push_back(std::cos(node.angle + surface_frames.load_angle));
    areas_of_load = shares.empty() ? std::vector<double>()
                                   : contact_matrix.multiply_transposed(shares);
  }

  std::array<double, 2> ContactOperators::place(const unsigned int i) const
  {
    return {{node_positions[i][0],
             surface_frames.is_plane() ? node_positions[i][1]
                                       : surface_frames.nodes[i].y}};
  }

  double ContactOperators::load(const std::vector<double> &pressure) const
  {
    return dot(load_areas(), pressure);
  }

  void ContactOperators::set_compliance(ContactCompliance W)
  {
    compliance = std::move(W);
    corrected  = false;
    find_pressure_compliance();
    find_normal_norm();
    find_tangential_norm();
  }

  void ContactOperators::set_time_scaling(const TimeScaling &new_scaling)
  {
    if (scaling == new_scaling)
      return;
    scaling = new_scaling;
    if (scaling.rate != 0. && compliance.on_grid())
      {
        compliance.make_dense();
        find_pressure_compliance();
      }
    find_tangential_norm();
  }

  void ContactOperators::correct(const std::vector<double> &forces,
                                 const std::vector<double> &displacement)
  {
    const double error = 1e-11 * norm(displacement);
    DenseMatrix &W     = compliance.make_dense();
    if (normal_tangential.exists)
      correct_block(0, forces, displacement, error, W);
    else
      {
        const auto correct_part = [&](const std::size_t begin,
                                      const std::size_t end) {
          const auto part = [&](const std::vector<double> &all) {
            return std::vector<double>(all.begin() + begin, all.begin() + end);
          };
          correct_block(begin, part(forces), part(displacement), error, W);
        };
        correct_part(0, first_normal());
        correct_part(first_normal(), forces.size());
      }
    corrected = true;
    find_pressure_compliance();
  }

  std::vector<double> ContactOperators::normal_displacement(
    const std::vector<double> &pressure) const
  {
    return compliance.product(first_normal(),
                              first_normal(),
                              n_nodes(),
                              contact_matrix.multiply(pressure));
  }

  std::vector<double> ContactOperators::normal_displacement_of_traction(
    const NodalField &traction) const
  {
    if (!normal_tangential.exists || n_tangential() == 0)
      return std::vector<double>(n_nodes(), 0.);
    return compliance.product(first_normal(),
                              0,
                              n_nodes(),
                              contact_matrix.multiply(traction.values()));
  }

  NodalField
  ContactOperators::tangential_displacement(const NodalField &traction) const
  {
    return {n_nodes(),
            compliance.product(0,
                               0,
                               first_normal(),
                               contact_matrix.multiply(traction.values()))};
  }

  NodalField ContactOperators::tangential_displacement_of_pressure(
    const std::vector<double> &pressure) const
  {
    if (!normal_tangential.exists)
      return {n_nodes(), n_tangential()};
    return {n_nodes(),
            compliance.product(0,
                               first_normal(),
                               first_normal(),
                               contact_matrix.multiply(pressure))};
  }

  NodalField ContactOperators::tangential_displacement(
    const NodalField          &traction,
    const std::vector<double> &pressure) const
  {
    if (n_tangential() == 0)
      return {};
    NodalField w = tangential_displacement(traction);
    w += tangential_displacement_of_pressure(pressure);
    return w;
  }

  std::vector<double>
  ContactOperators::displacement_along(const unsigned int         c,
                                       const std::vector<double> &field) const
  {
    const std::size_t first = c * n_nodes();
    return compliance.product(first,
                              first,
                              n_nodes(),
                              contact_matrix.multiply(field));
  }

  NodalField
  ContactOperators::distortion(const std::size_t          first_column,
                               const std::vector<double> &forces) const
  {
    if (const GridCompliance *grid = compliance.on_grid())
      return {n_nodes(),
              grid->product(
                forces, first_column / n_nodes(), 0, n_tangential(), true)};
    return distortion_by_columns(first_column, forces);
  }

  NodalField ContactOperators::distortion_by_columns(
    const std::size_t          first_column,
    const std::vector<double> &forces) const
  {
    const std::size_t        n = n_nodes(), together = 4;
    std::vector<std::size_t> columns;
    for (std::size_t j = 0; j < forces.size(); ++j)
      if (forces[j] != 0.)
        columns.push_back(j);
    NodalField result(n, n_tangential());
    for (unsigned int c = 0; c < n_tangential(); ++c)
      for (std::size_t k = 0; k < columns.size(); k += together)
        {
          // summed column by column; those that are not there have no force
          const double *W[together];
          double        common[together], force[together];
          for (std::size_t m = 0; m < together; ++m)
            {
              const bool exists = k + m < columns.size();
              const auto j      = columns[exists ? k + m : k];
              W[m]              = compliance.data() +
                     (first_column + j) * compliance.rows() + c * n;
              common[m] = W[m][n / 2];
              force[m]  = exists ? forces[j] : 0.;
            }
          double *sum = &result(c, 0);
          for (std::size_t i = 0; i < n; ++i)
            sum[i] = (((sum[i] + (W[0][i] - common[0]) * force[0]) +
                       (W[1][i] - common[1]) * force[1]) +
                      (W[2][i] - common[2]) * force[2]) +
                     (W[3][i] - common[3]) * force[3];
        }
    return result;
  }

  NodalField
  ContactOperators::distortion_of_traction(const NodalField &traction) const
  {
    return scaling.rate != 0.
             ? tangential_displacement(traction)
             : distortion(0, contact_matrix.multiply(traction.values()));
  }

  NodalField ContactOperators::distortion_of_pressure(
    const std::vector<double> &pressure) const
  {
    if (scaling.rate != 0. || !normal_tangential.exists)
      return tangential_displacement_of_pressure(pressure);
    return distortion(first_normal(), contact_matrix.multiply(pressure));
  }

  NodalField ContactOperators::distortion_of_unit(const NodalIndex &unit) const
  {
    NodalField result(n_nodes(), n_tangential());
    for (const auto &entry : H_columns[unit.node])
      {
        const std::size_t j = unit.component * n_nodes() + entry.first;
        for (unsigned int c = 0; c < n_tangential(); ++c)
          {
            const Eigen::VectorXd moved =
              compliance.column(c * n_nodes(), n_nodes(), j);
            const double common =
              scaling.rate == 0. ? moved[n_nodes() / 2] : 0.;
            for (std::size_t i = 0; i < n_nodes(); ++i)
              result(c, i) += (moved[i] - common) * entry.second;
          }
      }
    return result;
  }

  double ContactOperators::resultant(const std::vector<double> &field) const
  {
    return dot(node_areas, field);
  }

  void ContactOperators::find_pressure_compliance()
  {
    if (compliance.on_grid())
      return;
    const std::size_t first = first_normal(), n = n_nodes();
    W_nn_H = DenseMatrix::Zero(n, n);
    for (std::size_t k = 0; k < n; ++k)
      for (const auto &[j, value] : contact_matrix[k])
        W_nn_H.col(j) += compliance.column(first, n, first + k) * value;
  }
} // namespace RollingContact
