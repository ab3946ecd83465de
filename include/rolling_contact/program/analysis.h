#ifndef rolling_contact_program_analysis_h
#define rolling_contact_program_analysis_h

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  struct RunContext;
  struct SceneParameters;

  /**
   * What is asked of a scene: `Analysis` of the .prm file.
   */
  class Analysis
  {
  public:
    virtual ~Analysis() = default;

    /**
     * Compute, and write what is to be written. Throws ConvergenceError if that
     * is not possible.
     */
    virtual void
    run() = 0;
  };

  /**
   * An analysis as --print-parameters and main() know it.
   */
  struct AnalysisKind
  {
    using Maker = std::unique_ptr<Analysis> (*)(SceneParameters &,
                                                RunContext &);

    std::string name;
    std::string help;
    Maker       in_2d, in_3d;
    bool        resumes  = false; ///< --resume goes on with a run
    bool        on_ranks = true;  ///< under mpirun
  };

  /**
   * All there are.
   */
  const std::vector<AnalysisKind> &
  analysis_kinds();

  /**
   * Of an entry of analysis_kinds(). Throws InputError for any other name.
   */
  const AnalysisKind &
  analysis_kind(const std::string &name);
} // namespace RollingContact

#endif
