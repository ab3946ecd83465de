#include <rolling_contact/histories/point_columns.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  std::vector<std::string>
  point_columns(const SceneParameters &scene)
  {
    std::vector<std::string> columns;
    for (const Side side : both_sides)
      for (const VelocityPoint &point : scene.velocity_points(side))
        for (const char axis : std::string(scene.dimension == 3 ? "xyz" : "xz"))
          columns.push_back(velocity_column(point.name, axis));
    return columns;
  }
} // namespace RollingContact
