#ifndef rolling_contact_base_side_h
#define rolling_contact_base_side_h

#include <array>
#include <string>

namespace RollingContact
{
  /** The two bodies of a pair. */
  enum class Side
  {
    wheel,
    rail
  };

  inline constexpr std::array<Side, 2> both_sides{{Side::wheel, Side::rail}};

  inline std::string name_of(const Side side)
  {
    return side == Side::wheel ? "wheel" : "rail";
  }

  /** An object of each of the two bodies. */
  template <typename Object>
  struct PerSide
  {
    Object wheel{};
    Object rail{};

    Object &operator[](const Side side)
    {
      return side == Side::wheel ? wheel : rail;
    }

    const Object &operator[](const Side side) const
    {
      return side == Side::wheel ? wheel : rail;
    }
  };
} // namespace RollingContact

#endif
