#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/watched_points.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /// of the diameter of a cell: what facets of the mesh may be inside of the
    /// curved surface
    const double facet_share = 0.1;

    /**
     * A point by radius, angle and position along the axle: the axle passes
     * below the contact point, which is the origin, and x is perpendicular to
     * it. Units: m, degrees.
     */
    std::array<double, 3> round_axle(const Axle                  &axle,
                                     const std::array<double, 3> &place)
    {
      const auto  &a = axle.point, &d = axle.direction;
      const double length = std::hypot(d[0], d[1], d[2]);
      const double along =
        (a[0] * d[0] + a[1] * d[1] + a[2] * d[2]) / (length * length);
      // from the foot of the perpendicular to the contact point
      std::array<double, 3> up;
      for (unsigned int i = 0; i < 3; ++i)
        up[i] = along * d[i] - a[i];
      const double radius = std::hypot(up[0], up[1], up[2]),
                   angle  = place[1] * pi / 180;
      std::array<double, 3> point;
      for (unsigned int i = 0; i < 3; ++i)
        point[i] = up[i] * (place[0] * std::cos(angle) / radius - 1) +
                   place[2] * d[i] / length;
      point[0] += place[0] * std::sin(angle);
      return point;
    }

    /**
     * A point in the frame of its body. Units: m.
     */
    template <int dim>
    Point<dim> in_body(const BodySpec &body, const VelocityPoint &point)
    {
      std::array<double, 3> at = point.place;
      if (body.section == "Wheel")
        {
          const auto axle = body.body_shape()->axle();
          if (!axle)
            throw InputError("Wheel/Velocity points: they are given by radius "
                             "and angle, and a wheel with Shape = " +
                             body.shape +
                             " has no axle; leave them empty, or take a body "
                             "of revolution.");
          at = round_axle(*axle, point.place);
        }
      Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = at[d == dim - 1 ? 2 : d];
      return result;
    }

    template <int dim>
    std::string place_text(const Side side, const Point<dim> &point)
    {
      const double rounding = 1e-12; // m
      std::string  text;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool   up    = d == dim - 1;
          const double value = up && side == Side::wheel ? -point[d] : point[d];
          text += (d == 0 ? "x = "
                   : up   ? ", z = "
                          : ", y = ") +
                  significant(std::abs(value) > rounding ? value : 0., 5);
        }
      return text + " m";
    }

    /**
     * A point of the mesh. Throws InputError where there is none.
     */
    template <int dim>
    BodyPoint<dim> found(const PairSpec         &scene,
                         const Side              side,
                         const VelocityPoint    &wanted,
                         const ElasticBody<dim> &body)
    {
      const BodyPoint<dim> point(body, in_body<dim>(scene.body(side), wanted));
      if (point.distance() > facet_share * point.cell_diameter())
        throw InputError(
          scene.body(side).section + "/Velocity points: the point " +
          wanted.name + " (" + significant(wanted.place[0], 6) + ", " +
          significant(wanted.place[1], 6) + ", " +
          significant(wanted.place[2], 6) + ") is " +
          millimetres(point.distance()) + " outside of the " + name_of(side) +
          "; the nearest point of its mesh is at " +
          place_text(side, point.place()) +
          " in the axes of the body. Give a point inside.");
      return point;
    }
  } // namespace

  template <int dim>
  WatchedPoints<dim>::WatchedPoints(
    const PairSpec                                 &scene,
    const PerSide<std::vector<VelocityPoint>>      &wanted_points,
    const BodyPair<dim>                            &bodies,
    const std::function<void(const std::string &)> &tell)
  {
    for (const Side side : both_sides)
      {
        const std::vector<VelocityPoint> &wanted = wanted_points[side];
        n_of_body[side]                          = wanted.size();
        n_points += wanted.size();
        if (wanted.empty())
          continue;
        if (bodies.body_solver() == BodySolver::distributed)
          throw InputError(
            scene.body(side).section +
            "/Velocity points: they need all nodes of a body on one rank, and "
            "the bodies are distributed; take Body solver = direct, or name "
            "no points.");
        std::string text;
        Ranks::on(bodies.rank_of(side), [&]() {
          for (const VelocityPoint &point : wanted)
            {
              points[side].push_back(
                found(scene, side, point, *bodies.body(side)));
              text += (text.empty() ? "" : "; ") + point.name + " at " +
                      place_text(side, points[side].back().place());
            }
        });
        tell("Points of the " + name_of(side) + ": " +
             bodies.on_all_ranks(side, text) + ".");
      }
  }

  template <int dim>
  std::vector<double>
  WatchedPoints<dim>::values_of(const Side side, const BodyField &field) const
  {
    std::vector<double> result;
    for (const BodyPoint<dim> &point : points[side])
      {
        auto value = point.value(field);
        if (side == Side::wheel) // whose z points downwards
          value[dim - 1] *= -1;
        result.insert(result.end(), value.begin(), value.end());
      }
    return result;
  }

  template <int dim>
  std::vector<double> WatchedPoints<dim>::values(
    const BodyPair<dim>                        &bodies,
    const std::function<BodyField(const Side)> &field) const
  {
    std::vector<double> result;
    for (const Side side : both_sides)
      {
        if (!has_any(side))
          continue;
        const auto part =
          bodies.on_all_ranks(side, values_of(side, field(side)));
        result.insert(result.end(), part.begin(), part.end());
      }
    return result;
  }

  template class WatchedPoints<2>;
  template class WatchedPoints<3>;
} // namespace RollingContact
