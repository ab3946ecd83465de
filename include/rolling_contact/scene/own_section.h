#ifndef rolling_contact_scene_own_section_h
#define rolling_contact_scene_own_section_h

#include <any>
#include <typeinfo>

namespace RollingContact
{
  class Entries;

  /**
   * The entries of a section that one analysis alone reads: a value of any type
   * that has declare(Entries &) and check(), which throws InputError if they
   * break a rule of their own.
   */
  class OwnSection
  {
  public:
    template <class Section>
    explicit OwnSection(const Section &section)
      : value(section)
      , declare_value([](std::any &value, Entries &entries) {
        std::any_cast<Section &>(value).declare(entries);
      })
      , check_value([](const std::any &value) {
        std::any_cast<const Section &>(value).check();
      })
    {}

    void declare(Entries &entries)
    {
      declare_value(value, entries);
    }

    void check() const
    {
      check_value(value);
    }

    template <class Section>
    bool is() const
    {
      return value.type() == typeid(Section);
    }

    /**
     * The value, which is of this type.
     */
    template <class Section>
    Section &get()
    {
      return std::any_cast<Section &>(value);
    }

    template <class Section>
    const Section &get() const
    {
      return std::any_cast<const Section &>(value);
    }

  private:
    std::any value;
    void (*declare_value)(std::any &, Entries &);
    void (*check_value)(const std::any &);
  };
} // namespace RollingContact

#endif
