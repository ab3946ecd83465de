#include <rolling_contact/fmu/face.h>
#include <rolling_contact/fmu/fmi2.h>
#include <rolling_contact/fmu/fmi3.h>

using namespace RollingContact::Fmu;

#define FMI3 extern "C" ROLLING_CONTACT_FMI

/** No variable is of this type: nothing can be got or set. */
#define FMI3_NONE_OF(type)                                            \
  FMI3 fmi3Status fmi3Get##type(fmi3Instance              instance,   \
                                const fmi3ValueReference *references, \
                                std::size_t               n,          \
                                fmi3##type *,                         \
                                std::size_t)                          \
  {                                                                   \
    return none_of(instance, __func__, references, n, #type);         \
  }                                                                   \
  FMI3 fmi3Status fmi3Set##type(fmi3Instance              instance,   \
                                const fmi3ValueReference *references, \
                                std::size_t               n,          \
                                const fmi3##type *,                   \
                                std::size_t)                          \
  {                                                                   \
    return none_of(instance, __func__, references, n, #type);         \
  }

namespace
{
  fmi3Status none_of(fmi3Instance              instance,
                     const char               *function,
                     const fmi3ValueReference *references,
                     const std::size_t         n,
                     const char               *type)
  {
    return static_cast<fmi3Status>(
      static_cast<int>(with(instance, function, [=](Instance &own) {
        return own.none_of_type(function,
                                references,
                                n,
                                std::string("of type ") + type);
      })));
  }

  fmi3Status
  refuse_3(fmi3Instance instance, const char *function, const char *why)
  {
    return static_cast<fmi3Status>(
      static_cast<int>(refused(instance, function, why)));
  }

  const char no_events[] = "hasEventMode is false",
             no_clocks[] = "there are no clocks",
             no_model_exchange[] =
               "is a function of model exchange; this FMU is one of "
               "co-simulation";
} // namespace

FMI3_NONE_OF(Float32)
FMI3_NONE_OF(Int8)
FMI3_NONE_OF(UInt8)
FMI3_NONE_OF(Int16)
FMI3_NONE_OF(UInt16)
FMI3_NONE_OF(Int32)
FMI3_NONE_OF(UInt32)
FMI3_NONE_OF(Int64)
FMI3_NONE_OF(UInt64)

FMI3 fmi3Status fmi3SetBoolean(fmi3Instance              instance,
                               const fmi3ValueReference *references,
                               std::size_t               n,
                               const fmi3Boolean *,
                               std::size_t)
{
  return none_of(instance, __func__, references, n, "Boolean");
}

FMI3 fmi3Status fmi3SetString(fmi3Instance              instance,
                              const fmi3ValueReference *references,
                              std::size_t               n,
                              const fmi3String *,
                              std::size_t)
{
  return none_of(instance, __func__, references, n, "String");
}

FMI3 fmi3Status fmi3GetBinary(fmi3Instance              instance,
                              const fmi3ValueReference *references,
                              std::size_t               n,
                              std::size_t *,
                              fmi3Binary *,
                              std::size_t)
{
  return none_of(instance, __func__, references, n, "Binary");
}

FMI3 fmi3Status fmi3SetBinary(fmi3Instance              instance,
                              const fmi3ValueReference *references,
                              std::size_t               n,
                              const std::size_t *,
                              const fmi3Binary *,
                              std::size_t)
{
  return none_of(instance, __func__, references, n, "Binary");
}

FMI3 fmi3Status fmi3GetClock(fmi3Instance              instance,
                             const fmi3ValueReference *references,
                             std::size_t               n,
                             fmi3Clock *)
{
  return none_of(instance, __func__, references, n, "Clock");
}

FMI3 fmi3Status fmi3SetClock(fmi3Instance              instance,
                             const fmi3ValueReference *references,
                             std::size_t               n,
                             const fmi3Clock *)
{
  return none_of(instance, __func__, references, n, "Clock");
}

FMI3 fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance,
                                                    fmi3ValueReference,
                                                    std::size_t *)
{
  return refuse_3(instance,
                  __func__,
                  "providesPerElementDependencies is false");
}

FMI3 fmi3Status fmi3GetVariableDependencies(fmi3Instance instance,
                                            fmi3ValueReference,
                                            std::size_t *,
                                            fmi3ValueReference *,
                                            std::size_t *,
                                            fmi3DependencyKind *,
                                            std::size_t)
{
  return refuse_3(instance,
                  __func__,
                  "providesPerElementDependencies is false");
}

