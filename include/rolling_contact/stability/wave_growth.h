#ifndef rolling_contact_stability_wave_growth_h
#define rolling_contact_stability_wave_growth_h

#include <rolling_contact/stability/wave_response.h>

#include <complex>
#include <vector>

namespace RollingContact
{
  /**
   * Growth G of a wave by what it makes the contact wear, per passage.
   */
  struct Growth
  {
    /** The parts by disturbances of traction, and of slip. Units: 1, or J/m^3
     * over a wear coefficient. */
    std::complex<double> by_traction, by_slip;

    std::complex<double> total() const
    {
      return by_traction + by_slip;
    }
  };

  /**
   * Wear that is as friction's work, k_w (m^3/J) of a body, makes of a small
   * wave of unit height per passage
   *
   *   Delta z(X, y_j) = G_j z(X),
   *   G_j = k_w / V sum over the line j of
   *         h_i (q_0 . v^_i + q^_i . v_0) exp(i k x_i),
   *   G   = sum_j c_j G_j,
   *
   * with nodal tractions q on the wheel, slip velocities v of the wheel over
   * the rail in the mean around each node, and h_i the nodes' lengths along the
   * flow. c_j, whose sum is one, is the share of a line in the load of the
   * same patch under a rigid flat punch: what the contact feels of a wave that
   * varies across. The wave grows where Re G > 0, by exp(n Re G) in n passages,
   * and its crests move by Im G / k per passage along the flow.
   */
  class WaveGrowth
  {
  public:
    /**
     * A steady state with friction at a speed V (m/s) of @p problem; widths
     * across are those of the lines of nodes, in 2D the @p thickness (m). Keeps
     * references to the problem and its linearised @p contact. Throws
     * ConvergenceError if a flat punch on the patch has no pressure.
     */
    WaveGrowth(const ContactProblem &problem,
               const ContactState   &state,
               const LinearContact  &contact,
               const ReducedPair    &pair,
               const double          speed,
               const double          thickness);

    /** Places of the touching nodes along the flow. Units: m. */
    const std::vector<double> &along() const
    {
      return places;
    }

    /** Places of the touching nodes across it. Units: m. */
    std::vector<double> across() const;

    /** Nodal forces of component @p c, tangential ones first, that sum to 1 N
     * as those of a flat punch on the patch do. */
    std::vector<double> punch_forces(const unsigned int c) const;

    /** c_j h_i of all nodes, by which the powers of friction q . v of nodes
     * make a wave wear, 0 on lines that do not touch. Units: m. */
    const std::vector<double> &lengths() const
    {
      return node_lengths;
    }

    /** G over k_w of the answer to a wave. Units: 1/m, J/m^3. */
    Growth growth(const WaveAnswer &answer, const double wave_number) const;

    /** The normal load of the unknowns of an answer. Units: N/m. */
    std::complex<double> load(const ComplexVector &unknowns) const;

  private:
    /** The punch, which tells the c_j of each line. */
    void find_punch(const ReducedPair &pair);

    void find_lengths(const double thickness);

    const ContactProblem &problem;
    const LinearContact  &contact;
    double                speed;
    NodalField            traction, slip; ///< q_0, v_0 / V
    std::vector<double>   places, node_lengths;
    std::vector<double>   punch; ///< its load of each touching node, sum 1
  };
} // namespace RollingContact

#endif
