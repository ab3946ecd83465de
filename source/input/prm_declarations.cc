#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/input/prm_declarations.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    void
    declare_text(ParameterHandler                               &prm,
                 const std::string                              &path,
                 const std::string                              &default_text,
                 const std::string                              &help,
                 const std::function<void(const std::string &)> &read)
    {
      const std::string entry = path.substr(path.find('/') + 1);
      prm.declare_entry(entry, default_text, Patterns::Anything(), help);
      prm.add_action(entry, read);
    }
  } // namespace



  void
  declare_number(ParameterHandler      &prm,
                 const std::string     &path,
                 std::optional<double> &value,
                 const std::string     &unit,
                 const std::string     &help)
  {
    declare_text(
      prm, path, "", help, [&value, path, unit](const std::string &text) {
        value = number(text);
        if (!value && !text.empty())
          throw InputError(
            path + " = " + quotable(text) + ": give a number in " + unit +
            ", or leave it empty" +
            (text.find(',') != std::string::npos ? "; decimals take a point."
                                                 : "."));
      });
  }



  void
  declare_number_list(ParameterHandler    &prm,
                      const std::string   &path,
                      std::vector<double> &values,
                      const std::string   &default_text,
                      const std::string   &help)
  {
    declare_text(prm,
                 path,
                 default_text,
                 help,
                 [&values, path, default_text](const std::string &text) {
                   values = text.empty() && default_text.empty()
                              ? std::vector<double>()
                              : number_list(path, text);
                 });
  }



  std::optional<double>
  number(const std::string &text)
  {
    const auto value = number_of(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }



  std::string
  text_of(const double value)
  {
    return significant(value, 15);
  }
} // namespace RollingContact
