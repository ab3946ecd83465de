#ifndef rolling_contact_tests_wheel_frequencies_h
#define rolling_contact_tests_wheel_frequencies_h

#include <map>
#include <vector>

namespace RollingContact
{
  /** Frequencies (Hz) by nodal diameters. */
  using FrequenciesByDiameters = std::map<unsigned int, std::vector<double>>;

  /**
   * 32 frequencies below 5.5 kHz of prm/sections/wheel_2.msh, clamped at its
   * bore, by a Fourier expansion with elements of fourth order, 16 752 unknowns
   * for each number of nodal diameters. E = 210 GPa, nu = 0.3, 7850 kg/m^3.
   */
  inline FrequenciesByDiameters frequencies_of_wheel_2()
  {
    return {{0, {214.32, 495.00, 1475.26, 2561.67, 3378.24, 5453.24}},
            {1, {141.82, 1152.06, 1661.20, 2821.33, 3424.96}},
            {2, {383.68, 1620.56, 2138.85, 3272.21, 4505.79}},
            {3, {1044.18, 2111.94, 2748.13, 3894.69}},
            {4, {1895.51, 2728.24, 3425.53, 4699.26}},
            {5, {2856.05, 3462.86, 4176.55}},
            {6, {3876.08, 4289.46, 5012.41}},
            {7, {4919.86, 5192.01}}};
  }
} // namespace RollingContact

#endif
