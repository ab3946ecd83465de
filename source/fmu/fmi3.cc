#include <rolling_contact/fmu/face.h>
#include <rolling_contact/fmu/fmi2.h>
#include <rolling_contact/fmu/fmi3.h>

#include <algorithm>

using namespace RollingContact::Fmu;

#define FMI3 extern "C" ROLLING_CONTACT_FMI

namespace
{
  fmi3Status answer_3(const Status status)
  {
    return static_cast<fmi3Status>(static_cast<int>(status));
  }

  template <class What>
  fmi3Status
  call_3(fmi3Instance instance, const char *function, const What &what)
  {
    return answer_3(with(instance, function, what));
  }

  Logger logger_3(fmi3InstanceEnvironment environment,
                  fmi3LogMessageCallback  write)
  {
    if (!write)
      return {};
    return
      [=](const Status status, const char *category, const std::string &text) {
        write(environment, answer_3(status), category, text.c_str());
      };
  }

  fmi3Instance no_instance(fmi3InstanceEnvironment environment,
                           fmi3LogMessageCallback  write,
                           const char             *why)
  {
    if (const Logger logger = logger_3(environment, write))
      logger(Status::error, "logStatusError", why);
    return nullptr;
  }
} // namespace

FMI3 const char *fmi3GetVersion()
{
  return "3.0";
}

FMI3 fmi3Status fmi3SetDebugLogging(fmi3Instance      instance,
                                    fmi3Boolean       on,
                                    std::size_t       n,
                                    const fmi3String *categories)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    std::vector<std::string> wanted;
    if (n > 0 && !categories)
      return own.refuse(f, "the array of categories is NULL");
    for (std::size_t k = 0; k < n; ++k)
      wanted.push_back(text_of(categories[k]));
    return own.set_logging(on, wanted);
  });
}

FMI3 fmi3Instance
fmi3InstantiateModelExchange(fmi3String,
                             fmi3String,
                             fmi3String,
                             fmi3Boolean,
                             fmi3Boolean,
                             fmi3InstanceEnvironment environment,
                             fmi3LogMessageCallback  write)
{
  return no_instance(environment,
                     write,
                     "fmi3InstantiateModelExchange: this FMU is one of "
                     "co-simulation");
}

FMI3 fmi3Instance
fmi3InstantiateScheduledExecution(fmi3String,
                                  fmi3String,
                                  fmi3String,
                                  fmi3Boolean,
                                  fmi3Boolean,
                                  fmi3InstanceEnvironment environment,
                                  fmi3LogMessageCallback  write,
                                  fmi3ClockUpdateCallback,
                                  fmi3LockPreemptionCallback,
                                  fmi3UnlockPreemptionCallback)
{
  return no_instance(environment,
                     write,
                     "fmi3InstantiateScheduledExecution: this FMU is one of "
                     "co-simulation");
}

FMI3 fmi3Instance
fmi3InstantiateCoSimulation(fmi3String instance_name,
                            fmi3String token,
                            fmi3String resources,
                            fmi3Boolean,
                            fmi3Boolean logging_on,
                            fmi3Boolean event_mode_used,
                            fmi3Boolean,
                            const fmi3ValueReference *,
                            std::size_t             n_intermediate,
                            fmi3InstanceEnvironment environment,
                            fmi3LogMessageCallback  write,
                            fmi3IntermediateUpdateCallback)
{
  const std::string function = "fmi3InstantiateCoSimulation: ";
  try
    {
      const std::string name = text_of(instance_name);
      const char       *why  = name.empty()      ? "the instance has no name"
                               : event_mode_used ? "hasEventMode is false"
                               : n_intermediate > 0
                                 ? "providesIntermediateUpdate is false"
                                 : nullptr;
      if (why)
        return no_instance(environment, write, (function + why).c_str());
      auto made = Instance::make(name,
                                 text_of(token),
                                 folder_of(text_of(resources)),
                                 logger_3(environment, write));
      if (made)
        made->set_logging(logging_on, {});
      return made.release();
    }
  catch (const std::exception &)
    {
      return nullptr;
    }
}

FMI3 void fmi3FreeInstance(fmi3Instance instance)
{
  if (Instance::is_alive(instance))
    delete static_cast<Instance *>(instance);
}

