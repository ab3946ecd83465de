#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/error_indicator.h>
#include <rolling_contact/state/adaptive_levels.h>
#include <rolling_contact/state/estimate_errors.h>

#include <cmath>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Share of the squared bulk indicators that a level refines.
     */
    const double bulk_fraction = 0.3;

    /**
     * Nodes of the uniform part of the contact zone, at least.
     */
    template <int dim>
    double estimated_contact_nodes(const Grading<dim> &grading)
    {
      const double along = 2 * grading.zone_x / grading.element_size_x;
      if (dim == 2)
        return along;
      const double quarter_of_pi = std::atan(1.);
      return quarter_of_pi * along * 2 * grading.zone_y /
             grading.element_size_y;
    }

    /**
     * A cell of the trace as a flat box of the chart.
     */
    template <int dim>
    std::pair<Point<dim>, Point<dim>> chart_box(const Trace::Cell &cell)
    {
      std::pair<Point<dim>, Point<dim>> box;
      for (unsigned int d = 0; d < dim - 1; ++d)
        {
          box.first[d]  = cell.lower[d];
          box.second[d] = cell.upper[d];
        }
      return box;
    }

    template <int dim>
    RefinedBox<dim> halved(const Trace::Cell &cell, const Grading<dim> &grading)
    {
      RefinedBox<dim> box;
      std::tie(box.lower, box.upper) = chart_box<dim>(cell);
      const double size              = grading.size_in_x(box.lower, box.upper);
      box.lower[dim - 1]             = -size;
      box.size                       = size / 2;
      return box;
    }

    /**
     * How many times a face of the surface is split, itself and its parts.
     */
    template <int dim>
    std::size_t n_splits(const Point<dim>   &lower,
                         const Point<dim>   &upper,
                         const Grading<dim> &grading)
    {
      if (!grading.refine(lower, upper))
        return 0;
      std::size_t n = 1;
      for (unsigned int part = 0; part < 1u << (dim - 1); ++part)
        {
          Point<dim> part_lower = lower, part_upper = upper;
          for (unsigned int d = 0; d < dim - 1; ++d)
            {
              const double middle = (lower[d] + upper[d]) / 2;
              ((part >> d) & 1 ? part_lower : part_upper)[d] = middle;
            }
          n += n_splits(part_lower, part_upper, grading);
        }
      return n;
    }

    /**
     * Contact nodes that a refined grading adds: in the inside of a refined
     * region, one for each split in 2D and three in 3D.
     */
    template <int dim>
    std::size_t n_new_nodes(const Trace &trace, const Grading<dim> &grading)
    {
      std::size_t n = 0;
      for (const Trace::Cell &cell : trace.cells)
        {
          const auto box = chart_box<dim>(cell);
          n += n_splits(box.first, box.second, grading);
        }
      return n * ((1u << (dim - 1)) - 1);
    }

    template <int dim>
    LevelValues level_values(const SteadyState<dim> &steady)
    {
      const Resultants &result = steady.result;
      LevelValues       level;
      level.values         = {{result.normal_force,
                               result.force_x,
                               result.force_y,
                               steady.state.approach}};
      level.friction_force = result.friction_force;
      return level;
    }
  } // namespace

  template <int dim>
  void AdaptiveLevels<dim>::check_budget() const
  {
    if (scene.mesh.adaptive_levels == 0)
      return;
    const double nodes = estimated_contact_nodes(
      make_grading<dim>(scene,
                        demands,
                        estimate_patch(scene),
                        scene.mesh.elements_across_patch,
                        scene.mesh.offset()));
    if (nodes > scene.mesh.contact_node_budget)
      throw InputError("Mesh/Contact node budget = " +
                       std::to_string(scene.mesh.contact_node_budget) +
                       ": the first mesh needs about " +
                       std::to_string(std::lround(nodes)) +
                       " already. Take fewer Mesh/Elements across patch, a "
                       "smaller Mesh/Candidate zone or a larger budget.");
  }

  template <int dim>
  SteadyState<dim> AdaptiveLevels<dim>::run(
    const std::function<void(const SteadyState<dim> &)> &on_level)
  {
    check_budget();
    LevelHistory           history;
    const StateFinder<dim> finder(scene, demands, context);
    double                 peak_before = 0.;
    const auto             estimate    = [&](SteadyState<dim> &level) {
      if (!demands.pair.bulk_errors)
        return;
      estimate_errors(scene, level);
      if (level.estimate && level.change)
        level.estimate->from_level_before = {
          *level.change, std::abs(peak_before / level.result.max_pressure - 1)};
    };
    SteadyState<dim> steady = finder.find();
    estimate(steady);
    history.add(level_values(steady));
    on_level(steady);
    Grading<dim> grading = steady.grading;
    while (steady.level < scene.mesh.adaptive_levels &&
           steady.solver.converged && steady.result.n_touching > 0 &&
           refine(steady, grading))
      {
        steady.pair->release_statics();
        peak_before              = steady.result.max_pressure;
        const unsigned int level = steady.level + 1;
        steady =
          finder.find_from(steady, grading, "Level " + std::to_string(level));
        steady.level = level;
        grading      = steady.grading;
        history.add(level_values(steady));
        steady.change = history.change();
        steady.limit  = history.limit();
        estimate(steady);
        on_level(steady);
        context.log.message(
          "level " + std::to_string(steady.level) + ": " +
          std::to_string(steady.problem.n_nodes()) +
          " contact nodes, forces changed by " + scientific(*steady.change, 2) +
          ", expected error " + scientific(steady.limit->value_error, 2));
        if (*steady.change < scene.mesh.target_change)
          break;
      }
    return steady;
  }

  template <int dim>
  bool AdaptiveLevels<dim>::refine(const SteadyState<dim> &steady,
                                   Grading<dim>           &grading)
  {
    const bool refined = scene.mesh.level_marking == LevelMarking::uniform
                           ? refine_uniformly(steady, grading)
                           : refine_marked(steady, grading);
    if (!refined)
      context.log.message("The next level would exceed the budget of " +
                          std::to_string(scene.mesh.contact_node_budget) +
                          " contact nodes (Mesh/Contact node budget): level " +
                          std::to_string(steady.level) + " is the last.");
    return refined;
  }

  template <int dim>
  bool AdaptiveLevels<dim>::refine_uniformly(const SteadyState<dim> &steady,
                                             Grading<dim>           &grading)
  {
    if (steady.problem.n_nodes() << (dim - 1) > scene.mesh.contact_node_budget)
      return false;
    grading.element_size_x /= 2;
    grading.element_size_y /= 2;
    grading.offset *= 2;
    return true;
  }

  template <int dim>
  bool AdaptiveLevels<dim>::refine_marked(const SteadyState<dim> &steady,
                                          Grading<dim>           &grading)
  {
    const Trace &trace = steady.pair->trace();
    const auto   marks = refinement_marks(trace, steady.problem, steady.state);
    bool         refined = false;
    for (const auto mark : {RefinementMark::leading_rim,
                            RefinementMark::stick_border,
                            RefinementMark::trailing_rim})
      {
        Grading<dim> next = grading;
        for (std::size_t k = 0; k < marks.size(); ++k)
          if (marks[k] == mark)
            next.boxes.push_back(halved<dim>(trace.cells[k], grading));
        if (next.boxes.size() == grading.boxes.size())
          continue;
        if (steady.problem.n_nodes() + n_new_nodes(trace, next) >
            scene.mesh.contact_node_budget)
          break;
        grading = next;
        refined = true;
      }
    if (refined)
      add_bulk_boxes(steady, grading);
    return refined;
  }

  template <int dim>
  void AdaptiveLevels<dim>::add_bulk_boxes(const SteadyState<dim> &steady,
                                           Grading<dim>           &grading)
  {
    const RollingPair<dim> &pair = *steady.pair;
    for (const Side side : both_sides)
      if (pair.bodies().has_own_body(side))
        {
          std::vector<RefinedBox<dim>> boxes;
          if (pair.bodies().body(side))
            boxes =
              bulk_boxes(*pair.bodies().body(side),
                         pair.displacement(side, steady.problem, steady.state),
                         steady.grading,
                         bulk_fraction);
          boxes = pair.bodies().on_all_ranks(side, std::move(boxes));
          grading.boxes.insert(grading.boxes.end(), boxes.begin(), boxes.end());
        }
  }

  template class AdaptiveLevels<2>;
  template class AdaptiveLevels<3>;
} // namespace RollingContact
