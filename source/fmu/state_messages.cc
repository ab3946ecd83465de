#include <rolling_contact/fmu/bytes.h>
#include <rolling_contact/fmu/state_messages.h>

#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    void require_end(const BytesIn &in)
    {
      if (!in.at_end())
        throw std::invalid_argument("there are more bytes than of a message");
    }
  } // namespace

  std::string StatesQuestion::bytes() const
  {
    BytesOut out;
    for (unsigned int k = 0; k < 2; ++k)
      {
        out.add(wheels[k].numbers());
        out.add(memories[k]);
      }
    return out.all();
  }

  StatesQuestion StatesQuestion::of_bytes(const std::string &bytes)
  {
    BytesIn        in(bytes);
    StatesQuestion found;
    for (unsigned int k = 0; k < 2; ++k)
      {
        found.wheels[k] =
          WheelQuestion::of_numbers(in.numbers<WheelQuestion::n_numbers>());
        found.memories[k] = in.text();
      }
    require_end(in);
    return found;
  }

  std::string StatesAnswer::bytes() const
  {
    BytesOut out;
    out.add(is_solved ? 1. : 0.);
    out.add(why);
    for (const WheelAnswer &wheel : wheels)
      {
        out.add(wheel.roll);
        out.add(wheel.values);
        out.add(wheel.memory);
      }
    return out.all();
  }

  StatesAnswer StatesAnswer::of_bytes(const std::string &bytes)
  {
    BytesIn      in(bytes);
    StatesAnswer found;
    found.is_solved = in.number() != 0.;
    found.why       = in.text();
    for (WheelAnswer &wheel : found.wheels)
      {
        wheel.roll   = in.number();
        wheel.values = in.numbers<n_quantities>();
        wheel.memory = in.text();
      }
    require_end(in);
    return found;
  }
} // namespace RollingContact::Fmu
