#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/pair/split_choice.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Outer radius of the fading region over the distance to the next edge, and
     * over the inner radius, which leaves as much room for nodes as may be:
     * with an outer radius of 6 half-widths forces hardly depend on it, with
     * 3.5 they were 0.23 % of mu N off.
     */
    const double share_of_distance = 0.9, outer_over_inner = 3.5,
                 least_ratio = 2.2;

    /**
     * Inner radii of the fading region of true sections, and over them the
     * outer one and that from which on the surface may be steep: forces were
     * the same to 3e-4 of mu N with 25 to 36 mm for the outer, 16 to 20 mm for
     * the last. Units: m.
     */
    const double usual_inner = 12e-3, largest_inner = 16e-3,
                 section_outer_over_inner = 3., steep_over_inner = 1.6;

    /**
     * Error of the force for want of second order in the curvature, over mu N
     * and the half-width over the least radius: 0.05 was found.
     */
    const double of_curvature = 0.1;

    /**
     * Error of the force for what true sections add to half-spaces, over mu N:
     * 3.5e-3 to 4.9e-3 was found against 24 to 40 finite elements across.
     */
    const double of_sections = 4e-3;

    /**
     * Dundurs' constant from which on materials are unlike.
     */
    const double largest_beta = 0.01;

    /**
     * Bound of the force without spin in error_bounds(), over the inverse
     * square of the elements across the patch.
     */
    const double of_elements = 1.3;

    /**
     * Number of split bodies that are kept.
     */
    const std::size_t most_kept = 8;

    /**
     * Largest patch over the radii of a surface that is taken as plane, and
     * over those of a true section along x and across.
     */
    const double largest_curvature = 0.05, largest_of_section = 0.1;

    /**
     * How far the farthest node that may touch is from the contact point.
     * Units: m.
     */
    template <int dim>
    double farthest_node(const Grading<dim> &grading)
    {
      const auto along = grading.zone_along(), across = grading.zone_across();
      if (grading.zone_boxes.empty())
        return std::max({-along[0], along[1], dim == 3 ? across[1] : 0.});
      return std::hypot(std::max(-along[0], along[1]),
                        std::max(-across[0], across[1]));
    }

    /**
     * How far nodes that may touch are from the contact point, along x and
     * across. Units: m.
     */
    template <int dim>
    std::array<double, 2> reach_of_nodes(const Grading<dim> &grading)
    {
      const auto along = grading.zone_along(), across = grading.zone_across();
      return {{std::max(-along[0], along[1]), std::max(-across[0], across[1])}};
    }

    /**
     * Whether the program meshes the section under a profile.
     */
    bool is_true_section(const BodyShape &shape)
    {
      return shape.is_swept() && !shape.has_own_cells();
    }

    /**
     * Where the half-space fades out in a true section, beyond edges of its
     * running surface, whose tractions are those at the surface itself. Units:
     * m.
     */
    FadingRegion fading_in_section(const BodyShape &shape,
                                   const double     farthest)
    {
      const double possible = shape.distance_to_edge() / steep_over_inner,
                   wanted = farthest > usual_inner / FadingRegion::beyond_loads
                              ? largest_inner
                              : usual_inner,
                   inner  = std::min(possible, wanted),
                   held   = share_of_distance *
                          std::min(shape.reach_x(), shape.thickness_below());
      return {inner,
              std::min(section_outer_over_inner * inner, held),
              steep_over_inner * inner};
    }

    /**
     * Where the half-space fades out in a body of this shape. Units: m.
     */
    FadingRegion fading_region(const BodyShape &shape, const double farthest)
    {
      if (is_true_section(shape))
        return fading_in_section(shape, farthest);
      const double outer = share_of_distance * shape.distance_to_edge();
      FadingRegion fading{outer / outer_over_inner, outer};
      if (fading.loads_end() < farthest)
        fading.inner = outer / least_ratio;
      return fading;
    }

    /**
     * r/R for distances r along x and across, the larger one, from the heights
     * of a circle, -r^2 / (2 R).
     */
    double over_radii(const BodyShape &shape, const std::array<double, 2> &r)
    {
      return std::max(2 * std::abs(shape.surface_height(r[0], 0.)) / r[0],
                      2 * std::abs(shape.surface_height(0., r[1])) / r[1]);
    }

    /**
     * What speaks against one body.
     */
    template <int dim>
    std::string reason_of_body(const BodySpec     &body,
                               const Grading<dim> &grading)
    {
      const double farthest   = farthest_node(grading);
      const auto   shape      = body.body_shape();
      const bool   is_section = is_true_section(*shape);
      if (!(shape->distance_to_edge() > 0.))
        return "the " + body.section +
               " has a mesh, or under a profile a section, from a file";
      const FadingRegion fading = fading_region(*shape, farthest);
      if (is_section && farthest > largest_inner / FadingRegion::beyond_loads)
        return "the patch is large for the section of the " + body.section;
      if (fading.loads_end() < farthest)
        return "nodes that may touch are up to " +
               significant(1e3 * farthest, 3) +
               " mm from the contact point, and the next edge of the " +
               body.section + " or what holds it " +
               significant(1e3 * shape->distance_to_edge(), 3) + " mm, where " +
               significant(1e3 * shape->distance_to_edge() * farthest /
                             fading.loads_end(),
                           3) +
               " mm are needed";
      if (!is_section && (shape->surface_height(farthest, 0.) > 0. ||
                          shape->surface_height(0., farthest) > 0.))
        return "the surface of the " + body.section + " is concave";
      const bool is_large =
        is_section
          ? over_radii(*shape, reach_of_nodes(grading)) > largest_of_section
          : over_radii(*shape, {{farthest, farthest}}) > largest_curvature;
      return is_large
               ? "the patch is large for the radii of the " + body.section
               : "";
    }

    /**
     * Why finite elements would be more exact, or empty: unlike materials have
     * 2 to 10 times less error with them, and the curvature of the surfaces may
     * count for more than the elements across the patch.
     */
    template <int dim>
    std::string why_not_better(const PairSpec     &scene,
                               const Grading<dim> &grading)
    {
      if (std::abs(pair_constants(scene).dundurs_beta) > largest_beta)
        return "the materials are unlike";
      const bool is_section  = scene.profiles.has_true_sections();
      double     over_radius = 0.;
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (!body->rigid)
          {
            const auto   shape      = body->body_shape();
            const double half_width = std::abs(grading.leading_edge_x),
                         shape_of_elements =
                           grading.element_size_y / grading.element_size_x;
            over_radius =
              std::max(over_radius,
                       over_radii(*shape,
                                  {{half_width,
                                    half_width *
                                      (is_section ? shape_of_elements : 1.)}}));
          }
      const double error = of_elements / std::pow(grading.elements_across(), 2);
      if (of_curvature * over_radius > error)
        return "the curvature of the surfaces would count for more than the "
               "elements across the patch";
      return is_section && of_sections > error
               ? "what true sections add to half-spaces is known less exactly "
                 "than that many elements across the patch are"
               : "";
    }

    /**
     * Why the compliance of these bodies cannot be split: a part of a sentence,
     * empty if it can.
     */
    template <int dim>
    std::string why_not_split(const PairSpec     &scene,
                              const Grading<dim> &grading,
                              const PairDemands  &demands)
    {
      if (demands.displacements && !demands.modes)
        return "displacements inside the bodies are wanted (Output/Body fields)";
      if (scene.body_solver == BodySolver::distributed)
        return "bodies are spread over ranks (Body solver = distributed)";
      if (scene.mesh.rim_levels > 0 || scene.mesh.adaptive_levels > 0)
        return "elements of the contact are refined (Mesh/Rim levels, Adaptive "
               "levels)";
      if (scene.contact.contact_matrices != ContactMatrices::lumped)
        return "Contact/Contact matrices are not lumped";
      if (scene.has_covers())
        return "a body has a cover of another material (Cover thickness)";
      if (scene.profiles.has_true_sections() && demands.modes)
        return "true sections vibrate (modes are those of finite elements)";
      if (scene.profiles.has_true_sections() &&
          scene.profiles.surface_kind == Profiles::SurfaceKind::curved)
        return "the surface of contact between true sections is curved";
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (!body->rigid && scene.mesh.compliance != Compliance::half_spaces)
          if (const std::string reason = reason_of_body(*body, grading);
              !reason.empty())
            return reason;
      return "";
    }
  } // namespace

  template <int dim>
  ComplianceChoice choose_compliance(const PairSpec     &scene,
                                     const Grading<dim> &grading,
                                     const PairDemands  &demands)
  {
    const Compliance asked = scene.mesh.compliance;
    if (dim == 2 || !(demands.bulk_errors || demands.modes) ||
        asked == Compliance::finite_elements)
      return {};
    std::string reason = why_not_split(scene, grading, demands);
    if (!reason.empty() && asked == Compliance::split)
      throw InputError("Mesh/Compliance = split: " + reason +
                       ". Take `finite elements`, or `automatic`.");
    if (reason.empty() && asked == Compliance::automatic)
      reason = why_not_better(scene, grading);
    return {reason.empty(), reason};
  }

  std::shared_ptr<SplitBody> SplitBodies::body_of(const BodySpec   &body,
                                                  const Grading<3> &grading,
                                                  const bool        vibrates,
                                                  const bool is_half_space)
  {
    const auto         shape  = body.body_shape();
    const FadingRegion fading = fading_region(*shape, farthest_node(grading));
    const std::lock_guard<std::mutex> lock(alone);
    for (const auto &known : bodies)
      if (known->is_one_of(
            *shape, body.material, fading, body.model, vibrates, is_half_space))
        return known;
    if (bodies.size() == most_kept)
      bodies.erase(bodies.begin());
    bodies.push_back(std::make_shared<SplitBody>(
      shape, body.material, fading, body.model, vibrates, is_half_space));
    return bodies.back();
  }

  template ComplianceChoice
  choose_compliance(const PairSpec &, const Grading<2> &, const PairDemands &);
  template ComplianceChoice
  choose_compliance(const PairSpec &, const Grading<3> &, const PairDemands &);
} // namespace RollingContact
