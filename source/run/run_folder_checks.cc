#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/written_names.h>

#include <cerrno>
#include <cstring>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void
    refuse(const fs::path    &folder,
           const std::string &reason,
           const std::string &cure = "Name another folder with --output.")
    {
      throw InputError(fmt::format("Cannot use \"{}\" as run folder: {} {}",
                                   folder.string(),
                                   reason,
                                   cure));
    }

    /** What is no regular file is never replaced. */
    void require_regular(const fs::path &folder, const std::string &file)
    {
      const std::string what = kind_unless_regular(folder / file);
      if (!what.empty())
        refuse(folder,
               file + " in it is " + what +
                 ", no regular file, and stays untouched.",
               "Move it away, or name another folder with --output.");
    }
  } // namespace

  void RunFolder::check_place() const
  {
    if (folder.empty())
      refuse(folder, "its name is empty.");

    const fs::path existing = nearest_existing(fs::absolute(folder));
    if (!fs::is_directory(existing))
      refuse(folder, '"' + existing.string() + "\" is a file.");
    if (access(existing.c_str(), R_OK | W_OK | X_OK) != 0)
      refuse(folder,
             "no permission to write in \"" + existing.string() + "\".");
  }

  void RunFolder::refuse_foreign_files() const
  {
    require_regular(folder, record_name);
    require_regular(folder, '.' + record_name + ".part");
    if (is_empty_folder(folder))
      return;
    const PreviousRun previous = read_previous_run(folder);
    if (!previous.made_by_this_program)
      refuse(folder,
             "it holds files that this program did not write (no " +
               record_name + " of a former run), and they stay untouched.");
    for (const fs::directory_entry &entry : fs::directory_iterator(folder))
      {
        const std::string file = entry.path().filename().string(),
                          name = written_name_of(file);
        if (name.empty())
          continue;
        require_regular(folder, file);
        if (name != record_name && !vouch_for(previous.files, name))
          refuse(folder,
                 fmt::format("the former run did not write {} in it, says {}, "
                             "and it stays untouched.",
                             file,
                             record_name),
                 "Move it away, or name another folder with --output.");
      }
  }

  void RunFolder::take()
  {
    check_place();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      refuse(folder, "it cannot be created (" + error.message() + ").");
    lock();
    try
      {
        refuse_foreign_files();
      }
    catch (...)
      {
        unlock();
        throw;
      }
  }

  void RunFolder::lock()
  {
    lock_descriptor =
      ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_descriptor < 0)
      refuse(folder, std::string(std::strerror(errno)) + '.');
    // File systems without locks are used without one.
    if (flock(lock_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      {
        unlock();
        refuse(folder, "another run is writing to it.");
      }
  }

  void RunFolder::unlock()
  {
    close(lock_descriptor);
    lock_descriptor = -1;
  }

  void RunFolder::refuse_newcomers(const std::string &name) const
  {
    for (const fs::path &file : {final_path(name), temporary_path(name)})
      if (fs::exists(fs::symlink_status(file)))
        throw InputError("Cannot write \"" + file.string() +
                         "\": a file of that name, not of this run, came while "
                         "it went on, and stays untouched. Move it away.");
  }
} // namespace RollingContact
