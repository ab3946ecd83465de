#ifndef rolling_contact_base_turns_h
#define rolling_contact_base_turns_h

#include <cstddef>
#include <memory>
#include <optional>

namespace RollingContact
{
  namespace Ranks
  {
    /**
     * Numbers 0, 1, 2, ... of pieces of work, each of which one rank takes when
     * it is free, the lowest first. Ranks that share their memory take them as
     * they come; ranks on several machines have every n-th number each, as
     * there a rank that computes does not answer others. Threads may share one
     * object, also inside apart(). Collective to make and to destroy.
     */
    class Turns
    {
    public:
      Turns();

      ~Turns();

      Turns(const Turns &)            = delete;
      Turns &operator=(const Turns &) = delete;

      /** The next number for this rank if it is below @p end; otherwise it
       * stays for a later call with a larger end. */
      std::optional<std::size_t> take_below(const std::size_t end);

      /** Whether take_below() would give one. */
      bool has_below(const std::size_t end);

      /** No rank takes another number. */
      void stop();

      /** Whether a rank of this machine has called stop(). */
      bool stopped();

    private:
      struct Counter;

      const std::unique_ptr<Counter> counter;
    };
  } // namespace Ranks
} // namespace RollingContact

#endif
