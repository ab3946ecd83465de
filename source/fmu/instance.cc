#include <rolling_contact/fmu/instance.h>
#include <rolling_contact/fmu/resources.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    const double same_time = 1e-9; ///< relative, of points in time

    std::mutex alive_lock;

    std::set<const void *> &alive()
    {
      static std::set<const void *> all;
      return all;
    }

    const char *name_of(const Mode mode)
    {
      return mode == Mode::instantiated   ? "before initialisation"
             : mode == Mode::initialising ? "during initialisation"
             : mode == Mode::stepping     ? "between steps"
                                          : "after termination";
    }

    const char *category_of(const Status status)
    {
      return status == Status::warning   ? "logStatusWarning"
             : status == Status::discard ? "logStatusDiscard"
                                         : "logStatusError";
    }

  } // namespace

  Instance::Instance(const std::string &name, const Logger &logger)
    : name(name)
    , logger(logger)
  {
    const std::lock_guard<std::mutex> lock(alive_lock);
    alive().insert(this);
  }

  Instance::~Instance()
  {
    const std::lock_guard<std::mutex> lock(alive_lock);
    alive().erase(this);
  }

  bool Instance::is_alive(const void *instance)
  {
    const std::lock_guard<std::mutex> lock(alive_lock);
    return alive().count(instance) > 0;
  }

  std::unique_ptr<Instance> Instance::make(const std::string &name,
                                           const std::string &token,
                                           const std::string &resources,
                                           const Logger      &logger)
  {
    std::unique_ptr<Instance> made(new Instance(name, logger));
    const std::string         file = resources + '/' + token_file;
    try
      {
        const auto written = content_of(file);
        if (!written)
          throw std::invalid_argument(file + ": there is no such file");
        made->token = *written;
        if (made->token != token)
          {
            made->log(Status::error,
                      "the token (guid) of the caller, " + token +
                        ", is not that of the resources, " + made->token +
                        ": description and resources are of two FMUs");
            return nullptr;
          }
        made->model = ForceModel::of_folder(resources);
      }
    catch (const std::invalid_argument &problem)
      {
        made->log(Status::error, problem.what());
        return nullptr;
      }
    made->reset();
    return made;
  }

  void Instance::log(const Status status, const std::string &text)
  {
    const char *category = category_of(status);
    if (logger && logs &&
        (categories.empty() || categories.count(category) > 0))
      logger(status, category, text);
  }

  Status Instance::refuse(const std::string &function,
                          const std::string &why,
                          const Status       status)
  {
    log(status, function + ": " + why);
    return status;
  }

  bool Instance::is_in(const std::string                 &function,
                       const std::initializer_list<Mode> &modes)
  {
    if (std::find(modes.begin(), modes.end(), state.mode) != modes.end())
      return true;
    refuse(function, std::string("is not allowed ") + name_of(state.mode));
    return false;
  }

  Status Instance::set_logging(const bool                      on,
                               const std::vector<std::string> &wanted)
  {
    logs       = on;
    categories = {wanted.begin(), wanted.end()};
    if (categories.count("logAll") > 0)
      categories.clear();
    return Status::ok;
  }

  Status Instance::set_up(const std::string &function,
                          const double       start_time,
                          const bool         has_stop_time,
                          const double       stop_time)
  {
    if (!is_in(function, {Mode::instantiated}))
      return Status::error;
    if (!std::isfinite(start_time) ||
        (has_stop_time && !(stop_time >= start_time)))
      return refuse(function,
                    "the stop time " + std::to_string(stop_time) +
                      " is not behind the start time " +
                      std::to_string(start_time));
    state.time          = start_time;
    state.has_stop_time = has_stop_time;
    state.stop_time     = stop_time;
    state.is_set_up     = true;
    return Status::ok;
  }

  Status Instance::enter_initialisation(const std::string &function,
                                        const bool         needs_set_up)
  {
    if (!is_in(function, {Mode::instantiated}))
      return Status::error;
    if (needs_set_up && !state.is_set_up)
      return refuse(function, "fmi2SetupExperiment comes first");
    state.mode = Mode::initialising;
    return Status::ok;
  }

  Status Instance::exit_initialisation(const std::string &function)
  {
    if (!is_in(function, {Mode::initialising}))
      return Status::error;
    model->begin(state.program);
    state.mode = Mode::stepping;
    return Status::ok;
  }

  Status Instance::step(const std::string &function,
                        const double       from,
                        const double       size)
  {
    if (!is_in(function, {Mode::stepping}))
      return Status::error;
    const double to    = from + size,
                 close = same_time * std::max(1., std::abs(state.time));
    if (!(std::abs(from - state.time) <= close))
      return refuse(function,
                    "the step begins at " + std::to_string(from) +
                      " s, the last one ended at " +
                      std::to_string(state.time) + " s");
    if (!(size > 0.) || !std::isfinite(to))
      return refuse(function,
                    "a step of " + std::to_string(size) +
                      " s is not above 0 and finite");
    if (state.has_stop_time && to > state.stop_time + close)
      return refuse(function,
                    "the step ends at " + std::to_string(to) +
                      " s, beyond the stop time of " +
                      std::to_string(state.stop_time) + " s");
    try
      {
        outputs();
      }
    catch (const NoForces &none)
      {
        return refuse(function, none.what(), Status::discard);
      }
    state.time = to;
    if (!state.is_of_step)
      state.memory = reached;
    state.is_of_step = true;
    return Status::ok;
  }

  Status Instance::terminate(const std::string &function)
  {
    if (!is_in(function, {Mode::stepping}))
      return Status::error;
    state.mode = Mode::terminated;
    return Status::ok;
  }

  Status Instance::reset()
  {
    state        = Snapshot();
    state.inputs = model->wheelset.start;
    return Status::ok;
  }

  const Outputs &Instance::outputs()
  {
    if (!state.found)
      {
        ForceModel::Forces forces = model->forces(state.inputs,
                                                  state.least_speed,
                                                  state.memory,
                                                  state.program);
        reached                   = std::move(forces.memory);
        state.found               = forces.outputs;
        state.is_of_step          = false;
      }
    return *state.found;
  }
} // namespace RollingContact::Fmu
