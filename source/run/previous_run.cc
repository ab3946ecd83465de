#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <rolling_contact/base/files.h>
#include <rolling_contact/run/previous_run.h>

#include <algorithm>
#include <sstream>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    /** How deep the brackets of a JSON text nest, outside its strings. */
    std::size_t
    depth_of(const std::string &json)
    {
      std::size_t depth = 0, deepest = 0;
      bool        in_string = false;
      for (std::size_t i = 0; i < json.size(); ++i)
        if (in_string && json[i] == '\\')
          ++i;
        else if (json[i] == '"')
          in_string = !in_string;
        else if (!in_string && (json[i] == '[' || json[i] == '{'))
          deepest = std::max(deepest, ++depth);
        else if (!in_string && (json[i] == ']' || json[i] == '}') && depth > 0)
          --depth;
      return deepest;
    }
  } // namespace



  bool
  is_plain_name(const std::string &name)
  {
    const std::string allowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    return !name.empty() && name.front() != '.' &&
           name.find_first_not_of(allowed) == std::string::npos;
  }



  PreviousRun
  read_old_run(const fs::path &folder)
  {
    namespace property_tree = boost::property_tree;

    const std::size_t max_depth = 10;
    const std::string json      = read_bytes(folder / record_name);
    PreviousRun       previous_run;
    if (depth_of(json) > max_depth) // Boost's reader recurses
      return previous_run;
    try
      {
        property_tree::ptree record;
        std::istringstream   stream(json);
        property_tree::read_json(stream, record);
        previous_run.made_by_this_program =
          !record.empty() && record.front().first == "program" &&
          record.front().second.data() == program_name;
        if (const auto files = record.get_child_optional("files"))
          for (const auto &entry : *files)
            if (is_plain_name(entry.second.data()))
              previous_run.files.insert(entry.second.data());
      }
    catch (const property_tree::ptree_error &)
      {
        previous_run.made_by_this_program = false;
      }
    return previous_run;
  }



  bool
  is_empty_folder(const fs::path &folder)
  {
    return std::all_of(fs::directory_iterator(folder),
                       fs::directory_iterator(),
                       [](const fs::directory_entry &entry) {
                         return entry.path().filename() ==
                                "." + record_name + ".part";
                       });
  }
} // namespace RollingContact
