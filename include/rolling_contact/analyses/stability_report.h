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
   * Draws growth over frequency, of all eigenvalues between two frequencies
   * (Hz) and of the findings, by the whole bodies if they are known, with their
   * names.
   */
  void plot_growth(const ComplexValues            &eigenvalues,
                   const std::vector<Finding>     &findings,
                   const std::vector<std::string> &names,
                   const double                    lowest,
                   const double                    highest,
                   RunContext                     &context);
} // namespace RollingContact

#endif
