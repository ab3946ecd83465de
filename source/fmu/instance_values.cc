#include <rolling_contact/fmu/instance.h>

#include <cmath>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    const char *name_of(const VariableType type)
    {
      return type == VariableType::real      ? "a real number"
             : type == VariableType::boolean ? "a boolean"
                                             : "a string";
    }
  } // namespace

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
          return model->wheelset.radius;
        case Source::tape_circle:
          return model->wheelset.tape_circle;
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
        const Variable *variable = find(references[k]);
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
      values[k] = value_of(*find(references[k]));
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
      values.push_back(value_of(*find(references[k])) != 0.);
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
      values[k] = find(references[k])->source != Source::program ? model_name
                  : state.program.empty() ? model->known_program.c_str()
                                          : state.program.c_str();
    return Status::ok;
  }

  std::string Instance::why_not_set(const Variable &variable) const
  {
    if (!variable.is_set_by_importer())
      return "is not set from outside";
    if (variable.causality == Causality::parameter &&
        state.mode == Mode::stepping)
      return "is fixed after initialisation";
    return "";
  }

  bool Instance::may_set(const std::string &function,
                         const Variable    &variable,
                         const double       value)
  {
    std::string why = why_not_set(variable);
    if (!why.empty())
      ;
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
      if (!may_set(function, *find(references[k]), values[k]))
        return Status::error;
    for (std::size_t k = 0; k < n; ++k)
      {
        const Variable &variable = *find(references[k]);
        double         &now      = variable.source == Source::input
                                     ? state.inputs[variable.number]
                                     : state.least_speed;
        if (now != values[k])
          state.found.reset();
        now = values[k];
      }
    return Status::ok;
  }

  Status Instance::set(const std::string  &function,
                       const unsigned int *references,
                       const std::size_t   n,
                       const char *const  *values)
  {
    if (!is_in(function,
               {Mode::instantiated, Mode::initialising, Mode::stepping}) ||
        !are_of_type(function, references, n, values, VariableType::text))
      return Status::error;
    for (std::size_t k = 0; k < n; ++k)
      {
        const Variable   &variable = *find(references[k]);
        const std::string why      = why_not_set(variable);
        if (!why.empty() || !values[k])
          return refuse(function,
                        variable.name + ' ' +
                          (why.empty() ? "takes a text, not NULL" : why));
      }
    for (std::size_t k = 0; k < n; ++k)
      state.program = values[k];
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
