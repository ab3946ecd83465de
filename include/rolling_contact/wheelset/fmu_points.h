#ifndef rolling_contact_wheelset_fmu_points_h
#define rolling_contact_wheelset_fmu_points_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/wheelset/fmu_states.h>

namespace RollingContact
{
  /**
   * How far a model is off at random points between the states of its table,
   * where states of the scene are solved: errors of the force vector over the
   * friction that the wheel can carry. Those that come to lie beyond the table
   * because a rail has moved are not counted. Unit: 1.
   */
  struct FmuErrors
  {
    std::size_t n = 0, n_within = 0; ///< points, and those within the bound
    std::size_t n_unsolved = 0;      ///< that no state was found at
    double      median = 0., most = 0.;
  };

  /**
   * Solves points, with a row of fmu_points.csv for each: right-hand wheels,
   * left-hand ones, and right-hand ones between rails that have moved. Every
   * second one makes the bound of the model as wide as it must be to hold
   * there, and half as much again (WheelTable::margin); the others are judged.
   */
  FmuErrors measure_fmu(const Situation    &scene,
                        const FmuStates    &states,
                        const unsigned int  n_points,
                        Fmu::WheelsetModel &model,
                        RunContext         &context);
} // namespace RollingContact

#endif
