#ifndef rolling_contact_program_analysis_table_h
#define rolling_contact_program_analysis_table_h

#include <rolling_contact/scene/analysis_kind.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * All analyses, the default first.
   */
  const std::vector<AnalysisKind> &analysis_kinds();

  /**
   * The one of this name in analysis_kinds(). Throws InputError for any other
   * name.
   */
  const AnalysisKind &analysis_kind(const std::string &name);
} // namespace RollingContact

#endif
