#include <rolling_contact/modes/body_reflections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace RollingContact
{
  namespace
  {
    /// of the body's size, between places that are the same
    const double same_place = 1e-9;

    /// what rounding of coordinates and assembly makes of entries
    const double rounding = 1e-11;

    const std::size_t nowhere = std::numeric_limits<std::size_t>::max();

    /**
     * Coordinates along one axis that differ, in ascending order.
     */
    class Levels
    {
    public:
      Levels(const BodyPlaces &places, const unsigned int axis)
      {
        for (const auto &node : places.nodes)
          levels.push_back(node.point[axis]);
        std::sort(levels.begin(), levels.end());
        near = same_place * (levels.back() - levels.front());
        levels.erase(std::unique(levels.begin(),
                                 levels.end(),
                                 [&](const double a, const double b) {
                                   return b - a <= near;
                                 }),
                     levels.end());
      }

      bool is_flat() const
      {
        return levels.size() == 1;
      }

      double middle() const
      {
        return (levels.front() + levels.back()) / 2;
      }

      /** Number of the level at a coordinate; -1 if there is none. */
      int at(const double x) const
      {
        const auto found =
          std::lower_bound(levels.begin(), levels.end(), x - 2 * near);
        return found != levels.end() && *found <= x + 2 * near
                 ? found - levels.begin()
                 : -1;
      }

    private:
      std::vector<double> levels;
      double              near;
    };

    /**
     * Nodes by their places.
     */
    class NodeFinder
    {
    public:
      explicit NodeFinder(const BodyPlaces &places)
        : levels{{{places, 0}, {places, 1}, {places, 2}}}
      {
        for (std::size_t k = 0; k < places.nodes.size(); ++k)
          numbers[key(places.nodes[k].point)] = k;
      }

      /** Number of the node that is the image of a place, or nowhere. */
      std::size_t image(std::array<double, 3> point,
                        const unsigned int    axis) const
      {
        point[axis]      = 2 * levels[axis].middle() - point[axis];
        const auto found = numbers.find(key(point));
        return found == numbers.end() ? nowhere : found->second;
      }

      bool is_flat(const unsigned int axis) const
      {
        return levels[axis].is_flat();
      }

    private:
      std::array<int, 3> key(const std::array<double, 3> &point) const
      {
        return {{levels[0].at(point[0]),
                 levels[1].at(point[1]),
                 levels[2].at(point[2])}};
      }

      std::array<Levels, 3>                     levels;
      std::map<std::array<int, 3>, std::size_t> numbers;
    };

    /** The reflection of the nodes, nothing if they have no image. */
    std::optional<Reflection> reflection_of_nodes(const BodyPlaces  &places,
                                                  const NodeFinder  &finder,
                                                  const unsigned int axis,
                                                  const std::size_t  n_unknowns)
    {
      Reflection R{std::vector<std::size_t>(n_unknowns, nowhere),
                   std::vector<double>(n_unknowns, 1.)};
      for (const auto &node : places.nodes)
        {
          const std::size_t image = finder.image(node.point, axis);
          for (unsigned int c = 0; c < 3; ++c)
            if (node.unknowns[c] >= 0)
              {
                if (image == nowhere || places.nodes[image].unknowns[c] < 0)
                  return {};
                R.image[node.unknowns[c]] = places.nodes[image].unknowns[c];
                R.sign[node.unknowns[c]]  = c == axis ? -1. : 1.;
              }
        }
      return R;
    }

    /**
     * Sleepers: the image of one is that which pads tie to the images of its
     * own nodes. False if there is none.
     */
    bool reflect_attached(const SymmetricSparseMatrix &K, Reflection &R)
    {
      const std::size_t        n = R.image.size();
      std::vector<std::size_t> node_of(n, nowhere), attached_to(n, nowhere);
      for (std::size_t j = 0; j < n; ++j)
        for (std::int64_t k = K.column_starts[j]; k < K.column_starts[j + 1];
             ++k)
          {
            const std::size_t i = K.row_indices[k];
            if (K.values[k] != 0. && R.image[j] != nowhere &&
                R.image[i] == nowhere)
              {
                node_of[i]     = j;
                attached_to[j] = i;
              }
          }
      std::vector<std::size_t> images = R.image;
      for (std::size_t i = 0; i < n; ++i)
        if (R.image[i] == nowhere)
          {
            if (node_of[i] == nowhere ||
                attached_to[R.image[node_of[i]]] == nowhere)
              return false;
            images[i] = attached_to[R.image[node_of[i]]];
            R.sign[i] = R.sign[node_of[i]];
          }
      R.image = std::move(images);
      return true;
    }

    /** Whether R R = 1. */
    bool is_reflection(const Reflection &R)
    {
      for (std::size_t i = 0; i < R.image.size(); ++i)
        if (R.image[R.image[i]] != i || R.sign[R.image[i]] != R.sign[i])
          return false;
      return true;
    }
  } // namespace

  std::vector<Reflection> body_reflections(const BodyPlaces            &places,
                                           const SymmetricSparseMatrix &K,
                                           const SymmetricSparseMatrix &M)
  {
    std::vector<Reflection> result;
    if (places.nodes.empty())
      return result;
    const NodeFinder finder(places);
    for (unsigned int axis = 0; axis < 3; ++axis)
      {
        if (finder.is_flat(axis))
          continue;
        std::optional<Reflection> R =
          reflection_of_nodes(places, finder, axis, K.size());
        if (R && reflect_attached(K, *R) && is_reflection(*R) &&
            asymmetry(K, *R) <= rounding && asymmetry(M, *R) <= rounding)
          result.push_back(std::move(*R));
      }
    return result;
  }
} // namespace RollingContact
