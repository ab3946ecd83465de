#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/run_folder.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string record_name  = "run.json";
    const std::string program_name = "rolling-contact";

    /** Names every run may leave, whether or not its list has them. */
    const std::set<std::string> fixed_names{"original.prm",
                                            "used.prm",
                                            "results.csv",
                                            "bodies.pvd",
                                            "interface.pvd"};

    struct OldRun
    {
      bool                  is_ours = false;
      std::set<std::string> files;
    };



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
              old_run.files.insert(entry.second.data());
        }
      catch (const property_tree::ptree_error &)
        {
          old_run.is_ours = false;
        }
      return old_run;
    }



    /** Whether a first run died before it could leave its mark, or nothing was
     * ever there. */
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



    [[noreturn]] void
    refuse(const fs::path &folder, const std::string &reason)
    {
      throw InputError("Cannot use \"" + folder.string() +
                       "\" as run folder: " + reason +
                       " Name another folder with --output.");
    }



    [[noreturn]] void
    throw_write_error(const fs::path &file, const std::string &reason)
    {
      throw InputError("Cannot write \"" + file.string() + "\": " + reason +
                       ". Free some space or mend the permissions, or name "
                       "another folder with --output.");
    }



    fs::path
    nearest_existing(fs::path path)
    {
      std::error_code error;
      while (!fs::exists(path, error) && path != path.parent_path())
        path = path.parent_path();
      return path;
    }



    /** Removes a file or a link; leaves folders alone. */
    void
    remove_file(const fs::path &file)
    {
      std::error_code     error;
      const fs::file_type type = fs::symlink_status(file, error).type();
      if (type == fs::file_type::regular || type == fs::file_type::symlink)
        if (!fs::remove(file, error) && error)
          throw_write_error(file, error.message());
    }
  } // namespace



  fs::path
  RunFolder::default_path(const fs::path &prm_file)
  {
    return fs::path("output") / prm_file.stem();
  }



  RunFolder::RunFolder(const fs::path    &folder,
                       const std::string &original_prm,
                       const std::string &used_prm)
    : folder(folder)
    , original_prm(original_prm)
    , used_prm(used_prm)
    , record("\"status\": \"running\"")
    , lock_descriptor(-1)
  {}



  RunFolder::~RunFolder()
  {
    if (lock_descriptor < 0)
      return;
    try
      {
        remove_unpublished_files();
      }
    catch (const std::exception &)
      {
        // The next run removes them, since run.json lists them.
      }
    close(lock_descriptor);
  }



  void
  RunFolder::check() const
  {
    if (folder.empty())
      refuse(folder, "its name is empty.");

    const fs::path absolute = fs::absolute(folder);
    const fs::path existing = nearest_existing(absolute);
    if (!fs::is_directory(existing))
      refuse(folder, '"' + existing.string() + "\" is a file.");
    if (access(existing.c_str(), R_OK | W_OK | X_OK) != 0)
      refuse(folder,
             "no permission to write in \"" + existing.string() + "\".");
    if (existing == absolute && !is_empty_folder(folder) &&
        !read_old_run(folder).is_ours)
      refuse(folder,
             "it holds files that this program did not write (no " +
               record_name + " of a former run), and they stay untouched.");
  }



  void
  RunFolder::open()
  {
    check();

    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      refuse(folder, "it cannot be created (" + error.message() + ").");
    lock();

    // The mark comes first, with the old list: after a crash anywhere below
    // the next run knows what is left to remove.
    for (const std::string &name : read_old_run(folder).files)
      if (is_plain_name(name))
        claimed_files.insert(name);
    claimed_files.insert(fixed_names.begin(), fixed_names.end());
    write_run_json();
    remove_old_files();

    write_atomically("original.prm", original_prm);
    write_atomically("used.prm", used_prm);
  }



  const fs::path &
  RunFolder::get_path() const
  {
    return folder;
  }



  fs::path
  RunFolder::temporary(const std::string &name)
  {
    if (lock_descriptor < 0)
      throw std::logic_error("The run folder is not open.");
    if (!is_plain_name(name) || name == record_name)
      throw std::logic_error("Not a name for a file of a run: " + name);

    if (claimed_files.insert(name).second)
      write_run_json();
    return temporary_path(name);
  }



  void
  RunFolder::publish(const std::string &name)
  {
    std::error_code error;
    fs::rename(temporary_path(name), final_path(name), error);
    if (error)
      throw_write_error(final_path(name), error.message());
    published_files.insert(name);
  }



  void
  RunFolder::write_atomically(const std::string &name, const std::string &text)
  {
    temporary(name);
    write_text(name, text);
    published_files.insert(name);
  }



  void
  RunFolder::write_record(const std::string &members)
  {
    if (lock_descriptor < 0)
      throw std::logic_error("The run folder is not open.");
    record = members;
    write_run_json();
  }



  std::vector<std::string>
  RunFolder::files() const
  {
    return {published_files.begin(), published_files.end()};
  }



  fs::path
  RunFolder::final_path(const std::string &name) const
  {
    return folder / name;
  }



  fs::path
  RunFolder::temporary_path(const std::string &name) const
  {
    return folder / ("." + name + ".part");
  }



  void
  RunFolder::lock()
  {
    lock_descriptor =
      ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_descriptor < 0)
      refuse(folder, std::string(std::strerror(errno)) + '.');
    // File systems without locks are used without one.
    if (flock(lock_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      {
        close(lock_descriptor);
        lock_descriptor = -1;
        refuse(folder, "another run is writing to it.");
      }
  }



  void
  RunFolder::write_text(const std::string &name, const std::string &text) const
  {
    errno = 0;
    std::ofstream file(temporary_path(name), std::ios::binary);
    file << text;
    file.close();
    if (!file)
      throw_write_error(final_path(name), std::strerror(errno));

    std::error_code error;
    fs::rename(temporary_path(name), final_path(name), error);
    if (error)
      throw_write_error(final_path(name), error.message());
  }



  void
  RunFolder::write_run_json() const
  {
    std::string list;
    for (const std::string &name : claimed_files)
      list += (list.empty() ? "\n    \"" : ",\n    \"") + name + '"';

    write_text(record_name,
               "{\n  \"program\": \"" + program_name + "\",\n  " + record +
                 ",\n  \"files\": [" + list + "\n  ]\n}\n");
  }



  void
  RunFolder::remove_old_files()
  {
    for (const std::string &name : claimed_files)
      {
        remove_file(final_path(name));
        remove_file(temporary_path(name));
      }
    claimed_files.clear();
  }



  void
  RunFolder::remove_unpublished_files()
  {
    remove_file(temporary_path(record_name));
    for (const std::string &name : claimed_files)
      remove_file(temporary_path(name));
    if (claimed_files != published_files)
      {
        claimed_files = published_files;
        write_run_json();
      }
  }
} // namespace RollingContact
