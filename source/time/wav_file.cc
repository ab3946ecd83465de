#include <rolling_contact/time/wav_file.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace RollingContact::Sound
{
  namespace
  {
    const double       largest          = 8388608.; // 2^23
    const unsigned int bytes_per_sample = 3;

    /** An integer of so many bytes, the lowest first. */
    std::string bytes_of(const std::uint32_t value, const unsigned int n_bytes)
    {
      std::string bytes;
      for (unsigned int i = 0; i < n_bytes; ++i)
        bytes += static_cast<char>(value >> (8 * i) & 0xff);
      return bytes;
    }

    /** Name, length and content, which takes an even number of bytes. */
    std::string chunk(const std::string &name, const std::string &content)
    {
      return name + bytes_of(content.size(), 4) + content +
             std::string(content.size() % 2, '\0');
    }

    std::string format_of(const unsigned int rate)
    {
      const unsigned int pcm = 1, one_channel = 1;
      return bytes_of(pcm, 2) + bytes_of(one_channel, 2) + bytes_of(rate, 4) +
             bytes_of(rate * bytes_per_sample, 4) +
             bytes_of(bytes_per_sample, 2) + bytes_of(8 * bytes_per_sample, 2);
    }
  } // namespace

  double full_scale_above(const std::vector<double> &values)
  {
    double size = 0.;
    for (const double value : values)
      size = std::max(size, std::abs(value));
    if (!(size > 0.))
      return 1.;
    const double ten = std::pow(10., std::floor(std::log10(size)));
    for (const double step : {1., 2., 5., 10.})
      if (step * ten > size)
        return step * ten;
    return 20 * ten;
  }

  std::string wav_file(const std::vector<double> &values,
                       const unsigned int         rate,
                       const double               full_scale,
                       const std::string         &comment)
  {
    std::string samples;
    samples.reserve(values.size() * bytes_per_sample);
    for (const double value : values)
      {
        const double number =
          std::clamp(std::round(value / full_scale * largest),
                     -largest,
                     largest - 1);
        samples += bytes_of(static_cast<std::uint32_t>(
                              static_cast<std::int32_t>(number)),
                            bytes_per_sample);
      }
    return chunk("RIFF",
                 "WAVE" + chunk("fmt ", format_of(rate)) +
                   chunk("LIST", "INFO" + chunk("ICMT", comment + '\0')) +
                   chunk("data", samples));
  }

  std::size_t n_beyond(const std::vector<double> &values,
                       const double               full_scale)
  {
    return std::count_if(values.begin(), values.end(), [&](const double value) {
      return std::abs(value) > full_scale;
    });
  }
} // namespace RollingContact::Sound
