#include <hdf5.h>
#include <hdf5_hl.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/hdf5_file.h>

#include <type_traits>

namespace RollingContact
{
  static_assert(std::is_same_v<hid_t, std::int64_t>, "HDF5 1.10 or later");

  namespace
  {
    /**
     * What HDF5 opened, to be closed whatever happens.
     */
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t))
        : id(id)
        , close(close)
      {}

      ~Handle()
      {
        if (id >= 0)
          close(id);
      }

      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id;
      }

    private:
      const hid_t id;
      herr_t (*const close)(hid_t);
    };

    /// by which the file grows in memory, bytes
    const std::size_t memory_step = std::size_t(1) << 20;

    /**
     * A type for texts of any length, which readers take for such.
     */
    hid_t text_type()
    {
      const hid_t type = H5Tcopy(H5T_C_S1);
      H5Tset_size(type, H5T_VARIABLE);
      H5Tset_cset(type, H5T_CSET_UTF8);
      return type;
    }
  } // namespace

  Hdf5File::Hdf5File(const std::filesystem::path &path)
    : path_of_file(path)
    , file(-1)
  {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it is said by exceptions
    const Handle in_memory(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    succeeded(H5Pset_fapl_core(in_memory, memory_step, false));
    file =
      succeeded(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory));
  }

  Hdf5File::~Hdf5File()
  {
    if (file >= 0)
      H5Fclose(file);
  }

  Hdf5File::Id Hdf5File::succeeded(const Id result) const
  {
    if (result < 0)
      throw MemoryError("Cannot make \"" + path_of_file.string() +
                        "\": HDF5 has not enough memory for it. Take a table "
                        "of fewer states.");
    return result;
  }

  void Hdf5File::make_group(const std::string &path)
  {
    const Handle group(
      H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      &H5Gclose);
    succeeded(group);
  }

  void Hdf5File::write_array(const std::string &path,
                             const Shape       &shape,
                             const Id           type,
                             const void        *values)
  {
    const std::vector<hsize_t> sizes(shape.begin(), shape.end());
    const Handle               space(shape.empty() ? H5Screate(H5S_SCALAR)
                                     : H5Screate_simple(sizes.size(),
                                                        sizes.data(),
                                                        nullptr),
                       &H5Sclose);
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
    H5Pset_obj_track_times(properties, false);
    const Handle array(
      H5Dcreate2(
        file, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
      &H5Dclose);
    succeeded(array);
    succeeded(H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  }

  void Hdf5File::write(const std::string         &path,
                       const Shape               &shape,
                       const std::vector<double> &values)
  {
    write_array(path, shape, H5T_NATIVE_DOUBLE, values.data());
  }

  void Hdf5File::write(const std::string              &path,
                       const Shape                    &shape,
                       const std::vector<std::int8_t> &values)
  {
    write_array(path, shape, H5T_NATIVE_INT8, values.data());
  }

  void Hdf5File::write(const std::string &path, const std::string &text)
  {
    const Handle type(text_type(), &H5Tclose);
    const char  *begin = text.c_str();
    write_array(path, {}, type, &begin);
  }

  void Hdf5File::set_attribute(const std::string &path,
                               const std::string &name,
                               const std::string &text)
  {
    const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), &H5Oclose),
      type(text_type(), &H5Tclose), space(H5Screate(H5S_SCALAR), &H5Sclose);
    succeeded(object);
    const Handle attribute(
      H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
      &H5Aclose);
    succeeded(attribute);
    const char *begin = text.c_str();
    succeeded(H5Awrite(attribute, type, &begin));
  }

  void Hdf5File::attach_axis(const std::string &path,
                             const std::size_t  d,
                             const std::string &axis)
  {
    const Handle array(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose),
      scale(H5Dopen2(file, axis.c_str(), H5P_DEFAULT), &H5Dclose);
    succeeded(array);
    succeeded(scale);
    const std::string name = axis.substr(axis.rfind('/') + 1);
    if (H5DSis_scale(scale) <= 0)
      succeeded(H5DSset_scale(scale, name.c_str()));
    succeeded(H5DSattach_scale(array, scale, d));
    succeeded(H5DSset_label(array, d, name.c_str()));
  }

  std::string Hdf5File::bytes() const
  {
    succeeded(H5Fflush(file, H5F_SCOPE_LOCAL));
    std::string image(succeeded(H5Fget_file_image(file, nullptr, 0)), '\0');
    succeeded(H5Fget_file_image(file, image.data(), image.size()));
    return image;
  }
} // namespace RollingContact
