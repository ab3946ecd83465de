#ifndef rolling_contact_program_analysis_table_h
#define rolling_contact_program_analysis_table_h

#include <rolling_contact/analyses/analysis.h>
#include <rolling_contact/run/run_folder.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  struct RunContext;
  struct SceneParameters;

  /**
   * An analysis as --print-parameters and main() know it.
   */
  struct AnalysisKind
  {
    using Maker = std::unique_ptr<Analysis> (*)(const SceneParameters &,
                                                RunContext &);

    std::string name;
    std::string help;
    Maker       in_2d, in_3d;
    /** What --resume goes on with; none if it cannot. */
    std::function<RunFolder::Resumption(const SceneParameters &)> resumption =
      {};
    bool on_ranks = true; ///< under mpirun
  };

  /**
   * All analyses, the default first.
   */
  const std::vector<AnalysisKind> &
  analysis_kinds();

  /**
   * The one of this name in analysis_kinds(). Throws InputError for any other
   * name.
   */
  const AnalysisKind &
  analysis_kind(const std::string &name);
} // namespace RollingContact

#endif
