#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/written_names.h>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void refuse_to_resume(const fs::path    &folder,
                                       const std::string &reason)
    {
      throw InputError(fmt::format(
        "Cannot resume the run in \"{}\": {} Start it without --resume.",
        folder.string(),
        reason));
    }
  } // namespace

  fs::path RunFolder::default_path(const fs::path &prm_file)
  {
    return fs::path("output") / prm_file.stem();
  }

  RunFolder::RunFolder(const fs::path    &folder,
                       const std::string &original_prm,
                       const std::string &used_prm)
    : folder(folder)
    , original_prm(original_prm)
    , used_prm(used_prm)
    // until the run itself says more: no scene could be written
    , record("\"status\": \"failed\"")
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
    leave_on_stop("", "", "");
    unlock();
  }

  void RunFolder::open()
  {
    Ranks::on_root([&]() {
      take();
      // The mark comes first, with the old list: after a crash anywhere below
      // the next run knows what is left to remove.
      claim_old_files();
      write_run_json();
      remove_old_files();

      write_atomically("original.prm", original_prm);
      write_atomically("used.prm", used_prm);
    });
  }

  void RunFolder::reopen(const Resumption &resumption)
  {
    Ranks::on_root([&]() {
      check_place();
      if (!fs::is_directory(folder))
        refuse_to_resume(folder, "there is no such folder.");
      take();
      const fs::path used = final_path("used.prm");
      if (!has_checkpoint(folder, resumption.checkpoint) ||
          !fs::is_regular_file(used))
        refuse_to_resume(folder,
                         "it holds no checkpoint (no " + resumption.checkpoint +
                           ").");
      refuse_changed_entries(prm_entries(read_bytes(used)),
                             prm_entries(used_prm),
                             resumption.may_differ);
      if (resumption.check)
        resumption.check(folder);

      claim_old_files();
      adopt_old_files(resumption.growing_files);
      write_run_json();
      write_atomically("original.prm", original_prm);
      write_atomically("used.prm", used_prm);
    });
  }

  const fs::path &RunFolder::get_path() const
  {
    return folder;
  }

  fs::path RunFolder::temporary(const std::string &name)
  {
    begin({name});
    return temporary_path(name);
  }

  fs::path RunFolder::growing(const std::string &name)
  {
    growing_files.insert(name);
    return temporary(name);
  }

  fs::path RunFolder::continued(const std::string   &name,
                                const std::uintmax_t n_bytes)
  {
    const fs::path part = growing_path(name), whole = final_path(name);
    if (size_of(part) < n_bytes)
      {
        if (size_of(whole) < n_bytes)
          refuse_to_resume(
            folder,
            fmt::format("{} has less than the {} bytes it had at "
                        "the checkpoint.",
                        name,
                        n_bytes));
      }
    keep_first_bytes(size_of(part) < n_bytes ? whole : part, part, n_bytes);
    return growing(name);
  }

  void RunFolder::publish(const std::string &name)
  {
    if (!Ranks::is_root())
      return;
    rename_file(temporary_path(name), final_path(name));
    begun_files.erase(name);
    published_files.insert(name);
  }

  void RunFolder::write_atomically(const std::string &name,
                                   const std::string &text)
  {
    if (!Ranks::is_root())
      return;
    write_temporary(temporary(name), text, final_path(name));
    publish(name);
  }

  void RunFolder::write_durably(const std::string &name,
                                const std::string &text)
  {
    if (!Ranks::is_root())
      return;
    write_temporary(temporary(name), text, final_path(name));
    synchronise(temporary_path(name));
    publish(name);
    synchronise(folder);
  }

  void RunFolder::write_pieces(const std::vector<std::string> &names,
                               const std::string              &text)
  {
    Ranks::on_root([&]() { begin(names); });
    Ranks::on_all([&]() {
      const std::string &own = names.at(Ranks::rank());
      write_file(final_path(own), text, temporary_path(own));
    });
    for (const std::string &name : names)
      {
        begun_files.erase(name);
        published_files.insert(name);
      }
  }

  void RunFolder::claim_for_ranks(const std::string &name)
  {
    std::vector<std::string> names;
    for (unsigned int rank = 1; rank < Ranks::count(); ++rank)
      names.push_back(rank_file_name(name, rank));
    Ranks::on_root([&]() { begin(names); });
    // whoever writes them: they stay if the run ends before they are taken over
    for (const std::string &of_rank : names)
      {
        begun_files.erase(of_rank);
        published_files.insert(of_rank);
      }
  }

  void RunFolder::write_of_rank(const std::string &name,
                                const std::string &text)
  {
    write_file(final_path(name), text, temporary_path(name));
  }

  void RunFolder::remove_files_of_ranks(const std::string &name)
  {
    const std::set<std::string> claimed = claimed_files;
    for (const std::string &file : claimed)
      if (rank_of_file(name, file))
        forget(file);
    write_run_json();
  }

  void RunFolder::write_record(const std::string &members,
                               const std::string &members_if_stopped)
  {
    if (!Ranks::is_root())
      return;
    if (lock_descriptor < 0)
      throw std::logic_error("The run folder is not open.");
    record            = members;
    record_if_stopped = members_if_stopped;
    write_run_json();
  }

  std::vector<std::string> RunFolder::files() const
  {
    return {published_files.begin(), published_files.end()};
  }

  fs::path RunFolder::final_path(const std::string &name) const
  {
    return folder / name;
  }

  fs::path RunFolder::temporary_path(const std::string &name) const
  {
    return growing_files.count(name) > 0 ? growing_path(name)
                                         : folder / ("." + name + ".part");
  }

  fs::path RunFolder::growing_path(const std::string &name) const
  {
    return folder / (name + ".part");
  }

  void RunFolder::begin(const std::vector<std::string> &names)
  {
    if (lock_descriptor < 0)
      throw std::logic_error("The run folder is not open.");
    const std::size_t n_claimed = claimed_files.size();
    for (const std::string &name : names)
      {
        if (!is_written_name(name))
          throw std::logic_error("Not a name for a file of a run: " + name);
        if (!vouch_for(claimed_files, name))
          refuse_newcomers(name);
        begun_files.insert(name);
        claimed_files.insert(name);
      }
    if (claimed_files.size() != n_claimed)
      write_run_json();
  }

  void RunFolder::write_run_json() const
  {
    leave_on_stop(final_path(record_name),
                  temporary_path(record_name),
                  record_if_stopped.empty()
                    ? ""
                    : record_text(record_if_stopped, claimed_files));
    const std::string text = record_text(record, claimed_files);
    try
      {
        write_file(final_path(record_name), text, temporary_path(record_name));
      }
    catch (const InputError &)
      {
        // on a full disk the record says at least how the run ended
        if (!overwrite_file(final_path(record_name), text))
          throw;
      }
  }
} // namespace RollingContact
