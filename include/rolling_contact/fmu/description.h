#ifndef rolling_contact_fmu_description_h
#define rolling_contact_fmu_description_h

#include <rolling_contact/fmu/variables.h>

namespace RollingContact::Fmu
{
  /** What a description says besides the variables. */
  struct DescriptionText
  {
    ForceKind   kind = ForceKind::table;
    std::string title;         ///< of the model, one line
    std::string version;       ///< of the program
    std::string token;         ///< guid, instantiation token
    double      step   = 1e-3; ///< that is proposed, s
    Inputs      start  = {};
    double      radius = 0., tape_circle = 0.;
    std::string program; ///< that solves the states, its path
  };

  /** modelDescription.xml of an FMU 2.0. */
  std::string description_2(const DescriptionText &text);

  /** modelDescription.xml of an FMU 3.0. */
  std::string description_3(const DescriptionText &text);

  /**
   * 32 digits in the form of a guid that follow from some bytes (FNV-1a,
   * twice): the same bytes have the same one.
   */
  std::string token_of(const std::string &bytes);
} // namespace RollingContact::Fmu

#endif
