#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/modes/outer_surface.h>
#include <rolling_contact/time/radiating_surface.h>
#include <rolling_contact/time/radiation_efficiency.h>

#include <algorithm>
#include <map>

namespace RollingContact::Sound
{
  using namespace dealii;

  namespace
  {
    Tensor<1, 3> unit_vector(const unsigned int component)
    {
      Tensor<1, 3> e;
      e[component] = 1.;
      return e;
    }

    std::vector<RadiatingPart> parts_about_axle(const VibratingBody<3> &body,
                                                const OuterSurface     &surface,
                                                const Axle             &axle,
                                                const std::size_t       n_modes,
                                                const Air              &air)
    {
      Point<3>     middle;
      Tensor<1, 3> along;
      for (unsigned int d = 0; d < 3; ++d)
        {
          middle[d] = axle.point[d];
          along[d]  = axle.direction[d];
        }
      const auto axial   = [=](const Point<3> &) { return along; };
      const auto outward = [=](const Point<3> &at) {
        const Tensor<1, 3> from = at - middle;
        const Tensor<1, 3> out  = from - (from * along) * along;
        return out / out.norm();
      };
      std::map<unsigned int, std::vector<std::size_t>> by_diameters;
      for (std::size_t j = 0; j < n_modes; ++j)
        {
          if (!body.characters[j].nodal_diameters)
            throw InputError(
              "Sound/Estimate = true: the nodes of the " + name_of(body.side) +
              " make no rings round its axle, so that nodal diameters cannot be "
              "counted; take a mesh with equal angles or set it to false.");
          by_diameters[*body.characters[j].nodal_diameters].push_back(j);
        }
      const DenseMatrix R_axial  = surface.form(axial),
                        R_radial = surface.form(outward);
      const double radius = body.parameters.radius, c = air.speed,
                   width = surface.area(outward) / (2 * numbers::PI * radius);
      std::vector<RadiatingPart> parts;
      for (const auto &of_diameters : by_diameters)
        {
          const unsigned int n     = of_diameters.first;
          const auto        &modes = of_diameters.second;
          parts.push_back({modes, R_axial(modes, modes), [=](const double f) {
                             return axial_efficiency_of_wheel(n, radius, c, f);
                           }});
          parts.push_back(
            {modes, R_radial(modes, modes), [=](const double f) {
               return radial_efficiency_of_wheel(n, radius, width, c, f);
             }});
        }
      return parts;
    }

    /** Along y and z. */
    std::vector<std::function<double(double)>>
    efficiencies_of(const OuterSurface &surface, const Air &air)
    {
      const auto   box     = surface.box();
      const double length  = box[1][0] - box[0][0],
                   section = surface.volume() / length, c = air.speed;
      std::vector<std::function<double(double)>> result;
      for (const unsigned int component : {1, 2})
        {
          const unsigned int across = 3 - component;
          const double       a =
            equivalent_radius(section,
                              box[1][across] - box[0][across],
                              surface.area([e = unit_vector(component)](
                                             const Point<3> &) { return e; }) /
                                length);
          result.push_back(
            [=](const double f) { return efficiency_of_cylinder(a, c, f); });
        }
      return result;
    }

    std::vector<RadiatingPart> parts_of_beam(const OuterSurface &surface,
                                             const std::size_t   n_modes,
                                             const Air          &air)
    {
      std::vector<std::size_t> all(n_modes);
      for (std::size_t j = 0; j < n_modes; ++j)
        all[j] = j;
      const auto                 efficiencies = efficiencies_of(surface, air);
      std::vector<RadiatingPart> parts;
      for (const unsigned int component : {1, 2})
        parts.push_back({all,
                         surface.form([e = unit_vector(component)](
                                        const Point<3> &) { return e; }),
                         efficiencies[component - 1]});
      return parts;
    }
  } // namespace

  std::vector<std::function<double(double)>>
  efficiencies_of_beam(const VibratingBody<3> &body, const Air &air)
  {
    return efficiencies_of(OuterSurface(*body.body, DenseMatrix(), 0), air);
  }

  RadiatingBody radiating_body(const VibratingBody<3> &body,
                               const double            maximum_frequency,
                               const Air              &air)
  {
    if (body.waves)
      throw InputError(body.parameters.section +
                       "/Model = waveguide: Sound needs the modes of the rail; "
                       "take Model = mesh, or Sound/Estimate = false.");
    RadiatingBody radiating;
    for (const double frequency : body.modes.frequencies)
      if (frequency <= maximum_frequency)
        radiating.frequencies.push_back(frequency);
    const std::size_t  n = radiating.frequencies.size();
    const OuterSurface surface(*body.body, body.modes.shapes, n);
    const auto         axle = body.parameters.body_shape()->axle();
    radiating.parts = axle ? parts_about_axle(body, surface, *axle, n, air)
                           : parts_of_beam(surface, n, air);
    return radiating;
  }
} // namespace RollingContact::Sound
