#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/vibration/rolling_modes.h>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// relative residual of the equations of whole bodies
    const double full_tolerance = 1e-10;

    /** Both parts of complex values by a function of real ones. */
    template <typename Function>
    ComplexVector by_parts(const Function      &function,
                           const ComplexVector &values)
    {
      std::vector<double> real(values.size()), imaginary(values.size());
      as_vector(real)      = values.real();
      as_vector(imaginary) = values.imag();
      real                 = function(std::move(real));
      imaginary            = function(std::move(imaginary));
      return as_vector(real) + Complex(0., 1.) * as_vector(imaginary);
    }
  } // namespace

  template <int dim>
  WholeBodies<dim>::WholeBodies(const RollingModes<dim> &rolling,
                                const RollingConditions &conditions)
    : rolling(rolling)
    , added_damping(conditions.added_damping)
  {
    const ModalBodies<dim> &modal = rolling.bodies();
    for (const Side side : both_sides)
      if (modal.body(side) != nullptr && modal.n_modes(side) == 0)
        throw InputError(
          "Stability/Full model = true: the " + name_of(side) +
          " has no mode below the cut-off to begin its answers with; take a "
          "higher Modes/Cut-off ratio or Maximum frequency, or Full model = "
          "false.");
      else if (modal.body(side) != nullptr && !modal.body(side)->waves)
        bodies[side] = modal.whole_body(side, conditions);
  }

  template <int dim>
  std::vector<ComplexVector> WholeBodies<dim>::answer_of_waves(
    const Side                        side,
    const ComplexValues              &s,
    const std::vector<ComplexVector> &forces) const
  {
    const VibratingBody<dim> &body    = *rolling.bodies().body(side);
    const ContactVibration   &contact = rolling.contact_of(side);
    const DenseMatrix        &motions = rolling.motions_of_waves(side);
    DenseMatrix               moved(body.body->n_unknowns(), 2 * forces.size());
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        const ComplexVector load = contact.load(0., forces[k]);
        moved.col(2 * k)         = load.real();
        moved.col(2 * k + 1)     = load.imag();
      }
    body.factor->solve(moved);
    std::vector<ComplexVector> result;
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        const ComplexVector x =
          moved.col(2 * k) + Complex(0., 1.) * moved.col(2 * k + 1);
        const Complex       kappa = body.waves->stiffening(s[k], added_damping);
        const ComplexMatrix alpha = body.waves->change(s[k], added_damping) +
                                    rolling.beyond_mesh(side) / kappa;
        result.push_back(contact.of_nodes(0., forces[k], x) / kappa +
                         motions * (alpha * (motions.transpose() * forces[k])));
      }
    return result;
  }

  template <int dim>
  typename WholeBodies<dim>::Answer
  WholeBodies<dim>::answer(const Side                        side,
                           const ComplexValues              &s,
                           const std::vector<ComplexVector> &forces) const
  {
    Answer                     answer;
    std::vector<ComplexVector> loads;
    answer.forces = forces_on(side, forces);
    for (std::size_t k = 0; k < forces.size(); ++k)
      loads.push_back(rolling.contact_of(side).load(s[k], answer.forces[k]));
    answer.x = bodies[side]->solve(s, loads, full_tolerance);
    if (const AxleMotion *axle = rolling.bodies().axle(side))
      move_axle(side, *axle, s, loads, answer);
    return answer;
  }

  template <int dim>
  void WholeBodies<dim>::move_axle(const Side                        side,
                                   const AxleMotion                 &axle,
                                   const ComplexValues              &s,
                                   const std::vector<ComplexVector> &loads,
                                   Answer &answer) const
  {
    const VibratingBody<dim> &body = *rolling.bodies().body(side);
    const DenseMatrix        &R    = axle.motions();
    const Eigen::Index        q    = R.cols();
    DenseMatrix               MR(R.rows(), q);
    for (Eigen::Index j = 0; j < q; ++j)
      {
        std::vector<double> forces(R.rows());
        body.M.multiply(column_of(R, j), forces);
        MR.col(j) = as_vector(forces);
      }
    for (std::size_t k = 0; k < s.size(); ++k)
      {
        // x = x_f + X d under forces and under the inertia of d
        const Complex              s2 = s[k] * s[k];
        std::vector<ComplexVector> inertia;
        for (Eigen::Index j = 0; j < q; ++j)
          inertia.push_back(-s2 * MR.col(j));
        const auto of_unit =
          bodies[side]->solve(ComplexValues(q, s[k]), inertia, full_tolerance);
        ComplexMatrix stiffness = s2 * axle.mass();
        for (Eigen::Index j = 0; j < q; ++j)
          stiffness.col(j) += s2 * (MR.transpose() * of_unit[j]);
        ComplexVector d =
          R.transpose() * loads[k] - s2 * (MR.transpose() * answer.x[k]);
        ComplexLU(std::move(stiffness)).solve(d);
        for (Eigen::Index j = 0; j < q; ++j)
          answer.x[k] += d[j] * of_unit[j];
        answer.axle.push_back(std::move(d));
      }
  }

  template <int dim>
  std::vector<ComplexVector> WholeBodies<dim>::answer_of_body(
    const Side                        side,
    const ComplexValues              &s,
    const std::vector<ComplexVector> &forces) const
  {
    Answer moved = answer(side, s, forces);
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        if (const AxleMotion *axle = rolling.bodies().axle(side))
          moved.x[k] += axle->motions() * moved.axle[k];
        moved.x[k] =
          rolling.contact_of(side).of_nodes(s[k], moved.forces[k], moved.x[k]);
      }
    return std::move(moved.x);
  }

  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::forces_on(const Side                        side,
                              const std::vector<ComplexVector> &forces) const
  {
    std::vector<ComplexVector> result;
    for (const ComplexVector &force : forces)
      result.push_back(by_parts(
        [&](std::vector<double> part) {
          return rolling.pair().forces_on_body(side, std::move(part));
        },
        force));
    return result;
  }

  template <int dim>
  std::vector<ComplexVector> WholeBodies<dim>::motion_of_waves(
    const Side                        side,
    const ComplexValues              &s,
    const std::vector<ComplexVector> &forces) const
  {
    const VibratingBody<dim>  &body    = *rolling.bodies().body(side);
    const DenseMatrix         &motions = rolling.motions_of_waves(side);
    const auto                 on_body = forces_on(side, forces);
    const auto                 points  = body.points();
    std::vector<ComplexVector> result;
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        const ComplexMatrix moved =
          body.waves->field(s[k], points) * (motions.transpose() * on_body[k]);
        result.push_back(body.at_unknowns(moved));
      }
    return result;
  }

  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::motion(const Side                        side,
                           const ComplexValues              &s,
                           const std::vector<ComplexVector> &forces) const
  {
    const VibratingBody<dim> *body = rolling.bodies().body(side);
    if (body != nullptr && body->waves)
      return motion_of_waves(side, s, forces);
    if (!bodies[side])
      return std::vector<ComplexVector>(forces.size());
    Answer moved = answer(side, s, forces);
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        if (const AxleMotion *axle = rolling.bodies().axle(side))
          moved.x[k] += axle->motions() * moved.axle[k];
        moved.x[k] =
          rolling.contact_of(side).of_body(s[k], moved.forces[k], moved.x[k]);
      }
    return std::move(moved.x);
  }

  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::response(const ComplexValues              &s,
                             const std::vector<ComplexVector> &forces) const
  {
    std::vector<ComplexVector> result;
    for (const ComplexVector &force : forces)
      result.push_back(ComplexVector::Zero(force.size()));
    for (const Side side : both_sides)
      {
        const VibratingBody<dim> *body = rolling.bodies().body(side);
        if (body == nullptr)
          continue;
        const auto moved = body->waves
                             ? answer_of_waves(side, s, forces_on(side, forces))
                             : answer_of_body(side, s, forces);
        for (std::size_t k = 0; k < forces.size(); ++k)
          result[k] += by_parts(
            [&](std::vector<double> part) {
              return rolling.pair().relative_motion_of(side, std::move(part));
            },
            moved[k]);
      }
    return result;
  }

  template <int dim>
  unsigned int WholeBodies<dim>::n_iterations() const
  {
    unsigned int sum = 0;
    for (const Side side : both_sides)
      if (bodies[side])
        sum += bodies[side]->n_iterations();
    return sum;
  }

  template class WholeBodies<2>;
  template class WholeBodies<3>;
} // namespace RollingContact
