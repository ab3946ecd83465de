#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/mode_character.h>
#include <rolling_contact/modes/node_rings.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Vector  = std::array<double, 3>;
    using Complex = std::complex<double>;

    const unsigned int most_rings = 64, most_diameters = 24;

    /// of a pair: difference of the frequencies over their mean, of the shares
    const double close = 0.03, alike = 0.05;

    double product(const Vector &a, const Vector &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    Vector motion(const BodyPlaces::Node &node,
                  const DenseMatrix      &shapes,
                  const std::size_t       mode)
    {
      Vector u{};
      for (unsigned int c = 0; c < 3; ++c)
        if (node.unknowns[c] >= 0)
          u[c] = shapes(node.unknowns[c], mode);
      return u;
    }

    /** The heaviest rings that go all the way round. */
    std::vector<NodeRing> rings_of(const BodyPlaces &places, const Axle &axle)
    {
      std::vector<NodeRing> rings = node_rings(places, axle);
      std::sort(rings.begin(),
                rings.end(),
                [](const NodeRing &a, const NodeRing &b) {
                  return a.mass > b.mass;
                });
      if (rings.size() > most_rings)
        rings.resize(most_rings);
      return rings;
    }

    /** Along the axle, away from it and around it, by the weight of the node.
     */
    Vector weighted(const NodeRing::Node &at,
                    const DenseMatrix    &shapes,
                    const std::size_t     mode)
    {
      const Vector u = motion(*at.node, shapes, mode);
      return {{at.weight * product(u, at.place.along),
               at.weight * product(u, at.place.outwards),
               at.weight * product(u, at.place.around)}};
    }

    /** Energy of each order of the Fourier series round the axle. */
    std::vector<double> energy_of_orders(const std::vector<NodeRing> &rings,
                                         const DenseMatrix           &shapes,
                                         const std::size_t            mode)
    {
      double gap = 0.;
      for (const NodeRing &ring : rings)
        gap = std::max(gap, ring.gap);
      const unsigned int n_orders =
        std::min<unsigned int>(most_diameters, pi / gap);
      std::vector<double> energy(n_orders + 1, 0.);
      for (const NodeRing &ring : rings)
        {
          std::vector<Vector> cosine(n_orders + 1, Vector{}), sine = cosine;
          for (const NodeRing::Node &at : ring.nodes)
            {
              const Vector u = weighted(at, shapes, mode);
              for (unsigned int n = 0; n <= n_orders; ++n)
                {
                  const double c = std::cos(n * at.place.angle),
                               s = std::sin(n * at.place.angle);
                  for (unsigned int d = 0; d < 3; ++d)
                    {
                      cosine[n][d] += c * u[d];
                      sine[n][d] += s * u[d];
                    }
                }
            }
          for (unsigned int n = 0; n <= n_orders; ++n)
            energy[n] +=
              (n == 0 ? 1. : 2.) * ring.mass *
              (product(cosine[n], cosine[n]) + product(sine[n], sine[n]));
        }
      return energy;
    }

    /** Changes of sign, from the hub to the tread, of the axial motion with so
     * many nodal diameters, small ones left out. */
    unsigned int circles_of(const std::vector<NodeRing> &rings,
                            const DenseMatrix           &shapes,
                            const std::size_t            mode,
                            const unsigned int           diameters)
    {
      const double              small = 0.05; // of the largest
      std::map<double, Complex> amplitudes;   // by radius
      Complex                   largest = 0.;
      for (const NodeRing &ring : rings)
        {
          Complex sum = 0.;
          for (const NodeRing::Node &at : ring.nodes)
            sum += weighted(at, shapes, mode)[0] *
                   std::polar(1., diameters * at.place.angle);
          amplitudes[ring.nodes.front().place.radius] += sum;
          if (std::abs(sum) > std::abs(largest))
            largest = sum;
        }
      unsigned int circles = 0;
      double       before  = 0.;
      for (const auto &[radius, amplitude] : amplitudes)
        {
          const double now = (amplitude * std::conj(largest)).real();
          if (std::abs(now) < small * std::norm(largest))
            continue;
          circles += now * before < 0.;
          before = now;
        }
      return circles;
    }

    void find_shares(const BodyPlaces          &places,
                     const std::optional<Axle> &axle,
                     const DenseMatrix         &shapes,
                     const std::size_t          mode,
                     ModeCharacter             &character)
    {
      for (const BodyPlaces::Node &node : places.nodes)
        {
          const Vector u = motion(node, shapes, mode);
          Vector       parts{{u[1], u[2], u[0]}};
          if (axle)
            {
              const CylindricalPlace place(*axle, node.point);
              parts = {{product(u, place.along),
                        product(u, place.outwards),
                        product(u, place.around)}};
            }
          character.axial_share += node.mass * parts[0] * parts[0];
          character.radial_share += node.mass * parts[1] * parts[1];
          character.circumferential_share += node.mass * parts[2] * parts[2];
        }
      const double sum = character.axial_share + character.radial_share +
                         character.circumferential_share;
      for (double *share : {&character.axial_share,
                            &character.radial_share,
                            &character.circumferential_share})
        *share /= sum > 0. ? sum : 1.;
    }

    bool are_alike(const ModeCharacter &a, const ModeCharacter &b)
    {
      return a.nodal_diameters == b.nodal_diameters &&
             std::abs(a.axial_share - b.axial_share) < alike &&
             std::abs(a.radial_share - b.radial_share) < alike;
    }

    void find_pairs(const StructuralModes      &modes,
                    std::vector<ModeCharacter> &characters)
    {
      for (std::size_t i = 0; i < characters.size(); ++i)
        {
          if (characters[i].partner || !characters[i].nodal_diameters ||
              *characters[i].nodal_diameters == 0)
            continue;
          for (std::size_t j = i + 1; j < characters.size(); ++j)
            {
              const double split =
                2 * (modes.frequencies[j] - modes.frequencies[i]) /
                (modes.frequencies[j] + modes.frequencies[i]);
              if (!(split < close))
                break;
              if (characters[j].partner ||
                  !are_alike(characters[i], characters[j]))
                continue;
              characters[i].partner = j;
              characters[j].partner = i;
              characters[i].split = characters[j].split = split;
              break;
            }
        }
    }
  } // namespace

  char ModeCharacter::family() const
  {
    const double largest =
      std::max({axial_share, radial_share, circumferential_share});
    return largest == axial_share ? 'L' : largest == radial_share ? 'R' : 'C';
  }

  std::string ModeCharacter::name() const
  {
    if (!nodal_diameters)
      return "";
    return (family() == 'L' ? std::to_string(*nodal_circles) : "") + family() +
           std::to_string(*nodal_diameters);
  }

  std::vector<ModeCharacter> mode_characters(const BodyPlaces          &places,
                                             const std::optional<Axle> &axle,
                                             const StructuralModes     &modes)
  {
    std::vector<NodeRing> rings;
    if (axle)
      rings = rings_of(places, *axle);
    std::vector<ModeCharacter> characters(modes.size());
    for (std::size_t j = 0; j < modes.size(); ++j)
      {
        find_shares(places, axle, modes.shapes, j, characters[j]);
        if (rings.empty())
          continue;
        const auto energy = energy_of_orders(rings, modes.shapes, j);
        const auto most   = std::max_element(energy.begin(), energy.end());
        double     sum    = 0.;
        for (const double part : energy)
          sum += part;
        characters[j].nodal_diameters = most - energy.begin();
        characters[j].diameter_share  = sum > 0. ? *most / sum : 0.;
        characters[j].nodal_circles =
          circles_of(rings, modes.shapes, j, *characters[j].nodal_diameters);
      }
    find_pairs(modes, characters);
    return characters;
  }

  namespace
  {
    /** The motions of modes along the axis of the contact along which they
     * move most; zeros if they do not move there. */
    std::vector<double> largest_motions(const MeasuringPoint           &contact,
                                        const DenseMatrix              &shapes,
                                        const std::vector<std::size_t> &modes)
    {
      std::vector<double> largest(modes.size(), 0.);
      for (unsigned int axis = 0; axis < 3; ++axis)
        {
          std::vector<double> motions;
          for (const std::size_t mode : modes)
            motions.push_back(contact.motion(axis, shapes.col(mode).data()));
          // the margin keeps rounding from choosing between equal ones
          if (norm(motions) > 1.01 * norm(largest))
            largest = motions;
        }
      return largest;
    }
  } // namespace

  void align_pairs(const std::vector<ModeCharacter> &characters,
                   const MeasuringPoint             &contact,
                   const double                      tolerance,
                   StructuralModes                  &modes)
  {
    DenseMatrix &shapes = modes.shapes;
    for (std::size_t j = 0; j < modes.size(); ++j)
      {
        const auto partner = characters[j].partner;
        if (partner && *partner > j && characters[j].split < tolerance)
          {
            const auto moved = largest_motions(contact, shapes, {j, *partner});
            const double length = norm(moved), c = moved[0] / length,
                         s = moved[1] / length;
            if (length == 0.)
              continue;
            const Eigen::VectorXd first = shapes.col(j);
            shapes.col(j)               = c * first + s * shapes.col(*partner);
            shapes.col(*partner)        = c * shapes.col(*partner) - s * first;
          }
        if (largest_motions(contact, shapes, {j})[0] < 0.)
          shapes.col(j) *= -1;
      }
  }
} // namespace RollingContact
