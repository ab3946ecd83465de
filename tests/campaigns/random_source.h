#ifndef rolling_contact_tests_campaigns_dice_h
#define rolling_contact_tests_campaigns_dice_h

#include <cmath>
#include <cstdint>

/**
 * SplitMix64: small, and the same numbers everywhere.
 */
class RandomSource
{
public:
  explicit RandomSource(const std::uint64_t seed)
    : state(seed)
  {}

  /**
   * In [low, high).
   */
  double between(const double low, const double high)
  {
    return low + (high - low) * (next() >> 11) * 0x1p-53;
  }

  /**
   * Evenly in the logarithm.
   */
  double scale(const double low, const double high)
  {
    return std::exp(between(std::log(low), std::log(high)));
  }

  bool chance(const double probability)
  {
    return between(0., 1.) < probability;
  }

  int integer(const int low, const int high)
  {
    return low + static_cast<int>(next() % (high - low + 1));
  }

  double sign()
  {
    return chance(0.5) ? 1. : -1.;
  }

private:
  std::uint64_t next()
  {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z               = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z               = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state;
};

#endif
