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
   * The whole content of a file; empty if it cannot be read.
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
   * Renames a file, replacing any of the new name in one step. Throws
   * InputError.
   */
  void rename_file(const std::filesystem::path &file,
                   const std::filesystem::path &new_name);

  /**
   * Writes a text under a temporary name in the same folder, which becomes the
   * file's own when it is complete. Throws InputError if the disk is full.
   */
  void write_file(const std::filesystem::path &file,
                  const std::string           &text,
                  const std::filesystem::path &temporary);

  /**
   * Writes a text over a small file in place, without a temporary one, if it
   * fits in the blocks that the file has: there may be none left. False if it
   * does not fit or is not possible. A crash within leaves a mixture.
   */
  bool overwrite_file(const std::filesystem::path &file,
                      const std::string           &text);

  /** Removes a file or a link; leaves folders alone. Throws InputError. */
  void remove_file(const std::filesystem::path &file);

  /** The path itself or the nearest folder above it that exists. */
  std::filesystem::path nearest_existing(std::filesystem::path path);
} // namespace RollingContact

#endif
