#ifndef rolling_contact_scene_own_section_h
#define rolling_contact_scene_own_section_h

#include <any>
#include <typeinfo>

namespace RollingContact
{
  class Entries;

  /**
   * The entries of a section that one analysis alone reads: a value of any type
   * that has declare(Entries &).
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
    {}

    void declare(Entries &entries)
    {
      declare_value(value, entries);
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
  };
} // namespace RollingContact

#endif
