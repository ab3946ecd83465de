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
    const char mark_of_state[] = "rolling-contact state 1";
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

  Snapshot Snapshot::of_numbers(const std::array<double, n_numbers> &numbers)
  {
    for (const double number : numbers)
      if (!std::isfinite(number))
        throw std::invalid_argument("a number is not finite");
    const double *others = numbers.data() + n_inputs;
    const int     last   = static_cast<int>(Mode::terminated);
    if (!(numbers[friction] > 0. && others[0] > 0. && others[3] >= 0. &&
          others[3] <= last))
      throw std::invalid_argument("a number is none of a state");
    Snapshot found;
    std::copy_n(numbers.begin(), std::size_t(n_inputs), found.inputs.begin());
    found.least_speed   = others[0];
    found.time          = others[1];
    found.stop_time     = others[2];
    found.mode          = static_cast<Mode>(static_cast<int>(others[3]));
    found.has_stop_time = others[4] != 0.;
    found.is_set_up     = others[5] != 0.;
    return found;
  }

  Snapshot *Instance::kept(const std::string &function, const void *handle)
  {
    for (const auto &snapshot : snapshots)
      if (snapshot.get() == handle)
        return snapshot.get();
    refuse(function, "this state is none that the instance has kept");
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
        *old = state;
        return Status::ok;
      }
    *handle = snapshots.insert(std::make_unique<Snapshot>(state)).first->get();
    return Status::ok;
  }

  Status Instance::restore(const std::string &function, const void *handle)
  {
    const Snapshot *snapshot = kept(function, handle);
    if (!snapshot)
      return Status::error;
    state    = *snapshot;
    is_found = false;
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
    *size = sizeof(mark_of_state) + token.size() + sizeof(Snapshot().numbers());
    return Status::ok;
  }

  Status Instance::serialise(const std::string &function,
                             const void        *handle,
                             char              *bytes,
                             const std::size_t  size)
  {
    std::size_t needed = 0;
    if (size_of_state(function, handle, &needed) != Status::ok)
      return Status::error;
    if (!bytes || size < needed)
      return refuse(function,
                    "a state takes " + std::to_string(needed) + " bytes");
    std::memcpy(bytes, mark_of_state, sizeof(mark_of_state));
    std::memcpy(bytes + sizeof(mark_of_state), token.data(), token.size());
    const auto numbers = kept(function, handle)->numbers();
    std::memcpy(bytes + sizeof(mark_of_state) + token.size(),
                numbers.data(),
                sizeof(numbers));
    return Status::ok;
  }

  Status Instance::deserialise(const std::string &function,
                               const char        *bytes,
                               const std::size_t  size,
                               void             **handle)
  {
    const std::size_t head = sizeof(mark_of_state) + token.size();
    if (!bytes || !handle)
      return refuse(function, "bytes or the place of the state are NULL");
    std::array<double, Snapshot::n_numbers> numbers;
    if (size != head + sizeof(numbers) ||
        std::memcmp(bytes, mark_of_state, sizeof(mark_of_state)) != 0 ||
        std::memcmp(bytes + sizeof(mark_of_state),
                    token.data(),
                    token.size()) != 0)
      return refuse(function, "the bytes are no state of this FMU");
    std::memcpy(numbers.data(), bytes + head, sizeof(numbers));
    try
      {
        *handle =
          snapshots
            .insert(std::make_unique<Snapshot>(Snapshot::of_numbers(numbers)))
            .first->get();
      }
    catch (const std::invalid_argument &problem)
      {
        return refuse(function,
                      std::string("the bytes are no state: ") + problem.what());
      }
    return Status::ok;
  }
} // namespace RollingContact::Fmu
