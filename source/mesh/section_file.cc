#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/section_file.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    /// over the radius, of the hole round the axle: smaller ones make needles
    const double least_hole = 1e-3;

    /// of the radius, that of a file's name may be off
    const double off_radius = 5e-3;

    /// of an edge's length, its chord may miss the contact point
    const double off_contact = 0.01;

    std::string place(const MeshFile &file, const FileMesh::Point &point)
    {
      const double way = file.mirrored ? -1. : 1.;
      return "(" + significant(point[0] / file.unit, 4) + ", " +
             significant(way * point[2] / file.unit, 4) + ")";
    }

    /**
     * Height of the contact boundary over or under the contact point nearest to
     * that, and how far it may be off.
     */
    std::pair<double, double> height_at_contact(const FileMesh &mesh)
    {
      std::pair<double, double> nearest{HUGE_VAL, 0.};
      for (const FileMesh::Face &edge : mesh.contact_faces)
        {
          const FileMesh::Point &p = mesh.vertices[edge[0]],
                                &q = mesh.vertices[edge[1]];
          if (p[0] * q[0] > 0. || p[0] == q[0])
            continue;
          const double height = p[2] - p[0] * (q[2] - p[2]) / (q[0] - p[0]);
          if (std::abs(height) < std::abs(nearest.first))
            nearest = {height,
                       off_contact * std::hypot(q[0] - p[0], q[2] - p[2])};
        }
      return nearest;
    }

    /**
     * The radius in the name of a physical group of Gmsh, as "contact, radius
     * 0.46"; none if no name has one. Units: those of the file.
     */
    std::optional<double> named_radius(const MeshFile &file)
    {
      const std::string text = read_bytes(file.path), word = "radius";
      const auto        begin = text.find("$PhysicalNames"),
                 end          = text.find("$EndPhysicalNames");
      if (begin == std::string::npos || end == std::string::npos || end < begin)
        return {};
      const std::string names = text.substr(begin, end - begin);
      const auto        found = names.find(word);
      if (found == std::string::npos)
        return {};
      const auto first = names.find_first_not_of(" =", found + word.size());
      if (first == std::string::npos)
        return {};
      return number(names.substr(
        first, names.find_first_not_of("0123456789.eE+-", first) - first));
    }

    void check_named_radius(const MeshFile &file, const double radius)
    {
      const auto named = named_radius(file);
      if (radius == 0. || !named || *named <= 0. ||
          std::abs(*named * file.unit - radius) <= off_radius * radius)
        return;
      const std::string entry = file.section + "/Radius = ",
                        own   = significant(*named * file.unit, 6);
      reject(file,
             "it is the section of a body of radius " + own +
               " m, as the name of a group in it says, and " + entry +
               significant(radius, 6) + " m: set " + entry + own +
               ", take a section of that radius, or check " + file.section +
               "/Mesh unit (" + significant(file.unit, 4) + " m).");
    }

    void
    check_axle(const MeshFile &file, const FileMesh &mesh, const double radius)
    {
      if (radius == 0.)
        return;
      const auto innermost = std::min_element(mesh.vertices.begin(),
                                              mesh.vertices.end(),
                                              [](const auto &p, const auto &q) {
                                                return p[2] < q[2];
                                              });
      if (radius + (*innermost)[2] < least_hole * radius)
        reject(file,
               "the section crosses or touches its axle, which is " +
                 file.section + "/Radius = " + significant(radius, 6) + " m " +
                 (file.mirrored ? "above" : "below") +
                 " the contact point, at the point " + place(file, *innermost) +
                 " of the file: check Radius and Mesh unit (" +
                 significant(file.unit, 4) +
                 " m); this file needs a Radius above " +
                 significant(-(*innermost)[2], 6) +
                 " m, a solid axle a hole along it, of " +
                 significant(least_hole * radius, 2) + " m or more.");
    }
  } // namespace

  std::shared_ptr<const FileMesh> read_section_file(const MeshFile &file,
                                                    const double    radius)
  {
    const auto mesh            = read_mesh_file<2>(file);
    const auto [height, slack] = height_at_contact(*mesh);
    if (!file.is_under_profile && !(std::abs(height) <= slack))
      reject(file,
             "its contact boundary (" + file.section +
               "/Contact boundary id = " +
               std::to_string(file.contact_boundary) + ") passes " +
               significant(std::abs(height), 4) +
               " m over or under the contact point, the file's origin: move "
               "the section, or check Mesh unit (" +
               significant(file.unit, 4) + " m).");
    check_named_radius(file, radius);
    check_axle(file, *mesh, radius);
    return mesh;
  }
} // namespace RollingContact
