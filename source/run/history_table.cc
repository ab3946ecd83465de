#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/history_table.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    constexpr std::size_t buffer_size    = 65536;
    constexpr double      seconds_unseen = 0.5;

    std::string header_of(const std::vector<std::string> &columns)
    {
      std::string header;
      for (const std::string &column : columns)
        header += (header.empty() ? "" : ",") + column;
      return header + '\n';
    }

    bool begins_with(const std::filesystem::path &file,
                     const std::string           &header)
    {
      std::ifstream stream(file, std::ios::binary);
      std::string   begin(header.size(), '\0');
      stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
      return stream && begin == header;
    }

    bool ends_a_line(const std::filesystem::path &file)
    {
      std::ifstream stream(file, std::ios::binary);
      stream.seekg(-1, std::ios::end);
      return stream.get() == '\n';
    }
  } // namespace

  std::string numbers_of(const std::string &file_name)
  {
    return file_name.substr(0, file_name.rfind('.')) + ".bin";
  }

  HistoryTable::HistoryTable(RunFolder                      &folder,
                             const std::string              &file_name,
                             const std::vector<std::string> &columns,
                             const bool                      keeps_numbers)
    : folder(folder)
    , names(columns)
  {
    const std::string header = header_of(columns);
    streams.push_back({file_name, header, header.size()});
    if (keeps_numbers)
      streams.push_back({numbers_of(file_name), "", 0});
    Ranks::on_root([&]() {
      for (Stream &stream : streams)
        {
          const auto path = folder.growing(stream.name);
          close(create_file(path));
          open_at_end(path, stream);
        }
    });
  }

  HistoryTable::HistoryTable(RunFolder                      &folder,
                             const std::string              &file_name,
                             const std::vector<std::string> &columns,
                             const Position                 &position)
    : folder(folder)
    , names(columns)
    , n_rows(position.n_rows)
  {
    streams.push_back({file_name, "", position.n_bytes});
    streams.push_back({numbers_of(file_name), "", n_rows * row_bytes()});
    Ranks::on_root([&]() {
      const auto path = folder.continued(file_name, position.n_bytes);
      if (!begins_with(path, header_of(columns)) || !ends_a_line(path))
        throw InputError("Cannot resume: \"" + path.string() +
                         "\" is not the table this version of the program "
                         "writes. Start the run without --resume.");
      open_at_end(path, streams[0]);
      open_at_end(folder.continued(streams[1].name, streams[1].n_bytes),
                  streams[1]);
    });
  }

  HistoryTable::~HistoryTable()
  {
    if (is_published)
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

  void HistoryTable::keep_what_is_there()
  {
    for (Stream &stream : streams)
      {
        if (stream.descriptor >= 0)
          close(stream.descriptor);
        stream.descriptor = -1;
        try
          {
            if (stream.n_bytes > stream.buffer.size()) // a full disk may have
              folder.publish(stream.name);             // no row
          }
        catch (const std::exception &)
          {
            // The rows of the last checkpoint are on the disk.
          }
      }
  }

  void HistoryTable::add_row(const std::vector<double> &values)
  {
    if (!Ranks::is_root())
      {
        ++n_rows;
        return;
      }
    if (values.size() != names.size() || is_published)
      throw std::logic_error(fmt::format(
        "A row of {} values for {} of {} columns, or after its end.",
        values.size(),
        streams[0].name,
        names.size()));
    std::string row;
    for (const double value : values)
      row += (std::isnan(value) ? "" : significant(value, 9)) + ',';
    row.pop_back();
    streams[0].buffer += row + '\n';
    streams[0].n_bytes += row.size() + 1;
    if (streams.size() > 1)
      {
        streams[1].buffer.append(reinterpret_cast<const char *>(values.data()),
                                 row_bytes());
        streams[1].n_bytes += row_bytes();
      }
    ++n_rows;
    if (streams[0].buffer.size() >= buffer_size ||
        since_last_write.seconds() > seconds_unseen)
      write_buffers();
  }

  HistoryTable::Position HistoryTable::flush()
  {
    if (Ranks::is_root())
      {
        write_buffers();
        for (const Stream &stream : streams)
          synchronise(folder.temporary(stream.name));
      }
    return {n_rows, streams[0].n_bytes};
  }

  void HistoryTable::publish()
  {
    if (Ranks::is_root())
      {
        flush();
        for (Stream &stream : streams)
          {
            close(stream.descriptor);
            stream.descriptor = -1;
            folder.publish(stream.name);
          }
      }
    is_published = true;
  }

  HistoryColumns
  HistoryTable::columns(const std::vector<std::string> &wanted) const
  {
    HistoryColumns                                             result;
    std::vector<std::pair<std::size_t, std::vector<double> *>> places;
    for (const std::string &column : wanted)
      {
        std::vector<double> &values = result[column];
        const auto           at = std::find(names.begin(), names.end(), column);
        if (at != names.end())
          places.emplace_back(at - names.begin(), &values);
      }
    const std::string   name = streams.at(1).name;
    std::ifstream       file(folder.get_path() /
                         (is_published ? name : name + ".part"),
                       std::ios::binary);
    std::vector<double> row(names.size());
    while (file.read(reinterpret_cast<char *>(row.data()),
                     static_cast<std::streamsize>(row_bytes())))
      for (const auto &[k, values] : places)
        values->push_back(row[k]);
    return result;
  }

  void HistoryTable::open_at_end(const std::filesystem::path &path,
                                 Stream                      &stream)
  {
    stream.descriptor =
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
    if (stream.descriptor < 0)
      throw_write_error(path, std::strerror(errno));
  }

  void HistoryTable::drop_half_a_row(const std::size_t n_written,
                                     Stream           &stream)
  {
    const std::size_t begin = stream.n_bytes - stream.buffer.size(),
                      rows =
                        &stream == &streams[0]
                          ? stream.buffer.substr(0, n_written).rfind('\n') + 1
                          : n_written / row_bytes() * row_bytes();
    if (ftruncate(stream.descriptor, static_cast<off_t>(begin + rows)) == 0)
      stream.buffer.erase(0, rows);
  }

  void HistoryTable::write(Stream &stream)
  {
    std::size_t n_written = 0;
    while (n_written < stream.buffer.size())
      {
        const auto n = ::write(stream.descriptor,
                               stream.buffer.data() + n_written,
                               stream.buffer.size() - n_written);
        if (n > 0)
          n_written += n;
        else if (errno != EINTR)
          {
            const int reason = errno;
            drop_half_a_row(n_written, stream);
            throw_write_error(folder.get_path() / stream.name,
                              std::strerror(reason));
          }
      }
    stream.buffer.clear();
  }

  void HistoryTable::write_buffers()
  {
    since_last_write = Stopwatch();
    for (Stream &stream : streams)
      write(stream);
  }
} // namespace RollingContact
