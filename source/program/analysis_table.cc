#include <rolling_contact/analyses/contact_table.h>
#include <rolling_contact/analyses/corrugation.h>
#include <rolling_contact/analyses/creep_curve.h>
#include <rolling_contact/analyses/impacts.h>
#include <rolling_contact/analyses/limit_cycles.h>
#include <rolling_contact/analyses/load_curve.h>
#include <rolling_contact/analyses/modes.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/receptance.h>
#include <rolling_contact/analyses/rolling_noise.h>
#include <rolling_contact/analyses/study_kind.h>
#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/choices.h>
#include <rolling_contact/evolution/profile_evolution.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/tables/table.h>
#include <rolling_contact/wheelset/curve_stability.h>
#include <rolling_contact/wheelset/fmu_export.h>
#include <rolling_contact/wheelset/wheelset_analysis.h>

namespace RollingContact
{
  const std::vector<AnalysisKind> &analysis_kinds()
  {
    static const std::vector<AnalysisKind> kinds{quasi_static_kind(),
                                                 creep_curve_kind(),
                                                 load_curve_kind(),
                                                 transient_kind(),
                                                 accuracy_study_kind(),
                                                 contact_table_kind(),
                                                 table_kind(),
                                                 modes_kind(),
                                                 receptance_kind(),
                                                 stability_in_curves_kind(),
                                                 stability_map_in_curves_kind(),
                                                 limit_cycle_kind(),
                                                 impact_kind(),
                                                 corrugation_kind(),
                                                 rolling_noise_kind(),
                                                 wheelset_kind(),
                                                 fmu_kind(),
                                                 profile_evolution_kind()};
    return kinds;
  }

  const AnalysisKind &analysis_kind(const std::string &name)
  {
    return choice(analysis_kinds(), name, "Analysis");
  }
} // namespace RollingContact
