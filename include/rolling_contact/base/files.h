#ifndef rolling_contact_base_files_h
#define rolling_contact_base_files_h

#include <cstdint>
#include <filesystem>
#include <string>

namespace RollingContact
{
  /** Throws InputError: the file cannot be written, why, and what helps. */
  [[noreturn]] void throw_write_error(const std::filesystem::path &file,
                                      const std::string           &reason);

  /**
   * The whole content of a regular file; empty if it cannot be read.
   */
  std::string read_bytes(const std::filesystem::path &file);

  /**
   * Why a file cannot be read, "it is a folder", "there is no such file"; empty
   * if it is a regular file that opens. Pipes and devices are refused without
   * opening them, which may wait without end.
   */
  std::string why_unreadable(const std::filesystem::path &file);

  /**
   * Size of a file in bytes; 0 if there is no such file.
   */
  std::uintmax_t size_of(const std::filesystem::path &file);

  /** Returns when what was written to the file, or the names in the folder,
   * are on the disk. Throws InputError. */
  void synchronise(const std::filesystem::path &file_or_folder);

  /**
   * What has this name and is no regular file, "a symbolic link", "a folder";
   * empty if it is a regular file or nothing is there.
   */
  std::string kind_unless_regular(const std::filesystem::path &file);

  /**
   * Opens a new file to write to and returns its descriptor. A regular file of
   * that name is removed first, never written to: another name of it may be
   * somebody else's. Links are not followed. Throws InputError if something
   * else stands there or the file cannot be made.
   */
  int create_file(const std::filesystem::path &file);

  /**
   * Writes all of a text to a descriptor and closes it; 0, or the error number.
   */
  int write_and_close(const int descriptor, const std::string &text);

  /**
   * Cuts a regular file to its first n_bytes, copied from the other path unless
   * they are one. A file with a second name is copied as well, and that one
   * stays whole. Throws InputError.
   */
  void keep_first_bytes(const std::filesystem::path &from,
                        const std::filesystem::path &file,
                        const std::uintmax_t         n_bytes);

  /**
   * Renames a file, replacing any regular file of the new name in one step.
   * Throws InputError, also if something else has the new name.
   */
  void rename_file(const std::filesystem::path &file,
                   const std::filesystem::path &new_name);

  /**
   * Writes a text to a new file, see create_file(), which is removed again if
   * the disk is full. Throws InputError, naming the file it is to become.
   */
  void write_temporary(const std::filesystem::path &temporary,
                       const std::string           &text,
                       const std::filesystem::path &file);

  /**
   * As write_temporary(), and renames it to the file it is to become.
   */
  void write_file(const std::filesystem::path &file,
                  const std::string           &text,
                  const std::filesystem::path &temporary);

  /**
   * Writes a text over a small file in place, without a temporary one, if it
   * fits in the blocks that the file has: there may be none left. False if it
   * does not fit, has another name too or is not possible. A crash within
   * leaves a mixture.
   */
  bool overwrite_file(const std::filesystem::path &file,
                      const std::string           &text);

  /** Removes a regular file and leaves all else alone. Throws InputError. */
  void remove_file(const std::filesystem::path &file);

  /** The path itself or the nearest folder above it that exists. */
  std::filesystem::path nearest_existing(std::filesystem::path path);
} // namespace RollingContact

#endif
