#include <time.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/run/phase_timer.h>

#include <algorithm>
#include <cstdio>

namespace RollingContact
{
  namespace
  {
    double
    read_clock(const clockid_t clock)
    {
      timespec time = {};
      clock_gettime(clock, &time);
      return static_cast<double>(time.tv_sec) + 1e-9 * time.tv_nsec;
    }



    std::string
    fixed(const double value, const int decimals)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.*f", decimals, value);
      return buffer;
    }



    std::string
    table_line(const std::string     &name,
               const PhaseTimer::Row &row,
               const double           total_wall)
    {
      constexpr std::size_t name_width = 37;

      const double share =
        total_wall > 0. ? 100. * row.wall_seconds / total_wall : 0.;
      const std::string calls =
        row.n_calls > 0 ? std::to_string(row.n_calls) : "";
      return left_aligned(name, name_width) + right_aligned(calls, 9) +
             right_aligned(fixed(row.wall_seconds, 3), 13) +
             right_aligned(fixed(row.cpu_seconds, 3), 13) +
             right_aligned(fixed(share, 1), 8) + '\n';
    }
  } // namespace



  std::string
  name_of(const Phase phase)
  {
    switch (phase)
      {
        case Phase::mesh:
          return "mesh and assembly";
        case Phase::condensation:
          return "factorisation and condensation";
        case Phase::mass:
          return "mass and order of elimination";
        case Phase::body_solves:
          return "forward and backward solves";
        case Phase::contact_solve:
          return "contact solve";
        case Phase::fields:
          return "fields and plots";
        case Phase::checkpoints:
          return "checkpoints";
        case Phase::other:
          break;
      }
    return "other";
  }



  PhaseTimer::Scope::Scope(PhaseTimer &timer, const Phase phase)
    : timer(std::this_thread::get_id() == timer.owner ? &timer : nullptr)
  {
    if (this->timer != nullptr)
      this->timer->enter(phase);
  }



  PhaseTimer::Scope::~Scope()
  {
    if (timer != nullptr)
      timer->leave();
  }



  PhaseTimer::PhaseTimer()
    : owner(std::this_thread::get_id())
    , last_change(now())
    , phases{{Phase::other, 0, 0., 0.}}
    , open_phases{0}
  {}



  PhaseTimer::Instant
  PhaseTimer::now()
  {
    return {read_clock(CLOCK_MONOTONIC), read_clock(CLOCK_PROCESS_CPUTIME_ID)};
  }



  void
  PhaseTimer::charge(Row &row, const Instant &begin, const Instant &end)
  {
    row.wall_seconds += end.wall - begin.wall;
    row.cpu_seconds += end.cpu - begin.cpu;
  }



  void
  PhaseTimer::enter(const Phase phase)
  {
    const Instant change = now();
    charge(phases[open_phases.back()], last_change, change);
    last_change = change;

    auto found =
      std::find_if(phases.begin(), phases.end(), [&](const Row &row) {
        return row.phase == phase;
      });
    if (found == phases.end())
      found = phases.insert(phases.end(), {phase, 0, 0., 0.});
    ++found->n_calls;
    open_phases.push_back(found - phases.begin());
  }



  void
  PhaseTimer::leave()
  {
    const Instant change = now();
    charge(phases[open_phases.back()], last_change, change);
    last_change = change;
    open_phases.pop_back();
  }



  std::vector<PhaseTimer::Row>
  PhaseTimer::rows() const
  {
    std::vector<Row> result = phases;
    charge(result[open_phases.back()], last_change, now());
    std::rotate(result.begin(), result.begin() + 1, result.end());
    return result;
  }



  PhaseTimer::Row
  PhaseTimer::total(const std::vector<Row> &rows)
  {
    Row sum{Phase::other, 0, 0., 0.};
    for (const Row &row : rows)
      {
        sum.wall_seconds += row.wall_seconds;
        sum.cpu_seconds += row.cpu_seconds;
      }
    return sum;
  }



  std::string
  PhaseTimer::summary() const
  {
    const std::vector<Row> all_rows = rows();
    const Row              sum      = total(all_rows);
    const std::string      rule     = std::string(80, '-') + '\n';

    std::string table = left_aligned("Phase", 37) + right_aligned("calls", 9) +
                        right_aligned("wall [s]", 13) +
                        right_aligned("CPU [s]", 13) +
                        right_aligned("wall %", 8) + '\n' + rule;
    for (const Row &row : all_rows)
      table += table_line(name_of(row.phase), row, sum.wall_seconds);
    return table + rule + table_line("total", sum, sum.wall_seconds);
  }
} // namespace RollingContact
