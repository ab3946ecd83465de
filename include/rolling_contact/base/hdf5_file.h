#ifndef rolling_contact_base_hdf5_file_h
#define rolling_contact_base_hdf5_file_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * An HDF5 file that is made once, in memory: groups, arrays of numbers,
   * texts, and the axes of arrays as dimension scales, which readers of HDF5
   * and netCDF know. Every function throws MemoryError naming the file if it
   * does not fit into the memory. The same contents make the same bytes. For
   * one process, and one thread at a time of all that use HDF5.
   */
  class Hdf5File
  {
  public:
    /** How many values an array has along each of its dimensions, the last one
     * fastest. */
    using Shape = std::vector<std::size_t>;

    /** The @p file is for messages; nothing is written to it. */
    explicit Hdf5File(const std::filesystem::path &file);

    ~Hdf5File();

    Hdf5File(const Hdf5File &)            = delete;
    Hdf5File &operator=(const Hdf5File &) = delete;

    void make_group(const std::string &path);

    void write(const std::string         &path,
               const Shape               &shape,
               const std::vector<double> &values);

    void write(const std::string              &path,
               const Shape                    &shape,
               const std::vector<std::int8_t> &values);

    /** A text of any length, in UTF-8. */
    void write(const std::string &path, const std::string &text);

    /** An attribute of an array, or of the file, whose path is "/". */
    void set_attribute(const std::string &path,
                       const std::string &name,
                       const std::string &text);

    /** Give dimension @p d of an array the one-dimensional array @p axis as its
     * scale. */
    void attach_axis(const std::string &path,
                     const std::size_t  d,
                     const std::string &axis);

    /** What is to stand in the file, with all that was added so far. A library
     * that writes to a full disk itself crashes when the program ends. */
    std::string bytes() const;

  private:
    using Id = std::int64_t;

    void write_array(const std::string &path,
                     const Shape       &shape,
                     const Id           type,
                     const void        *values);

    /** Throws MemoryError unless it is the result of a success. */
    Id succeeded(const Id result) const;

    const std::filesystem::path path_of_file;
    Id                          file;
  };
} // namespace RollingContact

#endif
