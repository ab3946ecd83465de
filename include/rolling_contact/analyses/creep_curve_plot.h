#ifndef rolling_contact_analyses_creep_curve_plot_h
#define rolling_contact_analyses_creep_curve_plot_h

#include <rolling_contact/base/creepages.h>

#include <string>
#include <vector>

namespace RollingContact
{
  struct RunContext;

  /**
   * |T|/(mu N) of a theory at each point of a creep curve.
   */
  struct ReferenceCurve
  {
    std::string         label;
    bool                saturates = true;
    std::vector<double> ratios;
  };

  /**
   * What a creep curve found at each of its points. Units: 1, N, N, Nm, m.
   */
  struct CreepCurveForces
  {
    std::vector<double> force_ratio; ///< |T|/(mu N), mu_s N if friction falls
    std::vector<double> force_x, force_y, moment;
    std::vector<Creepages>      found;           ///< creepages of the states
    double                      half_width = 0.; ///< largest
    std::vector<ReferenceCurve> references;
  };

  /**
   * A line of a creep curve's plot: points over which one component varies, the
   * label says what the others are.
   */
  struct CreepLine
  {
    std::string              label;
    std::vector<std::size_t> points;
  };

  /**
   * Points over the component that makes the fewest lines of them, of equal
   * ones lateral before longitudinal creepage before spin; creepages in
   * percent, spin in 1/m. One line along the path if no component does.
   */
  struct CreepLines
  {
    explicit CreepLines(const std::vector<Creepages> &points);

    std::string            label;    ///< of the axis
    std::vector<double>    abscissa; ///< of all points
    std::vector<CreepLine> lines;
  };

  /**
   * creep_curve.svg: |T|/(mu N), with the theories if it is one line, and below
   * it the forces and the moment with their signs, those that are not zero.
   * @p scale: of friction, "mu".
   */
  void plot_creep_curve(const std::vector<Creepages> &points,
                        const CreepCurveForces       &curve,
                        const std::string            &scale,
                        RunContext                   &context);
} // namespace RollingContact

#endif
