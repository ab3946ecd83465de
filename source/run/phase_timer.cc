#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <rolling_contact/run/phase_timer.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    double read_clock(const clockid_t clock)
    {
      timespec time = {};
      clock_gettime(clock, &time);
      return static_cast<double>(time.tv_sec) + 1e-9 * time.tv_nsec;
    }

    std::string table_line(const std::string     &name,
                           const PhaseTimer::Row &row,
                           const double           total_wall)
    {
      const double share =
        total_wall > 0. ? 100. * row.wall_seconds / total_wall : 0.;
      return fmt::format("{:<37}{:>9}{:13.3f}{:13.3f}{:8.1f}\n",
                         name,
                         row.n_calls > 0 ? std::to_string(row.n_calls) : "",
                         row.wall_seconds,
                         row.cpu_seconds,
                         share);
    }
  } // namespace

  std::string name_of(const Phase phase)
  {
    switch (phase)
      {
        case Phase::start:
          return "start of the program";
        case Phase::mesh:
          return "mesh and assembly";
        case Phase::condensation:
          return "factorisation and condensation";
        case Phase::mass:
          return "mass and order of elimination";
        case Phase::modes:
          return "modes and their count";
        case Phase::response:
          return "frequency response";
        case Phase::eigenvalues:
          return "eigenvalues and their proof";
        case Phase::body_solves:
          return "forward and backward solves";
        case Phase::contact_solve:
          return "contact solve";
        case Phase::fields:
          return "fields and plots";
        case Phase::checkpoints:
          return "checkpoints";
        case Phase::step_estimate:
          return "error of the time step";
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

  namespace
  {
    /**
     * Seconds since the process began, field 22 of /proc/self/stat (proc(5));
     * zero where that cannot be read.
     */
    double age_of_process()
    {
      std::ifstream stat("/proc/self/stat");
      std::string   text((std::istreambuf_iterator<char>(stat)), {});
      const auto    name_ends = text.rfind(')');
      if (name_ends == std::string::npos)
        return 0.;
      std::istringstream fields(text.substr(name_ends + 1));
      std::string        field;
      for (unsigned int k = 3; k <= 22; ++k)
        fields >> field;
      const double ticks = std::strtod(field.c_str(), nullptr);
      return read_clock(CLOCK_BOOTTIME) - ticks / sysconf(_SC_CLK_TCK);
    }
  } // namespace

  void PhaseTimer::charge_start()
  {
    // a shell that becomes the program (exec) leaves it its own, longer age
    const double  longest_start = 5.; // s
    const Instant made          = last_change;
    const double  wall =
      std::max(0., age_of_process() - (now().wall - made.wall));
    phases.push_back(
      {Phase::start, 1, wall > longest_start ? made.cpu : wall, made.cpu});
  }

  PhaseTimer::Instant PhaseTimer::now()
  {
    return {read_clock(CLOCK_MONOTONIC), read_clock(CLOCK_PROCESS_CPUTIME_ID)};
  }

  void PhaseTimer::charge(Row &row, const Instant &begin, const Instant &end)
  {
    row.wall_seconds += end.wall - begin.wall;
    row.cpu_seconds += end.cpu - begin.cpu;
  }

  void PhaseTimer::enter(const Phase phase)
  {
    const Instant change = now();
    charge(phases[open_phases.back()], last_change, change);
    last_change = change;
    if (phases[open_phases.back()].phase == Phase::step_estimate)
      {
        open_phases.push_back(open_phases.back());
        return;
      }

    auto found =
      std::find_if(phases.begin(), phases.end(), [&](const Row &row) {
        return row.phase == phase;
      });
    if (found == phases.end())
      found = phases.insert(phases.end(), {phase, 0, 0., 0.});
    ++found->n_calls;
    open_phases.push_back(found - phases.begin());
  }

  void PhaseTimer::leave()
  {
    const Instant change = now();
    charge(phases[open_phases.back()], last_change, change);
    last_change = change;
    open_phases.pop_back();
  }

  std::vector<PhaseTimer::Row> PhaseTimer::rows() const
  {
    std::vector<Row> result = phases;
    charge(result[open_phases.back()], last_change, now());
    std::rotate(result.begin(), result.begin() + 1, result.end());
    return result;
  }

  PhaseTimer::Row PhaseTimer::total(const std::vector<Row> &rows)
  {
    Row sum{Phase::other, 0, 0., 0.};
    for (const Row &row : rows)
      {
        sum.wall_seconds += row.wall_seconds;
        sum.cpu_seconds += row.cpu_seconds;
      }
    return sum;
  }

  std::string PhaseTimer::summary() const
  {
    const std::vector<Row> all_rows = rows();
    const Row              sum      = total(all_rows);
    const std::string      rule     = std::string(80, '-') + '\n';

    std::string table = fmt::format("{:<37}{:>9}{:>13}{:>13}{:>8}\n{}",
                                    "Phase",
                                    "calls",
                                    "wall [s]",
                                    "CPU [s]",
                                    "wall %",
                                    rule);
    for (const Row &row : all_rows)
      table += table_line(name_of(row.phase), row, sum.wall_seconds);
    return table + rule + table_line("total", sum, sum.wall_seconds);
  }
} // namespace RollingContact
