#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const char state_file[] = "limit_cycle_state.txt";

    void write_numbers(const std::vector<double> &numbers, std::ostream &stream)
    {
      stream << numbers.size();
      for (const double number : numbers)
        stream << ' ' << significant(number, 17);
      stream << '\n';
    }

    /** False if there are not as many as it says, or one is not finite. */
    bool read_numbers(std::istream &stream, std::vector<double> &numbers)
    {
      std::string line, number;
      if (!std::getline(stream, line))
        return false;
      std::istringstream words(line);
      std::size_t        n = 0;
      words >> n;
      numbers.clear();
      while (words >> number)
        {
          const double value = number_of(number).value_or(HUGE_VAL);
          if (!std::isfinite(value))
            return false;
          numbers.push_back(value);
        }
      return numbers.size() == n;
    }
  } // namespace

  std::string name_of(const RunEnd &end)
  {
    return end ? Cycles::name_of(*end) : "not converged";
  }

  RunEnd end_named(const std::string &name)
  {
    for (const auto motion : {Cycles::Motion::too_short,
                              Cycles::Motion::changing,
                              Cycles::Motion::periodic,
                              Cycles::Motion::stationary,
                              Cycles::Motion::decayed})
      if (name == Cycles::name_of(motion))
        return motion;
    return {};
  }

  RunEnd end_of_row(const ResultsTable &results, const std::size_t row)
  {
    const auto *end = results.value<RunEnd>(row, "cycle");
    return end ? *end : RunEnd();
  }

  std::vector<SweepRun> sweep_runs(const LimitCycleParameters &parameters,
                                   const std::size_t           n_starts)
  {
    std::vector<double>   values = parameters.axis_values();
    std::vector<SweepRun> runs;
    for (std::size_t start = 0; start < n_starts; ++start)
      {
        const std::size_t before = runs.size();
        if (values.empty())
          runs.push_back({start, {}, true, true});
        if (parameters.direction != SweepDirection::down)
          for (const double value : values)
            runs.push_back({start, value, true, runs.size() == before});
        if (parameters.direction == SweepDirection::up)
          continue;
        const bool back = parameters.direction == SweepDirection::both;
        for (std::size_t k = values.size(); k-- > 0;)
          if (!back || k + 1 < values.size())
            runs.push_back({start, values[k], false, runs.size() == before});
      }
    return runs;
  }

  void write_sweep_state(const SweepState &state, RunFolder &folder)
  {
    std::ostringstream stream;
    stream << state.n_rows << ' ' << (state.carried ? 1 : 0) << '\n';
    write_numbers(state.starts, stream);
    if (state.carried)
      {
        const ReducedState &motion   = state.carried->motion;
        const PatchMemory  &friction = state.carried->friction;
        write_numbers({friction.share, friction.target}, stream);
        for (const auto *numbers :
             {&motion.eta, &motion.rate, &motion.forces, &motion.forces_before})
          write_numbers(*numbers, stream);
      }
    folder.write_atomically(state_file, stream.str());
  }

  SweepState read_sweep_state(const RunFolder &folder)
  {
    const auto         file = folder.get_path() / state_file;
    std::istringstream stream(read_bytes(file));
    SweepState         state;
    bool               carries = false;
    std::string        rest;
    bool good = static_cast<bool>(stream >> state.n_rows >> carries) &&
                std::getline(stream, rest) &&
                read_numbers(stream, state.starts);
    if (good && carries)
      {
        Disturbance        &carried = state.carried.emplace();
        std::vector<double> friction;
        good = read_numbers(stream, friction) && friction.size() == 2;
        for (auto *numbers : {&carried.motion.eta,
                              &carried.motion.rate,
                              &carried.motion.forces,
                              &carried.motion.forces_before})
          good = good && read_numbers(stream, *numbers);
        good =
          good && carried.motion.eta.size() == carried.motion.rate.size() &&
          carried.motion.forces.size() == carried.motion.forces_before.size();
        if (good)
          carried.friction = {friction[0], friction[1]};
      }
    if (!good)
      throw InputError("Cannot resume: \"" + file.string() +
                       "\" is missing or damaged. Start the run without "
                       "--resume.");
    return state;
  }
} // namespace RollingContact
