#ifndef rolling_contact_fmu_state_messages_h
#define rolling_contact_fmu_state_messages_h

#include <rolling_contact/fmu/wheelset_model.h>

#include <array>
#include <string>

namespace RollingContact::Fmu
{
  /** What the program says first when it solves states for an FMU. */
  constexpr char greeting_of_states[] = "rolling-contact states 1";

  /** The option with which the program does so. */
  constexpr char option_of_states[] = "--states";

  /**
   * What an FMU asks the program for: the states of both wheels, each as a
   * right-hand one, from what the program remembered of the last ones; empty:
   * nothing.
   */
  struct StatesQuestion
  {
    std::array<WheelQuestion, 2> wheels;
    std::array<std::string, 2>   memories;

    std::string bytes() const;

    /** Throws std::invalid_argument if the bytes are none of a question. */
    static StatesQuestion of_bytes(const std::string &bytes);
  };

  /** The state of a wheel as a right-hand one: roll at which both wheels touch,
   * values (zero without load), and what to remember of it. */
  struct WheelAnswer
  {
    double      roll = 0.;
    Quantities  values{};
    std::string memory;
  };

  /** What the program answers; without states it says why there are none. */
  struct StatesAnswer
  {
    bool                       is_solved = true;
    std::string                why;
    std::array<WheelAnswer, 2> wheels;

    std::string bytes() const;

    /** Throws std::invalid_argument if the bytes are none of an answer. */
    static StatesAnswer of_bytes(const std::string &bytes);
  };
} // namespace RollingContact::Fmu

#endif
