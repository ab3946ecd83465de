#include <rolling_contact/analyses/stability_drivers.h>
#include <rolling_contact/analyses/stability_thresholds.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace RollingContact
{
  namespace
  {
    /// modes up to this many times the highest frequency that is looked at
    /// vibrate, faster ones follow: half of the matrix, a fifth of the time
    const double kept_modes = 1.25;

    /// relative difference of frequencies of one vibration in two states
    const double same_vibration = 0.02;

    /** Lines of nodes across the flow that touch: elements along the patch. */
    std::size_t n_along(const ContactProblem &problem,
                        const LinearContact  &contact)
    {
      std::set<double> places;
      for (const unsigned int node : contact.touching)
        places.insert(problem.operators.positions()[node][0]);
      return std::max<std::size_t>(places.size(), 1);
    }

    /** By how much whole bodies differ from their modes in the growth of a
     * vibration: as the one of the state that is nearest to it does, or the
     * largest difference where none is near. */
    double difference_of_whole(const std::vector<Finding> &findings,
                               const double                frequency)
    {
      double largest = 0., nearest = 0., distance = same_vibration;
      bool   is_near = false;
      for (const Finding &finding : findings)
        if (finding.corrected)
          {
            const double difference =
                           std::abs(finding.growth() - finding.mode.growth()),
                         here =
                           std::abs(finding.mode.frequency() / frequency - 1);
            largest = std::max(largest, difference);
            if (here <= distance)
              {
                distance = here;
                nearest  = difference;
                is_near  = true;
              }
          }
      return is_near ? nearest : largest;
    }

    /** The vibration that grows fastest, or decays slowest, of those that are
     * looked at. */
    std::complex<double> fastest_vibration(const Vibrations &vibrations)
    {
      const ComplexValues listed =
        vibrations.least_damped(vibrations.eigenvalues().size());
      const auto at = std::max_element(listed.begin(),
                                       listed.end(),
                                       [](const auto &a, const auto &b) {
                                         return a.real() < b.real();
                                       });
      return at == listed.end()
               ? std::complex<double>(-std::numeric_limits<double>::max(), 0.)
               : *at;
    }

    /** A state near the one that is disturbed, and what of it is kept. */
    struct Neighbour
    {
      double               value = 0.;
      std::complex<double> fastest;
      std::string          mode;
      unsigned int         n_sticking = 0;
    };

    template <int dim>
    class Neighbours
    {
    public:
      Neighbours(const Situation         &scene,
                 const SteadyState<dim>  &steady,
                 const RollingModes<dim> &rolling,
                 const Vibrations        &vibrations)
        : scene(scene)
        , steady(steady)
        , rolling(rolling)
        , of_all_modes(vibrations)
        , slow(condensed(vibrations.bodies(),
                         2 * pi * kept_modes *
                           scene.inputs->modes.maximum_frequency))
        , of_slow_modes(scene, slow.pair, steady.problem, steady.state)
      {}

      /** The vibrations of the state itself, as thresholds of a driver are
       * found: damping with all modes, which have it. */
      const Vibrations &start(const StateDriver &driver) const
      {
        return driver.set == nullptr ? of_all_modes : of_slow_modes;
      }

      /** None where the state is not found on these bodies. */
      std::optional<Vibrations> vibrations_at(const StateDriver &driver,
                                              const double       value,
                                              const bool all_modes) const
      {
        throw_if_interrupted();
        if (driver.set == nullptr)
          {
            StabilityParameters damped = scene.inputs->stability;
            damped.added_damping       = value;
            return Vibrations(scene,
                              rolling.reduced(RollingConditions(scene, damped)),
                              steady.problem,
                              steady.state);
          }
        Situation changed = scene;
        driver.set(changed.contact, value);
        SteadyState<dim> other = steady;
        StateDemands     demands;
        demands.pair.factors = true;
        other.pair->set_loads(changed.contact, other.problem);
        solve_contact(changed, demands, other);
        if (!other.solver.converged || zone_too_small(other))
          return {};
        return Vibrations(changed,
                          all_modes ? of_all_modes.bodies() : slow.pair,
                          other.problem,
                          other.state);
      }

      Neighbour neighbour(const double value, const Vibrations &found) const
      {
        Neighbour here;
        here.value   = value;
        here.fastest = fastest_vibration(found);
        here.n_sticking =
          found.contact().touching.size() - found.contact().n_slip();
        if (here.fastest.real() > 0.)
          here.mode =
            name_of(found.template find<dim>({here.fastest}, nullptr)[0].mode);
        return here;
      }

      /** By how much all modes and those that thresholds are found with differ
       * in the growth of the fastest vibration of a neighbour. */
      double difference_of_modes(const StateDriver &driver,
                                 const Neighbour   &at) const
      {
        if (driver.set == nullptr)
          return 0.;
        const auto all        = vibrations_at(driver, at.value, true);
        double     difference = 0.;
        double     distance   = std::abs(at.fastest);
        for (const auto &s : all ? all->eigenvalues() : ComplexValues())
          if (std::abs(s - at.fastest) < distance)
            {
              distance   = std::abs(s - at.fastest);
              difference = std::abs(s.real() - at.fastest.real());
            }
        return difference;
      }

    private:
      std::string name_of(const StabilityMode &mode) const
      {
        const std::vector<double> shares = mode.participation();
        const std::size_t         n      = of_all_modes.bodies().n_modes();
        return rolling.nearest_name(
          shares.size() == n ? shares : slow.expanded(shares, n));
      }

      const Situation         &scene;
      const SteadyState<dim>  &steady;
      const RollingModes<dim> &rolling;
      const Vibrations        &of_all_modes;
      const CondensedPair      slow;
      const Vibrations         of_slow_modes;
    };

    /** The state of a value among those that were solved. */
    const Neighbour &solved_at(const std::vector<Neighbour> &solved,
                               const double                  value)
    {
      return *std::find_if(solved.begin(),
                           solved.end(),
                           [&](const Neighbour &it) {
                             return it.value == value;
                           });
    }

    template <int dim>
    DrivingThreshold find_threshold(const StateDriver          &driver,
                                    const Neighbours<dim>      &neighbours,
                                    const std::size_t           n_elements,
                                    const std::vector<Finding> &findings,
                                    unsigned int               &n_states)
    {
      const Neighbour now =
        neighbours.neighbour(driver.now, neighbours.start(driver));
      std::vector<Neighbour> solved{now};
      const Threshold        found = first_threshold(
        now.fastest.real(),
        [&](const double change) -> std::optional<double> {
          const double value = driver.value(change);
          const auto   there = neighbours.vibrations_at(driver, value, false);
          if (!there)
            return {};
          solved.push_back(neighbours.neighbour(value, *there));
          return solved.back().fastest.real();
        },
        driver.search);
      n_states += found.n_states;
      DrivingThreshold threshold;
      threshold.quantity = driver.quantity;
      threshold.now      = driver.now;
      threshold.squeals  = now.fastest.real() > 0.;
      threshold.found    = found.crossed;
      threshold.known    = found.known;
      threshold.to       = driver.value(found.behind);
      if (!found.crossed)
        return threshold;
      const Neighbour &before   = solved_at(solved, driver.value(found.before)),
                      &behind   = solved_at(solved, driver.value(found.behind)),
                      &stable   = threshold.squeals ? behind : before,
                      &unstable = threshold.squeals ? before : behind;
      threshold.value           = (stable.value + unstable.value) / 2;
      threshold.n_sticking      = stable.n_sticking;
      threshold.by_sticking     = stable.n_sticking > unstable.n_sticking;
      threshold.frequency       = unstable.fastest.imag() / (2 * pi);
      threshold.mode            = unstable.mode;
      threshold.uncertainty =
        std::abs(stable.value - unstable.value) / 2 +
        std::abs(driver.unit / found.slope()) *
          (difference_of_whole(findings, threshold.frequency) +
           neighbours.difference_of_modes(driver, unstable)) +
        (threshold.by_sticking ? std::abs(threshold.value) / n_elements : 0.);
      threshold.stable = threshold.value + (stable.value > unstable.value
                                              ? threshold.uncertainty
                                              : -threshold.uncertainty);
      if (driver.whole > 0.)
        threshold.share =
          std::abs(threshold.value - threshold.now) / driver.whole;
      return threshold;
    }
  } // namespace

  template <int dim>
  std::vector<DrivingThreshold>
  find_thresholds(const Situation            &scene,
                  const SteadyState<dim>     &steady,
                  const RollingModes<dim>    &rolling,
                  const Vibrations           &vibrations,
                  const std::vector<Finding> &findings,
                  RunContext                 &context)
  {
    std::vector<DrivingThreshold> thresholds;
    const LinearContact          &contact = vibrations.contact();
    if (contact.n_tangential == 0 || !(scene.contact.friction_coefficient > 0.))
      return thresholds;
    const Stopwatch          watch;
    const Neighbours<dim>    neighbours(scene, steady, rolling, vibrations);
    const bool               squeals = vibrations.n_unstable() > 0;
    std::vector<StateDriver> drivers =
      squeals ? possible_cures(scene.contact) : possible_onsets(scene.contact);
    double lacking = 0.;
    for (const auto &s : vibrations.least_damped(0))
      lacking = std::max(lacking, s.real() / std::abs(s));
    if (squeals)
      drivers.push_back(
        more_damping(scene.inputs->stability.added_damping, lacking));
    const std::size_t n_elements = n_along(steady.problem, contact);
    unsigned int      n_states   = 0;
    for (const StateDriver &driver : drivers)
      thresholds.push_back(
        find_threshold(driver, neighbours, n_elements, findings, n_states));
    context.report.objects.push_back(
      {"thresholds of " + std::to_string(n_states) + " states",
       true,
       0,
       watch.seconds(),
       ""});
    return thresholds;
  }

  template std::vector<DrivingThreshold>
  find_thresholds(const Situation &,
                  const SteadyState<2> &,
                  const RollingModes<2> &,
                  const Vibrations &,
                  const std::vector<Finding> &,
                  RunContext &);
  template std::vector<DrivingThreshold>
  find_thresholds(const Situation &,
                  const SteadyState<3> &,
                  const RollingModes<3> &,
                  const Vibrations &,
                  const std::vector<Finding> &,
                  RunContext &);
} // namespace RollingContact
