#include <boost/math/constants/constants.hpp>

#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace RollingContact::References
{
  namespace
  {
    constexpr double pi       = boost::math::constants::pi<double>();
    constexpr double infinity = std::numeric_limits<double>::infinity();

    double
    profile_radius(const LineBody &body)
    {
      if (body.shape == LineBody::Shape::block)
        return infinity;
      check_positive("Radius of the disc", body.extent, "m");
      return body.extent;
    }

    double
    young_modulus(const LineBody &body)
    {
      return body.rigid ? infinity : body.young_modulus;
    }

    double
    disc_factor(const double relative_extent)
    {
      return 2 * std::log(4 * relative_extent) - 1;
    }

    double
    block_factor(const double relative_extent, const double poisson_ratio)
    {
      // t (sqrt(1+t^2) - t), without cancellation
      const double lateral =
        relative_extent / (std::hypot(1, relative_extent) + relative_extent);
      return 2 * (std::asinh(relative_extent) -
                  poisson_ratio / (1 - poisson_ratio) * lateral);
    }

    double
    compression_of_both(const LineBodies &bodies, const HertzLine &contact)
    {
      return compression(bodies[0], contact) + compression(bodies[1], contact);
    }
  } // namespace

  double
  relative_radius(const LineBodies &bodies)
  {
    return relative_radius(profile_radius(bodies[0]),
                           profile_radius(bodies[1]));
  }

  double
  contact_modulus(const LineBodies &bodies)
  {
    return contact_modulus(young_modulus(bodies[0]),
                           bodies[0].poisson_ratio,
                           young_modulus(bodies[1]),
                           bodies[1].poisson_ratio);
  }

  double
  compression(const LineBody &body, const HertzLine &contact)
  {
    if (body.rigid || contact.half_width == 0)
      return 0;
    check_elasticity(body.young_modulus, body.poisson_ratio);
    check_positive("Radius of the disc or depth of the block",
                   body.extent,
                   "m");
    const double relative_extent = body.extent / contact.half_width;
    const double factor          = body.shape == LineBody::Shape::disc
                                     ? disc_factor(relative_extent)
                                     : block_factor(relative_extent, body.poisson_ratio);
    return (1 - body.poisson_ratio * body.poisson_ratio) *
           contact.load_per_length() / (pi * body.young_modulus) * factor;
  }

  double
  approach_of_line_contact(const LineBodies &bodies,
                           const double      load_per_length)
  {
    return compression_of_both(bodies,
                               hertz_line(load_per_length,
                                          relative_radius(bodies),
                                          contact_modulus(bodies)));
  }

  double
  load_of_line_contact(const LineBodies &bodies, const double approach)
  {
    const double radius  = relative_radius(bodies);
    const double modulus = contact_modulus(bodies);
    const auto   contact = [&](const double half_width) {
      return hertz_line_of_half_width(half_width, radius, modulus);
    };
    const double half_width = half_width_of_approach(
      [&](const double trial) {
        return compression_of_both(bodies, contact(trial));
      },
      radius,
      approach);
    return contact(half_width).load_per_length();
  }

  double
  half_width_of_approach(
    const std::function<double(double)> &approach_of_half_width,
    const double                         largest_half_width,
    const double                         approach)
  {
    check_finite("Approach", approach, "m");
    if (approach <= 0)
      return 0;
    const double largest = approach_of_half_width(largest_half_width);
    if (!(approach < largest))
      {
        std::ostringstream allowed;
        allowed << "smaller than " << largest
                << " m, where the half-width reaches " << largest_half_width
                << " m";
        reject("Approach", approach, "m", allowed.str());
      }
    const auto residual = [&](const double log_half_width) {
      return std::log(approach_of_half_width(std::exp(log_half_width)) /
                      approach);
    };
    const double upper = std::log(largest_half_width);
    const double lower = upper + std::log(approach / largest / 2);
    return std::exp(bracketed_root(residual, lower, upper));
  }
} // namespace RollingContact::References
