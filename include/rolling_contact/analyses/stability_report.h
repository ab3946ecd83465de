#ifndef rolling_contact_analyses_stability_report_h
#define rolling_contact_analyses_stability_report_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/vibration/vibrations.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A row of stability.csv.
   */
  template <int dim>
  void add_row(const Finding           &finding,
               const LinearContact     &contact,
               const RollingModes<dim> &rolling,
               ResultsTable            &table);

  /**
   * "3 modes grow, ...; the fastest at 1038 Hz by 1 1/s, ...", with what a
   * second count says.
   */
  std::string verdict(const Situation            &scene,
                      const std::vector<Finding> &findings,
                      const std::string          &counted);

  /**
   * Draws damping ratios over frequency, of all eigenvalues between two
   * frequencies (Hz), and the unstable ones.
   */
  void plot_eigenvalues(const ComplexValues        &eigenvalues,
                        const std::vector<Finding> &findings,
                        const double                lowest,
                        const double                highest,
                        RunContext                 &context);
} // namespace RollingContact

#endif
