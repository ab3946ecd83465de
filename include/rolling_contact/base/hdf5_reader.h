#ifndef rolling_contact_base_hdf5_reader_h
#define rolling_contact_base_hdf5_reader_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * An HDF5 file that is read array by array. Every function throws InputError
   * naming the file and the array if that is not there or of another kind. For
   * one thread at a time of all that use HDF5.
   */
  class Hdf5Reader
  {
  public:
    explicit Hdf5Reader(const std::filesystem::path &file);

    ~Hdf5Reader();

    Hdf5Reader(const Hdf5Reader &)            = delete;
    Hdf5Reader &operator=(const Hdf5Reader &) = delete;

    bool has(const std::string &path) const;

    /** The numbers of an array of any shape, the last dimension fastest. */
    std::vector<double> numbers(const std::string &path) const;

    /** Numbers of an array that must have n of them. Throws InputError. */
    std::vector<double> numbers(const std::string &path,
                                const std::size_t  n) const;

    /** Numbers of places in each dimension of an array. */
    std::vector<std::size_t> shape(const std::string &path) const;

    /** The number that an array has as an attribute. */
    double attribute(const std::string &path, const std::string &name) const;

    std::string text(const std::string &path) const;

  private:
    [[noreturn]] void reject(const std::string &path,
                             const std::string &reason) const;

    const std::filesystem::path path_of_file;
    std::int64_t                file;
  };
} // namespace RollingContact

#endif
