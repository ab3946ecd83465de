#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <algorithm>

namespace RollingContact
{
  template <int dim>
  RollingModes<dim>::RollingModes(const ModalBodies<dim> &bodies,
                                  const RollingPair<dim> &rolling,
                                  const DenseMatrix      &W)
    : modal(bodies)
    , rolling(rolling)
    , more_at_rest(DenseMatrix::Zero(W.rows(), W.cols()))
    , W_res(W)
  {
    for (const Side side : both_sides)
      {
        const std::size_t m = modal.n_modes(side);
        Phi[side]           = DenseMatrix::Zero(W.rows(), m);
        if (m == 0 && modal.axle(side))
          throw InputError(
            "Modes/Cut-off ratio: the " + name_of(side) +
            ", whose axle moves, has no mode below the cut-off; take a higher "
            "ratio or Maximum frequency, or Hub = clamped.");
        if (m == 0)
          continue;
        const VibratingBody<dim> &body = *modal.body(side);
        contacts[side] =
          body.body->vibration_of(rolling.interface().nodes[side],
                                  rolling.contact_directions());
        if (body.waves)
          take_waves(side);
        else
          take_modes(side);
      }
    check(reduced(bodies.standing()));
  }

  template <int dim>
  void RollingModes<dim>::take_modes(const Side side)
  {
    const StructuralModes &modes = modal.body(side)->modes;
    std::vector<double>    eigenvalues;
    for (std::size_t j = 0; j < modes.size(); ++j)
      eigenvalues.push_back(modes.eigenvalue(j));
    Phi[side] =
      at_contact(side, contacts[side]->of_modes(modes.shapes, eigenvalues));
    const Eigen::Index        n_first = modes.at_rest.cols();
    const std::vector<double> first(eigenvalues.begin(),
                                    eigenvalues.begin() + n_first);
    const DenseMatrix         statics =
      modes.statics(Phi[side],
                    at_contact(side,
                               contacts[side]->of_modes(modes.at_rest, first)));
    W_res -= statics * statics.transpose();
    const auto of_first = Phi[side].leftCols(n_first);
    more_at_rest +=
      of_first * as_vector(first).cwiseInverse().asDiagonal() *
        of_first.transpose() -
      statics.leftCols(n_first) * statics.leftCols(n_first).transpose();
    const AbsorberPlaces &places = modal.absorber_places(side);
    if (places.n_coordinates() > 0)
      cross[side] =
        at_contact(side,
                   contacts[side]->of_modes(
                     places.deflected,
                     std::vector<double>(places.deflected.cols(), 0.))) -
        statics * places.statics.transpose();
  }

