#include <rolling_contact/base/captured_stderr.h>

#include <atomic>
#include <iostream>
#include <mutex>
#include <sstream>
#include <thread>

namespace RollingContact
{
  namespace
  {
    /**
     * Keeps what one thread writes and hands on what others write.
     */
    class BufferOfOneThread : public std::streambuf
    {
    public:
      void begin()
      {
        in_use.lock();
        kept.clear();
        others = std::cerr.rdbuf();
        owner  = std::this_thread::get_id();
        std::cerr.rdbuf(this);
      }

      void end()
      {
        std::cerr.rdbuf(others);
        in_use.unlock();
      }

      const std::string &text() const
      {
        return kept;
      }

    protected:
      std::streamsize xsputn(const char *text, const std::streamsize n) override
      {
        if (!is_of_owner())
          return others.load()->sputn(text, n);
        kept.append(text, n);
        return n;
      }

      int_type overflow(const int_type c) override
      {
        const char letter = traits_type::to_char_type(c);
        return traits_type::eq_int_type(c, traits_type::eof()) ||
                   xsputn(&letter, 1) == 1
                 ? traits_type::not_eof(c)
                 : traits_type::eof();
      }

      int sync() override
      {
        return is_of_owner() ? 0 : others.load()->pubsync();
      }

    private:
      bool is_of_owner() const
      {
        return std::this_thread::get_id() == owner.load();
      }

      std::mutex                    in_use;
      std::string                   kept;
      std::atomic<std::streambuf *> others{nullptr};
      std::atomic<std::thread::id>  owner{};
    };

    /** Never destroyed: a thread may be writing to it when it is put back. */
    BufferOfOneThread &the_buffer()
    {
      static auto *const buffer = new BufferOfOneThread;
      return *buffer;
    }
  } // namespace

  CapturedStderr::CapturedStderr()
  {
    the_buffer().begin();
  }

  CapturedStderr::~CapturedStderr()
  {
    the_buffer().end();
  }

  std::string CapturedStderr::cause() const
  {
    const std::string &text = the_buffer().text(),
                      mark  = "Additional information:";
    const std::size_t at    = text.rfind(mark);
    if (at == std::string::npos)
      return "";
    std::istringstream lines(text.substr(at + mark.size()));
    std::string        line, word, cause;
    std::getline(lines, line);
    while (std::getline(lines, line) &&
           line.find_first_not_of(' ') != std::string::npos)
      for (std::istringstream words(line); words >> word;)
        cause += (cause.empty() ? "" : " ") + word;
    return cause;
  }
} // namespace RollingContact
