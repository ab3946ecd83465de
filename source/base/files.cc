#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace RollingContact
{
  namespace fs = std::filesystem;

  void throw_write_error(const fs::path &file, const std::string &reason)
  {
    throw InputError("Cannot write \"" + file.string() + "\": " + reason +
                     ". Free some space or mend the permissions, or name "
                     "another folder with --output.");
  }

  std::string read_bytes(const fs::path &file)
  {
    std::ifstream      stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  std::string why_unreadable(const fs::path &file)
  {
    std::error_code       error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
      return "there is no such file";
    if (error)
      return error.message();
    if (fs::is_directory(status))
      return "it is a folder";
    if (!fs::is_regular_file(status))
      return "it is a pipe or a device, no regular file";
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
      return std::strerror(errno);
    close(descriptor);
    return "";
  }

  std::uintmax_t size_of(const fs::path &file)
  {
    std::error_code      error;
    const std::uintmax_t size = fs::file_size(file, error);
    return error ? 0 : size;
  }

  void synchronise(const fs::path &file_or_folder)
  {
    const int descriptor = ::open(file_or_folder.c_str(), O_RDONLY | O_CLOEXEC);
    // File systems that cannot do it for this kind of file say EINVAL.
    const bool done =
      descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL);
    const int reason = errno;
    if (descriptor >= 0)
      close(descriptor);
    if (!done)
      throw_write_error(file_or_folder, std::strerror(reason));
  }

  void rename_file(const fs::path &file, const fs::path &new_name)
  {
    std::error_code error;
    fs::rename(file, new_name, error);
    if (error)
      throw_write_error(new_name, error.message());
  }

  void write_file(const fs::path    &file,
                  const std::string &text,
                  const fs::path    &temporary)
  {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
      {
        const int       reason = errno;
        std::error_code ignored;
        fs::remove(temporary, ignored); // its space is needed
        throw_write_error(file, std::strerror(reason));
      }
    rename_file(temporary, file);
  }

  bool overwrite_file(const fs::path &file, const std::string &text)
  {
    const std::size_t block      = 512; // of st_blocks, whatever the disk's
    const int         descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0)
      return false;
    struct stat status;
    const bool  done =
      fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
      text.size() <= block * static_cast<std::size_t>(status.st_blocks) &&
      pwrite(descriptor, text.data(), text.size(), 0) ==
        static_cast<ssize_t>(text.size()) &&
      ftruncate(descriptor, static_cast<off_t>(text.size())) == 0;
    close(descriptor);
    return done;
  }

  void remove_file(const fs::path &file)
  {
    std::error_code     error;
    const fs::file_type type = fs::symlink_status(file, error).type();
    if (type == fs::file_type::regular || type == fs::file_type::symlink)
      if (!fs::remove(file, error) && error)
        throw_write_error(file, error.message());
  }

  fs::path nearest_existing(fs::path path)
  {
    std::error_code error;
    while (!fs::exists(path, error) && path != path.parent_path())
      path = path.parent_path();
    return path;
  }
} // namespace RollingContact
