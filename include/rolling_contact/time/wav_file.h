#ifndef rolling_contact_time_wav_file_h
#define rolling_contact_time_wav_file_h

#include <cstddef>
#include <string>
#include <vector>

namespace RollingContact::Sound
{
  /**
   * The next of 1, 2, 5, 10, ... (and of 0.1, 0.2, ...) above the largest size
   * of the values; 1 if all are 0.
   */
  double full_scale_above(const std::vector<double> &values);

  /**
   * A WAV file (RIFF) of one channel, PCM of 24 bits: the integer 2^23 stands
   * for @p full_scale, in the values' unit, and values beyond are cut.
   * @p comment is kept within, in its list INFO. Units: Hz.
   */
  std::string wav_file(const std::vector<double> &values,
                       const unsigned int         rate,
                       const double               full_scale,
                       const std::string         &comment);

  /** How many values wav_file() cuts. */
  std::size_t n_beyond(const std::vector<double> &values,
                       const double               full_scale);
} // namespace RollingContact::Sound

#endif
