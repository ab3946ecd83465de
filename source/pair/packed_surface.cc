#include <rolling_contact/pair/packed_surface.h>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  std::vector<double>
  packed(const std::vector<typename ElasticBody<dim>::SurfaceNode> &nodes,
         const std::vector<typename ElasticBody<dim>::SurfaceFace> &faces)
  {
    std::vector<double> numbers{double(nodes.size()), double(faces.size())};
    const auto          put = [&](const Point<dim - 1> &point) {
      for (unsigned int d = 0; d < dim - 1; ++d)
        numbers.push_back(point[d]);
    };
    for (const auto &node : nodes)
      put(node.position);
    for (const auto &face : faces)
      {
        put(face.lower);
        put(face.upper);
        for (const auto &corner : face.corners)
          {
            numbers.push_back(corner.size());
            for (const auto &entry : corner)
              {
                numbers.push_back(entry.first);
                numbers.push_back(entry.second);
              }
          }
      }
    return numbers;
  }



  template <int dim>
  Trace
  unpacked(const std::vector<double> &numbers)
  {
    Trace trace;
    trace.n_dimensions = dim - 1;
    auto       number  = numbers.begin();
    const auto get     = [&]() { return *number++; };
    const auto point   = [&](std::array<double, 2> &at) {
      at = {{0., 0.}};
      for (unsigned int d = 0; d < dim - 1; ++d)
        at[d] = get();
    };
    trace.nodes.resize(get());
    trace.cells.resize(get());
    for (auto &node : trace.nodes)
      point(node);
    for (Trace::Cell &cell : trace.cells)
      {
        point(cell.lower);
        point(cell.upper);
        cell.corners.resize(1 << (dim - 1));
        for (auto &corner : cell.corners)
          {
            corner.resize(get());
            for (auto &entry : corner)
              {
                entry.first  = get();
                entry.second = get();
              }
          }
      }
    return trace;
  }



  template std::vector<double>
  packed<2>(const std::vector<ElasticBody<2>::SurfaceNode> &,
            const std::vector<ElasticBody<2>::SurfaceFace> &);
  template std::vector<double>
  packed<3>(const std::vector<ElasticBody<3>::SurfaceNode> &,
            const std::vector<ElasticBody<3>::SurfaceFace> &);
  template Trace
  unpacked<2>(const std::vector<double> &);
  template Trace
  unpacked<3>(const std::vector<double> &);
} // namespace RollingContact
