#include <rolling_contact/fmu/bytes.h>
#include <rolling_contact/fmu/instance.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    const std::string mark_of_state = "rolling-contact state 2";
  } // namespace

  std::array<double, Snapshot::n_numbers> Snapshot::numbers() const
  {
    std::array<double, n_numbers> all;
    const auto   rest = std::copy(inputs.begin(), inputs.end(), all.begin());
    const double others[] = {least_speed,
                             time,
                             stop_time,
                             double(static_cast<int>(mode)),
                             double(has_stop_time),
                             double(is_set_up)};
    std::copy(std::begin(others), std::end(others), rest);
    return all;
  }

  std::string Snapshot::bytes() const
  {
    BytesOut out;
    out.add(program);
    out.add(memory);
    out.add(found ? 1. : 0.);
    if (found)
      {
        out.add(is_of_step ? 1. : 0.);
        out.add(found->roll);
        for (const WheelOutputs &wheel : found->wheels)
          {
            out.add(wheel.values);
            out.add(wheel.force_ratio);
            out.add(wheel.inside ? 1. : 0.);
          }
      }
    out.add(numbers());
    return out.all();
  }

  Snapshot Snapshot::of_bytes(const std::string &bytes)
  {
    BytesIn  in(bytes);
    Snapshot all;
    all.program = in.text();
    all.memory  = in.text();
    if (in.number() != 0.)
      {
        all.is_of_step = in.number() != 0.;
        Outputs outputs;
        outputs.roll = in.number();
        for (WheelOutputs &wheel : outputs.wheels)
          {
            wheel.values      = in.numbers<n_quantities>();
            wheel.force_ratio = in.number();
            wheel.inside      = in.number() != 0.;
          }
        all.found = outputs;
      }
    all.take(in.numbers<n_numbers>());
    if (!in.at_end())
      throw std::invalid_argument("there are more bytes than of a state");
    return all;
  }

  void Snapshot::take(const std::array<double, n_numbers> &numbers)
  {
    for (const double number : numbers)
      if (!std::isfinite(number))
        throw std::invalid_argument("a number is not finite");
    const double *others = numbers.data() + n_inputs;
    const int     last   = static_cast<int>(Mode::terminated);
    if (!(numbers[friction] > 0. && others[0] > 0. && others[3] >= 0. &&
          others[3] <= last))
      throw std::invalid_argument("a number cannot be that of a state");
    std::copy_n(numbers.begin(), std::size_t(n_inputs), inputs.begin());
    least_speed   = others[0];
    time          = others[1];
    stop_time     = others[2];
    mode          = static_cast<Mode>(static_cast<int>(others[3]));
    has_stop_time = others[4] != 0.;
    is_set_up     = others[5] != 0.;
  }

  Snapshot *Instance::kept(const std::string &function, const void *handle)
  {
    for (const auto &snapshot : snapshots)
      if (snapshot.get() == handle)
        return snapshot.get();
    refuse(function, "the instance has not kept this state");
    return nullptr;
  }

  Status Instance::keep(const std::string &function, void **handle)
  {
    if (!handle)
      return refuse(function, "the place of the state is NULL");
    if (*handle)
      {
        Snapshot *old = kept(function, *handle);
        if (!old)
          return Status::error;
        *old = to_keep();
        return Status::ok;
      }
    *handle =
      snapshots.insert(std::make_unique<Snapshot>(to_keep())).first->get();
    return Status::ok;
  }

  Status Instance::restore(const std::string &function, const void *handle)
  {
    const Snapshot *snapshot = kept(function, handle);
    if (!snapshot)
      return Status::error;
    state = *snapshot;
    return Status::ok;
  }

  Status Instance::forget(const std::string &function, void **handle)
  {
    if (!handle || !*handle)
      return Status::ok;
    if (!kept(function, *handle))
      return Status::error;
    for (auto at = snapshots.begin(); at != snapshots.end(); ++at)
      if (at->get() == *handle)
        {
          snapshots.erase(at);
          break;
        }
    *handle = nullptr;
    return Status::ok;
  }

  Status Instance::size_of_state(const std::string &function,
                                 const void        *handle,
                                 std::size_t       *size)
  {
    if (!size)
      return refuse(function, "the place of the size is NULL");
    if (!kept(function, handle))
      return Status::error;
    *size = bytes_of(*kept(function, handle)).size();
    return Status::ok;
  }

  Status Instance::serialise(const std::string &function,
                             const void        *handle,
                             char              *bytes,
                             const std::size_t  size)
  {
    const Snapshot *snapshot = kept(function, handle);
    if (!snapshot)
      return Status::error;
    const std::string all = bytes_of(*snapshot);
    if (!bytes || size < all.size())
      return refuse(function,
                    "a state takes " + std::to_string(all.size()) + " bytes");
    std::memcpy(bytes, all.data(), all.size());
    return Status::ok;
  }

  Status Instance::deserialise(const std::string &function,
                               const char        *bytes,
                               const std::size_t  size,
                               void             **handle)
  {
    if (!bytes || !handle)
      return refuse(function, "bytes or the place of the state are NULL");
    try
      {
        const std::string all(bytes, size);
        BytesIn           in(all);
        if (in.text() != mark_of_state || in.text() != token)
          throw std::invalid_argument("they are of another FMU");
        const double      sum  = in.number();
        const std::string rest = in.text();
        if (sum != check_sum(rest) || !in.at_end())
          throw std::invalid_argument("they were changed");
        *handle =
          snapshots.insert(std::make_unique<Snapshot>(Snapshot::of_bytes(rest)))
            .first->get();
      }
    catch (const std::invalid_argument &problem)
      {
        return refuse(function,
                      std::string("the bytes are not a state of this FMU: ") +
                        problem.what());
      }
    return Status::ok;
  }

  std::string Instance::bytes_of(const Snapshot &snapshot) const
  {
    const std::string all = snapshot.bytes();
    BytesOut          out;
    out.add(mark_of_state);
    out.add(token);
    out.add(check_sum(all));
    out.add(all);
    return out.all();
  }

  Snapshot Instance::to_keep() const
  {
    Snapshot now = state;
    if (!now.is_of_step) // what was looked at follows from the memory again
      now.found.reset();
    return now;
  }
} // namespace RollingContact::Fmu
