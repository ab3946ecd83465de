#include "scene_variants.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

std::string trimmed(const std::string &text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r"),
                    end   = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  for (std::string &part : parts)
    part = trimmed(part);
  return parts;
}

namespace
{
  struct Expectation
  {
    int                      code;
    std::vector<std::string> values;
    std::string              reason;
  };

  /**
   * Every variant so far with every value of a line.
   */
  std::vector<Variant> crossed(const std::vector<Variant> &variants,
                               const std::string          &line)
  {
    const std::size_t equal = line.find('=');
    if (equal == std::string::npos)
      throw std::runtime_error("no = in: " + line);
    const auto entries = split(line.substr(0, equal), ','),
               values  = split(line.substr(equal + 1), '|');
    std::vector<Variant> result;
    for (const Variant &before : variants)
      for (const std::string &value : values)
        {
          Variant    variant = before;
          const auto parts   = split(value, '&');
          variant.values.push_back(parts[0]);
          variant.label += (variant.label.empty() ? "" : ", ") + value;
          for (const std::string &entry : entries)
            {
              variant.arguments.push_back("--set");
              variant.arguments.push_back(entry + "=" + parts[0]);
            }
          for (std::size_t k = 1; k < parts.size(); ++k)
            {
              variant.arguments.push_back("--set");
              variant.arguments.push_back(parts[k]);
            }
          result.push_back(variant);
        }
    return result;
  }

  void apply(const Expectation &expectation, std::vector<Variant> &variants)
  {
    for (Variant &variant : variants)
      for (const std::string &value : variant.values)
        if (std::find(expectation.values.begin(),
                      expectation.values.end(),
                      value) != expectation.values.end())
          {
            variant.expected = expectation.code;
            variant.reason   = expectation.reason;
          }
  }
} // namespace

VariedScene::VariedScene(const std::string &file)
  : file(file)
  , name(std::filesystem::path(file).stem().string())
  , variants(1)
{
  const std::string vary = "# vary:", expect = "# expect ", check = "# check:";
  std::vector<Expectation> expectations;
  std::ifstream            stream(file);
  if (!stream)
    throw std::runtime_error("cannot read " + file);
  for (std::string line; std::getline(stream, line);)
    if (line.compare(0, vary.size(), vary) == 0)
      variants = crossed(variants, line.substr(vary.size()));
    else if (line.compare(0, check.size(), check) == 0)
      check_names = split(line.substr(check.size()), ',');
    else if (line.compare(0, expect.size(), expect) == 0)
      {
        const std::size_t at    = line.find(" at ", expect.size()),
                          colon = line.find(": ", at);
        if (at == std::string::npos || colon == std::string::npos)
          throw std::runtime_error(file + ": cannot read: " + line);
        expectations.push_back({std::stoi(line.substr(expect.size())),
                                split(line.substr(at + 4, colon - at - 4), '|'),
                                trimmed(line.substr(colon + 1))});
      }
  for (const Expectation &expectation : expectations)
    apply(expectation, variants);
}

bool VariedScene::checks(const std::string &name) const
{
  return std::find(check_names.begin(), check_names.end(), name) !=
         check_names.end();
}
