#include <rolling_contact/fmu/face.h>
#include <rolling_contact/fmu/fmi2.h>

using namespace RollingContact::Fmu;

#define FMI2 extern "C" ROLLING_CONTACT_FMI

namespace
{
  const char at_once[] =
    "steps are done when fmi2DoStep returns: nothing is pending";

  fmi2Status refuse_step(fmi2Component c, const char *function, const char *why)
  {
    return static_cast<fmi2Status>(static_cast<int>(refused(c, function, why)));
  }
} // namespace

FMI2 fmi2Status fmi2SetRealInputDerivatives(fmi2Component c,
                                            const fmi2ValueReference *,
                                            std::size_t,
                                            const fmi2Integer *,
                                            const fmi2Real *)
{
  return refuse_step(c, __func__, "canInterpolateInputs is false");
}

FMI2 fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c,
                                             const fmi2ValueReference *,
                                             std::size_t,
                                             const fmi2Integer *,
                                             fmi2Real *)
{
  return refuse_step(c, __func__, "maxOutputDerivativeOrder is 0");
}

FMI2 fmi2Status fmi2DoStep(fmi2Component c,
                           fmi2Real      from,
                           fmi2Real      size,
                           fmi2Boolean)
{
  return static_cast<fmi2Status>(
    static_cast<int>(with(c, __func__, [=, f = __func__](Instance &own) {
      return own.step(f, from, size);
    })));
}

FMI2 fmi2Status fmi2CancelStep(fmi2Component c)
{
  return refuse_step(c, __func__, at_once);
}

FMI2 fmi2Status fmi2GetStatus(fmi2Component c,
                              const fmi2StatusKind,
                              fmi2Status *)
{
  return refuse_step(c, __func__, at_once);
}

FMI2 fmi2Status fmi2GetRealStatus(fmi2Component        c,
                                  const fmi2StatusKind kind,
                                  fmi2Real            *value)
{
  return static_cast<fmi2Status>(
    static_cast<int>(with(c, __func__, [=, f = __func__](Instance &own) {
      if (kind != fmi2LastSuccessfulTime || !value)
        return own.refuse(f,
                          "answers fmi2LastSuccessfulTime only, and needs "
                          "a pointer to write to");
      *value = own.now().time;
      return Status::ok;
    })));
}

FMI2 fmi2Status fmi2GetIntegerStatus(fmi2Component c,
                                     const fmi2StatusKind,
                                     fmi2Integer *)
{
  return refuse_step(c, __func__, "there is no such status");
}

FMI2 fmi2Status fmi2GetBooleanStatus(fmi2Component        c,
                                     const fmi2StatusKind kind,
                                     fmi2Boolean         *value)
{
  return static_cast<fmi2Status>(
    static_cast<int>(with(c, __func__, [=, f = __func__](Instance &own) {
      if (kind != fmi2Terminated || !value)
        return own.refuse(f,
                          "answers fmi2Terminated only, and needs a "
                          "pointer to write to");
      *value = 0; // it never ends by itself
      return Status::ok;
    })));
}

FMI2 fmi2Status fmi2GetStringStatus(fmi2Component c,
                                    const fmi2StatusKind,
                                    fmi2String *)
{
  return refuse_step(c, __func__, at_once);
}