FMI3 fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance,
                                             const fmi3ValueReference *,
                                             std::size_t,
                                             const fmi3ValueReference *,
                                             std::size_t,
                                             const fmi3Float64 *,
                                             std::size_t,
                                             fmi3Float64 *,
                                             std::size_t)
{
  return refuse_3(instance,
                  __func__,
                  "providesDirectionalDerivatives is false");
}

FMI3 fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance,
                                         const fmi3ValueReference *,
                                         std::size_t,
                                         const fmi3ValueReference *,
                                         std::size_t,
                                         const fmi3Float64 *,
                                         std::size_t,
                                         fmi3Float64 *,
                                         std::size_t)
{
  return refuse_3(instance, __func__, "providesAdjointDerivatives is false");
}

FMI3 fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance)
{
  return refuse_3(instance, __func__, "there are no structural parameters");
}

FMI3 fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance)
{
  return refuse_3(instance, __func__, "there are no structural parameters");
}

FMI3 fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance,
                                       const fmi3ValueReference *,
                                       std::size_t,
                                       fmi3Float64 *,
                                       fmi3IntervalQualifier *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3GetIntervalFraction(fmi3Instance instance,
                                        const fmi3ValueReference *,
                                        std::size_t,
                                        fmi3UInt64 *,
                                        fmi3UInt64 *,
                                        fmi3IntervalQualifier *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3GetShiftDecimal(fmi3Instance instance,
                                    const fmi3ValueReference *,
                                    std::size_t,
                                    fmi3Float64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3GetShiftFraction(fmi3Instance instance,
                                     const fmi3ValueReference *,
                                     std::size_t,
                                     fmi3UInt64 *,
                                     fmi3UInt64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance,
                                       const fmi3ValueReference *,
                                       std::size_t,
                                       const fmi3Float64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3SetIntervalFraction(fmi3Instance instance,
                                        const fmi3ValueReference *,
                                        std::size_t,
                                        const fmi3UInt64 *,
                                        const fmi3UInt64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3SetShiftDecimal(fmi3Instance instance,
                                    const fmi3ValueReference *,
                                    std::size_t,
                                    const fmi3Float64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3SetShiftFraction(fmi3Instance instance,
                                     const fmi3ValueReference *,
                                     std::size_t,
                                     const fmi3UInt64 *,
                                     const fmi3UInt64 *)
{
  return refuse_3(instance, __func__, no_clocks);
}

FMI3 fmi3Status fmi3EnterEventMode(fmi3Instance instance)
{
  return refuse_3(instance, __func__, no_events);
}

FMI3 fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance)
{
  return refuse_3(instance, __func__, no_events);
}

FMI3 fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance,
                                         fmi3Boolean *,
                                         fmi3Boolean *,
                                         fmi3Boolean *,
                                         fmi3Boolean *,
                                         fmi3Boolean *,
                                         fmi3Float64 *)
{
  return refuse_3(instance, __func__, no_events);
}

FMI3 fmi3Status fmi3EnterStepMode(fmi3Instance instance)
{
  return refuse_3(instance, __func__, no_events);
}

FMI3 fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance,
                                            fmi3Boolean,
                                            fmi3Boolean *,
                                            fmi3Boolean *)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3SetContinuousStates(fmi3Instance instance,
                                        const fmi3Float64 *,
                                        std::size_t)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance,
                                                  fmi3Float64 *,
                                                  std::size_t)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetEventIndicators(fmi3Instance instance,
                                       fmi3Float64 *,
                                       std::size_t)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetContinuousStates(fmi3Instance instance,
                                        fmi3Float64 *,
                                        std::size_t)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance,
                                                  fmi3Float64 *,
                                                  std::size_t)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance,
                                               std::size_t *)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance,
                                                std::size_t *)
{
  return refuse_3(instance, __func__, no_model_exchange);
}

FMI3 fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance,
                                         const fmi3ValueReference *,
                                         std::size_t,
                                         const fmi3Int32 *,
                                         fmi3Float64 *,
                                         std::size_t)
{
  return refuse_3(instance, __func__, "maxOutputDerivativeOrder is 0");
}

FMI3 fmi3Status fmi3ActivateModelPartition(fmi3Instance instance,
                                           fmi3ValueReference,
                                           fmi3Float64)
{
  return refuse_3(instance, __func__, no_clocks);
}
