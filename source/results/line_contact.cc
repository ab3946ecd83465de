#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/results/line_contact.h>
#include <rolling_contact/results/lines_across.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// over Hertz's half-width: where the pressure at an end is told
    const double end_distance_share = 0.25;

    /** A value of the lines at a place between them, by a straight line. */
    double between(const std::vector<LineAcross> &lines,
                   double LineAcross::*const value,
                   const double              y)
    {
      const auto above =
        std::lower_bound(lines.begin(),
                         lines.end(),
                         y,
                         [](const LineAcross &line, const double place) {
                           return line.y < place;
                         });
      if (above == lines.begin() || above == lines.end())
        return (above == lines.end() ? lines.back() : lines.front()).*value;
      const auto   below = above - 1;
      const double share = (y - below->y) / (above->y - below->y);
      return (1 - share) * ((*below).*value) + share * ((*above).*value);
    }

    /** Half-width and pressure in the middle of endless bodies. */
    References::HertzLine endless_cylinders(const PairSpec &scene,
                                            const double    load_per_length)
    {
      const PairConstants constants = pair_constants(scene);
      if (!scene.has_covers())
        return References::hertz_line(load_per_length,
                                      constants.relative_radius,
                                      constants.contact_modulus);
      const auto line = layered_line_contact(scene,
                                             load_per_length,
                                             References::LineFriction::none);
      return {line.half_width, line.pressure(0.)};
    }

    /** The load between two places, linear between the lines. Units: N. */
    double load_between(const std::vector<LineAcross> &lines,
                        const double                   begin,
                        const double                   end)
    {
      std::vector<double> places{begin};
      for (const LineAcross &line : lines)
        if (line.y > begin && line.y < end)
          places.push_back(line.y);
      places.push_back(end);
      double load = 0.;
      for (std::size_t k = 1; k < places.size(); ++k)
        load += (places[k] - places[k - 1]) *
                (between(lines, &LineAcross::load, places[k - 1]) +
                 between(lines, &LineAcross::load, places[k])) /
                2;
      return load;
    }
  } // namespace

  std::optional<LineContact> line_contact(const PairSpec       &scene,
                                          const SteadyState<3> &steady)
  {
    if (!scene.touches_in_line() || !steady.solver.converged ||
        !(steady.result.normal_force > 0.))
      return {};
    const auto   lines = lines_across(steady);
    const double w     = narrower_reach(scene);
    LineContact  contact;
    contact.length = 2 * w;
    contact.hertz =
      endless_cylinders(scene, steady.result.normal_force / contact.length);
    const double b          = contact.hertz.half_width;
    contact.middle_load     = between(lines, &LineAcross::load, 0.);
    contact.middle_pressure = between(lines, &LineAcross::max_pressure, 0.);
    contact.end_length      = std::min(b, w / 2);
    contact.end_distance    = end_distance_share * b;
    const double e          = contact.end_length,
                 middle     = load_between(lines, -e / 2, e / 2),
                 inside     = w - std::min(contact.end_distance, w);
    contact.end_excess =
      std::max(load_between(lines, -w, -w + e), load_between(lines, w - e, w)) /
        middle -
      1;
    contact.end_pressure =
      std::max(between(lines, &LineAcross::max_pressure, -inside),
               between(lines, &LineAcross::max_pressure, inside));
    return contact;
  }

  void set_line_contact_columns(const PairSpec       &scene,
                                const SteadyState<3> &steady,
                                ResultsTable         &table)
  {
    const auto contact = line_contact(scene, steady);
    if (!contact)
      return;
    table.set("length_m", contact->length);
    table.set("reference_half_width_x_m", contact->hertz.half_width);
    table.set("reference_max_pressure_Pa", contact->hertz.max_pressure);
    table.set("middle_pressure_Pa", contact->middle_pressure);
    table.set("middle_load_N/m", contact->middle_load);
    table.set("end_length_m", contact->end_length);
    table.set("end_load_excess", contact->end_excess);
    table.set("end_distance_m", contact->end_distance);
    table.set("end_pressure_Pa", contact->end_pressure);
  }

  void note_line_contact(const PairSpec       &scene,
                         const SteadyState<3> &steady,
                         RunReport            &report)
  {
    const auto contact = line_contact(scene, steady);
    if (!contact)
      return;
    const double p0 = contact->hertz.max_pressure;
    report.set_finding(
      "line",
      "middle pressure " + significant(contact->middle_pressure / p0, 4) +
        " p0, where endless cylinders have p0 = " + significant(1e-6 * p0, 4) +
        " MPa on " + millimetres(contact->length, 4) + "; load of the last " +
        millimetres(contact->end_length, 3) + " at an end " +
        significant(100 * std::abs(contact->end_excess), 3) + " % " +
        (contact->end_excess < 0. ? "below" : "above") +
        " the middle's, pressure " +
        significant(contact->end_pressure / p0, 3) + " p0 at " +
        millimetres(contact->end_distance, 3) + " from it");
  }
} // namespace RollingContact
