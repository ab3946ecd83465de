#include <poll.h>
#include <sys/socket.h>

#include <rolling_contact/fmu/frames.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace RollingContact::Fmu
{
  namespace
  {
    const std::uint64_t most_bytes = 1u << 30;

    bool send_all(const int socket, const char *bytes, std::size_t n)
    {
      while (n > 0)
        {
          const ssize_t sent = send(socket, bytes, n, MSG_NOSIGNAL);
          if (sent < 0 && errno == EINTR)
            continue;
          if (sent <= 0)
            return false;
          bytes += sent;
          n -= static_cast<std::size_t>(sent);
        }
      return true;
    }

    bool receive_all(const int                    socket,
                     char                        *bytes,
                     std::size_t                  n,
                     const std::function<bool()> &gives_up)
    {
      const int every_ms = 1000;
      while (n > 0)
        {
          pollfd    wait{socket, POLLIN, 0};
          const int ready = poll(&wait, 1, gives_up ? every_ms : -1);
          if (ready < 0 && errno != EINTR)
            return false;
          if (ready <= 0)
            {
              if (gives_up && gives_up())
                return false;
              continue;
            }
          const ssize_t got = recv(socket, bytes, n, 0);
          if (got < 0 && errno == EINTR)
            continue;
          if (got <= 0)
            return false;
          bytes += got;
          n -= static_cast<std::size_t>(got);
        }
      return true;
    }
  } // namespace

  bool send_frame(const int socket, const std::string &bytes)
  {
    const std::uint64_t n = bytes.size();
    char                head[sizeof(n)];
    std::memcpy(head, &n, sizeof(n));
    return send_all(socket, head, sizeof(n)) &&
           send_all(socket, bytes.data(), bytes.size());
  }

  std::optional<std::string>
  receive_frame(const int socket, const std::function<bool()> &gives_up)
  {
    std::uint64_t n = 0;
    char          head[sizeof(n)];
    if (!receive_all(socket, head, sizeof(n), gives_up))
      return {};
    std::memcpy(&n, head, sizeof(n));
    if (n > most_bytes)
      return {};
    std::string bytes(n, '\0');
    if (!receive_all(socket, bytes.data(), n, gives_up))
      return {};
    return bytes;
  }
} // namespace RollingContact::Fmu
