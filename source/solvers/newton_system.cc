#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/solvers/newton_system.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * The state without tractions where p - rho u_n <= 0.
     */
    ContactState released(const ContactProblem &problem,
                          const ContactState   &state,
                          const double          rho)
    {
      const std::vector<double> u_n    = normal_gap(problem, state);
      ContactState              result = state;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (!(state.pressure[i] - rho * u_n[i] > 0.))
          {
            result.pressure[i] = 0.;
            for (unsigned int c = 0; c < problem.n_tangential(); ++c)
              result.traction(c, i) = 0.;
          }
      return result;
    }
  } // namespace

  NewtonSystem::NewtonSystem(const ContactProblem &problem,
                             const SolverControls &controls,
                             const ContactState   &state,
                             const Unknowns        unknowns)
    : problem(problem)
    , now(released(problem, state, 1 / problem.operators.normal_norm()))
    , friction(tangential_problem(problem, now))
    , rho_n(1 / problem.operators.normal_norm())
    , rho_t(problem.operators.tangential_norm() > 0.
              ? controls.tangential_augmentation /
                  problem.operators.tangential_norm()
              : 0.)
    , n_tangential(problem.n_tangential())
    , n_components(n_tangential + (unknowns == Unknowns::traction ? 0 : 1))
    , number(problem.n_nodes(), problem.n_nodes())
    , u_n(normal_gap(problem, state))
  {
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (state.pressure[i] - rho_n * u_n[i] > 0.)
        {
          number[i] = nodes.size();
          nodes.push_back(i);
        }
    u_n  = normal_gap(problem, now);
    slip = friction.slip(now.traction);
    const bool finds_approach =
      n_components > n_tangential && problem.loads.normal_load;
    const std::size_t n =
      nodes.size() * n_components + (finds_approach ? 1 : 0);
    matrix = DenseMatrix::Zero(n, n);
    right  = DenseMatrix::Zero(n, 1);
  }

  /**
   * What one unknown does to gap and slip of the touching nodes.
   */
  void NewtonSystem::add_column(const std::size_t  touching,
                                const unsigned int component)
  {
    const unsigned int N = problem.n_nodes();
    const NodalField   w =
      problem.operators.distortion_of_unit({component, nodes[touching]});
    const std::size_t column = place(touching, component);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < n_tangential; ++c)
        matrix(place(k, c), column) = friction.slip_of(w, {c, nodes[k]});
    if (n_components == n_tangential)
      return;
    Eigen::VectorXd u_normal = Eigen::VectorXd::Zero(N);
    for (const auto &[j, value] : problem.operators.H_column(nodes[touching]))
      u_normal += problem.operators.W().column(problem.operators.first_normal(),
                                               N,
                                               component * N + j) *
                  value;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      matrix(place(k, n_tangential), column) = u_normal[nodes[k]];
  }

  void NewtonSystem::add_edge_rows()
  {
    for (unsigned int c = 0; c < friction.rows.edge_rows.size(); ++c)
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (const auto &entry : friction.rows.edge_rows[c][nodes[k]])
          if (number[entry.first] < problem.n_nodes())
            matrix(place(k, c), place(number[entry.first], c)) += entry.second;
  }

  void NewtonSystem::add_columns()
  {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        add_column(k, c);
    add_edge_rows();
  }

  double NewtonSystem::coefficient(const std::size_t touching) const
  {
    const unsigned int i = nodes[touching];
    const double       p = now.pressure[i];
    return p > 0. ? friction.bound[i] / p : friction.friction[i];
  }

  bool NewtonSystem::slides(const std::size_t      touching,
                            std::array<double, 2> &direction,
                            double                &size,
                            double                &bound) const
  {
    const unsigned int i = nodes[touching];
    bound =
      coefficient(touching) * std::max(0., now.pressure[i] - rho_n * u_n[i]);
    std::array<double, 2> z{};
    for (unsigned int c = 0; c < n_tangential; ++c)
      z[c] = now.traction(c, i) - rho_t * slip(c, i);
    size = std::hypot(z[0], z[1]);
    if (size <= bound)
      return false;
    direction = {{z[0] / size, z[1] / size}};
    return true;
  }

  double NewtonSystem::fall(const std::size_t touching) const
  {
    const ContactLoads &loads = problem.loads;
    const unsigned int  i     = nodes[touching];
    if (!loads.friction_law || friction.bound[i] <= 0.)
      return 0.;
    return loads.friction[i] * loads.speed *
           loads.friction_law->slope(slip.norm_at(i) * loads.speed) *
           (immediate.empty() ? 1. : immediate[i]);
  }

  void NewtonSystem::set_friction_rows(const std::size_t touching,
                                       const double      fall)
  {
    std::array<double, 2> direction{};
    double                size = 0., bound = 0.;
    if (!slides(touching, direction, size, bound))
      return;
    // dq - b' direction - b/|z| (1 - direction direction^T) (dq - rho ds)
    const std::size_t n  = matrix.cols();
    const double      mu = coefficient(touching),
                 falls   = fall * now.pressure[nodes[touching]];
    for (std::size_t column = 0; column < n; ++column)
      {
        std::array<double, 2> change{};
        double                slip_along = 0.;
        for (unsigned int c = 0; c < n_tangential; ++c)
          {
            const double ds = matrix(place(touching, c), column);
            change[c] = (column == place(touching, c) ? 1. : 0.) - rho_t * ds;
            slip_along += ds * direction[c];
          }
        const double along =
          change[0] * direction[0] + change[1] * direction[1];
        for (unsigned int c = 0; c < n_tangential; ++c)
          {
            double &entry = matrix(place(touching, c), column);
            entry         = (column == place(touching, c) ? 1. : 0.) -
                    (n_components > n_tangential &&
                         column == place(touching, n_tangential)
                       ? mu * direction[c]
                       : 0.) -
                    (n_tangential == 2
                       ? bound / size * (change[c] - along * direction[c])
                       : 0.);
            if (falls != 0.)
              entry -= falls * slip_along * direction[c];
          }
      }
  }

  void NewtonSystem::set_right(const std::size_t touching)
  {
    const unsigned int i                    = nodes[touching];
    right(place(touching, n_tangential), 0) = -u_n[i];
    std::array<double, 2> direction{};
    double                size = 0., bound = 0.;
    const bool            moves = slides(touching, direction, size, bound);
    for (unsigned int c = 0; c < n_tangential; ++c)
      right(place(touching, c), 0) =
        moves ? coefficient(touching) * now.pressure[i] * direction[c] -
                  now.traction(c, i)
              : -slip(c, i);
  }

  void NewtonSystem::set_load_rows()
  {
    const std::size_t n = matrix.rows();
    if (n == nodes.size() * n_components)
      return;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        matrix(place(k, n_tangential), n - 1) =
          -problem.operators.approach_share(nodes[k]);
        matrix(n - 1, place(k, n_tangential)) =
          problem.operators.load_areas()[nodes[k]];
      }
    right(n - 1, 0) =
      *problem.loads.normal_load - problem.operators.load(now.pressure);
  }

  bool NewtonSystem::solve(ContactState &target)
  {
    add_columns();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        set_right(k);
        set_friction_rows(k, 0.);
      }
    set_load_rows();
    const std::size_t n = matrix.rows();
    if (n == 0 || !solve_general(matrix, right))
      return false;
    target = now;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        target.pressure[nodes[k]] += right(place(k, n_tangential), 0);
        for (unsigned int c = 0; c < n_tangential; ++c)
          target.traction(c, nodes[k]) += right(place(k, c), 0);
      }
    if (problem.loads.normal_load)
      target.approach += right(n - 1, 0);
    return true;
  }

  void NewtonSystem::linearise()
  {
    add_columns();
    set_load_rows();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      set_friction_rows(k, fall(k));
  }

  std::array<double, 2>
  NewtonSystem::part_of_slip(const std::size_t            touching,
                             const std::array<double, 2> &change) const
  {
    std::array<double, 2> direction{};
    double                size = 0., bound = 0.;
    if (!slides(touching, direction, size, bound))
      return {{-change[0], -change[1]}};
    const double along = change[0] * direction[0] + change[1] * direction[1],
                 falls = fall(touching) * now.pressure[nodes[touching]];
    std::array<double, 2> part{};
    for (unsigned int c = 0; c < n_tangential; ++c)
      part[c] = falls * along * direction[c] -
                bound * rho_t / size * (change[c] - along * direction[c]);
    return part;
  }

  std::vector<ContactState>
  NewtonSystem::response(const std::vector<NodalField> &slips)
  {
    if (problem.loads.friction_law && problem.loads.memory_length > 0.)
      {
        const FrictionMemory memory(problem, friction.sliding_speeds(slip));
        for (unsigned int i = 0; i < problem.n_nodes(); ++i)
          immediate.push_back(memory.immediate_part(i));
      }
    linearise();
    const std::size_t n = matrix.rows();
    right               = DenseMatrix::Zero(n, slips.size());
    for (std::size_t j = 0; j < slips.size(); ++j)
      {
        const NodalField change = friction.rows.B2 * slips[j];
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            std::array<double, 2> at_node{};
            for (unsigned int c = 0; c < n_tangential; ++c)
              at_node[c] = change(c, nodes[k]);
            const auto part = part_of_slip(k, at_node);
            for (unsigned int c = 0; c < n_tangential; ++c)
              right(place(k, c), j) = part[c];
          }
      }
    if (n == 0 || !solve_general(matrix, right))
      return {};
    std::vector<ContactState> changes;
    for (std::size_t j = 0; j < slips.size(); ++j)
      {
        changes.push_back(open_state(problem));
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            for (unsigned int c = 0; c < n_tangential; ++c)
              changes[j].traction(c, nodes[k]) = right(place(k, c), j);
            if (n_components > n_tangential)
              changes[j].pressure[nodes[k]] = right(place(k, n_tangential), j);
          }
      }
    return changes;
  }

  std::vector<std::vector<double>>
  NewtonSystem::sensitivities(const std::vector<ContactState> &weights)
  {
    linearise();
    matrix.transposeInPlace();
    const std::size_t n = matrix.rows();
    right               = DenseMatrix::Zero(n, weights.size());
    for (std::size_t j = 0; j < weights.size(); ++j)
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          for (unsigned int c = 0; c < n_tangential; ++c)
            right(place(k, c), j) = weights[j].traction(c, nodes[k]);
          if (n_components > n_tangential)
            right(place(k, n_tangential), j) = weights[j].pressure[nodes[k]];
        }
    if (n == 0 || !solve_general(matrix, right))
      return {};
    const unsigned int               N = problem.n_nodes();
    std::vector<std::vector<double>> result;
    for (std::size_t j = 0; j < weights.size(); ++j)
      {
        NodalField          slip_weights(N, n_tangential);
        std::vector<double> gap_weights(N, 0.);
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            std::array<double, 2> at_node{};
            for (unsigned int c = 0; c < n_tangential; ++c)
              at_node[c] = right(place(k, c), j);
            const auto part = part_of_slip(k, at_node);
            for (unsigned int c = 0; c < n_tangential; ++c)
              slip_weights(c, nodes[k]) = part[c];
            if (n_components > n_tangential)
              gap_weights[nodes[k]] = -right(place(k, n_tangential), j);
          }
        std::vector<double> of_displacement =
          friction.rows.B1.multiply_transposed(slip_weights.values());
        as_vector(of_displacement) *= problem.operators.flow_convection();
        of_displacement.insert(of_displacement.end(),
                               gap_weights.begin(),
                               gap_weights.end());
        result.push_back(std::move(of_displacement));
      }
    return result;
  }
} // namespace RollingContact