  template <int dim>
  DenseMatrix RollingModes<dim>::find_motions_of_waves(const Side side) const
  {
    const VibratingBody<dim> &body       = *modal.body(side);
    const auto               &nodes      = rolling.interface().nodes[side];
    const auto               &components = rolling.contact_directions();
    const auto                shape      = body.parameters.body_shape();
    DenseMatrix result(components.size() * nodes.size(), RailWaves::n_motions);
    if constexpr (dim == 3)
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const double      x = nodes[i].position[0], y = nodes[i].position[1];
          const DenseMatrix motion =
            body.waves->motions_at({{x, y, shape->surface_height(x, y)}});
          for (std::size_t c = 0; c < components.size(); ++c)
            result.row(c * nodes.size() + i) = motion.row(components[c]);
        }
    return result;
  }

  template <int dim>
  void RollingModes<dim>::take_waves(const Side side)
  {
    const VibratingBody<dim> &body  = *modal.body(side);
    const RailWaves          &waves = *body.waves;
    four_motions[side]              = find_motions_of_waves(side);
    const DenseMatrix &on_body      = four_motions[side];
    const DenseMatrix  motions      = at_contact(side, on_body);
    if constexpr (dim == 3)
      beyond[side] = waves.beyond_mesh(*body.body, *body.factor);
    if (const DenseMatrix known = contacts[side]->beyond_mesh();
        known.size() > 0)
      {
        DenseMatrix square = on_body.transpose() * on_body;
        DenseMatrix mean   = on_body.transpose();
        solve_positive_definite(square, mean);
        beyond[side] -= mean * known * mean.transpose();
      }
    const FittedModes &fit = waves.modes();
    Phi[side]              = motions * fit.motions;
    const DenseMatrix more = motions *
                             (fit.rest - waves.at_rest() + beyond[side]) *
                             motions.transpose();
    W_res += more;
    more_at_rest += more;
    for (std::size_t j = 0; j < fit.frequencies.size(); ++j)
      more_at_rest += Phi[side].col(j) * Phi[side].col(j).transpose() /
                      body.modes.eigenvalue(j);
  }

  template <int dim>
  DenseMatrix RollingModes<dim>::at_contact(const Side         side,
                                            const DenseMatrix &motions) const
  {
    DenseMatrix result = DenseMatrix::Zero(W_res.rows(), motions.cols());
    for (Eigen::Index j = 0; j < motions.cols(); ++j)
      result.col(j) =
        as_vector(rolling.relative_motion_of(side, column_of(motions, j)));
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
    if (conditions.hysteretic)
      pair.H_m = DenseMatrix::Zero(m, m);
    pair.W_res       = W_res;
    pair.retardation = retardation();
    for (const Side side : both_sides)
      {
        if (modal.n_modes(side) == 0)
          continue;
        const std::size_t first = first_column(side);
        const auto [K_m, C_m]   = modal.modal_matrices(side, conditions);
        pair.K_m.block(first, first, K_m.rows(), K_m.cols()) = K_m;
        pair.C_m.block(first, first, C_m.rows(), C_m.cols()) = C_m;
        if (conditions.hysteretic)
          pair.H_m.block(first, first, C_m.rows(), C_m.cols()) =
            modal.loss_stiffness(side);
        DenseMatrix           shapes = Phi[side];
        const AbsorberPlaces &places = modal.absorber_places(side);
        if (places.n_coordinates() > 0)
          join_absorbers(
            places, conditions.absorbers, cross[side], shapes, pair.W_res);
        if (const AxleMotion *axle = modal.axle(side))
          axle->join(shapes, motions_of_axle(side));
        pair.Phi.middleCols(first, shapes.cols()) = shapes;
      }
    return pair;
  }

  template <int dim>
  DenseMatrix RollingModes<dim>::motions_of_axle(const Side side) const
  {
    const DenseMatrix &motions = modal.axle(side)->motions();
    return at_contact(side,
                      contacts[side]->of_modes(
                        motions, std::vector<double>(motions.cols(), 0.)));
  }

  template <int dim>
  double RollingModes<dim>::retardation() const
  {
    double sum = 0., weights = 0.;
    for (const Side side : both_sides)
      if (modal.body(side) != nullptr)
        {
          const BodySpec &spec = modal.body(side)->parameters;
          const double    nu   = spec.material.poisson_ratio,
                       weight  = (1 - nu * nu) / spec.material.young_modulus;
          sum += weight * spec.model.damping.retardation();
          weights += weight;
        }
    return weights > 0. ? sum / weights : 0.;
  }

  template <int dim>
  std::size_t RollingModes<dim>::first_column(const Side side) const
  {
    return side == Side::wheel ? 0 : modal.n_coordinates(Side::wheel);
  }

  template <int dim>
  std::optional<std::pair<std::size_t, double>>
  RollingModes<dim>::nearest_mode(const Side                 side,
                                  const std::vector<double> &shares) const
  {
    const std::size_t n = modal.n_modes(side);
    if (n == 0 || modal.body(side)->waves)
      return {};
    const auto first   = shares.begin() + first_column(side),
               largest = std::max_element(first, first + n);
    return std::pair<std::size_t, double>(largest - first, *largest);
  }

  template <int dim>
  std::string
  RollingModes<dim>::nearest_name(const std::vector<double> &shares) const
  {
    for (const Side side : both_sides)
      if (const auto nearest = nearest_mode(side, shares))
        return modal.body(side)->characters[nearest->first].name();
    return "";
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
        all.resize(first_column(side) + modal.n_coordinates(side), 0.);
      }
    return all;
  }

  template <int dim>
  DenseMatrix RollingModes<dim>::compliance_at_rest(DenseMatrix W) const
  {
    return W + more_at_rest;
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
    const VibratingBody<dim> &body       = *modal.body(side);
    std::vector<double>       amplitudes = part_of(side, eta);
    if (const AxleMotion *axle = modal.axle(side))
      amplitudes = axle->relative_to_axle(amplitudes);
    amplitudes.resize(modal.n_modes(side));
    return body.body->field(body.mode_shapes() * amplitudes);
  }

  template <int dim>
  std::optional<double>
  RollingModes<dim>::wheel_velocity(const std::vector<double> &rates) const
  {
    const AxleMotion *axle = modal.axle(Side::wheel);
    return axle ? axle->velocity_along_z(part_of(Side::wheel, rates))
                : std::optional<double>();
  }

  template <int dim>
  std::vector<double>
  RollingModes<dim>::part_of(const Side                 side,
                             const std::vector<double> &coordinates) const
  {
    const auto first = coordinates.begin() + first_column(side);
    return {first, first + modal.n_coordinates(side)};
  }

  template class RollingModes<2>;
  template class RollingModes<3>;
} // namespace RollingContact
