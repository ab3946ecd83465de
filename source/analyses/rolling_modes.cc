#include <rolling_contact/analyses/rolling_modes.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/modes/rotation.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// relative residual of the equations of whole bodies
    const double full_tolerance = 1e-10;
  } // namespace



  template <int dim>
  RollingModes<dim>::RollingModes(const SceneParameters  &scene,
                                  const SteadyState<dim> &steady,
                                  const double            cut_off,
                                  RunContext             &context)
    : rolling(*steady.pair)
  {
    for (const Side side : both_sides)
      {
        if (!rolling.bodies().is_elastic(side))
          continue;
        const auto *body =
          dynamic_cast<const DirectBody<dim> *>(rolling.bodies().body(side));
        if (body == nullptr)
          throw InputError("Body solver: modes need the factor of the bodies; "
                           "take direct, on one rank.");
        bodies[side] = std::make_unique<VibratingBody<dim>>(
          scene, side, *body, cut_off, context);
        PhaseTimer::Scope phase(context.timer, Phase::modes);
        add_part(scene, side);
      }
    PhaseTimer::Scope phase(context.timer, Phase::modes);
    join(steady.problem.operators.W());
    check(pair);
  }



  template <int dim>
  void
  RollingModes<dim>::add_part(const SceneParameters &scene, const Side side)
  {
    const VibratingBody<dim> &body  = *bodies[side];
    const StructuralModes    &modes = body.modes;
    Part                     &part  = parts[side];
    std::vector<unsigned int> components;
    for (unsigned int d = 0; d < dim; ++d)
      components.push_back(d);
    part.unknowns =
      body.body->unknowns(rolling.interface().nodes[side], components);
    part.damping_ratios = body.given_damping();
    part.C              = body.body->damping_in_time();
    part.C_m            = part.C.size() > 0 ? projected(part.C, modes.shapes)
                                            : DenseMatrix(modes.size(), modes.size());
    part.K_m            = DenseMatrix(modes.size(), modes.size());
    for (std::size_t j = 0; j < modes.size(); ++j)
      {
        part.K_m(j, j) = modes.eigenvalue(j);
        part.C_m(j, j) +=
          2 * part.damping_ratios[j] * 2 * pi * modes.frequencies[j];
      }
    const auto axle = body.parameters.body_shape()->axle();
    if constexpr (dim == 3)
      if (side == Side::wheel && axle && scene.stability.rotation)
        {
          rate   = scene.contact.speed.value_or(0.) / body.parameters.radius;
          part.S = body.body->rotation(*axle);
          ReducedPair alone;
          alone.K_m = std::move(part.K_m);
          alone.C_m = std::move(part.C_m);
          add_rotation(alone, modal_rotation(part.S, modes.shapes), rate);
          part.K_m = std::move(alone.K_m);
          part.C_m = std::move(alone.C_m);
        }
    part.full = std::make_unique<FullDynamics>(
      TurningStructure{
        body.K, body.M, part.C, part.S, side == Side::wheel ? rate : 0.},
      *body.factor,
      modes,
      part.damping_ratios,
      part.K_m,
      part.C_m);
  }



  template <int dim>
  std::vector<double>
  RollingModes<dim>::contact_motion(const Side        side,
                                    const std::size_t mode) const
  {
    PerSide<std::vector<double>> motions;
    for (const Side other : both_sides)
      if (bodies[other])
        motions[other].assign(parts[other].unknowns.size(), 0.);
    const DenseMatrix &shapes = bodies[side]->modes.shapes;
    for (std::size_t i = 0; i < motions[side].size(); ++i)
      motions[side][i] = shapes(parts[side].unknowns[i], mode);
    return rolling.relative_motion(std::move(motions));
  }



  template <int dim>
  void
  RollingModes<dim>::join(const DenseMatrix &W)
  {
    const std::size_t n_wheel = bodies.wheel ? bodies.wheel->modes.size() : 0,
                      m =
                        n_wheel + (bodies.rail ? bodies.rail->modes.size() : 0);
    pair.n_wheel_modes = n_wheel;
    pair.K_m = pair.C_m = DenseMatrix(m, m);
    pair.Phi            = DenseMatrix(W.n_rows(), m);
    pair.W_res          = W;
    for (std::size_t j = 0; j < m; ++j)
      {
        const auto [side, mode]         = mode_of(j);
        const std::size_t         first = side == Side::wheel ? 0 : n_wheel;
        const auto               &part  = parts[side];
        const std::vector<double> at    = contact_motion(side, mode);
        std::copy(at.begin(), at.end(), pair.Phi.data() + j * W.n_rows());
        for (std::size_t i = 0; i < part.K_m.n_rows(); ++i)
          {
            pair.K_m(first + i, j) = part.K_m(i, mode);
            pair.C_m(first + i, j) = part.C_m(i, mode);
          }
        const double lambda = bodies[side]->modes.eigenvalue(mode);
        for (std::size_t q = 0; q < at.size(); ++q)
          for (std::size_t p = 0; p < at.size(); ++p)
            pair.W_res(p, q) -= at[p] * at[q] / lambda;
      }
  }



  template <int dim>
  std::pair<Side, std::size_t>
  RollingModes<dim>::mode_of(const std::size_t column) const
  {
    return column < pair.n_wheel_modes
             ? std::pair(Side::wheel, column)
             : std::pair(Side::rail, column - pair.n_wheel_modes);
  }



  template <int dim>
  ComplexVector
  RollingModes<dim>::response(const Complex        s,
                              const ComplexVector &forces) const
  {
    PerSide<std::vector<double>> real, imaginary;
    std::vector<double>          force_real, force_imaginary;
    for (const Complex &force : forces)
      {
        force_real.push_back(force.real());
        force_imaginary.push_back(force.imag());
      }
    for (const Side side : both_sides)
      {
        if (!bodies[side])
          continue;
        const Part &part      = parts[side];
        const auto  load_real = rolling.forces_on_body(side, force_real),
                   load_imaginary =
                     rolling.forces_on_body(side, force_imaginary);
        ComplexVector b(bodies[side]->K.size(), 0.);
        for (std::size_t i = 0; i < part.unknowns.size(); ++i)
          b[part.unknowns[i]] += Complex(load_real[i], load_imaginary[i]);
        const ComplexVector x = part.full->solve(s, b, full_tolerance);
        for (const std::size_t unknown : part.unknowns)
          {
            real[side].push_back(x[unknown].real());
            imaginary[side].push_back(x[unknown].imag());
          }
      }
    const auto u = rolling.relative_motion(std::move(real)),
               v = rolling.relative_motion(std::move(imaginary));
    ComplexVector result;
    for (std::size_t i = 0; i < u.size(); ++i)
      result.emplace_back(u[i], v[i]);
    return result;
  }



  template <int dim>
  unsigned int
  RollingModes<dim>::n_iterations() const
  {
    unsigned int sum = 0;
    for (const Side side : both_sides)
      if (parts[side].full)
        sum += parts[side].full->n_iterations();
    return sum;
  }



  template class RollingModes<2>;
  template class RollingModes<3>;
} // namespace RollingContact
