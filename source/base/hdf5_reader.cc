#include <hdf5.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/hdf5_reader.h>

#include <algorithm>
#include <memory>

namespace RollingContact
{
  namespace
  {
    /** What HDF5 opened, closed by the function of its kind. */
    struct Opened
    {
      Opened(const hid_t id, herr_t (*close)(hid_t))
        : id(id)
        , close(close)
      {}

      ~Opened()
      {
        if (id >= 0)
          close(id);
      }

      Opened(const Opened &)            = delete;
      Opened &operator=(const Opened &) = delete;

      const hid_t id;
      herr_t (*const close)(hid_t);
    };
  } // namespace

  Hdf5Reader::Hdf5Reader(const std::filesystem::path &file)
    : path_of_file(file)
  {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it is said by exceptions
    this->file = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (this->file < 0)
      throw InputError("\"" + file.string() + "\" is no file of HDF5.");
  }

  Hdf5Reader::~Hdf5Reader()
  {
    H5Fclose(file);
  }

  void Hdf5Reader::reject(const std::string &path,
                          const std::string &reason) const
  {
    throw InputError("\"" + path_of_file.string() + "\": " + path + ": " +
                     reason + ".");
  }

  bool Hdf5Reader::has(const std::string &path) const
  {
    const std::string group = path.substr(0, path.rfind('/'));
    return (group.empty() || H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0) &&
           H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
  }

  std::vector<double> Hdf5Reader::numbers(const std::string &path) const
  {
    const Opened array(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose);
    if (array.id < 0)
      reject(path, "there is no such array");
    const Opened        space(H5Dget_space(array.id), &H5Sclose);
    const auto          n = H5Sget_simple_extent_npoints(space.id);
    std::vector<double> values(n < 0 ? 0 : n);
    if (n < 0 || H5Dread(array.id,
                         H5T_NATIVE_DOUBLE,
                         H5S_ALL,
                         H5S_ALL,
                         H5P_DEFAULT,
                         values.data()) < 0)
      reject(path, "these are not numbers");
    return values;
  }

  std::vector<double> Hdf5Reader::numbers(const std::string &path,
                                          const std::size_t  n) const
  {
    std::vector<double> values = numbers(path);
    if (values.size() != n)
      reject(path,
             "it has " + std::to_string(values.size()) + " numbers, not " +
               std::to_string(n));
    return values;
  }

  std::vector<std::size_t> Hdf5Reader::shape(const std::string &path) const
  {
    const Opened array(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose);
    if (array.id < 0)
      reject(path, "there is no such array");
    const Opened         space(H5Dget_space(array.id), &H5Sclose);
    const int            n = H5Sget_simple_extent_ndims(space.id);
    std::vector<hsize_t> sizes(std::max(0, n));
    H5Sget_simple_extent_dims(space.id, sizes.data(), nullptr);
    return {sizes.begin(), sizes.end()};
  }

  double Hdf5Reader::attribute(const std::string &path,
                               const std::string &name) const
  {
    const Opened array(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose);
    if (array.id < 0)
      reject(path, "there is no such array");
    const Opened attribute(H5Aopen(array.id, name.c_str(), H5P_DEFAULT),
                           &H5Aclose);
    if (attribute.id < 0)
      reject(path, "it has no attribute " + name);
    const Opened space(H5Aget_space(attribute.id), &H5Sclose);
    double       value = 0.;
    if (H5Sget_simple_extent_npoints(space.id) != 1 ||
        H5Aread(attribute.id, H5T_NATIVE_DOUBLE, &value) < 0)
      reject(path, "the attribute " + name + " is not a number");
    return value;
  }

  std::string Hdf5Reader::text(const std::string &path) const
  {
    const Opened array(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose),
      type(H5Tcopy(H5T_C_S1), &H5Tclose);
    H5Tset_size(type.id, H5T_VARIABLE);
    H5Tset_cset(type.id, H5T_CSET_UTF8);
    char *found = nullptr;
    if (array.id < 0 ||
        H5Dread(array.id, type.id, H5S_ALL, H5S_ALL, H5P_DEFAULT, &found) < 0)
      reject(path, "there is no such text");
    const std::unique_ptr<char, decltype(&H5free_memory)> owned(found,
                                                                &H5free_memory);
    return found;
  }
} // namespace RollingContact
