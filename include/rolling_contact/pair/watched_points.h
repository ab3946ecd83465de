#ifndef rolling_contact_pair_watched_points_h
#define rolling_contact_pair_watched_points_h

#include <rolling_contact/bodies/body_point.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/velocity_points.h>

#include <functional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The named points of a scene in its bodies, see
   * PairSpec::velocity_points(). Their motion is that of the points of
   * the wheel, then of the rail, by components x, (in 3D) y and z, z upwards
   * for both bodies.
   */
  template <int dim>
  class WatchedPoints
  {
  public:
    WatchedPoints() = default;

    /**
     * Find them, and tell where they are. Throws InputError for a point outside
     * of its body, for a wheel without axle and for bodies that are spread over
     * ranks. Collective.
     */
    WatchedPoints(const PairSpec                                 &scene,
                  const PerSide<std::vector<VelocityPoint>>      &wanted,
                  const BodyPair<dim>                            &bodies,
                  const std::function<void(const std::string &)> &tell);

    std::size_t n_values() const
    {
      return dim * n_points;
    }

    std::size_t n_values(const Side side) const
    {
      return dim * n_of_body[side];
    }

    /**
     * Values at all points, from fields of the bodies in their own frames; @p
     * field is called for bodies with points, on all ranks. Collective.
     */
    std::vector<double>
    values(const BodyPair<dim>                        &bodies,
           const std::function<BodyField(const Side)> &field) const;

    /**
     * Values at the points of one body alone; empty for a body without points,
     * and on ranks that hold nothing of the body. Not collective.
     */
    std::vector<double> values_of(const Side       side,
                                  const BodyField &field) const;

    bool has_any(const Side side) const
    {
      return n_of_body[side] > 0;
    }

  private:
    PerSide<std::vector<BodyPoint<dim>>> points; ///< where the body is
    PerSide<std::size_t>                 n_of_body;
    std::size_t                          n_points = 0;
  };
} // namespace RollingContact

#endif
