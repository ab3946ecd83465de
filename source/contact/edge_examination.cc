#include <rolling_contact/contact/edge_examination.h>
#include <rolling_contact/contact/edge_pressure.h>

namespace RollingContact
{
  namespace
  {
    /**
     * Largest change of the gap's curvature from node to node, over its mean,
     * and largest irregularity of the pressure, with which the edge law is more
     * exact than upwind 2. Measured on waves of 3 to 12 elements and on meshes
     * that do not match.
     */
    const double largest_change = 0.5, largest_irregularity = 0.06;
  } // namespace

  EdgeExamination examine_edge(const ContactProblem                   &contact,
                               const TouchingRun                      &run,
                               const std::vector<double>              &pressure,
                               const std::vector<std::vector<double>> &surplus)
  {
    EdgeExamination found;
    found.resolved = change_of_curvature(run,
                                         places(run, contact.operators),
                                         contact.loads.gap) <= largest_change;
    for (unsigned int c = 0; found.resolved && c < surplus.size(); ++c)
      {
        const EdgePressure        line(contact, run, c);
        const std::vector<double> p = line.equivalent(pressure, surplus[c]);
        found.resolved = line.irregularity(p, pressure) <= largest_irregularity;
        found.barely_touches = found.barely_touches || p[0] <= 0.;
      }
    return found;
  }
} // namespace RollingContact
