#include <rolling_contact/base/files.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/written_names.h>

namespace RollingContact
{
  namespace fs = std::filesystem;

  void RunFolder::claim_old_files()
  {
    const std::set<std::string> listed = read_previous_run(folder).files;
    claimed_files                      = listed;
    for (const fs::directory_entry &entry : fs::directory_iterator(folder))
      {
        const std::string file = entry.path().filename().string();
        if (is_written_name(file) && vouch_for(listed, file))
          claimed_files.insert(file);
      }
  }

  void RunFolder::remove_old_files()
  {
    // First what reopen() insists on: half a run cannot be resumed.
    remove_file(final_path("used.prm"));
    for (const std::string &name : claimed_files)
      {
        remove_file(final_path(name));
        remove_file(temporary_path(name));
        remove_file(growing_path(name));
      }
    claimed_files.clear();
  }

  void RunFolder::adopt_old_files(const std::set<std::string> &growing)
  {
    const std::set<std::string> old_files = claimed_files;
    for (const std::string &name : old_files)
      {
        if (growing.count(name) == 0)
          remove_file(temporary_path(name));
        if (fs::is_regular_file(final_path(name)))
          published_files.insert(name);
        else if (growing.count(name) == 0)
          claimed_files.erase(name);
      }
  }

  void RunFolder::forget(const std::string &name)
  {
    remove_file(final_path(name));
    remove_file(temporary_path(name));
    begun_files.erase(name);
    published_files.erase(name);
    claimed_files.erase(name);
  }

  void RunFolder::remove_unpublished_files()
  {
    remove_file(temporary_path(record_name));
    const std::size_t n_claimed = claimed_files.size();
    for (const std::string &name : begun_files)
      {
        remove_file(temporary_path(name));
        if (published_files.count(name) == 0)
          claimed_files.erase(name);
      }
    if (claimed_files.size() != n_claimed)
      write_run_json();
  }
} // namespace RollingContact
