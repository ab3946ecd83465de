#ifndef rolling_contact_analyses_study_kind_h
#define rolling_contact_analyses_study_kind_h

#include <rolling_contact/scene/analysis_kind.h>

namespace RollingContact
{
  /**
   * Analysis = accuracy study, of meshes or of time steps.
   */
  AnalysisKind accuracy_study_kind();
} // namespace RollingContact

#endif
