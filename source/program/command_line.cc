#include <boost/program_options.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/program/command_line.h>

#include <sstream>

namespace RollingContact
{
  namespace options = boost::program_options;

  namespace
  {
    const char *usage =
      "Usage: rolling-contact FILE.prm [--set \"Section/Entry=value\"]... "
      "[OPTION]...";

    options::options_description visible_options()
    {
      options::options_description visible("Options",
                                           screen_width(),
                                           screen_width() / 2);
      visible.add_options()(
        "set",
        options::value<std::vector<std::string>>(),
        "Section/Entry=value: override an entry of the file; "
        "repeatable")("output",
                      options::value<std::string>(),
                      "folder of the run (default: output/<stem of FILE>)")(
        "resume",
        "continue the transient run, table, map or limit cycles in the folder "
        "where they stopped")("validate",
                              "read and check the parameters, write nothing")(
        "states",
        "solve the states of a scene of Analysis = fmu for an FMU at the other "
        "end of the standard input")(
        "print-parameters", "print every parameter with its documentation")(
        "parameters-as-json",
        "print them for other programs, with the values that are allowed")(
        "version", "print the version")("help", "print this text");
      return visible;
    }

    CommandLine::Setting parse_setting(const std::string &text)
    {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || equals == 0)
        throw InputError("--set " + text +
                         ": give it as \"Section/Entry=value\".");
      const auto trim = [](const std::string &word) {
        const std::size_t begin = word.find_first_not_of(" \t"),
                          end   = word.find_last_not_of(" \t");
        return begin == std::string::npos ? std::string()
                                          : word.substr(begin, end - begin + 1);
      };
      return {trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
    }

    /** Boost fills these into its messages, and for ever so if a word on the
     * command line contains them. */
    void check_placeholders(const std::vector<std::string> &words)
    {
      for (const std::string &word : words)
        for (const std::string placeholder : {"%canonical_option%",
                                              "%option%",
                                              "%original_token%",
                                              "%prefix%",
                                              "%value%"})
          if (word.find(placeholder) != std::string::npos)
            throw InputError("Command line: " + word + " contains " +
                             placeholder +
                             ", which no file, folder or entry is named; " +
                             usage + ", or --help.");
    }
  } // namespace

  std::string CommandLine::help()
  {
    std::ostringstream text;
    const auto         line = [](const std::string &words) {
      return wrapped(words, screen_width()) + '\n';
    };
    text
      << line(usage) << '\n'
      << line(
           "Rolling contact with friction of wheel and rail by finite elements.")
      << '\n'
      << visible_options() << '\n'
      << line("Exit codes: 0 done and converged, 1 input error, 2 not "
              "converged or interrupted, 3 internal error.");
    return text.str();
  }

  CommandLine::CommandLine(const int argc, const char *const *argv)
    : words(argv, argv + argc)
  {
    check_placeholders(words);
    options::options_description all = visible_options();
    all.add_options()("file", options::value<std::vector<std::string>>());
    options::positional_options_description positional;
    positional.add("file", -1);
    options::variables_map values;
    try
      {
        options::store(options::command_line_parser(argc, argv)
                         .options(all)
                         .positional(positional)
                         .run(),
                       values);
      }
    catch (const options::error &error)
      {
        throw InputError("Command line: " + std::string(error.what()) + ". " +
                         usage + ", or --help.");
      }
    show_help        = values.count("help") > 0;
    show_version     = values.count("version") > 0;
    validate_only    = values.count("validate") > 0;
    print_parameters = values.count("print-parameters") > 0;
    print_json       = values.count("parameters-as-json") > 0;
    resume           = values.count("resume") > 0;
    serves_fmu       = values.count("states") > 0;
    if (values.count("output") > 0)
      {
        output_folder = values["output"].as<std::string>();
        if (output_folder.empty())
          throw InputError("Command line: --output is empty; name a folder, or "
                           "leave it out for output/<stem of FILE>.");
      }
    if (values.count("set") > 0)
      for (const std::string &text :
           values["set"].as<std::vector<std::string>>())
        settings.push_back(parse_setting(text));

    std::vector<std::string> files;
    if (values.count("file") > 0)
      files = values["file"].as<std::vector<std::string>>();
    if (files.size() > 1)
      throw InputError("Command line: one parameter file at a time, not " +
                       files[0] + " and " + files[1] + ".");
    if (!files.empty())
      prm_file = files[0];
    else if (!show_help && !show_version && !print_parameters && !print_json)
      throw InputError("Command line: no parameter file. " +
                       std::string(usage) + ", or --help.");
  }
} // namespace RollingContact
