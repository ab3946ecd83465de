#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/state/steady_state.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// across a slender patch, unless there are fewer along it
    const unsigned int usual_least = 6;

    /// where depths of wear are those of lines of nodes
    const unsigned int least_with_wear = 10;

    /** Mesh/Least elements y; 0 where the usual number will do. */
    unsigned int least_asked(const PairSpec &scene)
    {
      const unsigned int given = scene.mesh.least_elements_y;
      return given == 0 && scene.wear.report ? least_with_wear : given;
    }

    /**
     * As many as along x, but on a patch that is slender along x fewer: long
     * thin elements make tractions worse; on wider patches more, so that slip
     * which changes across, as that of spin, is resolved as it is along x, and
     * as small ones as along x on those of profiles, as their pressure varies
     * across more than that of an ellipse.
     */
    unsigned int elements_across_y(const PairSpec      &scene,
                                   const PatchEstimate &patch,
                                   const unsigned int   elements_across_patch)
    {
      const double longest            = 1.9; // over the width of an element
      const double widest             = 1.5; // over its length
      const double longest_along_line = 2.;  // over its length, where alike
      const double ratio              = patch.half_width_y / patch.half_width_x;
      double       n                  = elements_across_patch;
      if (scene.touches_in_line())
        n = std::ceil(n * ratio / longest_along_line);
      else if (ratio > 1.)
        n = std::ceil(
          n * std::max(1., ratio / (patch.boxes.empty() ? widest : 1.)));
      else
        n = std::min(n,
                     std::max<double>(usual_least,
                                      std::floor(longest * n * ratio)));
      return std::max<double>(n, least_asked(scene));
    }

    /**
     * Give the shortest of several patches at least half the elements along x
     * that the longest should have, and the narrowest at least the usual number
     * across.
     */
    template <int dim>
    void resolve_smallest_patch(const PairSpec      &scene,
                                const PatchEstimate &patch,
                                const unsigned int   elements_across_patch,
                                Grading<dim>        &grading)
    {
      const auto refine = [&](double &size, const double wanted) {
        size = std::min(size, std::max(wanted, scene.mesh.finest_share * size));
      };
      refine(grading.element_size_x,
             4 * patch.shortest_x / elements_across_patch);
      refine(grading.element_size_y,
             2 * patch.narrowest_y / std::max(usual_least, least_asked(scene)));
    }

    /**
     * The boxes of the patch and of others in place of its ellipse, with as
     * much around them.
     */
    template <int dim>
    void set_zone_boxes(const PatchEstimate        &patch,
                        const std::vector<ZoneBox> &others,
                        Grading<dim>               &grading)
    {
      std::vector<ZoneBox> all = patch.boxes;
      for (const ZoneBox &other : others)
        if (!covers(all, other, grading.element_size_x / 2))
          all.push_back(other);
      const double around_x = grading.zone_x - patch.half_width_x,
                   around_y = grading.zone_y - patch.half_width_y,
                   upstream = grading.element_size_x;
      grading.zone_x = grading.zone_y = 0.;
      for (const ZoneBox &touching : all)
        {
          ZoneBox box = touching.grown(around_x, around_y);
          if (grading.upstream < 0)
            box.lower[0] -= upstream;
          if (grading.upstream > 0)
            box.upper[0] += upstream;
          grading.zone_boxes.push_back(box);
          for (const auto &corner : {box.lower, box.upper})
            {
              grading.zone_x = std::max(grading.zone_x, std::abs(corner[0]));
              grading.zone_y = std::max(grading.zone_y, std::abs(corner[1]));
            }
        }
      grading.upstream = 0;
    }
    /**
     * Refine the ends of a line contact, its sides in y, in place of the rim at
     * its leading edge: by some of the smallest elements around each.
     */
    template <int dim>
    void refine_ends(Grading<dim> &grading)
    {
      if (dim == 3 && grading.rim_levels > 0)
        for (const double end : {-grading.zone_y, grading.zone_y})
          {
            const double    around = 2., beyond = 2.;
            RefinedBox<dim> box;
            box.size =
              std::ldexp(grading.element_size_x, -int(grading.rim_levels));
            const double share =
              around * box.size / grading.element_size_x; // of an element
            box.upper[0]       = beyond * grading.zone_x;
            box.lower[0]       = -box.upper[0];
            box.upper[1]       = end + share * grading.element_size_y;
            box.lower[1]       = end - share * grading.element_size_y;
            box.upper[dim - 1] = 0.;
            box.lower[dim - 1] = -share * grading.element_size_z();
            grading.boxes.push_back(box);
          }
      grading.rim_levels = 0;
    }
  } // namespace

  template <int dim>
  Grading<dim> make_grading(const PairSpec      &scene,
                            const StateDemands  &demands,
                            const PatchEstimate &patch,
                            const unsigned int   elements_across_patch,
                            const double         offset)
  {
    const MeshParameters &mesh = scene.mesh;
    Grading<dim>          grading;
    const unsigned int    elements_y =
      mesh.elements_across_patch_y > 0
           ? mesh.elements_across_patch_y
           : elements_across_y(scene, patch, elements_across_patch);
    const double factor =
      mesh.candidate_zone > 0. ? mesh.candidate_zone : demands.zone;
    const auto zone = [&](const double half_width, const double size) {
      return std::max(factor * demands.growth * half_width,
                      demands.growth * half_width + demands.margin * size);
    };
    const double half_width = patch.half_width_x;
    grading.element_size_x  = 2 * half_width / elements_across_patch;
    grading.element_size_y  = 2 * patch.half_width_y / elements_y;
    if (!patch.boxes.empty())
      resolve_smallest_patch(scene, patch, elements_across_patch, grading);
    grading.zone_x = zone(half_width, grading.element_size_x);
    if (demands.pair.surfaces_in_time)
      grading.zone_x += farthest_contact_of_dents(scene);
    grading.upstream = demands.one_direction ? -scene.contact.flow() : 0;
    grading.zone_y   = zone(patch.half_width_y, grading.element_size_y);
    if (patch.boxes.empty() || scene.touches_in_line())
      end_at_side(scene, patch.half_width_y, grading);
    grading.zone_depth = mesh.zone_depth * half_width *
                         grading.element_size_z() / grading.element_size_x;
    grading.growth            = mesh.growth_in(dim);
    grading.offset            = offset;
    grading.rim_levels        = mesh.rim_levels;
    grading.leading_edge_x    = -scene.contact.flow() * half_width;
    grading.trailing_edge_x   = -grading.leading_edge_x;
    grading.leading_edge_only = mesh.rim_edges == RimEdges::leading;
    grading.rim_width         = 2 * grading.element_size_x;
    if (scene.touches_in_line())
      refine_ends(grading);
    if (!patch.boxes.empty())
      set_zone_boxes(patch, demands.other_patches, grading);
    return grading;
  }

  template <int dim>
  bool reaches_side(const PairSpec &scene, const SteadyState<dim> &steady)
  {
    const double near = 1.5 * steady.grading.element_size_y,
                 side = narrower_reach(scene) - near;
    const auto room   = room_of_sections(scene);
    const auto nodes  = nodes_at_border(steady.pair->border_nodes(),
                                       steady.problem,
                                       steady.state.pressure);
    return dim == 3 && !scene.touches_in_line() &&
           std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int i) {
             const double y = steady.problem.operators.positions()[i][1];
             return std::abs(y) > side || y < room[0] + near ||
                    y > room[1] - near;
           });
  }

  template <int dim>
  void enlarge_zone(const PairSpec         &scene,
                    const SteadyState<dim> &steady,
                    const unsigned int      n_elements,
                    Grading<dim>           &grading)
  {
    grading.enlarge_zone(n_elements);
    if (scene.touches_in_line())
      end_at_side(scene, grading.zone_y, grading);
    else if (!reaches_side(scene, steady))
      {
        if (grading.zone_boxes.empty())
          grading.zone_y = std::min(grading.zone_y, narrower_reach(scene));
        else
          end_at_side(scene, grading.zone_y, grading);
      }
  }

  template bool       reaches_side(const PairSpec &, const SteadyState<2> &);
  template bool       reaches_side(const PairSpec &, const SteadyState<3> &);
  template void       enlarge_zone(const PairSpec &,
                                   const SteadyState<2> &,
                                   const unsigned int,
                                   Grading<2> &);
  template void       enlarge_zone(const PairSpec &,
                                   const SteadyState<3> &,
                                   const unsigned int,
                                   Grading<3> &);
  template Grading<2> make_grading(const PairSpec &,
                                   const StateDemands &,
                                   const PatchEstimate &,
                                   const unsigned int,
                                   const double);
  template Grading<3> make_grading(const PairSpec &,
                                   const StateDemands &,
                                   const PatchEstimate &,
                                   const unsigned int,
                                   const double);
} // namespace RollingContact
