#include <rolling_contact/base/text.h>
#include <rolling_contact/run/pvd.h>

namespace RollingContact
{
  namespace
  {
    std::string
    attribute(const std::string &name, const std::string &value)
    {
      std::string text = ' ' + name + "=\"";
      for (const char character : valid_utf8(value))
        if (character == '&')
          text += "&amp;";
        else if (character == '<')
          text += "&lt;";
        else if (character == '"')
          text += "&quot;";
        else
          text += character;
      return text + '"';
    }
  } // namespace



  void
  write_pvd(const std::vector<PvdBlock> &blocks,
            RunFolder                   &folder,
            const std::string           &file_name)
  {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\">\n"
                       "  <Collection>\n";
    for (const PvdBlock &block : blocks)
      text +=
        "    <DataSet" + attribute("timestep", significant(block.time, 15)) +
        attribute("group", "") + attribute("part", std::to_string(block.part)) +
        attribute("name", block.name) + attribute("file", block.file) + "/>\n";
    folder.write_atomically(file_name, text + "  </Collection>\n</VTKFile>\n");
  }
} // namespace RollingContact
