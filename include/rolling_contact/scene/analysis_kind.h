#ifndef rolling_contact_scene_analysis_kind_h
#define rolling_contact_scene_analysis_kind_h

#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/scene/analysis.h>
#include <rolling_contact/scene/analysis_traits.h>

#include <functional>
#include <memory>
#include <string>

namespace RollingContact
{
  struct RunContext;
  struct Situation;

  /**
   * All that the program knows of an analysis: what scenes are told of it, how
   * it is made, and how it is resumed.
   */
  struct AnalysisKind : AnalysisTraits
  {
    using Maker = std::unique_ptr<Analysis> (*)(const Situation &,
                                                RunContext &);

    Maker in_2d, in_3d;

    /** Throws InputError if what the scene names, as rows of a file, is not
     * possible; null if that cannot be. */
    void (*check_situation)(const Situation &) = nullptr;

    /** What --resume goes on with; none if it cannot. */
    std::function<RunFolder::Resumption(const Situation &)> resumption = {};
  };

  template <class Kind>
  std::unique_ptr<Analysis> make_analysis(const Situation &scene,
                                          RunContext      &context)
  {
    return std::make_unique<Kind>(scene, context);
  }

  /**
   * The analysis of a class, of one for each dimension or of one for both, with
   * traits of a steady rolling state, which is not resumed.
   */
  template <class In2D, class In3D = In2D>
  AnalysisKind kind_of(const std::string &name, const std::string &help)
  {
    AnalysisKind kind;
    kind.name  = name;
    kind.help  = help;
    kind.in_2d = &make_analysis<In2D>;
    kind.in_3d = &make_analysis<In3D>;
    return kind;
  }

  template <template <int> class Kind>
  AnalysisKind kind_of(const std::string &name, const std::string &help)
  {
    return kind_of<Kind<2>, Kind<3>>(name, help);
  }
} // namespace RollingContact

#endif
