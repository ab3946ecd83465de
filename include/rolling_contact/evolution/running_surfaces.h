#ifndef rolling_contact_evolution_running_surfaces_h
#define rolling_contact_evolution_running_surfaces_h

#include <rolling_contact/surfaces/contact_search.h>
#include <rolling_contact/surfaces/profile_file.h>

#include <array>
#include <memory>
#include <vector>

namespace RollingContact
{
  using BothWheelsOnRails =
    std::array<std::shared_ptr<const Profiles::WheelOnRail>, 2>;

  /** Wheel and rail of a side, as those of a right-hand one: their numbers. */
  inline constexpr std::array<Profiles::ProfileKind, 2> wheel_and_rail{
    {Profiles::ProfileKind::wheel, Profiles::ProfileKind::rail}};

  /**
   * The profiles of a wheelset and its rails while they wear: of both sides as
   * one where these are alike and wear alike, else right and left. Points stay
   * the same material as curves wear, so that what wears is told by amounts of
   * area at points.
   */
  class RunningSurfaces
  {
  public:
    /** Wheel and rail. */
    using Side = std::array<Profiles::ProfileCurve, 2>;

    /** What wears of each side, wheel and rail, at the points. Units: m^2. */
    using Amounts = std::vector<std::array<std::vector<double>, 2>>;

    /**
     * @p sides: one for both, or right and left; their points are brought to
     * distances that lines of nodes can be told from. Units: m.
     */
    explicit RunningSurfaces(const std::vector<Side>     &sides,
                             const std::array<double, 2> &radii,
                             const double                 tape_circle);

    /** A wheelset and rails with these curves, as they are. */
    RunningSurfaces with(const std::vector<Side> &curves) const;

    /** Whether these are its curves, point by point. */
    bool has_curves(const std::vector<Side> &curves) const;

    const std::vector<Side> &curves() const
    {
      return sides;
    }

    std::size_t n_sides() const
    {
      return sides.size();
    }

    /** The number of the side of a wheel, 0 the right-hand one. */
    std::size_t side_of(const unsigned int wheel) const
    {
      return sides.size() == 1 ? 0 : wheel;
    }

    const Profiles::ProfileCurve &curve(const std::size_t  side,
                                        const unsigned int body) const
    {
      return sides[side][body];
    }

    /** Shared by both sides where these are one. */
    const BothWheelsOnRails &wheels_on_rails() const
    {
      return both;
    }

    /** Zero amounts. */
    Amounts nothing() const;

    /** Depths of amounts at the points, see Profiles::depths_of(). */
    std::vector<double> depths(const Amounts     &amounts,
                               const std::size_t  side,
                               const unsigned int body) const;

    /** The largest of a body of a side, and of all. */
    double largest_depth(const Amounts     &amounts,
                         const std::size_t  side,
                         const unsigned int body) const;

    double largest_depth(const Amounts &amounts) const;

    /** The share of amounts that is elsewhere by a difference, times their
     * largest depth: the largest of all sides and bodies. Units: m. */
    double misplaced_depth(const Amounts &difference,
                           const Amounts &amounts) const;

    /** Without what has worn. Throws InputError, see Profiles::worn(). */
    RunningSurfaces worn(const Amounts &amounts) const;

  private:
    void make_pairs();

    std::vector<Side>     sides;
    std::array<double, 2> radii;
    double                tape_circle;
    BothWheelsOnRails     both;
  };

  /** a + factor b. */
  RunningSurfaces::Amounts sum(RunningSurfaces::Amounts        a,
                               const double                    factor,
                               const RunningSurfaces::Amounts &b);
} // namespace RollingContact

#endif
