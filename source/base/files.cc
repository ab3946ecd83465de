#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

namespace RollingContact
{
  namespace fs = std::filesystem;

  void throw_write_error(const fs::path &file, const std::string &reason)
  {
    throw InputError("Cannot write \"" + file.string() + "\": " + reason +
                     ". Free some space or mend the permissions, or name "
                     "another folder with --output.");
  }

  namespace
  {
    /** Opens a regular file and waits for no other end of a pipe; -1 if it is
     * none or cannot be opened. */
    int open_regular(const fs::path &file, const int flags)
    {
      const int descriptor =
        ::open(file.c_str(), flags | O_NONBLOCK | O_CLOEXEC);
      struct stat status;
      if (descriptor < 0 ||
          (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)))
        return descriptor;
      close(descriptor);
      errno = EINVAL;
      return -1;
    }

    /** Whether other names stand for the same file. */
    bool has_other_names(const int descriptor)
    {
      struct stat status;
      return fstat(descriptor, &status) != 0 || status.st_nlink > 1;
    }

    /** 0, or the error number. */
    int write_all(const int descriptor, const char *bytes, std::size_t n_bytes)
    {
      while (n_bytes > 0)
        {
          const auto n = ::write(descriptor, bytes, n_bytes);
          if (n > 0)
            {
              bytes += n;
              n_bytes -= n;
            }
          else if (errno != EINTR)
            return errno;
        }
      return 0;
    }

    /** Hands on pieces of what is in a file, at most so many bytes, as long as
     * they are taken. 0, or the error number. */
    template <typename Take>
    int read_pieces(const int descriptor, std::uintmax_t most, const Take &take)
    {
      char piece[65536];
      while (most > 0)
        {
          const auto n = ::read(descriptor,
                                piece,
                                std::min<std::uintmax_t>(most, sizeof(piece)));
          if (n == 0)
            return 0;
          if (n < 0 && errno != EINTR)
            return errno;
          if (n > 0)
            if (const int error = take(piece, n))
              return error;
          most -= std::max<std::intmax_t>(n, 0);
        }
      return 0;
    }
  } // namespace

  std::string read_bytes(const fs::path &file)
  {
    std::string text;
    const int   descriptor = open_regular(file, O_RDONLY);
    if (descriptor < 0)
      return text;
    read_pieces(descriptor,
                std::numeric_limits<std::uintmax_t>::max(),
                [&](const char *piece, const std::size_t n) {
                  text.append(piece, n);
                  return 0;
                });
    close(descriptor);
    return text;
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
    const int descriptor = open_regular(file, O_RDONLY);
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

  std::string kind_unless_regular(const fs::path &file)
  {
    std::error_code error;
    switch (fs::symlink_status(file, error).type())
      {
        case fs::file_type::none:
        case fs::file_type::not_found:
        case fs::file_type::regular:
          return "";
        case fs::file_type::symlink:
          return "a symbolic link";
        case fs::file_type::directory:
          return "a folder";
        default:
          return "a pipe, a socket or a device";
      }
  }

  namespace
  {
    void refuse_to_replace(const fs::path &file)
    {
      const std::string what = kind_unless_regular(file);
      if (!what.empty())
        throw InputError("Cannot write \"" + file.string() + "\": it is " +
                         what +
                         ", no regular file, and stays untouched. Move it "
                         "away, or name another folder with --output.");
    }
  } // namespace

  int create_file(const fs::path &file)
  {
    // several: a run that is ended at once may write its last words meanwhile
    for (unsigned int attempt = 0; attempt < 10; ++attempt)
      {
        remove_file(file);
        refuse_to_replace(file);
        const int descriptor =
          ::open(file.c_str(),
                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                 0666);
        if (descriptor >= 0)
          return descriptor;
        if (errno != EEXIST)
          break;
      }
    throw_write_error(file, std::strerror(errno));
  }

  int write_and_close(const int descriptor, const std::string &text)
  {
    const int error = write_all(descriptor, text.data(), text.size());
    return close(descriptor) == 0 || error != 0 ? error : errno;
  }

  void keep_first_bytes(const fs::path      &from,
                        const fs::path      &file,
                        const std::uintmax_t n_bytes)
  {
    const int source =
      open_regular(from, (from == file ? O_RDWR : O_RDONLY) | O_NOFOLLOW);
    if (source < 0)
      throw_write_error(file, std::strerror(errno));
    int error = 0;
    if (from == file && !has_other_names(source))
      error = ftruncate(source, static_cast<off_t>(n_bytes)) == 0 ? 0 : errno;
    else
      {
        const int copy = create_file(file);
        error          = read_pieces(source, n_bytes, [&](auto piece, auto n) {
          return write_all(copy, piece, n);
        });
        close(copy);
      }
    close(source);
    if (error != 0)
      throw_write_error(file, std::strerror(error));
  }

  void rename_file(const fs::path &file, const fs::path &new_name)
  {
    refuse_to_replace(new_name);
    std::error_code error;
    fs::rename(file, new_name, error);
    if (error)
      throw_write_error(new_name, error.message());
  }

  void write_temporary(const fs::path    &temporary,
                       const std::string &text,
                       const fs::path    &file)
  {
    if (const int error = write_and_close(create_file(temporary), text))
      {
        unlink(temporary.c_str()); // its space is needed
        throw_write_error(file, std::strerror(error));
      }
  }

  void write_file(const fs::path    &file,
                  const std::string &text,
                  const fs::path    &temporary)
  {
    write_temporary(temporary, text, file);
    rename_file(temporary, file);
  }

  bool overwrite_file(const fs::path &file, const std::string &text)
  {
    const std::size_t block      = 512; // of st_blocks, whatever the disk's
    const int         descriptor = open_regular(file, O_WRONLY | O_NOFOLLOW);
    if (descriptor < 0)
      return false;
    struct stat status;
    const bool  done =
      fstat(descriptor, &status) == 0 && status.st_nlink == 1 &&
      text.size() <= block * static_cast<std::size_t>(status.st_blocks) &&
      pwrite(descriptor, text.data(), text.size(), 0) ==
        static_cast<ssize_t>(text.size()) &&
      ftruncate(descriptor, static_cast<off_t>(text.size())) == 0;
    close(descriptor);
    return done;
  }

  void remove_file(const fs::path &file)
  {
    std::error_code error;
    if (fs::symlink_status(file, error).type() == fs::file_type::regular)
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
