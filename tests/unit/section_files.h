#ifndef rolling_contact_tests_section_files_h
#define rolling_contact_tests_section_files_h

#include "mesh_files.h"

#include <rolling_contact/mesh/section_file_shape.h>

#include <cmath>
#include <memory>

namespace RollingContact
{
  /** A body with a section of prm/sections. */
  inline BodyParameters section_body(const std::string &section,
                                     const std::string &file)
  {
    BodyParameters body(section);
    body.shape     = "section";
    body.mesh_file = TEST_DATA "/../../prm/sections/" + file;
    if (section == "Rail")
      body.radius = 0.;
    return body;
  }

  inline std::shared_ptr<const BodyShape> shape_of(const BodyParameters &body)
  {
    body.check(3);
    BodySpec spec(body);
    spec.read_mesh(3, "");
    return spec.body_shape();
  }

  inline double relative(const double value, const double expected)
  {
    return std::abs(value / expected - 1);
  }
} // namespace RollingContact

#endif
