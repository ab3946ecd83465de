#ifndef rolling_contact_base_xml_text_h
#define rolling_contact_base_xml_text_h

#include <string>

namespace RollingContact
{
  /** The text as content or quoted attribute of an XML element, valid UTF-8. */
  std::string xml_escaped(const std::string &text);
} // namespace RollingContact

#endif
