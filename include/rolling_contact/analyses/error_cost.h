#ifndef rolling_contact_analyses_error_cost_h
#define rolling_contact_analyses_error_cost_h

#include <cstddef>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a method reaches on one mesh or with one step, and what that costs. An
   * error that is not a number stands for a state that was not solved. Units:
   * 1, s.
   */
  struct CostedError
  {
    std::string method;
    std::string resolution; ///< "48 elements", "2e-06 s"
    double      cpu_seconds = 0.;
    double      error       = 0.;
  };

  /**
   * The points that no other beats in one of error and time without losing in
   * the other, in the order of rising time and falling error. Of equal points
   * the first.
   */
  std::vector<std::size_t> pareto_front(const std::vector<CostedError> &points);

  /**
   * The cheapest point whose error is at most a given level.
   */
  struct BestOfLevel
  {
    double      level = 0.;
    std::size_t point = 0;
  };

  /**
   * The cheapest point for each of the falling @p levels that is reached.
   */
  std::vector<BestOfLevel>
  best_of_levels(const std::vector<CostedError> &points,
                 const std::vector<double>      &levels);
} // namespace RollingContact

#endif
