#include <rolling_contact/vibration/rolling_modes.h>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// relative residual of the equations of whole bodies
    const double full_tolerance = 1e-10;



    /** The unknowns of a body at its contact nodes, component by component. */
    template <int dim>
    std::vector<std::size_t>
    unknowns_of_contact(const ModalBodies<dim> &modal,
                        const RollingPair<dim> &rolling,
                        const Side              side)
    {
      std::vector<unsigned int> components;
      for (unsigned int d = 0; d < dim; ++d)
        components.push_back(d);
      return modal.body(side)->body->unknowns(rolling.interface().nodes[side],
                                              components);
    }
  } // namespace



  template <int dim>
  RollingModes<dim>::RollingModes(const ModalBodies<dim> &bodies,
                                  const RollingPair<dim> &rolling,
                                  const DenseMatrix      &W)
    : modal(bodies)
    , rolling(rolling)
    , Phi(W.n_rows(),
          bodies.n_coordinates(Side::wheel) + bodies.n_coordinates(Side::rail))
    , W_res(W)
  {
    PerSide<std::vector<std::size_t>> unknowns;
    PerSide<std::vector<double>>      at_rest;
    for (const Side side : both_sides)
      if (bodies.body(side) != nullptr)
        {
          unknowns[side] = unknowns_of_contact(bodies, rolling, side);
          at_rest[side].assign(unknowns[side].size(), 0.);
        }
    const std::size_t n = W.n_rows();
    for (std::size_t j = 0; j < Phi.n_columns(); ++j)
      {
        const auto [side, mode]      = coordinate_of(j);
        const StructuralModes &modes = bodies.body(side)->modes;
        if (mode >= modes.size())
          continue; // absorbers do not touch
        PerSide<std::vector<double>> motions = at_rest;
        for (std::size_t i = 0; i < unknowns[side].size(); ++i)
          motions[side][i] = modes.shapes(unknowns[side][i], mode);
        const std::vector<double> at =
          rolling.relative_motion(std::move(motions));
        std::copy(at.begin(), at.end(), Phi.data() + j * n);
        const double lambda = modes.eigenvalue(mode);
        for (std::size_t q = 0; q < n; ++q)
          for (std::size_t p = 0; p < n; ++p)
            W_res(p, q) -= at[p] * at[q] / lambda;
      }
    check(reduced(bodies.standing()));
  }



  template <int dim>
  ReducedPair
  RollingModes<dim>::reduced(const RollingConditions &conditions) const
  {
    const std::size_t m = Phi.n_columns();
    ReducedPair       pair;
    pair.n_wheel_modes = modal.n_coordinates(Side::wheel);
    pair.K_m = pair.C_m = DenseMatrix(m, m);
    pair.Phi            = Phi;
    pair.W_res          = W_res;
    for (const Side side : both_sides)
      {
        if (modal.n_modes(side) == 0)
          continue;
        const std::size_t first = first_column(side);
        const auto [K_m, C_m]   = modal.modal_matrices(side, conditions);
        for (std::size_t j = 0; j < K_m.n_columns(); ++j)
          for (std::size_t i = 0; i < K_m.n_rows(); ++i)
            {
              pair.K_m(first + i, first + j) = K_m(i, j);
              pair.C_m(first + i, first + j) = C_m(i, j);
            }
      }
    return pair;
  }



  template <int dim>
  std::size_t
  RollingModes<dim>::first_column(const Side side) const
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
  std::vector<double>
  RollingModes<dim>::static_amplitudes(
    const std::vector<double> &forces,
    const RollingConditions   &conditions) const
  {
    std::vector<double> all;
    for (const Side side : both_sides)
      {
        std::vector<double> eta(modal.n_modes(side), 0.);
        for (std::size_t j = 0; j < eta.size(); ++j)
          {
            const std::size_t column = first_column(side) + j;
            for (std::size_t i = 0; i < forces.size(); ++i)
              eta[j] += Phi(i, column) * forces[i];
            eta[j] /= modal.body(side)->modes.eigenvalue(j);
          }
        eta = modal.with_absorbers_at_rest(side, std::move(eta), conditions);
        all.insert(all.end(), eta.begin(), eta.end());
      }
    return all;
  }



  template <int dim>
  BodyField
  RollingModes<dim>::displacement(const Side                 side,
                                  const std::vector<double> &eta) const
  {
    const VibratingBody<dim> &body   = *modal.body(side);
    const DenseMatrix        &shapes = body.modes.shapes;
    const auto                first  = eta.begin() + first_column(side);
    const std::vector<double> amplitudes(first, first + modal.n_modes(side));
    std::vector<double>       values(shapes.n_rows());
    shapes.multiply_block(0, 0, amplitudes, values);
    return body.body->field(values);
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
  ComplexVector
  WholeBodies<dim>::motion(const Side           side,
                           const Complex        s,
                           const ComplexVector &forces) const
  {
    if (!bodies[side])
      return {};
    std::vector<double> real, imaginary;
    for (const Complex &force : forces)
      {
        real.push_back(force.real());
        imaginary.push_back(force.imag());
      }
    const auto load_real      = rolling.pair().forces_on_body(side, real),
               load_imaginary = rolling.pair().forces_on_body(side, imaginary);
    ComplexVector b(rolling.bodies().body(side)->K.size(), 0.);
    for (std::size_t i = 0; i < unknowns[side].size(); ++i)
      b[unknowns[side][i]] += Complex(load_real[i], load_imaginary[i]);
    return bodies[side]->solve(s, b, full_tolerance);
  }



  template <int dim>
  ComplexVector
  WholeBodies<dim>::response(const Complex s, const ComplexVector &forces) const
  {
    PerSide<std::vector<double>> real, imaginary;
    for (const Side side : both_sides)
      {
        const ComplexVector x = motion(side, s, forces);
        for (const std::size_t unknown : unknowns[side])
          {
            real[side].push_back(x[unknown].real());
            imaginary[side].push_back(x[unknown].imag());
          }
      }
    const auto u = rolling.pair().relative_motion(std::move(real)),
               v = rolling.pair().relative_motion(std::move(imaginary));
    ComplexVector result;
    for (std::size_t i = 0; i < u.size(); ++i)
      result.emplace_back(u[i], v[i]);
    return result;
  }



  template <int dim>
  unsigned int
  WholeBodies<dim>::n_iterations() const
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
