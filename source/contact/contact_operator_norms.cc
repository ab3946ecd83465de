#include <rolling_contact/contact/contact_operators.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Largest singular value of an operator from products with it and its
     * transpose; to the few digits an augmentation parameter needs.
     */
    template <typename Product, typename TransposedProduct>
    double operator_norm(const std::size_t        n,
                         const Product           &product,
                         const TransposedProduct &transposed_product)
    {
      std::vector<double> x(n);
      for (std::size_t i = 0; i < n; ++i)
        x[i] = 1. + 0.5 * std::cos(1. + 7. * i);
      double value = 0.;
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          const double length = norm(x);
          if (length == 0.)
            return 0.;
          for (double &entry : x)
            entry /= length;
          x                     = transposed_product(product(x));
          const double previous = value;
          value                 = std::sqrt(norm(x));
          if (std::abs(value - previous) < 1e-3 * value)
            break;
        }
      return value;
    }
  } // namespace

  void ContactOperators::find_normal_norm()
  {
    largest_normal = operator_norm(
      n_nodes(),
      [&](const std::vector<double> &p) { return normal_displacement(p); },
      [&](const std::vector<double> &u) {
        return contact_matrix.multiply_transposed(
          compliance.product(first_normal(), first_normal(), n_nodes(), u));
      });
  }

  void ContactOperators::find_tangential_norm()
  {
    if (n_tangential() == 0)
      return;
    // flow convection B1 x + rate y
    const auto scaled = [&](std::vector<double>        B1_x,
                            const std::vector<double> &y) {
      for (std::size_t i = 0; i < B1_x.size(); ++i)
        B1_x[i] = flow_convection() * B1_x[i] + scaling.rate * y[i];
      return B1_x;
    };
    largest_tangential = operator_norm(
      first_normal(),
      [&](const std::vector<double> &q) {
        const auto w =
          compliance.product(0, 0, first_normal(), contact_matrix.multiply(q));
        return scaled(B1.rows().multiply(w), w);
      },
      [&](const std::vector<double> &s) {
        return contact_matrix.multiply_transposed(compliance.product(
          0, 0, first_normal(), scaled(B1.rows().multiply_transposed(s), s)));
      });
  }
} // namespace RollingContact
