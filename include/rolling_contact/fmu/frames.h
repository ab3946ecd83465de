#ifndef rolling_contact_fmu_frames_h
#define rolling_contact_fmu_frames_h

#include <functional>
#include <optional>
#include <string>

namespace RollingContact::Fmu
{
  /**
   * Sends bytes to the other end of a socket, after their number. Returns
   * whether that is possible: not if there is no other end, for which no signal
   * comes.
   */
  bool send_frame(const int socket, const std::string &bytes);

  /**
   * What the other end of a socket has sent by send_frame(); nothing if it is
   * gone or @p gives_up, which is asked every second while nothing comes.
   */
  std::optional<std::string>
  receive_frame(const int socket, const std::function<bool()> &gives_up = {});
} // namespace RollingContact::Fmu

#endif
