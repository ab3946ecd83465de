#include <rolling_contact/pair/section_in_contact.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  bool SectionInContact::is_on(const PairSpec &scene, const Side side)
  {
    return scene.frame && scene.body(side).is_section();
  }

  SectionInContact::SectionInContact(const PairSpec &scene, const Side side)
    : is_left(scene.profiles.is_left)
    , is_curved(scene.profiles.surface_kind == Profiles::SurfaceKind::curved)
    , radius(side == Side::wheel ? scene.wheel.radius : 0.)
    , profile(*scene.body(side).profile, side == Side::wheel)
    , turn((is_left ? -1. : 1.) * scene.body(side).profile->turn)
    , origin(profile.at(profile.contact()))
  {
    if (is_left)
      origin[0] = -origin[0];
  }

  ProfiledSection::Point
  SectionInContact::in_file(const FileMesh::Point &vertex) const
  {
    const double outwards =
      radius > 0. ? std::hypot(vertex[0], vertex[2] + radius) - radius
                  : vertex[2];
    return {{is_left ? -vertex[1] : vertex[1], outwards}};
  }

  double SectionInContact::off_profile(const FileMesh::Point &vertex) const
  {
    return profile.nearest(in_file(vertex)).distance;
  }

  FileMesh SectionInContact::seen_from_contact(const FileMesh &mesh) const
  {
    FileMesh     result = mesh;
    const double c = std::cos(turn), s = std::sin(turn);
    for (FileMesh::Point &vertex : result.vertices)
      {
        const double y = vertex[1] - origin[0], z = vertex[2] - origin[1];
        vertex[1] = c * y - s * z;
        vertex[2] = s * y + c * z;
      }
    // the flange opposite the contact faces the same way as that at it
    auto      &faces    = result.contact_faces;
    const auto opposite = [&](const FileMesh::Face &face) {
      return radius > 0. && mesh.vertices[face[0]][2] < -radius;
    };
    faces.erase(std::remove_if(faces.begin(), faces.end(), opposite),
                faces.end());
    if (!is_curved)
      return result;
    for (const FileMesh::Face &face : faces)
      for (const unsigned int corner : face)
        {
          const double across = profile.coordinate(
            profile.nearest(in_file(mesh.vertices[corner])).along);
          result.vertices[corner][1] = is_left ? -across : across;
        }
    return result;
  }
} // namespace RollingContact
