#ifndef rolling_contact_mesh_body_model_h
#define rolling_contact_mesh_body_model_h

#include <rolling_contact/base/constants.h>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Linear elements: B-bar by mean dilatation, or enhanced by incompatible
   * modes, which bend with one element through the thickness; see
   * cell_stiffness() and cell_stiffness_enhanced().
   */
  enum class ElementKind
  {
    b_bar,
    enhanced
  };

  /**
   * How the vibration of a body is found: by the modes of its mesh, of a body
   * of revolution by those of its section with Fourier series about the axle,
   * or of a rail without ends by waves in its section.
   */
  enum class ModeModel
  {
    mesh,
    harmonic,
    waveguide
  };

  /**
   * How the displacements of a body are found.
   */
  enum class BodySolver
  {
    automatic,
    direct,
    distributed
  };

  /**
   * The largest Poisson ratio of a distributed body: conjugate gradients with
   * multigrid fail on nearly incompressible ones.
   */
  constexpr double distributed_poisson_limit = 0.49;

  /**
   * The mass matrix of a body in time.
   */
  enum class MassKind
  {
    lumped,
    consistent
  };

  /**
   * Springs under the hub boundary, used where Hub = elastic: one layer to the
   * ground, or pads to sleepers that lie on ballast. Stiffness is that of a
   * metre of length along x, spread evenly over the boundary; that of a pad or
   * a sleeper is so much times the spacing. Components x, y (unused in 2D), z.
   */
  struct Foundation
  {
    std::array<double, 3> stiffness{{0., 0., 0.}}; ///< N/m^2
    double                loss_factor  = 0.;
    double                pad_spacing  = 0.;   ///< m; 0: a continuous layer
    double                pad_length   = 0.15; ///< m
    double                pad_offset   = 0.;   ///< m, x of the middle of a pad
    double                sleeper_mass = 0.;   ///< kg; 0: pads on the ground
    std::array<double, 3> ballast_stiffness{{0., 0., 0.}}; ///< N/m^2
    double                ballast_loss_factor = 0.;

    bool has_sleepers() const
    {
      return sleeper_mass > 0.;
    }

    bool operator==(const Foundation &other) const
    {
      const auto tied = [](const Foundation &it) {
        return std::tie(it.stiffness,
                        it.loss_factor,
                        it.pad_spacing,
                        it.pad_length,
                        it.pad_offset,
                        it.sleeper_mass,
                        it.ballast_stiffness,
                        it.ballast_loss_factor);
      };
      return tied(*this) == tied(other);
    }
  };

  /**
   * A rigid mass that the hub boundary is fixed to, used where Hub = mass: that
   * of an axle, about the centroid of the boundary and the axes x, y (that of
   * the axle, the only one in 2D), z. Units: kg, kg m^2.
   */
  struct HubMass
  {
    double                mass = 0.;
    std::array<double, 3> inertia{{0., 0., 0.}};

    bool operator==(const HubMass &other) const
    {
      return mass == other.mass && inertia == other.inertia;
    }
  };

  /**
   * Damping of a body: hysteretic by loss factors, K (1 + i eta), viscous by
   * Rayleigh, C = mass_damping M + stiffness_damping K, and by absorbing ends;
   * ratios of its modes. Of full bodies in time a loss factor is viscous at one
   * frequency.
   */
  struct BodyDamping
  {
    double loss_factor       = 0.;    ///< of the material
    double loss_frequency    = 1000.; ///< Hz
    double mass_damping      = 0.;    ///< 1/s
    double stiffness_damping = 0.;    ///< s
    double sponge_length     = 0.;    ///< m at each end along x
    double sponge_rate       = 3000.; ///< 1/s at the very ends
    std::vector<double>
      modal; ///< with 0, 1, ... nodal diameters, the last: all
    std::vector<std::pair<double, double>>
      of_modes; ///< of single modes in addition: frequency (Hz), ratio

    /**
     * Whether there is a viscous matrix.
     */
    bool is_viscous() const
    {
      return mass_damping > 0. || stiffness_damping > 0. || has_sponge();
    }

    bool has_sponge() const
    {
      return sponge_length > 0. && sponge_rate > 0.;
    }

    /**
     * Retardation time of the material in time, C = tau K. Units: s.
     */
    double retardation() const
    {
      return stiffness_damping + loss_factor / (2 * pi * loss_frequency);
    }

    bool operator==(const BodyDamping &other) const
    {
      const auto tied = [](const BodyDamping &it) {
        return std::tie(it.loss_factor,
                        it.loss_frequency,
                        it.mass_damping,
                        it.stiffness_damping,
                        it.sponge_length,
                        it.sponge_rate,
                        it.modal,
                        it.of_modes);
      };
      return tied(*this) == tied(other);
    }
  };

  /**
   * How a body is modelled beyond shape and material: its elements, what is at
   * its hub, its damping.
   */
  struct BodyModel
  {
    ElementKind elements = ElementKind::b_bar;
    Foundation  foundation;
    HubMass     hub_mass;
    BodyDamping damping;

    bool operator==(const BodyModel &other) const
    {
      return elements == other.elements && foundation == other.foundation &&
             hub_mass == other.hub_mass && damping == other.damping;
    }
  };
} // namespace RollingContact

#endif
