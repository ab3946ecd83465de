#ifndef rolling_contact_run_run_folder_h
#define rolling_contact_run_run_folder_h

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The folder of one run and the files in it. Creates nothing before open(),
   * and gives every file its final name only when it is complete. Owns run.json
   * as the mark of a folder this program made: it begins with the program's
   * name and ends with the list of files, so that the next run knows what it
   * may remove, even after a crash; what stands between comes from others
   * (RunReport). Only regular files of names that a run writes
   * (is_written_name()) are ever removed or replaced; a link, a folder or a
   * pipe of such a name, or a file that the list does not have, is refused.
   *
   * With several MPI ranks every one has this object, and the root does it all:
   * what is not marked otherwise does nothing on the other ranks, and errors
   * are the root's alone.
   *
   * A run that was interrupted or killed can be continued: reopen() in place of
   * open(). The lock is the kernel's and dies with the process that holds it.
   */
  class RunFolder
  {
  public:
    /**
     * Default folder of a scene: output/carter for prm/carter.prm.
     */
    static std::filesystem::path
    default_path(const std::filesystem::path &prm_file);

    /** The two texts become original.prm and used.prm. */
    RunFolder(const std::filesystem::path &folder,
              const std::string           &original_prm,
              const std::string           &used_prm);

    /** Removes what was begun and not published. */
    ~RunFolder();

    RunFolder(const RunFolder &)            = delete;
    RunFolder &operator=(const RunFolder &) = delete;

    /**
     * Creates the folder, or removes an old run's files from it, no others.
     * Throws InputError, and leaves the folder as it is, if it was not made by
     * this program, holds something else under a name that a run writes, cannot
     * be written to, or belongs to a run that is still going.
     * Collective: errors are thrown on all ranks.
     */
    void open();

    /** What of an old run may differ and what it left for the new one. */
    struct Resumption
    {
      /** Entries of used.prm, or sections as "Section/". */
      std::set<std::string> may_differ;
      /** Without this published file, or one that a rank wrote of it, there
       * is nothing to resume. */
      std::string checkpoint;
      /** Their temporary forms are kept for the new run to continue. */
      std::set<std::string> growing_files;
      /** Throws InputError if the run cannot be resumed after all. */
      std::function<void(const std::filesystem::path &folder)> check = {};
    };

    /**
     * Continues the run that is in the folder: its published files stay.
     * Throws InputError, and leaves the folder as it is, if this program did
     * not make it, it has no checkpoint, its used.prm differs from the scene
     * (naming the entry and both values), or its run is still going.
     * Collective: errors are thrown on all ranks.
     */
    void reopen(const Resumption &resumption);

    const std::filesystem::path &get_path() const;

    /**
     * Path to write the file `name` to; a temporary name in the same folder.
     * Names are those of is_written_name(). Only for the root.
     */
    std::filesystem::path temporary(const std::string &name);

    /**
     * As temporary(), for a file that grows while the run goes on and is to be
     * looked at meanwhile: its temporary name is `name.part`, not hidden.
     */
    std::filesystem::path growing(const std::string &name);

    /** Gives the finished temporary file its final name, replacing a file that
     * this run published under it in one step. Throws InputError if there is no
     * such file. */
    void publish(const std::string &name);

    /**
     * Like growing() for the growing file of the run that is continued: its
     * first n_bytes, from what a killed run left or from the published file,
     * which stays. Throws InputError if neither is that long. Only for the
     * root.
     */
    std::filesystem::path continued(const std::string   &name,
                                    const std::uintmax_t n_bytes);

    /**
     * As temporary() and publish() for a text; InputError if the disk is full.
     */
    void write_atomically(const std::string &name, const std::string &text);

    /**
     * As write_atomically(), and the file and its name outlive a loss of power.
     */
    void write_durably(const std::string &name, const std::string &text);

    /**
     * Like write_atomically() for a file in pieces: rank r writes its text to
     * names[r], as many names as ranks. Collective: errors are thrown on all
     * ranks.
     */
    void write_pieces(const std::vector<std::string> &names,
                      const std::string              &text);

    /**
     * Each rank but the root may write its rows of the file @p name to a file
     * of its own, rank_file_name(), by write_of_rank() and alone; the run that
     * follows finds them even if this one is killed. Collective: errors are
     * thrown on all ranks.
     */
    void claim_for_ranks(const std::string &name);

    /** Replaces the file of this rank in one step. Not collective. */
    void write_of_rank(const std::string &name, const std::string &text);

    /** Removes the files of all ranks, of any number of them. Only for the
     * root. */
    void remove_files_of_ranks(const std::string &name);

    /** Writes run.json; `members` are JSON members without the outer braces,
     * `members_if_stopped` those of the run.json that is left if the process is
     * ended at once, see leave_on_stop(); empty if the run is over. */
    void write_record(const std::string &members,
                      const std::string &members_if_stopped = "");

    /** The published files, sorted; run.json is not among them. */
    std::vector<std::string> files() const;

  private:
    std::filesystem::path final_path(const std::string &name) const;
    std::filesystem::path temporary_path(const std::string &name) const;
    std::filesystem::path growing_path(const std::string &name) const;

    void check_place() const;
    void refuse_foreign_files() const;
    void refuse_newcomers(const std::string &name) const;
    void take();
    void lock();
    void unlock();
    void begin(const std::vector<std::string> &names);
    void forget(const std::string &name);
    void write_run_json() const;
    void claim_old_files();
    void remove_old_files();
    void adopt_old_files(const std::set<std::string> &growing);
    void remove_unpublished_files();

    const std::filesystem::path folder;
    const std::string           original_prm;
    const std::string           used_prm;

    std::string           record, record_if_stopped;
    std::set<std::string> claimed_files; ///< as listed in run.json
    std::set<std::string> begun_files;   ///< temporary so far, by this run
    std::set<std::string> growing_files; ///< of these, see growing()
    std::set<std::string> published_files;
    /** File descriptor that holds the lock; -1 unless open. */
    int lock_descriptor;
  };
} // namespace RollingContact

#endif
