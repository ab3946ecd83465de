#ifndef rolling_contact_tests_vibrating_pair_h
#define rolling_contact_tests_vibrating_pair_h

#include <deal.II/lac/vector.h>

#include "scene_run.h"
#include "time_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/stability/correction.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <functional>
#include <memory>

/** Small bodies with meshes that vibrate as they roll. */
namespace VibratingPair
{
  using namespace RollingContact;
  using Change = std::function<void(SceneParameters &)>;

  /**
   * What both have: density, damping, inertia and a steady start.
   */
  inline void vibrating(SceneParameters &scene)
  {
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->material.density                = 7800.;
        body->radius                          = 0.2;
        body->hub_radius                      = 0.05;
        body->model.damping.mass_damping      = 10.;
        body->model.damping.stiffness_damping = 1e-7;
      }
    scene.contact.slip_operator = SlipOperatorKind::upwind_2;
    scene.contact.speed         = 10.;
    scene.stability.rotation    = false; // there is none in time
    scene.time.inertia          = true;
    scene.time.initial_state    = InitialState::steady;
    scene.time.theta            = 0.5;
  }

  /**
   * A disc on a block with a pad that is not below the contact: the block
   * pitches, so that normal and tangential motion are coupled.
   */
  inline void disc_on_pad(SceneParameters &scene)
  {
    vibrating(scene);
    scene.rail.shape                   = "block";
    scene.rail.radius                  = 0.;
    scene.rail.block_length            = 0.12;
    scene.rail.block_depth             = 0.05;
    scene.rail.hub                     = Hub::elastic;
    Foundation &foundation             = scene.rail.model.foundation;
    foundation.pad_spacing             = 1.;
    foundation.pad_length              = 0.036;
    foundation.pad_offset              = -0.039;
    foundation.stiffness               = {{17e9, 0.46e9, 1.8e9}};
    scene.wheel.width                  = 0.03;
    scene.wheel.lateral_radius         = 0.1;
    scene.rail.width                   = 0.04;
    scene.rail.lateral_radius          = 0.;
    scene.contact.friction_coefficient = 0.41;
  }

  /**
   * The same in 3D with coarse elements, all of which slide: one vibration
   * grows.
   */
  inline void unstable_pair(SceneParameters &scene)
  {
    disc_on_pad(scene);
    scene.mesh.elements_across_patch = 5;
    scene.mesh.growth                = 1.5;
    scene.contact.approach           = 4.5e-5;
    scene.contact.creepages.x        = 0.05;
    scene.contact.creepages.y        = -0.02;
  }

  /**
   * What the stability of the steady state on the same mesh says.
   */
  template <int dim>
  struct Eigenvalues
  {
    Eigenvalues(const Change &change, const double cut_off)
    {
      standard<dim>(run.scene);
      change(run.scene);
      run.scene.analysis = analysis_kind("stability");
      run.scene.check();
      PairDemands pair;
      pair.modes = true;
      steady     = solve_steady_state<dim>(run.situation(),
                                       demands_in_time(pair),
                                       run.context);
      BOOST_TEST_REQUIRE(steady.solver.converged);
      bodies = std::make_unique<ModalBodies<dim>>(run.situation(),
                                                  run.scene.modes,
                                                  steady.pair->bodies(),
                                                  cut_off,
                                                  run.context);
      const RollingConditions conditions(run.situation(), run.scene.stability);
      rolling = std::make_unique<RollingModes<dim>>(
        *bodies, *steady.pair, steady.problem.operators.W().dense());
      reduced = rolling->reduced(conditions);
      whole   = std::make_unique<WholeBodies<dim>>(*rolling, conditions);
      LinearContactOptions options;
      options.speed = *run.scene.contact.speed;
      contact       = linear_contact(steady.problem, steady.state, options);
    }

    /** The vibrations from @p low to @p high (Hz) by the whole bodies. */
    std::vector<CorrectedMode> vibrations(const double low, const double high)
    {
      const StabilityPencil pencil(reduced, contact);
      CorrectionOptions     options;
      options.most_steps = 20;
      options.tolerance  = 1e-11;
      std::vector<StabilityMode> modes;
      for (const auto &s : pencil.eigenvalues())
        if (s.imag() > 2 * pi * low && s.imag() < 2 * pi * high)
          modes.push_back(pencil.mode(s));
      return correct(
        reduced,
        contact,
        modes,
        [&](const auto &s, const auto &forces) {
          return whole->response(s, forces);
        },
        options);
    }

    SceneInMemory                      run;
    SteadyState<dim>                   steady;
    std::unique_ptr<ModalBodies<dim>>  bodies;
    std::unique_ptr<RollingModes<dim>> rolling;
    std::unique_ptr<WholeBodies<dim>>  whole;
    ReducedPair                        reduced;
    LinearContact                      contact;
  };
} // namespace VibratingPair

#endif
