#ifndef rolling_contact_analyses_study_errors_h
#define rolling_contact_analyses_study_errors_h

#include <rolling_contact/analyses/study_state.h>
#include <rolling_contact/base/creepages.h>
#include <rolling_contact/scene/study_parameters.h>

#include <map>
#include <string>
#include <vector>

namespace RollingContact
{
  struct StudyCase
  {
    std::string direction;
    double      over_saturation = 0.;
    Creepages   creepages;
  };

  /**
   * All states of one method on one mesh and for one case; indices.
   */
  struct StudyKey
  {
    std::size_t  method;
    std::size_t  state;
    unsigned int elements;

    bool operator<(const StudyKey &other) const;
  };

  /**
   * What an accuracy study solved; the samples of a key are those of its
   * positions under the patch. Behind the methods to be compared stands that of
   * the reference, if it is not one of them.
   */
  struct StudyResults
  {
    std::vector<StudyMethod>                     methods;
    std::size_t                                  n_compared       = 0;
    std::size_t                                  reference_method = 0;
    bool                                         carter           = false;
    std::vector<StudyCase>                       cases;
    std::map<StudyKey, std::vector<StudySample>> samples;
  };

  /**
   * The converged solution of a case: forces over mu N, load in N or approach
   * in m; what extrapolation changed, forces over mu N.
   */
  struct StudyReference
  {
    std::array<double, 2> force{};
    double                load   = 0.;
    double                change = 0.;
    double                order  = 0.;
  };

  struct MeanAndLargest
  {
    double       mean    = 0.;
    double       largest = 0.; ///< magnitude
    unsigned int n       = 0;

    void add(const double value);
  };

  /**
   * Errors and costs over the positions of a key that were solved. The error of
   * the force is positive if the force is too large; with all creepages
   * combined it is the length of a vector, also of the mean one.
   */
  struct StudyErrors
  {
    MeanAndLargest force, load, pressure, traction, sawtooth, stick_boundary;
    StateSeconds   seconds;                               ///< mean
    double         n_unknowns = 0., n_contact_nodes = 0.; ///< mean
    double         residual        = 0.;
    std::size_t    peak_memory     = 0;
    unsigned int   n_states        = 0;
    unsigned int   n_not_converged = 0;
  };

  /**
   * Elements across the patch of the reference mesh, and of the two it is
   * extrapolated from if it is.
   */
  std::vector<unsigned int> reference_meshes(const StudyParameters &study);

  /**
   * The converged solution of a case: the mean over all positions of the
   * reference mesh, extrapolated with the observed order if the scene asks for
   * it.
   */
  StudyReference study_reference(const StudyParameters &study,
                                 const StudyResults    &results,
                                 const std::size_t      state);

  StudyErrors study_errors(const StudyCase                &state,
                           const StudyReference           &reference,
                           const std::vector<StudySample> &samples);

  /**
   * The worst of all cases: largest errors and memory, mean seconds, and over
   * the cases the mean of the size of their mean errors.
   */
  StudyErrors worst_case(const std::vector<StudyErrors> &cases);
} // namespace RollingContact

#endif