FMI3 fmi3Status fmi3EnterInitializationMode(fmi3Instance instance,
                                            fmi3Boolean,
                                            fmi3Float64,
                                            fmi3Float64 start_time,
                                            fmi3Boolean has_stop_time,
                                            fmi3Float64 stop_time)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    const Status status = own.set_up(f, start_time, has_stop_time, stop_time);
    return status == Status::ok ? own.enter_initialisation(f, false) : status;
  });
}

FMI3 fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
  return call_3(instance, __func__, [f = __func__](Instance &own) {
    return own.exit_initialisation(f);
  });
}

FMI3 fmi3Status fmi3Terminate(fmi3Instance instance)
{
  return call_3(instance, __func__, [f = __func__](Instance &own) {
    return own.terminate(f);
  });
}

FMI3 fmi3Status fmi3Reset(fmi3Instance instance)
{
  return call_3(instance, __func__, [](Instance &own) { return own.reset(); });
}

FMI3 fmi3Status fmi3DoStep(fmi3Instance instance,
                           fmi3Float64  from,
                           fmi3Float64  size,
                           fmi3Boolean,
                           fmi3Boolean *event_handling_needed,
                           fmi3Boolean *terminate_simulation,
                           fmi3Boolean *early_return,
                           fmi3Float64 *last_successful_time)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    const Status status = own.step(f, from, size);
    for (fmi3Boolean *never :
         {event_handling_needed, terminate_simulation, early_return})
      if (never)
        *never = false;
    if (last_successful_time)
      *last_successful_time = own.now().time;
    return status;
  });
}

FMI3 fmi3Status fmi3GetFloat64(fmi3Instance              instance,
                               const fmi3ValueReference *references,
                               std::size_t               n,
                               fmi3Float64              *values,
                               std::size_t               n_values)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return n_values == n ? own.get(f, references, n, values)
                         : own.refuse(f, "nValues is not the number of values");
  });
}

FMI3 fmi3Status fmi3SetFloat64(fmi3Instance              instance,
                               const fmi3ValueReference *references,
                               std::size_t               n,
                               const fmi3Float64        *values,
                               std::size_t               n_values)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return n_values == n ? own.set(f, references, n, values)
                         : own.refuse(f, "nValues is not the number of values");
  });
}

FMI3 fmi3Status fmi3GetBoolean(fmi3Instance              instance,
                               const fmi3ValueReference *references,
                               std::size_t               n,
                               fmi3Boolean              *values,
                               std::size_t               n_values)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    if (n_values != n || (n > 0 && !values))
      return own.refuse(f, "an array is NULL or of another length");
    std::vector<bool> found;
    const Status      status = own.get(f, references, n, found);
    std::copy(found.begin(), found.end(), values);
    return status;
  });
}

FMI3 fmi3Status fmi3GetString(fmi3Instance              instance,
                              const fmi3ValueReference *references,
                              std::size_t               n,
                              fmi3String               *values,
                              std::size_t               n_values)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return n_values == n ? own.get(f, references, n, values)
                         : own.refuse(f, "nValues is not the number of values");
  });
}

FMI3 fmi3Status fmi3SetString(fmi3Instance              instance,
                              const fmi3ValueReference *references,
                              std::size_t               n,
                              const fmi3String         *values,
                              std::size_t               n_values)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return n_values == n ? own.set(f, references, n, values)
                         : own.refuse(f, "nValues is not the number of values");
  });
}

FMI3 fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *state)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.keep(f, state);
  });
}

FMI3 fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.restore(f, state);
  });
}

FMI3 fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *state)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.forget(f, state);
  });
}

FMI3 fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance,
                                           fmi3FMUState state,
                                           std::size_t *size)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.size_of_state(f, state, size);
  });
}

FMI3 fmi3Status fmi3SerializeFMUState(fmi3Instance instance,
                                      fmi3FMUState state,
                                      fmi3Byte    *bytes,
                                      std::size_t  size)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.serialise(f, state, reinterpret_cast<char *>(bytes), size);
  });
}

FMI3 fmi3Status fmi3DeserializeFMUState(fmi3Instance    instance,
                                        const fmi3Byte *bytes,
                                        std::size_t     size,
                                        fmi3FMUState   *state)
{
  return call_3(instance, __func__, [=, f = __func__](Instance &own) {
    return own.deserialise(f,
                           reinterpret_cast<const char *>(bytes),
                           size,
                           state);
  });
}
