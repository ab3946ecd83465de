#ifndef rolling_contact_base_run_folder_h
#define rolling_contact_base_run_folder_h

#include <filesystem>
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
   * (RunReport). Belongs to the first MPI rank.
   */
  class RunFolder
  {
  public:
    /** output/carter for prm/carter.prm. */
    static std::filesystem::path
    default_path(const std::filesystem::path &prm_file);

    /** The two texts become original.prm and used.prm. */
    RunFolder(const std::filesystem::path &folder,
              const std::string           &original_prm,
              const std::string           &used_prm);

    /** Removes what was begun and not published. */
    ~RunFolder();

    RunFolder(const RunFolder &) = delete;
    RunFolder &
    operator=(const RunFolder &) = delete;

    /** Throws InputError if open() would refuse; changes nothing. */
    void
    check() const;

    /**
     * Creates the folder, or removes an old run's files from it, no others.
     * Throws InputError, and leaves the folder as it is, if it holds something
     * else, cannot be written to, or belongs to a run that is still going.
     */
    void
    open();

    const std::filesystem::path &
    get_path() const;

    /** Where to write the file `name`; a temporary name in the same folder.
     * Names are plain: letters, digits, '.', '_', '-', no leading '.'. */
    std::filesystem::path
    temporary(const std::string &name);

    /** Gives the finished temporary file its final name, replacing any file
     * of that name in one step. Throws InputError if there is no such file. */
    void
    publish(const std::string &name);

    /** temporary() and publish() for a text; InputError if the disk is full. */
    void
    write_atomically(const std::string &name, const std::string &text);

    /** Writes run.json; `members` are JSON members without the outer braces. */
    void
    write_record(const std::string &members);

    /** The published files, sorted; run.json is not among them. */
    std::vector<std::string>
    files() const;

  private:
    std::filesystem::path
    final_path(const std::string &name) const;
    std::filesystem::path
    temporary_path(const std::string &name) const;

    void
    lock();
    void
    write_text(const std::string &name, const std::string &text) const;
    void
    write_run_json() const;
    void
    remove_old_files();
    void
    remove_unpublished_files();

    const std::filesystem::path folder;
    const std::string           original_prm;
    const std::string           used_prm;

    std::string           record;
    std::set<std::string> claimed_files;
    std::set<std::string> published_files;
    /** File descriptor that holds the lock; -1 unless open. */
    int lock_descriptor;
  };
} // namespace RollingContact

#endif
