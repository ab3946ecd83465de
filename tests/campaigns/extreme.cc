// Runs the scenes of prm/extreme, each case in its own process with limits, and
// prints one table. Usage: extreme_cases PROGRAM FOLDER [--quick] [SCENE ...]
// Exit code 0 if every case ended right, or as its scene says it must.

#include "scene_variants.h"
#include "trial.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace
{
  namespace fs = std::filesystem;

  /**
   * How equal forces of the same state must be, over the load.
   */
  const double same = 1e-7;

  struct Summary
  {
    unsigned int n_right = 0, n_expected = 0, n_failed = 0, n_fallbacks = 0;
    double       cpu_s = 0.;
  };

  /**
   * A text with all white space turned into single blanks.
   */
  std::string in_one_line(const std::string &text)
  {
    std::istringstream words(text);
    std::string        result;
    for (std::string word; words >> word;)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }

  /**
   * A label that fits into its column.
   */
  std::string short_label(const std::string &label)
  {
    const std::size_t width = 40;
    return label.empty()           ? "-"
           : label.size() <= width ? label
                                   : label.substr(0, width - 3) + "...";
  }

  /**
   * The entries of a used.prm as Section/Entry.
   */
  std::map<std::string, std::string> entries_of(const fs::path &file)
  {
    std::map<std::string, std::string> entries;
    std::ifstream                      stream(file);
    std::string                        section;
    for (std::string line; std::getline(stream, line);)
      {
        const std::string text = trimmed(line.substr(0, line.find('#')));
        if (text.compare(0, 11, "subsection ") == 0)
          section = trimmed(text.substr(11)) + "/";
        else if (text == "end")
          section.clear();
        else if (text.compare(0, 4, "set ") == 0)
          {
            const std::size_t equal = text.find('=');
            entries[section + trimmed(text.substr(4, equal - 4))] =
              trimmed(text.substr(equal + 1));
          }
      }
    return entries;
  }

  /**
   * The scene of a run in millimetres and MPa, forces in N.
   */
  std::vector<std::string> in_millimetres(const fs::path &used)
  {
    std::map<std::string, double> factors{{"Contact/Approach", 1e3},
                                          {"Contact/Spin", 1e-3}};
    for (const std::string body : {"Wheel", "Rail"})
      {
        for (const std::string length : {"Radius",
                                         "Lateral radius",
                                         "Hub radius",
                                         "Block length",
                                         "Block depth",
                                         "Thickness",
                                         "Width"})
          factors[body + "/" + length] = 1e3;
        factors[body + "/Young modulus"] = 1e-6;
      }
    std::vector<std::string> arguments;
    for (const auto &entry : entries_of(used))
      if (factors.count(entry.first) > 0 && !entry.second.empty())
        {
          char value[64];
          std::snprintf(value,
                        sizeof value,
                        "%.17g",
                        std::atof(entry.second.c_str()) * factors[entry.first]);
          arguments.push_back("--set");
          arguments.push_back(entry.first + "=" + value);
        }
    return arguments;
  }

  std::vector<std::string> mirrored(const Trial &trial)
  {
    std::vector<std::string> arguments{"--set", "Contact/Speed=-1"};
    for (const auto &entry :
         {std::make_pair("Contact/Creepage x", trial.number("creepage_x")),
          std::make_pair("Contact/Spin", trial.number("spin_1/m"))})
      {
        char text[64];
        std::snprintf(
          text, sizeof text, "%s=%.17g", entry.first, -entry.second);
        arguments.push_back("--set");
        arguments.push_back(text);
      }
    return arguments;
  }

  /**
   * What differs between the forces of two runs, the second with the given
   * sign of force_x.
   */
  std::string
  difference(const Trial &first, const Trial &second, const double sign)
  {
    if (!second.complaint().empty())
      return second.complaint();
    const double load = std::max(first.number("normal_force_N"), 1e-300);
    for (const std::string column :
         {"normal_force_N", "force_x_N", "force_y_N"})
      {
        const double factor = column == "force_x_N" ? sign : 1.,
                     by     = std::abs(first.number(column) -
                                   factor * second.number(column)) /
                          load;
        if (!(by <= same))
          return column + " differs by " + short_number(by) + " N";
      }
    return {};
  }

  class ExtremeCases
  {
  public:
    ExtremeCases(const std::string &program,
                 const bool         quick,
                 const std::string &work)
      : program(program)
      , quick(quick)
      , work(work)
    {
      std::printf("%-17s %-40s %-12s %-44s %6s %8s %8s %-15s %6s\n",
                  "scene",
                  "case",
                  "status",
                  "solver",
                  "iter.",
                  "residual",
                  "invar.",
                  "(which)",
                  "CPU s");
    }

    void run(const VariedScene &scene)
    {
      double before = 0.;
      for (std::size_t k = 0; k < scene.variants.size(); ++k)
        {
          if (quick && k != 0 && k + 1 != scene.variants.size())
            continue;
          const Variant &variant = scene.variants[k];
          const Trial    trial   = start(scene, variant, {}, "case");
          std::string    fault   = judge(variant, trial);
          if (fault.empty() && trial.exit_code == 0)
            fault = further_checks(scene, variant, trial);
          const double load = trial.number("normal_force_N");
          if (fault.empty() && trial.exit_code == 0 && load > 0. &&
              scene.checks("monotone") && !(load > before))
            fault = "the load does not rise";
          before = load;
          report(scene, variant, trial, fault);
        }
    }

    Summary summary;

  private:
    Trial start(const VariedScene              &scene,
                const Variant                  &variant,
                const std::vector<std::string> &more,
                const std::string              &folder)
    {
      std::vector<std::string> arguments{scene.file};
      arguments.insert(arguments.end(),
                       variant.arguments.begin(),
                       variant.arguments.end());
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Trial trial =
        run_trial(program, arguments, work + "/" + folder, TrialLimits());
      summary.cpu_s += trial.cpu_s;
      return trial;
    }

    std::string judge(const Variant &variant, const Trial &trial) const
    {
      if (variant.expected == 0)
        {
          const std::string fault = trial.complaint();
          return fault.empty() || trial.messages.empty()
                   ? fault
                   : fault + ": " + in_one_line(trial.messages);
        }
      if (trial.end != Trial::End::exited ||
          trial.exit_code != variant.expected)
        return "ended with " + std::to_string(trial.exit_code) +
               ", expected exit " + std::to_string(variant.expected);
      return in_one_line(trial.messages).find(variant.reason) ==
                 std::string::npos
               ? "another reason: " + in_one_line(trial.messages)
               : "";
    }

    std::string further_checks(const VariedScene &scene,
                               const Variant     &variant,
                               const Trial       &trial)
    {
      if (scene.checks("mirror"))
        {
          const std::string fault =
            difference(trial,
                       start(scene, variant, mirrored(trial), "mirror"),
                       -1.);
          if (!fault.empty())
            return "mirror: " + fault;
        }
      if (scene.checks("units"))
        {
          const std::string fault = difference(
            trial,
            start(scene,
                  variant,
                  in_millimetres(fs::path(work) / "case" / "used.prm"),
                  "units"),
            1.);
          if (!fault.empty())
            return "millimetres: " + fault;
        }
      return {};
    }

    void report(const VariedScene &scene,
                const Variant     &variant,
                const Trial       &trial,
                const std::string &fault)
    {
      const bool fallback =
        trial.cell("solver").find("fallback") != std::string::npos;
      summary.n_fallbacks += trial.exit_code == 0 && fallback;
      ++(!fault.empty()          ? summary.n_failed
         : variant.expected == 0 ? summary.n_right
                                 : summary.n_expected);
      const auto worst = trial.worst_invariant();
      std::printf(
        "%-17s %-40s %-12s %-44s %6.0f %8s %8s %-15s %6.2f\n",
        scene.name.c_str(),
        short_label(variant.label).c_str(),
        !fault.empty()
          ? "FAILED"
          : (variant.expected == 0
               ? "right"
               : ("exit " + std::to_string(variant.expected)).c_str()),
        trial.cell("solver").c_str(),
        trial.largest("iterations"),
        short_number(std::max(trial.largest("residual_normal"),
                              trial.largest("residual_tangential")))
          .c_str(),
        short_number(worst.first).c_str(),
        worst.second.c_str(),
        trial.cpu_s);
      if (!fault.empty())
        std::printf("    %s\n", fault.c_str());
      std::fflush(stdout);
    }

    const std::string program;
    const bool        quick;
    const std::string work;
  };
} // namespace

