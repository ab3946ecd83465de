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

/** A function that does not apply: @p arguments in parentheses. */
#define FMI3_REFUSED(function, why, arguments) \
  FMI3 fmi3Status function arguments           \
  {                                            \
    return refuse_3(instance, __func__, why);  \
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

FMI3_REFUSED(fmi3GetNumberOfVariableDependencies,
             "providesPerElementDependencies is false",
             (fmi3Instance instance, fmi3ValueReference, std::size_t *))
FMI3_REFUSED(fmi3GetVariableDependencies,
             "providesPerElementDependencies is false",
             (fmi3Instance instance,
              fmi3ValueReference,
              std::size_t *,
              fmi3ValueReference *,
              std::size_t *,
              fmi3DependencyKind *,
              std::size_t))
FMI3_REFUSED(fmi3GetDirectionalDerivative,
             "providesDirectionalDerivatives is false",
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3Float64 *,
              std::size_t,
              fmi3Float64 *,
              std::size_t))
FMI3_REFUSED(fmi3GetAdjointDerivative,
             "providesAdjointDerivatives is false",
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3Float64 *,
              std::size_t,
              fmi3Float64 *,
              std::size_t))
FMI3_REFUSED(fmi3EnterConfigurationMode,
             "there are no structural parameters",
             (fmi3Instance instance))
FMI3_REFUSED(fmi3ExitConfigurationMode,
             "there are no structural parameters",
             (fmi3Instance instance))
FMI3_REFUSED(fmi3GetIntervalDecimal,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              fmi3Float64 *,
              fmi3IntervalQualifier *))
FMI3_REFUSED(fmi3GetIntervalFraction,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              fmi3UInt64 *,
              fmi3UInt64 *,
              fmi3IntervalQualifier *))
FMI3_REFUSED(fmi3GetShiftDecimal,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              fmi3Float64 *))
FMI3_REFUSED(fmi3GetShiftFraction,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              fmi3UInt64 *,
              fmi3UInt64 *))
FMI3_REFUSED(fmi3SetIntervalDecimal,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3Float64 *))
FMI3_REFUSED(fmi3SetIntervalFraction,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3UInt64 *,
              const fmi3UInt64 *))
FMI3_REFUSED(fmi3SetShiftDecimal,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3Float64 *))
FMI3_REFUSED(fmi3SetShiftFraction,
             no_clocks,
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3UInt64 *,
              const fmi3UInt64 *))
FMI3_REFUSED(fmi3EnterEventMode, no_events, (fmi3Instance instance))
FMI3_REFUSED(fmi3EvaluateDiscreteStates, no_events, (fmi3Instance instance))
FMI3_REFUSED(fmi3UpdateDiscreteStates,
             no_events,
             (fmi3Instance instance,
              fmi3Boolean *,
              fmi3Boolean *,
              fmi3Boolean *,
              fmi3Boolean *,
              fmi3Boolean *,
              fmi3Float64 *))
FMI3_REFUSED(fmi3EnterStepMode, no_events, (fmi3Instance instance))
FMI3_REFUSED(fmi3EnterContinuousTimeMode,
             no_model_exchange,
             (fmi3Instance instance))
FMI3_REFUSED(fmi3CompletedIntegratorStep,
             no_model_exchange,
             (fmi3Instance instance, fmi3Boolean, fmi3Boolean *, fmi3Boolean *))
FMI3_REFUSED(fmi3SetTime,
             no_model_exchange,
             (fmi3Instance instance, fmi3Float64))
FMI3_REFUSED(fmi3SetContinuousStates,
             no_model_exchange,
             (fmi3Instance instance, const fmi3Float64 *, std::size_t))
FMI3_REFUSED(fmi3GetContinuousStateDerivatives,
             no_model_exchange,
             (fmi3Instance instance, fmi3Float64 *, std::size_t))
FMI3_REFUSED(fmi3GetEventIndicators,
             no_model_exchange,
             (fmi3Instance instance, fmi3Float64 *, std::size_t))
FMI3_REFUSED(fmi3GetContinuousStates,
             no_model_exchange,
             (fmi3Instance instance, fmi3Float64 *, std::size_t))
FMI3_REFUSED(fmi3GetNominalsOfContinuousStates,
             no_model_exchange,
             (fmi3Instance instance, fmi3Float64 *, std::size_t))
FMI3_REFUSED(fmi3GetNumberOfEventIndicators,
             no_model_exchange,
             (fmi3Instance instance, std::size_t *))
FMI3_REFUSED(fmi3GetNumberOfContinuousStates,
             no_model_exchange,
             (fmi3Instance instance, std::size_t *))
FMI3_REFUSED(fmi3GetOutputDerivatives,
             "maxOutputDerivativeOrder is 0",
             (fmi3Instance instance,
              const fmi3ValueReference *,
              std::size_t,
              const fmi3Int32 *,
              fmi3Float64 *,
              std::size_t))
FMI3_REFUSED(fmi3ActivateModelPartition,
             no_clocks,
             (fmi3Instance instance, fmi3ValueReference, fmi3Float64))
