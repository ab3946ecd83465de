#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/results/nodal_values.h>
#include <rolling_contact/results/state_damage.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using F = std::optional<NodalField>;
    using S = const NodalState &;

    F one(const std::vector<double> &values)
    {
      return NodalField(values.size(), values);
    }

    F slip(S s)
    {
      return s.problem.n_tangential() > 0
               ? s.tangential().slip(s.state.traction)
               : NodalField(s.problem.n_nodes(), 0);
    }

    F traction_size(S s)
    {
      std::vector<double> sizes;
      for (std::size_t i = 0; i < s.problem.n_nodes(); ++i)
        sizes.push_back(s.state.traction.norm_at(i));
      return one(sizes);
    }

    bool friction_falls(S s)
    {
      return s.problem.loads.friction_law && s.problem.n_tangential() > 0;
    }

    F friction(S s)
    {
      const bool follows_heat =
        s.scene && s.problem.n_tangential() > 0 &&
        !s.scene->contact.friction_over_temperature.empty();
      return friction_falls(s) || follows_heat ? one(s.tangential().friction)
                                               : F();
    }

    F sliding_speed(S s)
    {
      return friction_falls(s) ? one(s.tangential().sliding_speeds(*slip(s)))
                               : F();
    }

    F temperature(S s)
    {
      const auto rise = s.scene
                          ? flash_temperature(*s.scene, s.problem, s.state)
                          : std::vector<double>();
      return rise.empty() ? F() : one(rise);
    }

    /** By the law of this number in Damage::wear_laws(). */
    template <int number>
    F wear_rate(S s)
    {
      const Damage::WearLaw &law = Damage::wear_laws().at(number);
      return s.damage() && s.damage()->can_tell(law)
               ? one(s.damage()->rates(law))
               : F();
    }

    F surface_index(S s)
    {
      return s.damage() ? one(s.damage()->surface_indices()) : F();
    }

    F gap(S s)
    {
      return one(normal_gap(s.problem, s.state));
    }

    F node_state(S s)
    {
      std::vector<double> values;
      for (const NodeState state : node_states(s.tangential(), s.state))
        values.push_back(static_cast<int>(state));
      return one(values);
    }
  } // namespace

  NodalState::NodalState(const ContactProblem &problem,
                         const ContactState   &state,
                         const bool            step_is_known,
                         const PairSpec       *scene)
    : problem(problem)
    , state(state)
    , step_is_known(step_is_known)
    , scene(scene)
  {}

  const TangentialProblem &NodalState::tangential() const
  {
    if (!tangential_problem)
      tangential_problem.emplace(
        RollingContact::tangential_problem(problem, state));
    return *tangential_problem;
  }

  const RecoveredTractions &NodalState::recovered() const
  {
    if (!recovered_tractions)
      recovered_tractions =
        RollingContact::recovered_tractions(tangential(), state);
    return *recovered_tractions;
  }

  const StateDamage *NodalState::damage() const
  {
    if (!state_damage && scene && StateDamage::is_asked(*scene, problem))
      state_damage =
        std::make_shared<const StateDamage>(*scene, problem, state);
    return state_damage.get();
  }

  F NodalQuantity::of(const NodalState &state) const
  {
    F field = values(state);
    if (field && of_step && !state.step_is_known)
      std::fill(field->begin(), field->end(), std::nan(""));
    return field;
  }

  const std::vector<NodalQuantity> &nodal_quantities()
  {
    static const std::vector<NodalQuantity> all{
      {"traction", "Pa", [](S s) -> F { return s.state.traction; }, true},
      {"slip", "1", &slip, true, true},
      {"recovered_traction",
       "Pa",
       [](S s) -> F { return s.recovered().traction; },
       true},
      {"pressure", "Pa", [](S s) { return one(s.state.pressure); }},
      {"recovered_pressure",
       "Pa",
       [](S s) { return one(s.recovered().pressure); }},
      {"traction_size", "Pa", &traction_size},
      {"traction_bound", "Pa", [](S s) { return one(s.tangential().bound); }},
      {"friction_coefficient", "1", &friction},
      {"sliding_speed", "m/s", &sliding_speed, false, true},
      {"flash_temperature", "K", &temperature},
      {"wear_rate_archard", "1", &wear_rate<0>, false, true},
      {"wear_rate_usfd", "1", &wear_rate<1>, false, true},
      {"wear_rate_t_gamma", "1", &wear_rate<2>, false, true},
      {"surface_index", "1", &surface_index},
      {"gap", "m", &gap, false, true},
      {"area", "m^2", [](S s) { return one(s.problem.operators.areas()); }},
      {"state", "1", &node_state}};
    return all;
  }

  const NodalQuantity &nodal_quantity(const std::string &name)
  {
    for (const NodalQuantity &quantity : nodal_quantities())
      if (quantity.name == name)
        return quantity;
    throw std::out_of_range("There is no field " + name + '.');
  }
} // namespace RollingContact
