#include <rolling_contact/fmu/instance.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
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

    /** The content of a file; throws std::invalid_argument without. */
    std::string content_of(const std::string &file)
    {
      std::ifstream in(file, std::ios::binary);
      if (!in)
        throw std::invalid_argument("there is no such file");
      return {std::istreambuf_iterator<char>(in), {}};
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
      return status == Status::warning ? "logStatusWarning" : "logStatusError";
    }

    const char *name_of(const VariableType type)
    {
      return type == VariableType::real      ? "a real number"
             : type == VariableType::boolean ? "a boolean"
                                             : "a string";
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
    std::string               file = resources + '/' + token_file;
    try
      {
        made->token = content_of(file);
        if (made->token != token)
          {
            made->log(Status::error,
                      "the token (guid) of the caller, " + token +
                        ", is not that of the resources, " + made->token +
                        ": description and resources are of two FMUs");
            return nullptr;
          }
        file        = resources + '/' + table_file;
        made->model = WheelsetModel::of_bytes(content_of(file));
      }
    catch (const std::invalid_argument &problem)
      {
        made->log(Status::error, file + ": " + problem.what());
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

  Status Instance::refuse(const std::string &function, const std::string &why)
  {
    log(Status::error, function + ": " + why);
    return Status::error;
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
                    "a step of " + std::to_string(size) + " s is none");
    if (state.has_stop_time && to > state.stop_time + close)
      return refuse(function,
                    "the step ends at " + std::to_string(to) +
                      " s, beyond the stop time of " +
                      std::to_string(state.stop_time) + " s");
    state.time = to;
    outputs();
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
    state.inputs = model.start;
    is_found     = false;
    return Status::ok;
  }

  const Outputs &Instance::outputs()
  {
    if (!is_found)
      found = model.evaluate(state.inputs, state.least_speed);
    is_found = true;
    return found;
  }

  double Instance::value_of(const Variable &variable)
  {
    switch (variable.source)
      {
        case Source::time:
          return state.time;
        case Source::input:
          return state.inputs[variable.number];
        case Source::least_speed:
          return state.least_speed;
        case Source::radius:
          return model.radius;
        case Source::tape_circle:
          return model.tape_circle;
        case Source::roll:
          return outputs().roll;
        default:
          break;
      }
    const WheelOutputs &wheel = outputs().wheels[variable.wheel];
    return variable.source == Source::quantity ? wheel.values[variable.number]
           : variable.source == Source::inside ? wheel.inside
                                               : wheel.force_ratio;
  }

  bool Instance::are_of_type(const std::string  &function,
                             const unsigned int *references,
                             const std::size_t   n,
                             const void         *values,
                             const VariableType  type)
  {
    if (n > 0 && (!references || !values))
      {
        refuse(function, "an array is NULL");
        return false;
      }
    for (std::size_t k = 0; k < n; ++k)
      {
        const Variable *variable = find_variable(references[k]);
        if (variable && variable->type == type)
          continue;
        refuse(function,
               "no variable that is " + std::string(name_of(type)) +
                 " has the reference " + std::to_string(references[k]));
        return false;
      }
    return true;
  }

  bool Instance::may_get(const std::string &function)
  {
    return is_in(function,
                 {Mode::initialising, Mode::stepping, Mode::terminated});
  }

  Status Instance::get(const std::string  &function,
                       const unsigned int *references,
                       const std::size_t   n,
                       double             *values)
  {
    if (!may_get(function) ||
        !are_of_type(function, references, n, values, VariableType::real))
      return Status::error;
    for (std::size_t k = 0; k < n; ++k)
      values[k] = value_of(*find_variable(references[k]));
    return Status::ok;
  }

  Status Instance::get(const std::string  &function,
                       const unsigned int *references,
                       const std::size_t   n,
                       std::vector<bool>  &values)
  {
    if (!may_get(function) ||
        !are_of_type(function, references, n, &values, VariableType::boolean))
      return Status::error;
    values.clear();
    for (std::size_t k = 0; k < n; ++k)
      values.push_back(value_of(*find_variable(references[k])) != 0.);
    return Status::ok;
  }

  Status Instance::get(const std::string  &function,
                       const unsigned int *references,
                       const std::size_t   n,
                       const char        **values)
  {
    if (!may_get(function) ||
        !are_of_type(function, references, n, values, VariableType::text))
      return Status::error;
    for (std::size_t k = 0; k < n; ++k)
      values[k] = model_name;
    return Status::ok;
  }

  bool Instance::may_set(const std::string &function,
                         const Variable    &variable,
                         const double       value)
  {
    std::string why;
    if (!variable.is_set_by_importer())
      why = "is not set from outside";
    else if (variable.causality == Causality::parameter &&
             state.mode == Mode::stepping)
      why = "is fixed after initialisation";
    else if (!std::isfinite(value))
      why = "takes finite numbers only";
    else if ((variable.source == Source::least_speed ||
              (variable.source == Source::input &&
               variable.number == friction)) &&
             !(value > 0.))
      why = "takes numbers above 0, not " + std::to_string(value);
    if (!why.empty())
      refuse(function, variable.name + ' ' + why);
    return why.empty();
  }

  Status Instance::set(const std::string  &function,
                       const unsigned int *references,
                       const std::size_t   n,
                       const double       *values)
  {
    if (!is_in(function,
               {Mode::instantiated, Mode::initialising, Mode::stepping}) ||
        !are_of_type(function, references, n, values, VariableType::real))
      return Status::error;
    // all of them or none
    for (std::size_t k = 0; k < n; ++k)
      if (!may_set(function, *find_variable(references[k]), values[k]))
        return Status::error;
    for (std::size_t k = 0; k < n; ++k)
      {
        const Variable &variable = *find_variable(references[k]);
        (variable.source == Source::input ? state.inputs[variable.number]
                                          : state.least_speed) = values[k];
      }
    is_found = is_found && n == 0;
    return Status::ok;
  }

  Status Instance::none_of_type(const std::string  &function,
                                const unsigned int *references,
                                const std::size_t   n,
                                const std::string  &type)
  {
    if (n == 0)
      return Status::ok;
    return refuse(function,
                  "no variable that is " + type +
                    (references
                       ? " has the reference " + std::to_string(references[0])
                       : " is there") +
                    ", or it cannot be set");
  }
} // namespace RollingContact::Fmu
