#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/mesh_file.h>

using namespace RollingContact;

/** A mesh of Gmsh if it begins with a dollar, else of Abaqus, of a rail in both
 * dimensions, and as a wheel's, which is mirrored. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  MeshFile file;
  file.section = "Rail";
  file.name    = size > 0 && data[0] == '$' ? "mesh.msh" : "mesh.inp";
  file.path    = file.name;
  write_part(file.name, input_parts(data, size), 0);
  for (const bool mirrored : {false, true})
    {
      file.mirrored = mirrored;
      try
        {
          read_mesh_file<2>(file);
        }
      catch (const InputError &)
        {}
      try
        {
          read_mesh_file<3>(file);
        }
      catch (const InputError &)
        {}
    }
  return 0;
}
