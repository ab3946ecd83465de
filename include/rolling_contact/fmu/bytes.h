#ifndef rolling_contact_fmu_bytes_h
#define rolling_contact_fmu_bytes_h

#include <array>
#include <cstddef>
#include <string>

namespace RollingContact::Fmu
{
  /**
   * Numbers and texts that are put one behind the other, for files, states and
   * other processes on a machine of the same kind.
   */
  class BytesOut
  {
  public:
    void add(const double number);

    /** A text goes with its length. */
    void add(const std::string &text);

    template <std::size_t n>
    void add(const std::array<double, n> &numbers)
    {
      for (const double number : numbers)
        add(number);
    }

    const std::string &all() const
    {
      return bytes;
    }

  private:
    std::string bytes;
  };

  /**
   * What BytesOut has put, in the same order. Functions throw
   * std::invalid_argument where the bytes end too early.
   */
  class BytesIn
  {
  public:
    /** The bytes must outlive this. */
    explicit BytesIn(const std::string &bytes)
      : bytes(bytes)
    {}

    double number();

    /** A number that is a size, which is not larger than @p most. */
    std::size_t size(const std::size_t most);

    std::string text();

    template <std::size_t n>
    std::array<double, n> numbers()
    {
      std::array<double, n> all;
      for (double &value : all)
        value = number();
      return all;
    }

    bool at_end() const
    {
      return place == bytes.size();
    }

  private:
    const std::string &bytes;
    std::size_t        place = 0;
  };

  /** 53 bits that follow from some bytes (FNV-1a), as a number. */
  double check_sum(const std::string &bytes);
} // namespace RollingContact::Fmu

#endif
