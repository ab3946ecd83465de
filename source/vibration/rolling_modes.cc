#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
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
    const std::size_t n = W.n_rows();
    for (const Side side : both_sides)
      {
        const std::size_t m = modal.n_modes(side);
        Phi[side]           = DenseMatrix(n, m);
        if (m == 0)
          continue;
        const StructuralModes &modes = modal.body(side)->modes;
        Phi[side]                    = at_contact(side, modes.shapes);
        DenseMatrix soft             = Phi[side]; // Phi Lambda^-1
        for (std::size_t j = 0; j < m; ++j)
          for (std::size_t p = 0; p < n; ++p)
            soft(p, j) /= modes.eigenvalue(j);
        for (std::size_t j = 0; j < m; ++j)
          for (std::size_t q = 0; q < n; ++q)
            for (std::size_t p = 0; p < n; ++p)
              W_res(p, q) -=
                Phi[side](p, j) * Phi[side](q, j) / modes.eigenvalue(j);
        const AbsorberPlaces &places = modal.absorber_places(side);
        if (places.n_coordinates() == 0)
          continue;
        cross[side] = at_contact(side, places.deflected);
        const DenseMatrix of_modes =
          dense_product(soft, transposed(places.motions));
        for (std::size_t k = 0; k < places.n_coordinates(); ++k)
          for (std::size_t p = 0; p < n; ++p)
            cross[side](p, k) -= of_modes(p, k);
      }
    check(reduced(bodies.standing()));
  }



  template <int dim>
  DenseMatrix
  RollingModes<dim>::at_contact(const Side         side,
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
    DenseMatrix result(W_res.n_rows(), motions.n_columns());
    for (std::size_t j = 0; j < motions.n_columns(); ++j)
      {
        PerSide<std::vector<double>> moved = at_rest;
        for (std::size_t i = 0; i < unknowns[side].size(); ++i)
          moved[side][i] = motions(unknowns[side][i], j);
        const std::vector<double> at =
          rolling.relative_motion(std::move(moved));
        std::copy(at.begin(), at.end(), result.data() + j * at.size());
      }
    return result;
  }



  template <int dim>
  ReducedPair
  RollingModes<dim>::reduced(const RollingConditions &conditions) const
  {
    const std::size_t m = modal.n_coordinates(Side::wheel) +
                          modal.n_coordinates(Side::rail),
                      n = W_res.n_rows();
    ReducedPair pair;
    pair.n_wheel_modes = modal.n_coordinates(Side::wheel);
    pair.K_m = pair.C_m = DenseMatrix(m, m);
    pair.Phi            = DenseMatrix(n, m);
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
        DenseMatrix           shapes = Phi[side];
        const AbsorberPlaces &places = modal.absorber_places(side);
        if (places.n_coordinates() > 0)
          join_absorbers(
            places, conditions.absorbers, cross[side], shapes, pair.W_res);
        std::copy(shapes.data(),
                  shapes.data() + n * shapes.n_columns(),
                  pair.Phi.data() + n * first);
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
        const AbsorberPlaces &places = modal.absorber_places(side);
        std::vector<double>   eta(modal.n_modes(side), 0.),
          left_out(places.n_coordinates(), 0.);
        for (std::size_t j = 0; j < eta.size(); ++j)
          {
            for (std::size_t i = 0; i < forces.size(); ++i)
              eta[j] += Phi[side](i, j) * forces[i];
            eta[j] /= modal.body(side)->modes.eigenvalue(j);
          }
        all.insert(all.end(), eta.begin(), eta.end());
        for (std::size_t k = 0; k < left_out.size(); ++k)
          for (std::size_t i = 0; i < forces.size(); ++i)
            left_out[k] += cross[side](i, k) * forces[i];
        if (!left_out.empty())
          for (const double z :
               absorbers_at_rest(places, conditions.absorbers, eta, left_out))
            all.push_back(z);
      }
    return all;
  }



  template <int dim>
  std::vector<double>
  RollingModes<dim>::hub_inertia() const
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
    const DenseMatrix &shapes = wheel->modes.shapes;
    for (std::size_t j = 0; j < modal.n_modes(Side::wheel); ++j)
      for (std::size_t i = 0; i < momentum.size(); ++i)
        result[j] -= shapes(i, j) * momentum[i];
    return result;
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
  WholeBodies<dim>::load(const Side side, const ComplexVector &forces) const
  {
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
    return b;
  }



  template <int dim>
  std::vector<ComplexVector>
  WholeBodies<dim>::motion(const Side                        side,
                           const ComplexVector              &s,
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
  WholeBodies<dim>::response(const ComplexVector              &s,
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
        result.emplace_back();
        for (std::size_t i = 0; i < u.size(); ++i)
          result.back().emplace_back(u[i], v[i]);
      }
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
