#include <rolling_contact/base/expression_text.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace RollingContact
{
  namespace
  {
    bool is_letter(const char c)
    {
      return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
    }

    bool is_digit(const char c)
    {
      return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
    }

    bool has_bare_comma(const std::string &text)
    {
      int depth = 0;
      for (const char character : text)
        {
          depth += (character == '(') - (character == ')');
          if (character == ',' && depth == 0)
            return true;
        }
      return false;
    }

    /** Whether there is a '=' that is no part of ==, !=, <= and >=. */
    bool has_assignment(const std::string &text)
    {
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            if (i + 1 < text.size() && text[i + 1] == '=')
              ++i;
            else if (i == 0 ||
                     std::string("!<>").find(text[i - 1]) == std::string::npos)
              return true;
          }
      return false;
    }
  } // namespace

  std::vector<ExpressionName> names_in_expression(const std::string &text)
  {
    std::vector<ExpressionName> names;
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t begin = i;
        if (is_digit(text[i])) // the e of 1e-3 is part of a number
          {
            char *end = nullptr;
            std::strtod(text.c_str() + i, &end);
            i = std::max<std::size_t>(i + 1, end - text.c_str());
          }
        else if (is_letter(text[i]))
          {
            while (i < text.size() && (is_letter(text[i]) || is_digit(text[i])))
              ++i;
            const std::size_t next = text.find_first_not_of(" \t", i);
            names.push_back({text.substr(begin, i - begin),
                             next != std::string::npos && text[next] == '('});
          }
        else
          ++i;
      }
    return names;
  }

  std::string trap_in_expression(const std::string &text)
  {
    if (has_bare_comma(text))
      return "decimals take a point, and it is one expression.";
    if (text.find(';') != std::string::npos)
      return "it is one expression.";
    if (has_assignment(text))
      return "a '=' would assign a value; write the expression alone, and == "
             "to compare.";
    for (const ExpressionName &it : names_in_expression(text))
      if (it.name.compare(0, 4, "rand") == 0)
        return "what is random cannot be repeated.";
    return "";
  }

  std::string
  unknown_name_in_expression(const std::string              &text,
                             const std::vector<std::string> &variables)
  {
    std::string allowed;
    for (const std::string &variable : variables)
      allowed += (allowed.empty() ? "" : ", ") + variable;
    for (const ExpressionName &it : names_in_expression(text))
      if (!it.is_function && it.name != "pi" && it.name[0] != '_' &&
          std::find(variables.begin(), variables.end(), it.name) ==
            variables.end())
        return "'" + quotable(it.name) + "' is not known here; there are " +
               allowed + ", pi and functions.";
    return "";
  }
} // namespace RollingContact
