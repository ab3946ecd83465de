#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <rolling_contact/base/old_run.h>

#include <algorithm>

namespace RollingContact
{
  namespace fs = std::filesystem;

  bool
  is_plain_name(const std::string &name)
  {
    const std::string allowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    return !name.empty() && name.front() != '.' &&
           name.find_first_not_of(allowed) == std::string::npos;
  }



  OldRun
  read_old_run(const fs::path &folder)
  {
    namespace property_tree = boost::property_tree;

    OldRun old_run;
    try
      {
        property_tree::ptree record;
        property_tree::read_json((folder / record_name).string(), record);
        old_run.is_ours = !record.empty() &&
                          record.front().first == "program" &&
                          record.front().second.data() == program_name;
        if (const auto files = record.get_child_optional("files"))
          for (const auto &entry : *files)
            if (is_plain_name(entry.second.data()))
              old_run.files.insert(entry.second.data());
      }
    catch (const property_tree::ptree_error &)
      {
        old_run.is_ours = false;
      }
    return old_run;
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
