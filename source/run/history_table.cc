#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/ranks.h>
#include <rolling_contact/run/history_table.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    constexpr std::size_t buffer_size    = 65536;
    constexpr double      seconds_unseen = 0.5;

    std::string
    header_of(const std::vector<std::string> &columns)
    {
      std::string header;
      for (const std::string &column : columns)
        header += (header.empty() ? "" : ",") + column;
      return header + '\n';
    }



    bool
    begins_with(const std::filesystem::path &file, const std::string &header)
    {
      std::ifstream stream(file, std::ios::binary);
      std::string   begin(header.size(), '\0');
      stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
      return stream && begin == header;
    }



    bool
    ends_a_line(const std::filesystem::path &file)
    {
      std::ifstream stream(file, std::ios::binary);
      stream.seekg(-1, std::ios::end);
      return stream.get() == '\n';
    }
  } // namespace



  HistoryTable::HistoryTable(RunFolder                      &folder,
                             const std::string              &file_name,
                             const std::vector<std::string> &columns)
    : folder(folder)
    , file_name(file_name)
    , n_columns(columns.size())
    , buffer(header_of(columns))
    , position{0, buffer.size()}
    , descriptor(-1)
  {
    Ranks::on_root([&]() {
      const auto path = folder.growing(file_name);
      remove_file(path);
      open_at_end(path);
    });
  }



  HistoryTable::HistoryTable(RunFolder                      &folder,
                             const std::string              &file_name,
                             const std::vector<std::string> &columns,
                             const Position                 &position)
    : folder(folder)
    , file_name(file_name)
    , n_columns(columns.size())
    , position(position)
    , descriptor(-1)
  {
    Ranks::on_root([&]() {
      const auto path = folder.continued(file_name, position.n_bytes);
      if (!begins_with(path, header_of(columns)) || !ends_a_line(path))
        throw InputError("Cannot resume: \"" + path.string() +
                         "\" is not the table this version of the program "
                         "writes. Start the run without --resume.");
      open_at_end(path);
    });
  }



  HistoryTable::~HistoryTable()
  {
    if (descriptor < 0)
      return;
    try
      {
        publish();
      }
    catch (const std::exception &)
      {
        keep_what_is_there();
      }
  }



  void
  HistoryTable::keep_what_is_there()
  {
    if (descriptor >= 0)
      close(descriptor);
    descriptor = -1;
    try
      {
        if (position.n_bytes > buffer.size()) // a full disk may have no row
          folder.publish(file_name);
      }
    catch (const std::exception &)
      {
        // The rows of the last checkpoint are on the disk.
      }
  }



  void
  HistoryTable::add_row(const std::vector<double> &values)
  {
    if (!Ranks::is_root())
      return;
    if (values.size() != n_columns || descriptor < 0)
      throw std::logic_error(fmt::format(
        "A row of {} values for {} of {} columns, or after its end.",
        values.size(),
        file_name,
        n_columns));
    const std::size_t begin = buffer.size();
    for (std::size_t i = 0; i < n_columns; ++i)
      buffer += (i == 0 ? "" : ",") + significant(values[i], 9);
    buffer += '\n';
    ++position.n_rows;
    position.n_bytes += buffer.size() - begin;
    if (buffer.size() >= buffer_size ||
        since_last_write.seconds() > seconds_unseen)
      write_buffer();
  }



  HistoryTable::Position
  HistoryTable::flush()
  {
    if (!Ranks::is_root())
      return position;
    write_buffer();
    synchronise(folder.temporary(file_name));
    return position;
  }



  void
  HistoryTable::publish()
  {
    if (!Ranks::is_root())
      return;
    flush();
    close(descriptor);
    descriptor = -1;
    folder.publish(file_name);
  }



  void
  HistoryTable::open_at_end(const std::filesystem::path &path)
  {
    descriptor =
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0)
      throw_write_error(path, std::strerror(errno));
  }



  void
  HistoryTable::drop_half_a_row(const std::size_t n_written)
  {
    const std::size_t rows  = buffer.substr(0, n_written).rfind('\n') + 1;
    const std::size_t begin = position.n_bytes - buffer.size();
    if (ftruncate(descriptor, static_cast<off_t>(begin + rows)) == 0)
      buffer.erase(0, rows);
  }



  void
  HistoryTable::write_buffer()
  {
    since_last_write      = Stopwatch();
    std::size_t n_written = 0;
    while (n_written < buffer.size())
      {
        const auto n = ::write(descriptor,
                               buffer.data() + n_written,
                               buffer.size() - n_written);
        if (n > 0)
          n_written += n;
        else if (errno != EINTR)
          {
            const int reason = errno;
            drop_half_a_row(n_written);
            throw_write_error(folder.get_path() / file_name,
                              std::strerror(reason));
          }
      }
    buffer.clear();
  }
} // namespace RollingContact
