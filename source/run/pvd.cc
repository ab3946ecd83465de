#include <fmt/format.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/base/xml_text.h>
#include <rolling_contact/run/pvd.h>

namespace RollingContact
{
  void write_pvd(const std::vector<PvdBlock> &blocks,
                 RunFolder                   &folder,
                 const std::string           &file_name)
  {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                       "  <Collection>\n";
    for (const PvdBlock &block : blocks)
      text += fmt::format("    <DataSet timestep=\"{}\" group=\"\" part=\"{}\" "
                          "name=\"{}\" file=\"{}\"/>\n",
                          significant(block.time, 15),
                          block.part,
                          xml_escaped(block.name),
                          xml_escaped(block.file));
    folder.write_atomically(file_name, text + "  </Collection>\n</VTKFile>\n");
  }
} // namespace RollingContact
