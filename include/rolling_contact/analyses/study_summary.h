#ifndef rolling_contact_analyses_study_summary_h
#define rolling_contact_analyses_study_summary_h

#include <rolling_contact/analyses/error_cost_report.h>
#include <rolling_contact/analyses/study_errors.h>
#include <rolling_contact/scene/situation.h>

#include <map>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The tables of an accuracy study: summary.csv with a row for each method,
   * mesh and case; methods.csv and the screen with the worst case of each
   * method and mesh; then report_errors_and_costs().
   */
  class StudySummary
  {
  public:
    StudySummary(const Situation    &scene,
                 const StudyResults &results,
                 RunContext         &context);

    void write();

  private:
    using TextTable = std::vector<std::vector<std::string>>;

    void write_cases() const;

    void add_case_row(const StudyKey    &key,
                      const StudyErrors &errors,
                      ResultsTable      &table) const;

    std::string load_reference() const;

    void say_references() const;

    std::string name_of(const std::size_t method) const;

    /**
     * Meshes of a method, the smallest first.
     */
    std::vector<unsigned int> meshes_of(const std::size_t method) const;

    void write_methods() const;

    void say_methods(const std::vector<StudyErrors> &rows) const;

    /**
     * Errors and costs for one direction of creepage, for all if it is empty.
     */
    ErrorCostSet points_of(const std::string &direction) const;

    void report_points() const;

    const Situation                &scene;
    const StudyResults             &results;
    RunContext                     &context;
    std::vector<StudyReference>     references; ///< of the cases
    std::map<StudyKey, StudyErrors> all_errors;
    std::string                     force_reference;
  };
} // namespace RollingContact

#endif
