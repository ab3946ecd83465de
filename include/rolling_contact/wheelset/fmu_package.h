#ifndef rolling_contact_wheelset_fmu_package_h
#define rolling_contact_wheelset_fmu_package_h

#include <rolling_contact/fmu/wheelset_model.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>

namespace RollingContact
{
  /**
   * The binary of FMUs, beside the program or in the folder of libraries of its
   * prefix. Throws InputError if it is in none of them.
   */
  std::string fmu_binary();

  /** Write wheelset_fmi2.fmu and wheelset_fmi3.fmu, which hold the table of a
   * model. */
  void write_fmus_of_table(const Situation          &scene,
                           const Fmu::WheelsetModel &model,
                           const RunContext         &context);

  /**
   * Write wheelset_states_fmi2.fmu and wheelset_states_fmi3.fmu, which hold the
   * scene with the files of its profiles, and the path of this program.
   */
  void write_fmus_of_states(const Situation &scene, const RunContext &context);
} // namespace RollingContact

#endif
