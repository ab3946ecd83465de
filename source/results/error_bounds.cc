#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/friction_limit.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/estimated_bounds.h>
#include <rolling_contact/solvers/scaled_forces.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * c / n^p.
     */
    struct Bound
    {
      double constant;
      double order;

      double at(const double n) const
      {
        return constant / std::pow(n, order);
      }
    };

    /**
     * Dundurs' constant from which on the edge law is of first order in full.
     */
    const double of_first_order = 0.06;

    /**
     * How much of the bound is of first order, 0 to 1: the edge law keeps its
     * order for one material that is not nearly incompressible, and loses it
     * little by little.
     */
    double share_of_first_order(const BoundCircumstances &found)
    {
      const double of_materials = std::min(1., found.beta / of_first_order);
      if (found.kind == SlipOperatorKind::upwind_2)
        return of_materials;
      return found.edge_law ? std::max(of_materials, found.incompressibility)
                            : 1.;
    }

    /**
     * Below one half-width of thickness, and with waves that no mesh of this
     * size resolves, nothing was found that bounds the error.
     */
    const double thinnest = 1., roughest = 3.;

    /**
     * Waves that the edge law leaves to upwind 2, see slip_rows().
     */
    const double unresolved = 0.5;

    /**
     * Friction below which the elements across the patch shift the slip by more
     * than the edges of the patch do: the force over mu N follows as 1 / mu.
     */
    const double little_friction = 0.1;

    double rise_of_elements(const double friction)
    {
      return friction > 0. ? std::max(1., little_friction / friction) : 1.;
    }

    double rise_with_spin(const BoundCircumstances &found)
    {
      return found.dim == 3 && found.spin && found.expected ? most_under_spin
                                                            : 1.;
    }

    /**
     * Bodies thinner than so many half-widths count as thin.
     */
    const double thin = 3.;

    /**
     * What a wave adds, over change_of_curvature().
     */
    const double of_waves = 0.05;

    /**
     * What the growth of the mesh adds, over Mesh/Growth, and the residual of
     * the solver, over itself.
     */
    const double of_growth = 2e-3, of_residual = 4.;

    /**
     * What the growth adds below a friction of 0.3: the bulk shifts the slip,
     * and the force over mu N follows as 1 / mu.
     */
    double rise_with_little_friction(const double friction)
    {
      return friction > 0. ? std::max(1., 0.6 / friction - 1) : 1.;
    }

    /**
     * What it adds to the force of a body under a given approach, whose load
     * has an error then, and of one half-width of thickness, as much over its
     * thickness in half-widths, at most half of it; 3D: half of that.
     */
    const double of_growth_under_approach = 1e-2, of_growth_of_layer = 2.5e-2,
                 most_of_layer = 1e-2;

    /**
     * What it adds to the peak pressure.
     */
    const double of_growth_on_peak                = 4e-3,
                 of_growth_on_peak_under_approach = 1.6e-2;

    /**
     * Growth below which the bulk has an error of second order in it.
     */
    const double small_growth = 0.25;

    double growth_in_bulk(const BoundCircumstances &found)
    {
      return found.growth * std::min(1., found.growth / small_growth);
    }

    /**
     * What the growth of the mesh adds to the bound of the force.
     */
    double share_of_growth(const BoundCircumstances &found)
    {
      const double layer =
        std::min(most_of_layer, of_growth_of_layer / found.thickness);
      return of_growth * found.growth *
               rise_with_little_friction(found.friction) +
             ((found.approach_given ? of_growth_under_approach : 0.) +
              (found.dim == 2 ? 1. : 0.5) * layer) *
               growth_in_bulk(found);
    }

    /**
     * Change of the gap's curvature from which on waves count.
     */
    const double wavy = 0.1;

    /**
     * Factor of the bound where the edge law does not keep its order and the
     * body is thin, the rim refined, or the gap has waves as well.
     */
    const double of_both = 2.5;

    /**
     * Factor of the bound where the one edge of a plane patch did not settle;
     * in 3D it is a few of many.
     */
    const double of_unsettled = 2.;

    /**
     * Length over width of elements, and width over length, from which on it
     * raises the bound, and by which share of it.
     */
    const double longest_element = 2., of_long_elements = 6.,
                 widest_element = 1.6, of_wide_elements = 1.;

    double rise_with_shape(const BoundCircumstances &found)
    {
      return 1 +
             of_long_elements *
               std::max(0., found.element_aspect - longest_element) +
             of_wide_elements *
               std::max(0., 1 / found.element_aspect - widest_element);
    }

    Bound upwind_2_bound(const bool plane)
    {
      return {plane ? 0.4 : 0.65, 1.};
    }

    /**
     * The part of the operator's own order, that of bodies of one material.
     */
    Bound bound_of_twins(const BoundCircumstances &found, const bool disturbed)
    {
      const bool plane = found.dim == 2;
      if (found.kind == SlipOperatorKind::upwind_2 || found.waves > unresolved)
        return upwind_2_bound(plane);
      if (plane)
        return {disturbed ? 5. : 1.3, 2.};
      return found.spin ? Bound{0.5, 1.5} : Bound{disturbed ? 2.6 : 1.3, 2.};
    }

    /**
     * The two parts of c / n^p, of the order of the operator and of the first.
     */
    std::array<Bound, 2> force_bounds(const BoundCircumstances &found)
    {
      const bool   plane = found.dim == 2;
      const double of_upwind_2 =
        found.on_upwind_2 * upwind_2_bound(plane).constant;
      const bool disturbed = found.thickness < thin || found.refined;
      if (found.kind == SlipOperatorKind::upwind_1)
        return {{{plane ? 0.65 : 1.1, 1.}, {0., 1.}}};
      if (found.kind == SlipOperatorKind::galerkin)
        return {{{plane ? 1.6 : 0.8, 1.}, {0., 1.}}};
      const double share = share_of_first_order(found);
      Bound        own   = bound_of_twins(found, disturbed);
      own.constant *= 1 - share;
      return {{own,
               {share * ((plane ? 0.6 : 0.75) + 2.4 * found.beta) *
                    (disturbed || found.waves > wavy ? of_both : 1.) +
                  of_upwind_2,
                1.}}};
    }

    std::string in_words(const std::array<Bound, 2> &bounds, const double n)
    {
      std::string sum;
      for (const Bound &bound : bounds)
        if (bound.constant > 0.)
          sum += (sum.empty() ? "" : " + ") + significant(bound.constant, 2) +
                 "/n" +
                 (bound.order > 1. ? "^" + significant(bound.order, 2) : "");
      return sum + ", n = " + significant(n, 2) + " elements across the patch";
    }
  } // namespace

  double residual_share(const BoundCircumstances &found)
  {
    return of_residual * found.residual_tangential;
  }

  namespace
  {
    const char ends_of_line[] =
      "at the ends of a line contact pressure and tractions follow no closed "
      "form";
    const char layered_bodies[] =
      "the bounds are those of bodies without covers";
  } // namespace

  ErrorBounds error_bounds(const BoundCircumstances &found)
  {
    ErrorBounds bounds;
    if (found.thickness < thinnest)
      bounds.text = "a body is thinner than half the patch";
    else if (found.varying_friction)
      bounds.text = "friction differs from place to place, or has a memory";
    else if (found.waves > roughest)
      bounds.text = "the surface has waves of few elements";
    if (!bounds.text.empty())
      return bounds;

    std::array<Bound, 2> parts = force_bounds(found);
    double               mesh  = 0.;
    for (Bound &part : parts)
      {
        part.constant *= rise_with_shape(found) *
                         rise_of_elements(found.friction) *
                         rise_with_spin(found);
        mesh += part.at(found.n);
      }
    bounds.first_order =
      parts[1].at(found.n) / mesh +
      (parts[0].order > 1. ? 0. : parts[0].at(found.n) / mesh);
    const double added = of_waves * (found.waves > wavy ? found.waves : 0.) +
                         share_of_growth(found) + residual_share(found);
    bounds.force =
      std::min(1.,
               (found.dim == 3 || found.edges_settled ? 1. : of_unsettled) *
                   mesh +
                 added);
    bounds.text = in_words(parts, found.n) + ", and " + scientific(added, 1) +
                  " for " + (found.waves > wavy ? "waves, " : "") +
                  "the growth of the mesh and the residual";
    if (found.dim == 3)
      bounds.moment = bounds.force;
    bounds.max_pressure =
      std::max(Bound{2., 2.}.at(found.n), found.bend_of_peak) +
      (found.waves > wavy ? 0.3 * found.waves : 0.) +
      4 * found.beta * found.friction / found.n +
      of_growth_on_peak * found.growth +
      (found.approach_given
         ? of_growth_on_peak_under_approach * growth_in_bulk(found)
         : 0.) +
      of_residual * found.residual_normal;
    return bounds;
  }

  template <int dim>
  ErrorBounds error_bounds(const PairSpec         &scene,
                           const SteadyState<dim> &steady)
  {
    if (scene.touches_in_line() || scene.has_covers())
      {
        ErrorBounds unknown;
        unknown.text = scene.touches_in_line() ? ends_of_line : layered_bodies;
        return unknown;
      }
    const BoundCircumstances found = bound_circumstances(scene, steady);
    return steady.estimate
             ? estimated_bounds(found, *steady.estimate, steady.result)
             : error_bounds(found);
  }

  template <int dim>
  std::vector<double> creepage_bounds(const PairSpec         &scene,
                                      const SteadyState<dim> &steady,
                                      const ErrorBounds      &bounds)
  {
    const AskedForces &asked = steady.problem.loads.forces;
    if (!bounds.force || (asked.moment && !bounds.moment) ||
        !(steady.result.friction_force > 0.))
      return {};
    double part = *bounds.force;
    if (asked.moment)
      {
        const double mu_N_a =
          steady.result.friction_force * steady.result.half_width_x;
        part = std::max(part,
                        *bounds.moment * mu_N_a /
                          sliding_resultant(steady.problem,
                                            steady.state.pressure,
                                            2));
      }
    return creepage_margins(steady.problem,
                            scene.solver.controls,
                            steady.state,
                            part);
  }

  template ErrorBounds error_bounds(const PairSpec &, const SteadyState<2> &);
  template ErrorBounds error_bounds(const PairSpec &, const SteadyState<3> &);
  template std::vector<double> creepage_bounds(const PairSpec &,
                                               const SteadyState<2> &,
                                               const ErrorBounds &);
  template std::vector<double> creepage_bounds(const PairSpec &,
                                               const SteadyState<3> &,
                                               const ErrorBounds &);
} // namespace RollingContact
