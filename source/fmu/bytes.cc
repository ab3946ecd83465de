#include <rolling_contact/fmu/bytes.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace RollingContact::Fmu
{
  void BytesOut::add(const double number)
  {
    bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
  }

  void BytesOut::add(const std::string &text)
  {
    add(static_cast<double>(text.size()));
    bytes += text;
  }

  double BytesIn::number()
  {
    double value = 0.;
    if (bytes.size() - place < sizeof(value))
      throw std::invalid_argument("the bytes end too early");
    std::memcpy(&value, bytes.data() + place, sizeof(value));
    place += sizeof(value);
    return value;
  }

  std::size_t BytesIn::size(const std::size_t most)
  {
    const double value = number();
    if (!(value >= 0. && value <= static_cast<double>(most) &&
          value == std::floor(value)))
      throw std::invalid_argument("a size is not a whole number that fits");
    return static_cast<std::size_t>(value);
  }

  std::string BytesIn::text()
  {
    const std::size_t length = size(bytes.size());
    if (bytes.size() - place < length)
      throw std::invalid_argument("the bytes end too early");
    place += length;
    return bytes.substr(place - length, length);
  }

  double check_sum(const std::string &bytes)
  {
    std::uint64_t sum = 14695981039346656037u;
    for (const unsigned char byte : bytes)
      sum = (sum ^ byte) * 1099511628211u;
    return static_cast<double>(sum >> 11);
  }
} // namespace RollingContact::Fmu
