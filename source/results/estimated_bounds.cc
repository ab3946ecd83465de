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
     * Weights of estimates and of what circumstances tell, see
     * estimated_bounds().
     */
    const double of_across = 0.4, of_circumstances = 0.1, of_bulk = 0.8,
                 of_bulk_under_approach = 1.3;

    /**
     * What the growth of the mesh adds to the heat, over Mesh/Growth and mu: it
     * moves the slip of nodes that slide all the same.
     */
    const double of_growth_on_heat = 2e-3;

    /**
     * What the elements across the patch may add to a value, from its change on
     * every second node and the bound by circumstances.
     */
    double of_elements(const double across, const double known)
    {
      return std::min(known,
                      std::sqrt(of_across * across * known) +
                        of_circumstances * known);
    }

    std::string in_words(const double      elements,
                         const double      bulk,
                         const std::string bulk_text,
                         const double      residual)
    {
      std::string text = scientific(elements, 2) +
                         " for the elements across the patch, " +
                         scientific(bulk, 2) + " for " + bulk_text;
      if (residual > 0.1 * (elements + bulk))
        text += ", " + scientific(residual, 2) + " for the residual";
      return text;
    }

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
  } // namespace

  ErrorBounds estimated_bounds(const BoundCircumstances &found,
                               const ErrorEstimate      &estimate,
                               const Resultants         &result)
  {
    ErrorBounds       bounds = error_bounds(found);
    const ErrorBounds mesh   = error_bounds(of_mesh_alone(found));
    if (!bounds.force || !(result.friction_force > 0.) ||
        !(result.normal_force > 0.))
      return bounds;
    const double scale    = result.friction_force,
                 moment   = scale * result.half_width_x,
                 residual = residual_share(found),
                 bulk = found.approach_given ? of_bulk_under_approach : of_bulk;
    const bool   tells       = estimate.n_positions > 0;
    const double unknown     = std::numeric_limits<double>::infinity();
    const auto   elements_of = [&](const double change) {
      return estimate.sticks ? of_elements(change, *mesh.force) : *mesh.force;
    };
    const double elements =
      elements_of(std::min(tells ? estimate.across.force / scale : unknown,
                           estimate.from_level_before.value_or(unknown)));
    const double of_growth = estimate.bulk_known
                               ? bulk * estimate.bulk.force / scale
                               : *bounds.force - *mesh.force - residual;
    bounds.force           = std::min(1., elements + of_growth + residual);
    bounds.text =
      in_words(elements, of_growth, "the growth of the mesh", residual);
    if (found.dim == 3 && moment > 0.)
      bounds.moment =
        std::min(1.,
                 elements_of(tells ? estimate.across.moment / moment
                                   : unknown) +
                   (estimate.bulk_known ? bulk * estimate.bulk.moment / moment
                                        : of_growth) +
                   residual);
    if (estimate.from_level_before)
      bounds.max_pressure =
        std::max(*bounds.max_pressure,
                 1.3 * estimate.across.max_pressure / result.max_pressure);
    if (found.approach_given && estimate.bulk_known && tells)
      bounds.normal_force = (of_across * estimate.across.normal_force +
                             bulk * estimate.bulk.normal_force) /
                            result.normal_force;
    if (tells && result.dissipation > 0.)
      bounds.dissipation =
        (estimate.across.dissipation + estimate.bulk.dissipation) /
          result.dissipation +
        *mesh.force + residual +
        of_growth_on_heat * found.growth / std::max(found.friction, 1e-6);
    return bounds;
  }
} // namespace RollingContact
