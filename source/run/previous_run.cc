#include <nlohmann/json.hpp>

#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/written_names.h>

#include <algorithm>

namespace RollingContact
{
  namespace fs = std::filesystem;

  using Json = nlohmann::ordered_json;

  namespace
  {
    /** In one line; numbers that are no integers with 9 significant digits. */
    std::string line_of(const Json &value)
    {
      if (value.is_number_float())
        return significant(value.get<double>(), 9);
      if (!value.is_structured())
        return value.dump(-1, ' ', false, Json::error_handler_t::replace);
      std::string text;
      for (const auto &[key, element] : value.items())
        text += (text.empty() ? "" : ", ") +
                (value.is_object() ? line_of(key) + ": " : std::string()) +
                line_of(element);
      return value.is_object() ? '{' + text + '}' : '[' + text + ']';
    }

    /** An array with one element a line, to be read with grep and diff. */
    std::string lines_of(const Json &value)
    {
      if (!value.is_array() || value.empty())
        return line_of(value);
      std::string text;
      for (const Json &element : value)
        text += (text.empty() ? "[\n    " : ",\n    ") + line_of(element);
      return text + "\n  ]";
    }
  } // namespace

  std::string record_text(const std::string           &members,
                          const std::set<std::string> &files)
  {
    Json record;
    record["program"] = program_name;
    record.update(Json::parse('{' + members + '}'));
    record["files"] = files;

    std::string text;
    for (const auto &[key, value] : record.items())
      text += (text.empty() ? "{\n  " : ",\n  ") + line_of(key) + ": " +
              lines_of(value);
    return text + "\n}\n";
  }

  PreviousRun read_previous_run(const fs::path &folder)
  {
    const int  max_depth = 10;
    bool       too_deep  = false;
    const auto guard     = [&](const int depth, auto, const Json &) {
      too_deep = too_deep || depth > max_depth;
      return !too_deep;
    };
    const Json record =
      Json::parse(read_bytes(folder / record_name), guard, false);

    PreviousRun previous_run;
    if (too_deep || !record.is_object() || record.empty())
      return previous_run;
    previous_run.made_by_this_program =
      record.begin().key() == "program" && *record.begin() == program_name;
    const Json files = record.value("files", Json());
    if (files.is_array())
      for (const Json &file : files)
        if (file.is_string() && is_written_name(file.get<std::string>()))
          previous_run.files.insert(file.get<std::string>());
    return previous_run;
  }

  bool is_empty_folder(const fs::path &folder)
  {
    return std::all_of(fs::directory_iterator(folder),
                       fs::directory_iterator(),
                       [](const fs::directory_entry &entry) {
                         return entry.path().filename() ==
                                "." + record_name + ".part";
                       });
  }
} // namespace RollingContact
