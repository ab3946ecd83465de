#include <rolling_contact/base/broadcast.h>
#include <rolling_contact/base/ordered_work.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/evolution/wear_step.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// m: tread and flange, between which nothing wears
    const double far_apart = 5e-3;

    double interpolated(const std::vector<double> &arc,
                        const std::vector<double> &values,
                        const double               s)
    {
      const std::size_t end =
        std::upper_bound(arc.begin(), arc.end(), s) - arc.begin();
      if (end == 0 || end == arc.size())
        return 0.;
      const double share = (s - arc[end - 1]) / (arc[end] - arc[end - 1]);
      return (1 - share) * values[end - 1] + share * values[end];
    }
  } // namespace

  WearStep::WearStep(const EvolutionParameters   &section,
                     const std::vector<DutyCase> &duty)
    : section(section)
    , duty(duty)
    , rows(duty.size())
  {
    for (std::size_t j = 0; j < duty.size(); ++j)
      if (rank_of_task(j) == Ranks::rank())
        rows[j] = std::make_unique<DutyRow>(duty[j]);
    reserve_blas_memory(n_threads());
  }

  unsigned int WearStep::n_threads() const
  {
    const unsigned int most =
      section.threads > 0 ? section.threads : Ranks::cpus_of_each();
    const std::size_t own = (rows.size() + Ranks::count() - 1) / Ranks::count();
    return std::min<std::size_t>(most, own);
  }

  DutyStates WearStep::stand_on(const RunningSurfaces &surfaces)
  {
    DutyStates found(rows.size());
    do_on_ranks(
      rows.size(),
      n_threads(),
      [&](const std::size_t j) {
        found[j] = rows[j]->stand_on(surfaces, section.wear_law());
      },
      [&](const std::size_t j, const unsigned int rank) {
        Ranks::broadcast(found[j].summary, rank);
      });
    return found;
  }

  WearingWay WearStep::way_of(const std::size_t row, const double share) const
  {
    const double of_row = share * duty[row].share;
    return {section.wears_wheel() ? of_row * section.distance.value() : 0.,
            section.wears_rail() ? of_row * section.passages.value() : 0.};
  }

  double WearStep::smoothing(const DutyStates &states) const
  {
    if (section.smoothing)
      return *section.smoothing;
    std::vector<double> centres;
    for (const DutyState &state : states)
      for (const WearingWheel &wheel : state.summary.wheels)
        if (std::isfinite(wheel.centre_of_wear))
          centres.push_back(wheel.centre_of_wear);
    std::sort(centres.begin(), centres.end());
    double largest = 0.;
    for (std::size_t k = 1; k < centres.size(); ++k)
      if (centres[k] - centres[k - 1] < far_apart)
        largest = std::max(largest, centres[k] - centres[k - 1]);
    return largest / 2;
  }

  RunningSurfaces::Amounts WearStep::total_of(
    const RunningSurfaces                                      &surfaces,
    const std::function<RunningSurfaces::Amounts(std::size_t)> &of_row) const
  {
    RunningSurfaces::Amounts              total = surfaces.nothing();
    std::vector<RunningSurfaces::Amounts> of_rows(rows.size());
    do_on_ranks(
      rows.size(),
      n_threads(),
      [&](const std::size_t j) { of_rows[j] = of_row(j); },
      [&](const std::size_t j, const unsigned int rank) {
        Ranks::broadcast(of_rows[j], rank);
        total = sum(std::move(total), 1., of_rows[j]);
        of_rows[j].clear();
      });
    return total;
  }

  RunningSurfaces::Amounts WearStep::worn_by(
    const RunningSurfaces                                            &surfaces,
    const DutyState                                                  &state,
    const WearingWay                                                 &way,
    const std::function<std::vector<double>(const WearingContact &)> &depths_of,
    const double smoothing) const
  {
    RunningSurfaces::Amounts found = surfaces.nothing();
    for (const WearingContact &contact : state.contacts)
      found =
        sum(std::move(found),
            1.,
            amounts_of(surfaces, contact, way, depths_of(contact), smoothing));
    return found;
  }

  RunningSurfaces::Amounts
  WearStep::worn_at_once(const RunningSurfaces &surfaces,
                         const DutyStates      &states,
                         const double           share) const
  {
    const double width = smoothing(states);
    return total_of(surfaces, [&](const std::size_t j) {
      return worn_by(surfaces,
                     states[j],
                     way_of(j, share),
                     std::mem_fn(&WearingContact::depths),
                     width);
    });
  }

  RunningSurfaces::Amounts
  WearStep::amounts_of(const RunningSurfaces     &surfaces,
                       const WearingContact      &contact,
                       const WearingWay          &way,
                       const std::vector<double> &depths,
                       const double               smoothing) const
  {
    RunningSurfaces::Amounts found = surfaces.nothing();
    const std::size_t        side  = surfaces.side_of(contact.summary.wheel);
    for (unsigned int body = 0; body < 2; ++body)
      if (body == 0 ? section.wears_wheel() : section.wears_rail())
        found[side][body] = contact.amounts(
          surfaces.curve(side, body), body, way, depths, smoothing);
    return found;
  }

  std::vector<double>
  WearStep::depths_of_others(const RunningSurfaces          &surfaces,
                             const WearingContact           &contact,
                             const RunningSurfaces::Amounts &others) const
  {
    std::vector<double> found(contact.lines().size(), 0.);
    const std::size_t   side = surfaces.side_of(contact.summary.wheel);
    for (unsigned int body = 0; body < 2; ++body)
      {
        const auto  depths = surfaces.depths(others, side, body);
        const auto &arc    = surfaces.curve(side, body).arc_lengths();
        for (std::size_t k = 0; k < found.size(); ++k)
          if (const auto &place = contact.lines()[k].place[body])
            found[k] += std::max(0., interpolated(arc, depths, *place));
      }
    return found;
  }

  RunningSurfaces::Amounts WearStep::worn(const RunningSurfaces &surfaces,
                                          const DutyStates      &states,
                                          const double           share) const
  {
    const RunningSurfaces::Amounts at_once =
      worn_at_once(surfaces, states, share);
    if (!section.is_implicit)
      return at_once;
    const double width = smoothing(states);
    return total_of(surfaces, [&](const std::size_t j) {
      const WearingWay way = way_of(j, share);
      return worn_by(
        surfaces,
        states[j],
        way,
        [&](const WearingContact &contact) {
          const auto own =
            amounts_of(surfaces, contact, way, contact.depths(), width);
          return contact.depths_at_end(
            way, depths_of_others(surfaces, contact, sum(at_once, -1., own)));
        },
        width);
    });
  }

  WearStep::Found WearStep::find(const RunningSurfaces &surfaces,
                                 const DutyStates      &states,
                                 const double           share)
  {
    const auto whole  = worn(surfaces, states, share);
    const auto first  = worn(surfaces, states, share / 2);
    const auto middle = surfaces.worn(first);
    const auto both = sum(first, 1., worn(middle, stand_on(middle), share / 2));
    const auto difference = sum(both, -1., whole);
    const auto amounts    = sum(both, 1., difference);
    Found      found{amounts,
                surfaces.misplaced_depth(difference, amounts),
                surfaces.largest_depth(amounts)};
    Ranks::broadcast(found); // or ranks might go different ways
    return found;
  }

  unsigned int WearStep::n_states() const
  {
    double sum = 0.;
    for (const auto &row : rows)
      if (row)
        sum += row->n_states();
    return Ranks::sum(sum);
  }
} // namespace RollingContact
