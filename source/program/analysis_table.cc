#include <rolling_contact/analyses/contact_table.h>
#include <rolling_contact/analyses/creep_curve.h>
#include <rolling_contact/analyses/limit_cycles.h>
#include <rolling_contact/analyses/load_curve.h>
#include <rolling_contact/analyses/modes.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/receptance.h>
#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/choices.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/state/checkpoint.h>
#include <rolling_contact/studies/accuracy_study.h>
#include <rolling_contact/studies/time_study.h>
#include <rolling_contact/tables/stability_map.h>
#include <rolling_contact/tables/table.h>

namespace RollingContact
{
  namespace
  {
    template <template <int> class Kind, int dim>
    std::unique_ptr<Analysis>
    make(const SceneParameters &scene, RunContext &context)
    {
      return std::make_unique<Kind<dim>>(scene, context);
    }



    template <template <int> class Kind>
    AnalysisKind
    kind(const std::string &name, const std::string &help)
    {
      return {name, help, &make<Kind, 2>, &make<Kind, 3>};
    }



    template <int dim>
    std::unique_ptr<Analysis>
    make_study(const SceneParameters &scene, RunContext &context)
    {
      return scene.study.varies_time_step
               ? make<TimeStudy, dim>(scene, context)
               : make<AccuracyStudy, dim>(scene, context);
    }



    std::unique_ptr<Analysis>
    make_contact_table(const SceneParameters &scene, RunContext &context)
    {
      return std::make_unique<ContactTable>(scene, context);
    }



    RunFolder::Resumption
    transient_resumption(const SceneParameters &scene)
    {
      return {TimeParameters::free_on_resume(),
              checkpoint_name,
              {history_name, modal_velocities_name},
              [&](const std::filesystem::path &path) {
                check_resumable(scene, path);
              }};
    }



    RunFolder::Resumption
    table_resumption(const SceneParameters &)
    {
      return {{"Output/", "Table/Threads", "Body threads"},
              "results.csv",
              {},
              {}};
    }



    RunFolder::Resumption
    cycle_resumption(const SceneParameters &)
    {
      return {{"Output/", "Body threads"}, "limit_cycle_state.txt", {}, {}};
    }



    std::vector<AnalysisKind>
    make_kinds()
    {
      AnalysisKind transient =
        kind<Transient>("transient", "rolling in time, see section Time");
      transient.resumption = &transient_resumption;
      AnalysisKind study{
        "accuracy study",
        "the same state on many meshes, or the same transient with many "
        "steps, see section Accuracy study",
        &make_study<2>,
        &make_study<3>};
      study.on_ranks = false;
      AnalysisKind table =
        kind<Table>("table",
                    "the states of a grid over any entries, or of the rows of "
                    "a file, see section Table");
      table.resumption = &table_resumption;
      table.on_ranks   = false;
      AnalysisKind contacts{"contact table",
                            "where rigid wheel and rail profiles touch, see "
                            "section Profiles",
                            &make_contact_table,
                            &make_contact_table};
      contacts.on_ranks  = false;
      AnalysisKind modes = kind<Modes>("modes",
                                       "eigenfrequencies and mode shapes of "
                                       "each body, see section Modes");
      modes.on_ranks     = false;
      AnalysisKind receptance =
        kind<Receptance>("receptance",
                         "how each body moves under harmonic forces, see "
                         "section Receptance");
      receptance.on_ranks = false;
      AnalysisKind stability =
        kind<Stability>("stability",
                        "whether the steady rolling state squeals, see section "
                        "Stability");
      stability.on_ranks = false;
      AnalysisKind map =
        kind<StabilityMap>("stability map",
                           "which of the states of a grid squeal, see "
                           "sections Table and Stability");
      map.resumption = &table_resumption;
      map.on_ranks   = false;
      AnalysisKind cycles =
        kind<LimitCycles>("limit cycle",
                          "runs in time until the motion repeats itself, from "
                          "several starts and along an axis, see sections Time "
                          "and Limit cycle");
      cycles.resumption = &cycle_resumption;
      cycles.on_ranks   = false;
      return {kind<QuasiStatic>("quasi-static", "one steady rolling state"),
              kind<CreepCurve>("creep curve",
                               "many creepages, see section Creep curve"),
              kind<LoadCurve>("load curve",
                              "approach and contact stiffness under many "
                              "loads, see section Load curve"),
              transient,
              study,
              contacts,
              table,
              modes,
              receptance,
              stability,
              map,
              cycles};
    }
  } // namespace



  const std::vector<AnalysisKind> &
  analysis_kinds()
  {
    static const std::vector<AnalysisKind> kinds = make_kinds();
    return kinds;
  }



  const AnalysisKind &
  analysis_kind(const std::string &name)
  {
    return choice(analysis_kinds(), name, "Analysis");
  }
} // namespace RollingContact