int main(const int argc, char **argv)
{
  try
    {
      if (argc < 3)
        throw std::runtime_error(
          "usage: extreme_cases PROGRAM FOLDER [--quick] [SCENE ...]");
      bool                     quick = false;
      std::vector<std::string> chosen;
      for (int i = 3; i < argc; ++i)
        if (std::string(argv[i]) == "--quick")
          quick = true;
        else
          chosen.push_back(argv[i]);
      std::vector<fs::path> files;
      for (const auto &entry : fs::directory_iterator(argv[2]))
        if (entry.path().extension() == ".prm" &&
            (chosen.empty() ||
             std::find(chosen.begin(),
                       chosen.end(),
                       entry.path().stem().string()) != chosen.end()))
          files.push_back(entry.path());
      std::sort(files.begin(), files.end());
      const std::string folder = make_work_folder();
      ExtremeCases      cases(fs::absolute(argv[1]).string(), quick, folder);
      for (const fs::path &file : files)
        cases.run(VariedScene(file.string()));
      fs::remove_all(folder);
      const Summary &sum = cases.summary;
      std::printf(
        "%u cases ended right (%u by a fallback), %u as expected with "
        "an error, %u failed; %.0f s CPU\n",
        sum.n_right,
        sum.n_fallbacks,
        sum.n_expected,
        sum.n_failed,
        sum.cpu_s);
      return sum.n_failed == 0 && !files.empty() ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << "extreme_cases: " << error.what() << '\n';
      return 2;
    }
}
