#include <rolling_contact/vibration/rolling_modes.h>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// relative residual of the equations of whole bodies
    const double full_tolerance = 1e-10;

    /** The unknowns of a body at its contact nodes, component by component;
     * without friction the normal one alone. */
    template <int dim>
    std::vector<std::size_t>
    unknowns_of_contact(const ModalBodies<dim> &modal,
                        const RollingPair<dim> &rolling,
                        const Side              side)
    {
      return modal.body(side)->body->unknowns(rolling.interface().nodes[side],
                                              rolling.contact_directions());
    }
  } // namespace

  template <int dim>
  RollingModes<dim>::RollingModes(const ModalBodies<dim> &bodies,
                                  const RollingPair<dim> &rolling,
                                  const DenseMatrix      &W)
    : modal(bodies)
    , rolling(rolling)
    , W_res(W)
  {
    const std::size_t n = W.rows();
    for (const Side side : both_sides)
      {
        const std::size_t m = modal.n_modes(side);
        Phi[side]           = DenseMatrix::Zero(n, m);
        if (m == 0)
          continue;
        const StructuralModes &modes = modal.body(side)->modes;
        Phi[side]                    = at_contact(side, modes.shapes);
        DenseMatrix soft             = Phi[side]; // Phi Lambda^-1
        for (std::size_t j = 0; j < m; ++j)
          soft.col(j) /= modes.eigenvalue(j);
        W_res -= soft * Phi[side].transpose();
        const AbsorberPlaces &places = modal.absorber_places(side);
        if (places.n_coordinates() > 0)
          cross[side] = at_contact(side, places.deflected) -
                        soft * places.motions.transpose();
      }
    check(reduced(bodies.standing()));
  }

  template <int dim>
  DenseMatrix RollingModes<dim>::at_contact(const Side         side,
                                            const DenseMatrix &motions) const
  {
    PerSide<std::vector<std::size_t>> unknowns;
    PerSide<std::vector<double>>      at_rest;
    for (const Side it : both_sides)
      if (modal.body(it) != nullptr)
        {
          unknowns[it] = unknowns_of_contact(modal, rolling, it);
          at_rest[it].assign(unknowns[it].size(), 0.);
        }
    DenseMatrix result = DenseMatrix::Zero(W_res.rows(), motions.cols());
    for (Eigen::Index j = 0; j < motions.cols(); ++j)
      {
        PerSide<std::vector<double>> moved = at_rest;
        for (std::size_t i = 0; i < unknowns[side].size(); ++i)
          moved[side][i] = motions(unknowns[side][i], j);
        result.col(j) = as_vector(rolling.relative_motion(std::move(moved)));
      }
    return result;
  }

  template <int dim>
  ReducedPair
  RollingModes<dim>::reduced(const RollingConditions &conditions) const
  {
    const std::size_t m = modal.n_coordinates(Side::wheel) +
                          modal.n_coordinates(Side::rail),
                      n = W_res.rows();
    ReducedPair pair;
    pair.n_wheel_modes = modal.n_coordinates(Side::wheel);
    pair.K_m = pair.C_m = DenseMatrix::Zero(m, m);
    pair.Phi            = DenseMatrix::Zero(n, m);
    pair.W_res          = W_res;
    for (const Side side : both_sides)
      {
        if (modal.n_modes(side) == 0)
          continue;
        const std::size_t first = first_column(side);
        const auto [K_m, C_m]   = modal.modal_matrices(side, conditions);
        pair.K_m.block(first, first, K_m.rows(), K_m.cols()) = K_m;
        pair.C_m.block(first, first, C_m.rows(), C_m.cols()) = C_m;
        DenseMatrix           shapes                         = Phi[side];
        const AbsorberPlaces &places = modal.absorber_places(side);
        if (places.n_coordinates() > 0)
          join_absorbers(
            places, conditions.absorbers, cross[side], shapes, pair.W_res);
        pair.Phi.middleCols(first, shapes.cols()) = shapes;
      }
    return pair;
  }

  template <int dim>
  std::size_t RollingModes<dim>::first_column(const Side side) const
  {
    return side == Side::wheel ? 0 : modal.n_coordinates(Side::wheel);
  }

  template <int dim>
  std::pair<Side, std::size_t>
  RollingModes<dim>::coordinate_of(const std::size_t column) const
  {
    const std::size_t n_wheel = first_column(Side::rail);
    return column < n_wheel ? std::pair(Side::wheel, column)
                            : std::pair(Side::rail, column - n_wheel);
  }

  template <int dim>
  std::vector<double> RollingModes<dim>::static_amplitudes(
    const std::vector<double> &forces,
    const RollingConditions   &conditions) const
  {
    std::vector<double> all;
    for (const Side side : both_sides)
      {
        const AbsorberPlaces &places = modal.absorber_places(side);
        std::vector<double>   eta    = transposed_product(Phi[side], forces);
        for (std::size_t j = 0; j < eta.size(); ++j)
          eta[j] /= modal.body(side)->modes.eigenvalue(j);
        all.insert(all.end(), eta.begin(), eta.end());
        if (places.n_coordinates() > 0)
          for (const double z :
               absorbers_at_rest(places,
                                 conditions.absorbers,
                                 eta,
                                 transposed_product(cross[side], forces)))
            all.push_back(z);
      }
    return all;
  }

  template <int dim>
  std::vector<double> RollingModes<dim>::hub_inertia() const
  {
    std::vector<double>       result(modal.n_coordinates(Side::wheel) +
                                 modal.n_coordinates(Side::rail),
                               0.);
    const VibratingBody<dim> *wheel = modal.body(Side::wheel);
    if (wheel == nullptr)
      return result;
    const std::vector<double> rise = wheel->body->uniform(dim - 1, 1.);
    std::vector<double>       momentum(rise.size());
    wheel->M.multiply(rise, momentum);
    as_vector(result).head(modal.n_modes(Side::wheel)) -=
      wheel->modes.shapes.transpose() * as_vector(momentum);
    return result;
  }

  template <int dim>
  BodyField
  RollingModes<dim>::displacement(const Side                 side,
                                  const std::vector<double> &eta) const
  {
    const VibratingBody<dim> &body  = *modal.body(side);
    const auto                first = eta.begin() + first_column(side);
    return body.body->field(
      body.modes.shapes *
      std::vector<double>(first, first + modal.n_modes(side)));
  }

  template <int dim>
  WholeBodies<dim>::WholeBodies(const RollingModes<dim> &rolling,
                                const RollingConditions &conditions)
    : rolling(rolling)
  {
    const ModalBodies<dim> &modal = rolling.bodies();
    for (const Side side : both_sides)
      if (modal.body(side) != nullptr)
        {
          bodies[side]   = modal.whole_body(side, conditions);
          unknowns[side] = unknowns_of_contact(modal, rolling.pair(), side);
        }
  }

  template <int dim>
  ComplexVector WholeBodies<dim>::load(const Side           side,
                                       const ComplexVector &forces) const
  {
    std::vector<double> real(forces.size()), imaginary(forces.size());
    as_vector(real)           = forces.real();
    as_vector(imaginary)      = forces.imag();
    const auto load_real      = rolling.pair().forces_on_body(side, real),
               load_imaginary = rolling.pair().forces_on_body(side, imaginary);
    ComplexVector b =
      ComplexVector::Zero(rolling.bodies().body(side)->K.size());
    for (std::size_t i = 0; i < unknowns[side].size(); ++i)
      b[unknowns[side][i]] += Complex(load_real[i], load_imaginary[i]);
    return b;
  }

  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::motion(const Side                        side,
                           const ComplexValues              &s,
                           const std::vector<ComplexVector> &forces) const
  {
    if (!bodies[side])
      return std::vector<ComplexVector>(forces.size());
    std::vector<ComplexVector> loads;
    for (const ComplexVector &force : forces)
      loads.push_back(load(side, force));
    return bodies[side]->solve(s, loads, full_tolerance);
  }

  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::response(const ComplexValues              &s,
                             const std::vector<ComplexVector> &forces) const
  {
    PerSide<std::vector<ComplexVector>> x;
    for (const Side side : both_sides)
      x[side] = motion(side, s, forces);
    std::vector<ComplexVector> result;
    for (std::size_t k = 0; k < forces.size(); ++k)
      {
        PerSide<std::vector<double>> real, imaginary;
        for (const Side side : both_sides)
          for (const std::size_t unknown : unknowns[side])
            {
              real[side].push_back(x[side][k][unknown].real());
              imaginary[side].push_back(x[side][k][unknown].imag());
            }
        const auto u = rolling.pair().relative_motion(std::move(real)),
                   v = rolling.pair().relative_motion(std::move(imaginary));
        result.push_back(as_vector(u) + Complex(0., 1.) * as_vector(v));
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

  template class RollingModes<2>;
  template class RollingModes<3>;
  template class WholeBodies<2>;
  template class WholeBodies<3>;
} // namespace RollingContact
