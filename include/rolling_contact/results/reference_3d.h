#ifndef rolling_contact_results_reference_3d_h
#define rolling_contact_results_reference_3d_h

#include <rolling_contact/base/creepages.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/scene/pair_spec.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The force on the wheel by a half-space theory. Units: N, N m.
   */
  struct NamedForce
  {
    std::string           name;   ///< "Shen-Hedrick-Elkins", in texts
    std::string           column; ///< "shen", what its columns begin with
    std::string           label;  ///< "Shen, Hedrick, Elkins", in plots
    bool                  saturates = true; ///< at mu N, mu constant
    double                x = 0., y = 0.;
    std::optional<double> spin_moment{}; ///< if the theory has one
  };

  /**
   * What half-space theory says of a 3D state at a given load: Hertz, and the
   * creep forces of Kalker's linear theory and of the theories that saturate,
   * those only with constant friction above 0. All but Hertz are
   * approximations, shown beside the result and no measure of its error.
   */
  struct Reference3D
  {
    References::HertzEllipse hertz;
    std::vector<NamedForce>  forces; ///< in the order of their columns

    /**
     * Kalker's linear theory.
     */
    const NamedForce &linear() const
    {
      return forces.front();
    }
  };

  Reference3D reference_3d(const PairSpec  &scene,
                           const double     normal_force,
                           const Creepages &creepages);

  /**
   * Kalker's linear theory on an ellipse of these half-widths (m), whatever its
   * load: the size of the force where profiles touch and no ellipse of Hertz
   * is there.
   */
  NamedForce linear_theory(const PairSpec  &scene,
                           const double     half_width_x,
                           const double     half_width_y,
                           const Creepages &creepages);

  /**
   * Names of the theories that need constant friction, "FASTSIM, ...".
   */
  std::string saturating_theories();
} // namespace RollingContact

#endif
