#include <rolling_contact/base/text.h>
#include <rolling_contact/results/estimated_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * What the growth of the mesh adds to the heat, over Mesh/Growth and mu: it
     * moves the slip of nodes that slide all the same.
     */
    const double of_growth_on_heat = 2e-3;

    /**
     * Weight of the change on every second node in the error of the peak
     * pressure, where elements were refined.
     */
    const double of_change_on_peak = 1.3;

    /**
     * Under spin, whose error falls with n^1.5 only: the error over the change
     * on every second node, were it of second order.
     */
    const double of_second_order = 1. / 3;

    /**
     * What the change from the level before weighs at least, and how much of
     * the change on every second node stays where that is small by chance.
     */
    const double of_change_of_level = 1.3, least_of_halving = 1. / 3;

    /**
     * Weight of the load on slip that turns, where every node slides.
     */
    const double of_turning_slip = 0.125;

    /**
     * The circumstances without what is estimated or added by itself.
     */
    BoundCircumstances of_mesh_alone(BoundCircumstances found)
    {
      found.growth              = 0.;
      found.residual_tangential = found.residual_normal = 0.;
      found.approach_given                              = false;
      return found;
    }

    /**
     * The bounds of a state by what it tells of itself, see
     * estimated_bounds().
     */
    class Estimated
    {
    public:
      Estimated(const BoundCircumstances &found,
                const ErrorEstimate      &estimate,
                const Resultants         &result)
        : found(found)
        , estimate(estimate)
        , result(result)
        , known(error_bounds(found))
        , mesh(error_bounds(of_mesh_alone(found)))
        , residual(residual_share(found))
        , tells(estimate.n_positions > 0)
      {}

      ErrorBounds bounds() const;

    private:
      /**
       * What the elements across the patch may add to a force or a moment that
       * changes by so much on every second node, both over that of sliding.
       */
      double of_elements(const double change) const
      {
        // 1/(2^p - 1) of the change is the error of order p; in 3D the lines of
        // a patch have edges at many places of the mesh
        const bool   plane  = found.dim == 2;
        const double weight = plane ? 0.4 + 0.6 * mesh.first_order : 0.2,
                     share  = plane ? 0.05 + 0.1 * mesh.first_order : 0.1,
                     most   = *mesh.force;
        if (change == unknown)
          return most;
        if (estimate.load_on_turning_slip)
          return std::min(most, change + of_turns());
        // errors that come near to what is known of them, whatever E says
        const bool is_near = found.kind == SlipOperatorKind::upwind_1 ||
                             (!plane && found.falling_friction);
        const double told =
          is_near
            ? most
            : std::min(most, std::sqrt(weight * change * most) + share * most);
        return plane || !found.spin
                 ? told
                 : std::max(told,
                            std::min(of_second_order * change,
                                     most_under_spin * most));
      }

      /** What nodes that all slide may miss, over mu N. */
      double of_turns() const
      {
        return of_turning_slip * *estimate.load_on_turning_slip /
               result.normal_force;
      }

      /**
       * What is missing in the bulk, over a value of the same units.
       */
      double of_bulk(double ValueChanges::*what, const double value) const
      {
        return (found.approach_given ? 1.3 : 0.8) * ((*estimate.bulk).*what) /
               value;
      }

      /**
       * What the growth of the mesh adds to a force or a moment, over that of
       * sliding: what is missing in the bulk or, where that is not known, what
       * the circumstances tell.
       */
      double of_growth(double ValueChanges::*what, const double sliding) const
      {
        return estimate.bulk ? of_bulk(what, sliding)
                             : *known.force - *mesh.force - residual;
      }

      double of_elements_on_force() const;

      void set_force(ErrorBounds &bounds) const;

      void set_moment(ErrorBounds &bounds) const;

      void set_heat(ErrorBounds &bounds) const;

      const BoundCircumstances &found;
      const ErrorEstimate      &estimate;
      const Resultants         &result;
      const ErrorBounds         known, mesh;
      const double              residual;
      const bool                tells;
      static constexpr double unknown = std::numeric_limits<double>::infinity();
    };

    /**
     * What the elements across the patch may add to a force; with levels of
     * refinement by what the last one changed as well.
     */
    double Estimated::of_elements_on_force() const
    {
      const double halving =
        tells ? estimate.across.force / result.friction_force : unknown;
      if (!estimate.from_level_before)
        return of_elements(halving);
      const double level = estimate.from_level_before->forces;
      return std::max(of_elements(std::min(
                        halving, std::max(level, least_of_halving * halving))),
                      of_change_of_level * level);
    }

    void Estimated::set_force(ErrorBounds &bounds) const
    {
      const double sliding  = result.friction_force,
                   elements = of_elements_on_force(),
                   growth   = of_growth(&ValueChanges::force, sliding);
      bounds.force          = std::min(1., elements + growth + residual);
      bounds.text           = scientific(elements, 2) +
                    " for the elements across the patch, " +
                    scientific(growth, 2) +
                    (found.split ? " for the bodies beyond half-spaces"
                                 : " for the growth of the mesh");
      if (residual > 0.1 * (elements + growth))
        bounds.text += ", " + scientific(residual, 2) + " for the residual";
    }

    void Estimated::set_moment(ErrorBounds &bounds) const
    {
      const double sliding = result.friction_force * result.half_width_x;
      if (sliding > 0.)
        bounds.moment =
          std::min(1.,
                   of_elements(tells ? estimate.across.moment / sliding
                                     : unknown) +
                     of_growth(&ValueChanges::moment, sliding) + residual);
    }

    void Estimated::set_heat(ErrorBounds &bounds) const
    {
      if (tells && result.dissipation > 0.)
        bounds.dissipation =
          (estimate.across.dissipation +
           (estimate.bulk ? estimate.bulk->dissipation : 0.)) /
            result.dissipation +
          (estimate.load_on_turning_slip ? of_elements_on_force()
                                         : *mesh.force) +
          residual + of_growth_on_heat * found.growth / found.friction;
    }

    ErrorBounds Estimated::bounds() const
    {
      ErrorBounds bounds = known;
      if (!known.force || !(result.normal_force > 0.))
        return bounds;
      if (estimate.from_level_before)
        bounds.max_pressure =
          std::max(*bounds.max_pressure,
                   of_change_on_peak *
                     std::max(estimate.across.max_pressure /
                                result.max_pressure,
                              estimate.from_level_before->max_pressure));
      if (found.approach_given && estimate.bulk && tells)
        bounds.normal_force =
          estimate.across.normal_force / result.normal_force +
          of_bulk(&ValueChanges::normal_force, result.normal_force);
      if (!(result.friction_force > 0.))
        return bounds;
      set_force(bounds);
      if (found.dim == 3)
        set_moment(bounds);
      set_heat(bounds);
      return bounds;
    }
  } // namespace

  ErrorBounds estimated_bounds(const BoundCircumstances &found,
                               const ErrorEstimate      &estimate,
                               const Resultants         &result)
  {
    return Estimated(found, estimate, result).bounds();
  }
} // namespace RollingContact
