#ifndef rolling_contact_tests_mesh_files_h
#define rolling_contact_tests_mesh_files_h

#include "mesh_writer.h"
#include "scratch_folder.h"

#include <rolling_contact/scene/body_parameters.h>

namespace RollingContact
{
  /** Mesh files in a folder of their own. */
  struct Files : public ScratchFolder
  {
    std::string save(const std::string &name, const std::string &text) const
    {
      write(scratch / name, text);
      return (scratch / name).string();
    }

    /** A scene's body from this file; it must be read before a run. */
    void take(BodyParameters &body, const std::string &name) const
    {
      body.shape     = "mesh file";
      body.mesh_file = (scratch / name).string();
    }
  };

  inline std::vector<double>
  equal(const double begin, const double end, const unsigned int n)
  {
    std::vector<double> points(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      points[i] = begin + (end - begin) * i / n;
    return points;
  }

  /** A block with a flat top, 40 mm long (and wide) and 30 mm deep. */
  inline WrittenMesh
  block(const unsigned int dim, const unsigned int n, const double distortion)
  {
    WrittenMesh mesh;
    mesh.a = equal(-0.02, 0.02, n);
    if (dim == 3)
      mesh.b = equal(-0.02, 0.02, n + 1);
    mesh.c   = equal(0., 0.03, 3);
    mesh.map = [=](double a, double b, double c) {
      const double inside =
        (1 - a * a / 4e-4) * (1 - b * b / 4e-4) * distortion * 0.04 / n;
      return WrittenMesh::Point{{a + inside * std::sin(300 * a + 200 * b),
                                 b + inside * std::cos(250 * a),
                                 -c}};
    };
    return mesh;
  }

} // namespace RollingContact

#endif
