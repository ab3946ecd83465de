#ifndef rolling_contact_tests_time_run_h
#define rolling_contact_tests_time_run_h

#include "scene_run.h"

#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/time/contact_stepper.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * Two discs, in 3D with a crown, that roll at 10 m/s without inertia.
   */
  template <int dim>
  inline void standard(SceneParameters &scene)
  {
    scene.dimension = dim;
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->radius     = 0.46;
        body->hub_radius = 0.3;
        if (dim == 3)
          body->lateral_radius = 0.3;
      }
    scene.mesh.elements_across_patch = dim == 2 ? 16 : 6;
    scene.mesh.growth                = dim == 2 ? 0.3 : 0.8;
    scene.contact.speed              = 10.;
    scene.contact.approach           = dim == 2 ? 0.15e-3 : 0.07e-3;
    scene.time.time_step             = 1e-4;
    scene.time.end_time              = 1.;
    scene.time.inertia               = false;
  }

  /**
   * Steady rolling whose creepage begins to oscillate, 0.1 +- 0.08 % at 1 kHz.
   */
  inline void oscillates(SceneParameters &scene)
  {
    scene.contact.creepages.x   = 0.001;
    scene.contact.slip_operator = SlipOperatorKind::upwind_2;
    scene.time.initial_state    = InitialState::steady;
    scene.time.creepage_x       = "0.001 + 0.0008 * sin(2 * pi * 1000 * t)";
  }

  /**
   * A transient scene stepped in memory.
   */
  template <int dim>
  struct TimeRun : public SceneInMemory
  {
    explicit TimeRun(const std::function<void(SceneParameters &)> &change)
    {
      scene.analysis = analysis_kind("transient");
      standard<dim>(scene);
      change(scene);
      scene.check();
      PairDemands demands;
      demands.displacements = true;
      stepper =
        std::make_unique<ContactStepper<dim>>(situation(), demands, context);
    }

    /**
     * @p n steps of the scene's length; the force ratio T_x/(mu N) after each.
     */
    std::vector<double> march(const unsigned int n)
    {
      std::vector<double> forces;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double h         = scene.time.time_step;
          const double stored    = stepper->bodies().stored_energy();
          last                   = stepper->advance(time, h);
          time                   = ++n_steps * h;
          const StepEnergy &e    = last.energy;
          const double      gain = stepper->bodies().stored_energy() - stored;
          worst_balance =
            std::max(worst_balance,
                     std::abs(gain - e.contact_work - e.load_work + e.damping +
                              e.numerical_dissipation));
          least_friction = std::min(least_friction, last.friction);
          largest_energy =
            std::max(largest_energy, stepper->bodies().stored_energy());
          n_impacts += last.n_impacts;
          forces.push_back(force_x());
        }
      return forces;
    }

    double force_x() const
    {
      const Resultants &result = stepper->current().result;
      return result.normal_force > 0.
               ? result.force_x /
                   (scene.contact.friction_coefficient * result.normal_force)
               : 0.;
    }

    std::unique_ptr<ContactStepper<dim>> stepper;
    StepOutcome                          last;
    double time = 0., worst_balance = 0., least_friction = 0.,
           largest_energy = 0.;
    unsigned int n_steps = 0, n_impacts = 0;
  };
} // namespace RollingContact

#endif
