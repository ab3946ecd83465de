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

  template <template <int> class Kind, int dim>
  std::unique_ptr<Analysis> make_analysis(const Situation &scene,
                                          RunContext      &context)
  {
    return std::make_unique<Kind<dim>>(scene, context);
  }

  /**
   * The analysis of a class, with traits of a steady rolling state, which is
   * not resumed.
   */
  template <template <int> class Kind>
  AnalysisKind kind_of(const std::string &name, const std::string &help)
  {
    AnalysisKind kind;
    kind.name  = name;
    kind.help  = help;
    kind.in_2d = &make_analysis<Kind, 2>;
    kind.in_3d = &make_analysis<Kind, 3>;
    return kind;
  }
} // namespace RollingContact

#endif
