#ifndef rolling_contact_run_written_names_h
#define rolling_contact_run_written_names_h

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Whether a run may write a file of this name: one of those that
   * doc/reference/output.md lists. RunFolder writes no others, and a run.json
   * that lists others is not believed: what has such a name was made by
   * somebody else. All of them are plain: no folder, no leading '.'.
   */
  bool is_written_name(const std::string &name);

  /**
   * The written name that an entry of a run folder belongs to: its own, or that
   * of a file that was not complete, `.NAME.part` or `NAME.part`; empty if it
   * is none of this program.
   */
  std::string written_name_of(const std::string &entry);

  /**
   * "results_rank_2.csv", in which rank 2 keeps its rows of results.csv until
   * the root has them.
   */
  std::string rank_file_name(const std::string &name, const unsigned int rank);

  /** The rank whose file of @p name this is; none if it is no such file. */
  std::optional<unsigned int> rank_of_file(const std::string &name,
                                           const std::string &file);

  /** The names of the files in a folder that ranks keep of @p name, by the
   * numbers of their ranks. */
  std::vector<std::string> files_of_ranks(const std::filesystem::path &folder,
                                          const std::string           &name);

  /** Whether a folder has a file @p name, or one that a rank keeps of it. */
  bool has_checkpoint(const std::filesystem::path &folder,
                      const std::string           &name);

  /**
   * Whether a run that left these files made that one too. Each is its own
   * witness, and a script of gnuplot that of the picture it draws, by hand too.
   */
  bool vouch_for(const std::set<std::string> &files, const std::string &name);
} // namespace RollingContact

#endif
