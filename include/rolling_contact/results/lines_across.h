#ifndef rolling_contact_results_lines_across_h
#define rolling_contact_results_lines_across_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <vector>

namespace RollingContact
{
  /**
   * What a line of nodes along x, all those with the same y, carries. Per metre
   * across it is over half the distance of the lines on either side, so that
   * sums with these widths are those of the state.
   */
  struct LineAcross
  {
    double       y            = 0.; ///< across, m
    double       width        = 0.; ///< m
    double       max_pressure = 0.; ///< Pa
    double       load         = 0.; ///< pressure over the line, N/m
    double       heat         = 0.; ///< dissipation() per metre across, J/m^2
    unsigned int n_touching = 0, n_stick = 0;

    std::vector<unsigned int> nodes; ///< of the contact
  };

  /**
   * The lines of a state in 3D from the least y to the largest.
   */
  std::vector<LineAcross> lines_across(const SteadyState<3> &steady);

  /**
   * Write the CSV @p file of a state on profiles: a row for each line of nodes
   * along x that touches, with its places on the profiles, peak pressure, load
   * and heat of friction, as models of wear take them. Nothing if the bodies
   * have other surfaces, do not touch, or the state did not converge.
   */
  void write_lines_across(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          RunContext           &context,
                          const std::string    &file = "across.csv");
} // namespace RollingContact

#endif
