#ifndef rolling_contact_scene_stability_parameters_h
#define rolling_contact_scene_stability_parameters_h

#include <rolling_contact/stability/linear_contact.h>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * Section `Stability`: what the steady rolling state is disturbed by, and how
   * its eigenvalues are proved.
   */
  struct StabilityParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    /**
     * Throws InputError.
     */
    void
    check() const;

    double           lowest_frequency = 60.; ///< Hz
    bool             rotation         = true;
    FrictionResponse friction         = FrictionResponse::patch_mean;
    double           memory           = 60e-6; ///< s
    bool             count            = true;
    bool             correct          = true;
    double           damping_margin   = 0.;
  };
} // namespace RollingContact

#endif
