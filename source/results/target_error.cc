#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/touching_run.h>
#include <rolling_contact/results/target_error.h>
#include <rolling_contact/surfaces/roughness.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    /**
     * Patches were found to be up to 2 % shorter than estimated for a load;
     * what is more is found out by the first mesh.
     */
    const double margin = 0.98;

    /**
     * From so many elements on the own bound of a single state in 3D is hoped
     * to fall with their number beside the one expected of its kind: by 0.8
     * with 14, 0.46 with 21, 0.31 with 29 on crowned discs; and by how much
     * more than that it may be on the next mesh.
     */
    const double hopeful_elements = 11., room = 1.1;

    /**
     * Least and most elements to think of: fewer have no bound, and in 2D the W
     * of so many alone takes 13 GB.
     */
    const unsigned int least_elements = 4, most_elements = 20000;

    /**
     * Growths to choose from: larger ones save less than 10 %, smaller ones no
     * memory holds in 3D.
     */
    const std::vector<double>
      growths{1.2, 0.8, 0.6, 0.4, 0.3, 0.2, 0.15, 0.1, 0.05, 0.02, 0.01};

    /**
     * Seconds of a state after the start of the program, but for a factor. In
     * 3D fitted to 25 states with 10 to 38 elements at growths of 0.2 to 1.2,
     * where it is off by 20 % in the mean; in 2D, where states take
     * milliseconds, to 24 and 48 elements at 0.05 to 1.2.
     */
    double cost(const int dim, const unsigned int elements, const double growth)
    {
      if (dim == 2)
        return (100. + elements) * (1 + std::pow(0.1 / growth, 2));
      const double n = elements / 20.;
      return std::pow(n, 4.4) +
             0.37 * std::pow(n, 1.7) * std::pow(growth, -1.75);
    }

    /**
     * Largest change_of_curvature() of the undeformed gap on lines through the
     * estimated patch, with points of this distance. Units: m.
     */
    double waves_at_distance(const PairSpec      &scene,
                             const PatchEstimate &patch,
                             const double         size)
    {
      const Roughness roughness(scene.contact.roughness);
      const auto      wheel = scene.wheel.body_shape(),
                 rail       = scene.rail.body_shape();
      double largest        = 0.;
      for (const double place : {-0.6, -0.3, 0., 0.3, 0.6})
        {
          const double y    = place * patch.half_width_y,
                       half = patch.half_width_x * std::sqrt(1 - place * place);
          std::vector<double> x, gap;
          for (double at = -half; at < half; at += size)
            {
              x.push_back(at);
              gap.push_back(-wheel->surface_height(at, y) -
                            rail->surface_height(at, y) +
                            roughness.value(at, y));
            }
          TouchingRun run;
          run.nodes.resize(x.size());
          std::iota(run.nodes.begin(), run.nodes.end(), 0);
          largest = std::max(largest, change_of_curvature(run, x, gap));
        }
      return largest;
    }

    /**
     * Waves of the gap that a mesh with so many elements across the patch
     * resolves, looked for at smaller distances as well, since a wave as long
     * as an element vanishes at its nodes.
     */
    double waves_of_gap(const PairSpec      &scene,
                        const PatchEstimate &patch,
                        const unsigned int   elements)
    {
      double largest = 0.;
      for (const double finer : {1., 1.15, 1.35})
        largest = std::max(largest,
                           waves_at_distance(scene,
                                             patch,
                                             2 * patch.half_width_x /
                                               (elements * finer)));
      return largest;
    }
  } // namespace

  TargetError::TargetError(const PairSpec &scene, const TargetDemands &demands)
    : scene(scene)
    , demands(demands)
    , target(*scene.mesh.target_error)
    , patch(estimate_patch(scene))
    , known(expected_circumstances(scene, patch.half_width_x))
    , length(margin)
    , hopes(demands.is_one_state() && known.dim == 3)
  {
    known.spin = known.spin || demands.spin;
  }

  ErrorBounds TargetError::worst_bounds(const BoundCircumstances &found) const
  {
    ErrorBounds worst;
    for (const double share : demands.patches)
      {
        BoundCircumstances state = found;
        state.n *= share;
        state.thickness /= share;
        ErrorBounds bounds = error_bounds(state);
        if (!bounds.force)
          return bounds;
        const double hoped =
          raised * (hopes ? std::min(1., hopeful_elements / state.n) : 1.);
        *bounds.force = std::min(1., hoped * *bounds.force);
        if (hoped != 1.)
          bounds.text += "; " + significant(hoped, 2) + " times that";
        if (!worst.force || *bounds.force > *worst.force)
          worst = bounds;
      }
    return worst;
  }

  BoundCircumstances TargetError::expected(const unsigned int elements,
                                           const double       growth) const
  {
    BoundCircumstances found = known;
    found.n                  = length * elements;
    found.growth             = growth;
    if (!scene.contact.roughness.empty())
      found.waves = waves * waves_of_gap(scene, patch, elements);
    return found;
  }

  TargetMesh TargetError::cheapest_mesh() const
  {
    TargetMesh best;  // that keeps the target
    TargetMesh other; // that comes nearest to it
    double     least_cost = std::numeric_limits<double>::infinity();
    for (unsigned int n = least_elements; n <= most_elements;
         n += std::max(1u, n / 50))
      {
        if (cost(known.dim, n, growths.front()) >= least_cost)
          break;
        BoundCircumstances mesh = expected(n, growths.front());
        for (const double growth : growths)
          {
            mesh.growth              = growth;
            const ErrorBounds bounds = worst_bounds(mesh);
            const double      price  = cost(known.dim, n, growth);
            if (bounds.force && *bounds.force <= target && price < least_cost)
              {
                best       = {n, growth, bounds};
                least_cost = price;
              }
            if (!other.bounds.force ||
                (bounds.force && *bounds.force < *other.bounds.force))
              other = {n, growth, bounds};
          }
      }
    if (!best.bounds.force)
      reject(other);
    return best;
  }

  void TargetError::reject(const TargetMesh &best) const
  {
    const std::string entry =
      "Mesh/Target error = " + significant(target, 6) + ": ";
    if (!best.bounds.force)
      throw InputError(entry + "no bound of the error is known, " +
                       best.bounds.text +
                       ". Leave it empty and give Mesh/Elements across patch.");
    BoundCircumstances solved  = expected(best.elements, best.growth);
    solved.residual_tangential = 0.;
    std::string remedy         = "Give a larger target";
    if (*worst_bounds(solved).force < 0.5 * *best.bounds.force)
      remedy += " or a smaller Contact/Tolerance than " +
                significant(scene.solver.controls.tolerance, 3);
    else if (known.kind != SlipOperatorKind::calibrated)
      remedy += " or Contact/Slip operator = calibrated";
    else if (!scene.contact.roughness.empty())
      remedy += " or a smoother Contact/Roughness";
    throw InputError(entry + "the smallest bound of any mesh is " +
                     scientific(*best.bounds.force, 2) + " (" +
                     best.bounds.text + "). " + remedy + ".");
  }

  template <int dim>
  BoundCircumstances TargetError::found_on(const TargetMesh       &mesh,
                                           const SteadyState<dim> &steady) const
  {
    BoundCircumstances found = bound_circumstances(scene, steady);
    found.spin               = found.spin || demands.spin;
    found.growth             = mesh.growth;
    return found;
  }

  template <int dim>
  ErrorBounds TargetError::own_bounds(const TargetMesh       &mesh,
                                      const SteadyState<dim> &steady) const
  {
    PairSpec meshed    = scene;
    meshed.mesh.growth = mesh.growth;
    return error_bounds(meshed, steady);
  }

  template <int dim>
  ErrorBounds TargetError::bounds_on(const TargetMesh       &mesh,
                                     const SteadyState<dim> &steady) const
  {
    const ErrorBounds worst = worst_bounds(found_on(mesh, steady)),
                      here  = own_bounds(mesh, steady);
    return worst.force && here.force &&
               (demands.is_one_state() || *here.force > *worst.force)
             ? here
             : worst;
  }

  template <int dim>
  void TargetError::learn(const TargetMesh       &mesh,
                          const SteadyState<dim> &steady,
                          const bool              the_last)
  {
    const double tolerance     = scene.solver.controls.tolerance;
    known                      = found_on(mesh, steady);
    known.residual_tangential  = std::max(known.residual_tangential, tolerance);
    length                     = margin * known.n / mesh.elements;
    const ErrorBounds expected = worst_bounds(known),
                      here     = own_bounds(mesh, steady);
    if (expected.force && here.force)
      {
        const double ratio = *here.force / *expected.force;
        raised *= demands.is_one_state() ? room * ratio : std::max(1., ratio);
      }
    if (the_last)
      {
        hopes  = false;
        raised = std::max(raised, 1.);
      }
    if (!scene.contact.roughness.empty())
      waves = std::max(waves,
                       known.waves / waves_of_gap(scene, patch, mesh.elements));
  }

  template ErrorBounds TargetError::bounds_on(const TargetMesh &,
                                              const SteadyState<2> &) const;
  template ErrorBounds TargetError::bounds_on(const TargetMesh &,
                                              const SteadyState<3> &) const;
  template void
  TargetError::learn(const TargetMesh &, const SteadyState<2> &, const bool);
  template void
  TargetError::learn(const TargetMesh &, const SteadyState<3> &, const bool);
} // namespace RollingContact
