#include <rolling_contact/modes/node_rings.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Vector = std::array<double, 3>;

    /// of the largest radius, by which nodes of a ring may differ
    const double same_ring = 1e-6;



    double
    product(const Vector &a, const Vector &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }



    Vector
    cross(const Vector &a, const Vector &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }



    Vector
    combination(const double  a,
                const Vector &x,
                const double  b,
                const Vector &y)
    {
      return {{a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]}};
    }
  } // namespace



  CylindricalPlace::CylindricalPlace(const Axle &axle, const Vector &point)
    : along(axle.direction)
  {
    const Vector from = combination(1., point, -1., axle.point);
    axial             = product(from, along);
    outwards          = combination(1., from, -axial, along);
    radius            = std::sqrt(product(outwards, outwards));
    if (radius > 0.)
      outwards = combination(1 / radius, outwards, 0., outwards);
    around          = cross(along, outwards);
    const Vector up = combination(1., {{0., 0., 1.}}, -along[2], along);
    angle =
      std::atan2(product(outwards, cross(along, up)), product(outwards, up));
  }



  void
  NodeRing::close()
  {
    std::sort(nodes.begin(), nodes.end(), [](const Node &a, const Node &b) {
      return a.place.angle < b.place.angle;
    });
    gap = 0.;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const std::size_t next = (k + 1) % nodes.size();
        const double step = nodes[next].place.angle - nodes[k].place.angle +
                            (next == 0 ? 2 * pi : 0.);
        nodes[k].weight += step / (4 * pi);
        nodes[next].weight += step / (4 * pi);
        gap = std::max(gap, step);
      }
  }



  std::vector<NodeRing>
  node_rings(const BodyPlaces &places, const Axle &axle)
  {
    double largest = 0.;
    for (const auto &node : places.nodes)
      largest = std::max(largest, CylindricalPlace(axle, node.point).radius);
    const double                              tolerance = same_ring * largest;
    std::map<std::pair<long, long>, NodeRing> found;
    for (const auto &node : places.nodes)
      {
        const CylindricalPlace place(axle, node.point);
        if (place.radius < 1e-3 * largest)
          continue;
        NodeRing &ring = found[{std::lround(place.radius / tolerance),
                                std::lround(place.axial / tolerance)}];
        ring.nodes.push_back({&node, place, 0.});
        ring.mass += node.mass;
      }
    std::vector<NodeRing> rings;
    for (auto &[key, ring] : found)
      {
        ring.close();
        if (ring.gap < widest_ring_gap)
          rings.push_back(std::move(ring));
      }
    return rings;
  }
} // namespace RollingContact
