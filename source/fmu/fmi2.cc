#include <rolling_contact/fmu/face.h>
#include <rolling_contact/fmu/fmi2.h>

#include <algorithm>

using namespace RollingContact::Fmu;

#define FMI2 extern "C" ROLLING_CONTACT_FMI

namespace
{
  fmi2Status answer(const Status status)
  {
    return static_cast<fmi2Status>(static_cast<int>(status));
  }

  const char of_model_exchange[] =
    "is a function of model exchange; this FMU is one of co-simulation";

  /** Messages for the caller; texts are no formats. */
  Logger logger_for(const std::string           &name,
                    const fmi2CallbackFunctions &functions)
  {
    const auto write       = functions.logger;
    const auto environment = functions.componentEnvironment;
    if (!write)
      return {};
    return
      [=](const Status status, const char *category, const std::string &text) {
        write(environment,
              name.c_str(),
              answer(status),
              category,
              "%s",
              text.c_str());
      };
  }

  template <class What>
  fmi2Status
  of_instance(fmi2Component c, const char *function, const What &what)
  {
    return answer(with(c, function, what));
  }

  fmi2Status refuse(fmi2Component c, const char *function, const char *why)
  {
    return answer(refused(c, function, why));
  }
} // namespace

FMI2 const char *fmi2GetTypesPlatform()
{
  return "default";
}

FMI2 const char *fmi2GetVersion()
{
  return "2.0";
}

FMI2 fmi2Status fmi2SetDebugLogging(fmi2Component     c,
                                    fmi2Boolean       on,
                                    std::size_t       n,
                                    const fmi2String *categories)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    std::vector<std::string> wanted;
    if (n > 0 && !categories)
      return own.refuse(f, "the array of categories is NULL");
    for (std::size_t k = 0; k < n; ++k)
      wanted.push_back(text_of(categories[k]));
    return own.set_logging(on != 0, wanted);
  });
}

FMI2 fmi2Component fmi2Instantiate(fmi2String                   instance_name,
                                   fmi2Type                     type,
                                   fmi2String                   guid,
                                   fmi2String                   resources,
                                   const fmi2CallbackFunctions *functions,
                                   fmi2Boolean,
                                   fmi2Boolean logging_on)
{
  if (!functions)
    return nullptr;
  try
    {
      const std::string name   = text_of(instance_name);
      const Logger      logger = logger_for(name, *functions);
      const auto        refuse = [&](const char *why) {
        if (logger)
          logger(Status::error, "logStatusError", why);
        return nullptr;
      };
      if (name.empty())
        return refuse("fmi2Instantiate: the instance has no name");
      if (type != fmi2CoSimulation)
        return refuse("fmi2Instantiate: this FMU is one of co-simulation");
      auto made = Instance::make(name,
                                 text_of(guid),
                                 folder_of(text_of(resources)),
                                 logger);
      if (made)
        made->set_logging(logging_on != 0, {});
      return made.release();
    }
  catch (const std::exception &)
    {
      return nullptr;
    }
}

FMI2 void fmi2FreeInstance(fmi2Component c)
{
  if (Instance::is_alive(c))
    delete static_cast<Instance *>(c);
}

FMI2 fmi2Status fmi2SetupExperiment(fmi2Component c,
                                    fmi2Boolean,
                                    fmi2Real,
                                    fmi2Real    start_time,
                                    fmi2Boolean has_stop_time,
                                    fmi2Real    stop_time)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.set_up(f, start_time, has_stop_time != 0, stop_time);
  });
}

FMI2 fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
  return of_instance(c, __func__, [f = __func__](Instance &own) {
    return own.enter_initialisation(f, true);
  });
}

FMI2 fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
  return of_instance(c, __func__, [f = __func__](Instance &own) {
    return own.exit_initialisation(f);
  });
}

FMI2 fmi2Status fmi2Terminate(fmi2Component c)
{
  return of_instance(c, __func__, [f = __func__](Instance &own) {
    return own.terminate(f);
  });
}

FMI2 fmi2Status fmi2Reset(fmi2Component c)
{
  return of_instance(c, __func__, [](Instance &own) { return own.reset(); });
}

