#include "input_parts.h"

#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/base/exceptions.h>

using namespace RollingContact;

namespace
{
  const char state_name[] = "limit_cycle_state.txt";

  /** Rows that were read are written as the same rows. */
  void read_rows_of(const std::string &text)
  {
    ResultsTable table;
    try
      {
        table.restore(text, "results.csv");
      }
    catch (const InputError &error)
      {
        must_name(error, "results.csv");
        return;
      }
    ResultsTable again;
    again.restore(table.csv(), "results.csv");
    must(again.csv() == table.csv(), "other rows");
  }

  void read_state(const RunFolder &folder)
  {
    SweepState state;
    try
      {
        state = read_sweep_state(folder);
      }
    catch (const InputError &error)
      {
        must_name(error, state_name);
        return;
      }
    for (const double frequency : state.starts)
      must(std::isfinite(frequency), "a start that is not finite");
    if (!state.carried)
      return;
    const auto &motion = state.carried->motion;
    for (const auto *numbers :
         {&motion.eta, &motion.rate, &motion.forces, &motion.forces_before})
      for (const double number : *numbers)
        must(std::isfinite(number), "a motion that is not finite");
    must(motion.eta.size() == motion.rate.size() &&
           motion.forces.size() == motion.forces_before.size(),
         "motions of two sizes");
  }
} // namespace

/** Parts: results.csv, limit_cycle_state.txt. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  write_part(state_name, parts, 1);
  read_rows_of(parts[0]);
  read_state(RunFolder("", "", ""));
  return 0;
}
