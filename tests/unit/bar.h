#ifndef rolling_contact_tests_unit_bar_h
#define rolling_contact_tests_unit_bar_h

#include "plain_stepper.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  /**
   * A bar of linear elements with its contact node first, its other end clamped
   * or free. The defaults make u_tt = u_xx on (0, 1).
   */
  struct Bar
  {
    unsigned int n_elements    = 100;
    bool         clamped       = true;
    bool         consistent    = false;
    double       length        = 1.;
    double       young_modulus = 1.;
    double       density       = 1.;
    double       area          = 1.;

    double element_size() const
    {
      return length / n_elements;
    }

    double wave_speed() const
    {
      return std::sqrt(young_modulus / density);
    }

    unsigned int n_unknowns() const
    {
      return n_elements + !clamped;
    }

    SymmetricSparseMatrix tridiagonal(const double diagonal,
                                      const double off_diagonal) const
    {
      SymmetricSparseMatrix matrix;
      const unsigned int    n = n_unknowns();
      for (unsigned int j = 0; j < n; ++j)
        {
          matrix.column_starts.push_back(matrix.values.size());
          matrix.row_indices.push_back(j);
          matrix.values.push_back(j == 0 || j == n_elements ? diagonal / 2
                                                            : diagonal);
          if (j + 1 < n)
            {
              matrix.row_indices.push_back(j + 1);
              matrix.values.push_back(off_diagonal);
            }
        }
      matrix.column_starts.push_back(matrix.values.size());
      return matrix;
    }

    SymmetricSparseMatrix stiffness() const
    {
      const double k = young_modulus * area / element_size();
      return tridiagonal(2 * k, -k);
    }

    SymmetricSparseMatrix mass() const
    {
      const double m = density * area * element_size();
      return consistent ? tridiagonal(2 * m / 3, m / 6) : tridiagonal(m, 0.);
    }

    PlainStepper stepper(const ThetaScheme              &scheme,
                         const double                    h,
                         const std::vector<std::size_t> &contact = {0}) const
    {
      std::vector<unsigned int> nodes(n_unknowns());
      std::iota(nodes.begin(), nodes.end(), 0);
      PlainStepper result(std::make_shared<ThetaSystem>(
        scheme, stiffness(), mass(), nodes, contact));
      result.set_time_step(h);
      return result;
    }
  };

  /**
   * One step with the first node kept at or above @p wall on the shifted
   * configuration: 0 <= r, u1 + h (1 - theta) v1 >= wall, complementary.
   * Returns r.
   */
  inline double impact_step(PlainStepper &stepper, const double wall = 0.)
  {
    stepper.begin_step();
    const double h       = stepper.system->time_step(),
                 theta   = stepper.system->scheme().theta,
                 shifted = stepper.contact_displacement()[0] +
                           h * (1 - theta) * stepper.contact_velocity()[0] +
                           h * stepper.free_contact_velocity()[0];
    const double reaction =
      std::max(0.,
               (wall - shifted) / stepper.system->contact_compliance()(0, 0));
    stepper.end_step({reaction});
    return reaction;
  }
} // namespace RollingContact

#endif
