#include <boost/crc.hpp>

#include <rolling_contact/fmu/stored_zip.h>

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace RollingContact::Fmu
{
  namespace
  {
    /** Numbers of a zip file, the least byte first. */
    void put(std::string &to, const std::uint32_t number, const int n_bytes)
    {
      for (int k = 0; k < n_bytes; ++k)
        to += static_cast<char>(number >> 8 * k & 0xff);
    }

    std::uint32_t size_of_part(const std::string &part)
    {
      if (part.size() > std::numeric_limits<std::uint32_t>::max())
        throw std::length_error("a zip file is beyond 4 GB");
      return static_cast<std::uint32_t>(part.size());
    }

    /**
     * What a header says of a file behind its signature, stored, of the first
     * day that there is.
     */
    std::string file_header(const std::string &name, const std::string &content)
    {
      boost::crc_32_type crc;
      crc.process_bytes(content.data(), content.size());
      std::string header;
      put(header, 10, 2); // version 1.0 unpacks it
      put(header, 0, 2);
      put(header, 0, 2); // stored
      put(header, 0, 2);
      put(header, 1 << 5 | 1, 2); // 1980-01-01
      put(header, crc.checksum(), 4);
      put(header, size_of_part(content), 4);
      put(header, size_of_part(content), 4);
      put(header, size_of_part(name), 2);
      put(header, 0, 2);
      return header;
    }
  } // namespace

  std::string
  stored_zip(const std::vector<std::pair<std::string, std::string>> &files)
  {
    const std::uint32_t of_file = 0x04034b50, of_entry = 0x02014b50,
                        of_end = 0x06054b50;
    std::string zip, directory;
    for (const auto &[name, content] : files)
      {
        const std::string   header = file_header(name, content);
        const std::uint32_t at     = size_of_part(zip);
        put(zip, of_file, 4);
        zip += header + name + content;
        put(directory, of_entry, 4);
        put(directory, 3 << 8 | 10, 2); // made by Unix
        directory += header;
        put(directory, 0, 2);
        put(directory, 0, 2);
        put(directory, 0, 2);
        // a regular file that all may read and, for the binary, execute
        put(directory, std::uint32_t(0100755) << 16, 4);
        put(directory, at, 4);
        directory += name;
      }
    const std::uint32_t at = size_of_part(zip);
    zip += directory;
    put(zip, of_end, 4);
    put(zip, 0, 4);
    put(zip, static_cast<std::uint32_t>(files.size()), 2);
    put(zip, static_cast<std::uint32_t>(files.size()), 2);
    put(zip, size_of_part(directory), 4);
    put(zip, at, 4);
    put(zip, 0, 2);
    size_of_part(zip);
    return zip;
  }
} // namespace RollingContact::Fmu