FMI2 fmi2Status fmi2GetReal(fmi2Component             c,
                            const fmi2ValueReference *references,
                            std::size_t               n,
                            fmi2Real                 *values)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.get(f, references, n, values);
  });
}

FMI2 fmi2Status fmi2GetInteger(fmi2Component             c,
                               const fmi2ValueReference *references,
                               std::size_t               n,
                               fmi2Integer *)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.none_of_type(f, references, n, "an integer");
  });
}

FMI2 fmi2Status fmi2GetBoolean(fmi2Component             c,
                               const fmi2ValueReference *references,
                               std::size_t               n,
                               fmi2Boolean              *values)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    if (n > 0 && !values)
      return own.refuse(f, "an array is NULL");
    std::vector<bool> found;
    const Status      status = own.get(f, references, n, found);
    std::copy(found.begin(), found.end(), values);
    return status;
  });
}

FMI2 fmi2Status fmi2GetString(fmi2Component             c,
                              const fmi2ValueReference *references,
                              std::size_t               n,
                              fmi2String               *values)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.get(f, references, n, values);
  });
}

FMI2 fmi2Status fmi2SetReal(fmi2Component             c,
                            const fmi2ValueReference *references,
                            std::size_t               n,
                            const fmi2Real           *values)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.set(f, references, n, values);
  });
}

FMI2 fmi2Status fmi2SetInteger(fmi2Component             c,
                               const fmi2ValueReference *references,
                               std::size_t               n,
                               const fmi2Integer *)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.none_of_type(f, references, n, "an integer");
  });
}

FMI2 fmi2Status fmi2SetBoolean(fmi2Component             c,
                               const fmi2ValueReference *references,
                               std::size_t               n,
                               const fmi2Boolean *)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.none_of_type(f, references, n, "a boolean");
  });
}

FMI2 fmi2Status fmi2SetString(fmi2Component             c,
                              const fmi2ValueReference *references,
                              std::size_t               n,
                              const fmi2String         *values)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.set(f, references, n, values);
  });
}

FMI2 fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.keep(f, state);
  });
}

FMI2 fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.restore(f, state);
  });
}

FMI2 fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.forget(f, state);
  });
}

FMI2 fmi2Status fmi2SerializedFMUstateSize(fmi2Component c,
                                           fmi2FMUstate  state,
                                           std::size_t  *size)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.size_of_state(f, state, size);
  });
}

FMI2 fmi2Status fmi2SerializeFMUstate(fmi2Component c,
                                      fmi2FMUstate  state,
                                      fmi2Byte     *bytes,
                                      std::size_t   size)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.serialise(f, state, bytes, size);
  });
}

FMI2 fmi2Status fmi2DeSerializeFMUstate(fmi2Component   c,
                                        const fmi2Byte *bytes,
                                        std::size_t     size,
                                        fmi2FMUstate   *state)
{
  return of_instance(c, __func__, [=, f = __func__](Instance &own) {
    return own.deserialise(f, bytes, size, state);
  });
}

FMI2 fmi2Status fmi2GetDirectionalDerivative(fmi2Component c,
                                             const fmi2ValueReference *,
                                             std::size_t,
                                             const fmi2ValueReference *,
                                             std::size_t,
                                             const fmi2Real *,
                                             fmi2Real *)
{
  return refuse(c, __func__, "providesDirectionalDerivative is false");
}

FMI2 fmi2Status fmi2EnterEventMode(fmi2Component c)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2CompletedIntegratorStep(fmi2Component c,
                                            fmi2Boolean,
                                            fmi2Boolean *,
                                            fmi2Boolean *)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2SetTime(fmi2Component c, fmi2Real)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2SetContinuousStates(fmi2Component c,
                                        const fmi2Real *,
                                        std::size_t)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real *, std::size_t)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real *, std::size_t)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2GetContinuousStates(fmi2Component c,
                                        fmi2Real *,
                                        std::size_t)
{
  return refuse(c, __func__, of_model_exchange);
}

FMI2 fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c,
                                                  fmi2Real *,
                                                  std::size_t)
{
  return refuse(c, __func__, of_model_exchange);
}
