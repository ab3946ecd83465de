#include <rolling_contact/modes/node_rings.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Vector = std::array<double, 3>;

    /// of the largest radius, by which neighbours among the sorted coordinates
    /// of a ring's nodes may differ: files have six digits or more
    const double same_ring = 3e-6;

    double scalar_product(const Vector &a, const Vector &b)
    {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    Vector cross(const Vector &a, const Vector &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }

    Vector combination(const double  a,
                       const Vector &x,
                       const double  b,
                       const Vector &y)
    {
      return {{a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]}};
    }

    /**
     * Groups of nodes by a coordinate, in ascending order of it: sorted, they
     * part where it grows by more than the tolerance.
     */
    std::vector<std::vector<NodeRing::Node>>
    clusters(std::vector<NodeRing::Node> nodes,
             double CylindricalPlace::*const coordinate,
             const double                    tolerance)
    {
      const auto of = [&](const NodeRing::Node &node) {
        return node.place.*coordinate;
      };
      std::sort(nodes.begin(), nodes.end(), [&](const auto &a, const auto &b) {
        return of(a) < of(b);
      });
      std::vector<std::vector<NodeRing::Node>> groups;
      for (const NodeRing::Node &node : nodes)
        {
          if (groups.empty() || of(node) - of(groups.back().back()) > tolerance)
            groups.emplace_back();
          groups.back().push_back(node);
        }
      return groups;
    }
  } // namespace

  CylindricalPlace::CylindricalPlace(const Axle &axle, const Vector &point)
    : along(axle.direction)
  {
    const Vector from = combination(1., point, -1., axle.point);
    axial             = scalar_product(from, along);
    outwards          = combination(1., from, -axial, along);
    radius            = std::sqrt(scalar_product(outwards, outwards));
    if (radius > 0.)
      outwards = combination(1 / radius, outwards, 0., outwards);
    around          = cross(along, outwards);
    const Vector up = combination(1., {{0., 0., 1.}}, -along[2], along);
    angle           = std::atan2(scalar_product(outwards, cross(along, up)),
                       scalar_product(outwards, up));
  }

  void NodeRing::close()
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

  std::vector<NodeRing> node_rings(const BodyPlaces &places, const Axle &axle)
  {
    double largest = 0.;
    for (const auto &node : places.nodes)
      largest = std::max(largest, CylindricalPlace(axle, node.point).radius);
    std::vector<NodeRing::Node> nodes;
    for (const auto &node : places.nodes)
      {
        const CylindricalPlace place(axle, node.point);
        if (place.radius >= 1e-3 * largest)
          nodes.push_back({&node, place, 0.});
      }
    std::vector<NodeRing> rings;
    for (const auto &cylinder :
         clusters(nodes, &CylindricalPlace::radius, same_ring * largest))
      for (const auto &circle :
           clusters(cylinder, &CylindricalPlace::axial, same_ring * largest))
        {
          NodeRing ring;
          ring.nodes = circle;
          // so that the sum of masses does not hang on the last digits
          std::sort(ring.nodes.begin(),
                    ring.nodes.end(),
                    [](const auto &a, const auto &b) {
                      return a.node < b.node;
                    });
          for (const NodeRing::Node &node : ring.nodes)
            ring.mass += node.node->mass;
          ring.close();
          if (ring.gap < widest_ring_gap)
            rings.push_back(std::move(ring));
        }
    return rings;
  }
} // namespace RollingContact
