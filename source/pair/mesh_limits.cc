#include <deal.II/base/numbers.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/surface_chart.h>
#include <rolling_contact/pair/mesh_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Largest size of the elastic bodies that the program meshes; 0 if there is
     * none. Units: m.
     */
    double largest_size(const PairSpec &scene)
    {
      double size = 0.;
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (!body->rigid && !body->is_from_file())
          {
            const auto shape = body->body_shape();
            size = std::max({size, shape->thickness_below(), shape->reach_x()});
          }
      return size;
    }

    /** "Contact/Normal load = 1e-6 N", for a patch so many times larger if the
     * factor is not 1. */
    std::string what_presses(const ContactParameters &contact,
                             const int                dim,
                             const double             factor)
    {
      if (contact.approach)
        return "Contact/Approach = " +
               significant(*contact.approach * factor * factor, 2) + " m";
      return "Contact/Normal load = " +
             significant(*contact.normal_load * std::pow(factor, dim), 2) +
             " N";
    }
  } // namespace

  double narrower_reach(const PairSpec &scene)
  {
    double reach = std::numeric_limits<double>::infinity();
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      if (!body->rigid && !body->is_from_file())
        {
          const auto shape = body->body_shape();
          if (!shape->is_swept())
            reach = std::min(reach, shape->reach_y());
        }
    return reach;
  }

  std::array<double, 2> room_of_sections(const PairSpec &scene)
  {
    const double          none = std::numeric_limits<double>::infinity();
    std::array<double, 2> room{{-none, none}};
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      if (!body->rigid && !body->is_from_file())
        {
          const auto shape = body->body_shape();
          if (!shape->is_swept())
            continue;
          const auto across = shape->room_across();
          room = {{std::max(room[0], across[0]), std::min(room[1], across[1])}};
        }
    return room;
  }

  namespace
  {
    template <int dim>
    void end_with_sections(const PairSpec &scene, Grading<dim> &grading)
    {
      if (dim == 2 || grading.zone_boxes.empty())
        return;
      const auto room = room_of_sections(scene);
      for (ZoneBox &box : grading.zone_boxes)
        if (box.lower[1] < room[1] && box.upper[1] > room[0])
          {
            box.lower[1] = std::max(box.lower[1], room[0]);
            box.upper[1] = std::min(box.upper[1], room[1]);
          }
    }
  } // namespace

  template <int dim>
  std::array<double, 2> room_for_zone(const Grading<dim> &grading)
  {
    const auto room = [](const std::array<double, 2> &zone,
                         const double                 element) {
      return 2 * (std::max(-zone[0], zone[1]) + element);
    };
    return {{room(grading.zone_along(), grading.element_size_x),
             room(grading.zone_across(), grading.element_size_y)}};
  }

  std::string at_least(const double length)
  {
    const double half_last_digit = 5e-3;
    return "at least " + significant((1 + half_last_digit) * length, 3) + " m";
  }

  template <int dim>
  void end_at_side(const PairSpec &scene,
                   const double    half_width_y,
                   Grading<dim>   &grading)
  {
    end_with_sections(scene, grading);
    const double reach = narrower_reach(scene), near = 2.5; // elements
    const auto   fit = [&]() {
      grading.element_size_y =
        reach / (4 * fewest_parts(reach, 4 * grading.element_size_y));
    };
    if (scene.touches_in_line())
      {
        for (ZoneBox &box : grading.zone_boxes)
          {
            box.lower[1] = -reach;
            box.upper[1] = reach;
          }
        grading.zone_y = reach;
        fit();
        return;
      }
    if (dim == 2 || !grading.zone_boxes.empty() ||
        grading.zone_y + near * grading.element_size_y < reach)
      return;
    if (half_width_y < reach)
      grading.zone_y = std::min(grading.zone_y, reach);
    fit();
  }

  template <int dim>
  CellCount cells_to_mesh(const PairSpec &scene, const Grading<dim> &grading)
  {
    const double enough = 1e6; // to count no longer than meshing takes
    CellCount    count;
    for (const Side side : both_sides)
      {
        const BodySpec &body = scene.body(side);
        if (body.rigid || (body.is_from_file() && !body.is_section()))
          continue;
        const double cells =
          std::min(enough,
                   least_cells<dim>(body.body_shape(), grading, enough));
        count.total += cells;
        count.text += (count.text.empty() ? "the " : ", the ") + name_of(side) +
                      " with " + std::to_string(std::lround(cells)) +
                      " cells or more";
      }
    return count;
  }

  template <int dim>
  void check_element_size(const PairSpec &scene, const Grading<dim> &grading)
  {
    double size = std::ldexp(grading.element_size_x, -int(grading.rim_levels));
    for (const RefinedBox<dim> &box : grading.boxes)
      size = std::min(size, box.size);
    const double smallest = smallest_element * largest_size(scene);
    if (size >= smallest ||
        (!scene.contact.approach && !scene.contact.normal_load))
      return;
    throw InputError(
      what_presses(scene.contact, dim, 1.) + " makes elements of " +
      significant(size, 2) + " m, too small beside bodies of " +
      significant(smallest / smallest_element, 2) +
      " m: take fewer Mesh/Elements across patch or, for these, at least " +
      what_presses(scene.contact, dim, 1.1 * smallest / size) + ".");
  }

  void check_contact_memory(const double n_unknowns, const bool on_grid)
  {
    const double n_matrices = on_grid ? 0.1 : 5.;
    const double bytes = n_matrices * n_unknowns * n_unknowns * sizeof(double),
                 free  = available_memory();
    if (free > 0. && bytes > 0.7 * free)
      throw MemoryError(
        "The contact nodes have " + significant(n_unknowns, 3) +
        " pressures and tractions and need about " + human_bytes(bytes) +
        " for their compliance, more than 70 % of the " + human_bytes(free) +
        " free: take fewer Mesh/Elements across patch, a "
        "smaller Mesh/Candidate zone or a smaller "
        "Mesh/Contact node budget.");
  }

  template <int dim>
  double contact_nodes(const Grading<dim> &grading)
  {
    const double surely = 0.9, size_x = grading.element_size_x,
                 size_y = grading.element_size_y;
    if (dim == 2)
      return surely * 2 * grading.semi_axis_x() / size_x;
    const double ellipse = numbers::PI * grading.semi_axis_x() *
                           grading.zone_y / (size_x * size_y),
                 countable = 1e6;
    if (grading.zone_boxes.empty() || ellipse > countable)
      return surely * ellipse;
    // boxes overlap, and may be far from each other
    const auto along = grading.zone_along(), across = grading.zone_across();
    double     n = 0.;
    for (double x = along[0] + size_x / 2; x < along[1]; x += size_x)
      for (double y = across[0] + size_y / 2; y < across[1]; y += size_y)
        n +=
          std::any_of(grading.zone_boxes.begin(),
                      grading.zone_boxes.end(),
                      [&](const ZoneBox &box) { return box.contains(x, y); });
    return surely * n;
  }

  template <int dim>
  void check_contact_memory(const PairSpec     &scene,
                            const Grading<dim> &grading,
                            const bool          on_grid)
  {
    const int components = scene.contact.friction_coefficient > 0. ? dim : 1;
    check_contact_memory(contact_nodes(grading) * components, on_grid);
  }

  template std::array<double, 2> room_for_zone(const Grading<2> &);
  template std::array<double, 2> room_for_zone(const Grading<3> &);
  template void      end_at_side(const PairSpec &, const double, Grading<2> &);
  template void      end_at_side(const PairSpec &, const double, Grading<3> &);
  template CellCount cells_to_mesh(const PairSpec &, const Grading<2> &);
  template CellCount cells_to_mesh(const PairSpec &, const Grading<3> &);
  template double    contact_nodes(const Grading<2> &);
  template double    contact_nodes(const Grading<3> &);
  template void
  check_contact_memory(const PairSpec &, const Grading<2> &, const bool);
  template void
  check_contact_memory(const PairSpec &, const Grading<3> &, const bool);
  template void check_element_size(const PairSpec &, const Grading<2> &);
  template void check_element_size(const PairSpec &, const Grading<3> &);
} // namespace RollingContact
