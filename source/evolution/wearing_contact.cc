#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/evolution/wearing_contact.h>
#include <rolling_contact/results/state_damage.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/surfaces/wear_deposit.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// force of a line over the largest one, below which it has none
    const double least_force = 1e-3;
  } // namespace

  double WearingWay::factor(const unsigned int body,
                            const double       rolling_radius) const
  {
    return body == 0 ? distance / (2 * pi * rolling_radius) : passages;
  }

  namespace
  {
    DenseMatrix normal_block(const ContactOperators &all)
    {
      const std::size_t n = all.n_nodes();
      return all.W().dense().bottomRightCorner(n, n);
    }

    /** The normal contact of a state, whose traction is part of the gap. */
    ContactProblem normal_contact(const ContactProblem &problem,
                                  const ContactState   &state)
    {
      const ContactOperators &all = problem.operators;
      ContactProblem          normal;
      normal.operators =
        ContactOperators(all.positions(), all.H(), normal_block(all));
      normal.operators.set_frames(all.frames());
      normal.loads.gap =
        sum(problem.loads.gap,
            1.,
            all.normal_displacement_of_traction(state.traction));
      normal.loads.normal_load = all.load(state.pressure);
      return normal;
    }
  } // namespace

  WearingContact::WearingContact(const PairSpec        &scene,
                                 const SteadyState<3>  &steady,
                                 const Damage::WearLaw &law,
                                 const unsigned int     wheelset,
                                 const unsigned int     wheel,
                                 const double           portion)
    : summary{wheelset,
              wheel,
              steady.result.creep_work,
              steady.result.max_pressure,
              {}}
    , portion(portion)
    , normal(normal_contact(steady.problem, steady.state))
    , state(open_state(normal))
    , controls(scene.solver.controls)
  {
    if (const auto rise =
          patch_temperature(scene, steady.problem, steady.state))
      summary.flash = *rise;
    state.pressure = steady.state.pressure;
    state.approach = steady.state.approach;
    find_lines(scene, steady, law);
    fill_lines_without_load();
  }

  void WearingContact::find_lines(const PairSpec        &scene,
                                  const SteadyState<3>  &steady,
                                  const Damage::WearLaw &law)
  {
    const StateDamage damage(scene, steady.problem, steady.state);
    double            worn = 0., moment = 0.;
    for (const LineAcross &line : lines_across(steady))
      {
        const double depth = damage.depth(line, law, scene.wear);
        WearingLine  wearing{
          {{scene.frame->wheel_arc_length(line.y),
            scene.frame->covers(line.y)
               ? std::make_optional(scene.frame->rail_arc_length(line.y))
               : std::nullopt}},
          line.width,
          line.load,
          line.load > 0. ? depth / line.load : 0.,
          rolling_radius(scene, line.y).value_or(scene.wheel.radius),
          line.nodes};
        if (wearing.place[0] && depth > 0.)
          {
            const auto &curve = scene.frame->wheel_on_rail().wheel_profile();
            worn += depth * line.width;
            moment += depth * line.width * curve.at(*wearing.place[0]).y;
          }
        all.push_back(wearing);
      }
    summary.centre_of_wear = worn > 0. ? moment / worn : std::nan("");
  }

  void WearingContact::fill_lines_without_load()
  {
    std::vector<std::size_t> loaded;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].load > 0.)
        loaded.push_back(k);
    for (std::size_t k = 0; !loaded.empty() && k < all.size(); ++k)
      if (all[k].load == 0.)
        {
          const auto distance = [&](const std::size_t other) {
            return k > other ? k - other : other - k;
          };
          const std::size_t nearest =
            *std::min_element(loaded.begin(),
                              loaded.end(),
                              [&](const auto a, const auto b) {
                                return distance(a) < distance(b);
                              });
          all[k].depth_over_load = all[nearest].depth_over_load;
        }
  }

  std::vector<double> WearingContact::depths() const
  {
    std::vector<double> found;
    for (const WearingLine &line : all)
      found.push_back(line.depth_over_load * line.load);
    return found;
  }

  std::vector<double>
  WearingContact::depths_at_end(const WearingWay          &way,
                                const std::vector<double> &others) const
  {
    double largest = 0.;
    for (const WearingLine &line : all)
      largest = std::max(largest, line.load * line.width);
    ContactProblem worn = normal;
    DenseMatrix    W    = normal.operators.W().dense();
    for (std::size_t k = 0; k < all.size(); ++k)
      {
        const WearingLine &line = all[k];
        if (!(line.width > 0.))
          continue;
        const double force = line.load * line.width;
        double       C     = portion * line.depth_over_load / line.width *
                   (way.factor(0, line.radius) + way.factor(1, line.radius));
        if (force > least_force * largest)
          C += others[k] / force;
        else
          for (const unsigned int i : line.nodes)
            worn.loads.gap[i] += others[k];
        for (const unsigned int i : line.nodes)
          for (const unsigned int j : line.nodes)
            W(i, j) += C;
      }
    worn.operators.set_compliance(std::move(W));
    ContactState       there  = state;
    const SolverReport report = NormalActiveSet(controls).solve(worn, there);
    if (!report.converged)
      throw ConvergenceError("The contact at the end of a step of wear: " +
                             shortfall(report, controls.tolerance));
    std::vector<double> found;
    for (const WearingLine &line : all)
      {
        double force = 0.;
        for (const unsigned int i : line.nodes)
          force += normal.operators.areas()[i] * there.pressure[i];
        found.push_back(
          line.width > 0. ? line.depth_over_load * force / line.width : 0.);
      }
    return found;
  }

  std::vector<double>
  WearingContact::amounts(const Profiles::ProfileCurve &curve,
                          const unsigned int            body,
                          const WearingWay             &way,
                          const std::vector<double>    &depths,
                          const double                  smoothing) const
  {
    std::vector<Profiles::WearLine> lines;
    double                          width = smoothing;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].place[body] && all[k].width > 0.)
        {
          width = std::max(width, all[k].width);
          lines.push_back(
            {*all[k].place[body],
             all[k].width,
             portion * way.factor(body, all[k].radius) * depths[k]});
        }
    return Profiles::smoothed(curve, Profiles::deposited(curve, lines), width);
  }
} // namespace RollingContact
