// Runs the program on random valid scenes, each in its own process with limits,
// and checks how it ends and the invariants. Prints the scene of every failure.
// Usage: random_scenes PROGRAM [--seed S] [--count N] [--dimension 2|3]
//        [--keep FOLDER]
// Scene k of seed S is the same on every machine. Exit code 0 if none failed.

#include "random_scene.h"
#include "trial.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace
{
  namespace fs = std::filesystem;

  struct Options
  {
    std::string   program, keep;
    std::uint64_t seed      = 1;
    unsigned int  count     = 20;
    unsigned int  dimension = 2;
  };

  const char usage[] =
    "usage: random_scenes PROGRAM [--seed S] [--count N] [--dimension 2|3] "
    "[--keep FOLDER]";

  Options read_options(const int argc, char **argv)
  {
    if (argc < 2 || argc % 2 != 0 || argv[1][0] == '-')
      throw std::runtime_error(usage);
    Options options;
    options.program = fs::absolute(argv[1]).string();
    if (!fs::is_regular_file(options.program))
      throw std::runtime_error("there is no program " + options.program);
    for (int i = 2; i + 1 < argc; i += 2)
      {
        const std::string name = argv[i];
        if (name == "--seed")
          options.seed = std::stoull(argv[i + 1]);
        else if (name == "--count")
          options.count = std::stoul(argv[i + 1]);
        else if (name == "--dimension")
          options.dimension = std::stoul(argv[i + 1]);
        else if (name == "--keep")
          options.keep = argv[i + 1];
        else
          throw std::runtime_error("no option " + name);
      }
    return options;
  }

  struct Counts
  {
    unsigned int n_right = 0, n_fallbacks = 0, n_refused = 0, n_told = 0,
                 n_failed = 0;
    double cpu_s          = 0.;
  };

  /**
   * True if a run rightly ended with exit 2: the operators of the paper, and a
   * patch that in time outgrows its candidate zone.
   */
  bool rightly_not_converged(const RandomScene &scene, const Trial &trial)
  {
    return trial.end == Trial::End::exited && trial.exit_code == 2 &&
           (scene.may_not_converge() ||
            trial.messages.find("border of the") != std::string::npos);
  }

  /**
   * True if a scene was refused for what cannot be seen before it is drawn: it
   * does not fit into the memory or its patch does not fit on the bodies.
   */
  bool rightly_refused(const Trial &trial)
  {
    if (trial.end != Trial::End::exited || trial.exit_code != 1)
      return false;
    std::string text = trial.messages;
    std::replace(text.begin(), text.end(), '\n', ' ');
    // messages are wrapped
    for (std::size_t k; (k = text.find("  ")) != std::string::npos;)
      text.erase(k, 1);
    for (const char *reason : {"more than 70 %",
                               "beyond what the body offers",
                               "must not reach the edges"})
      if (text.find(reason) != std::string::npos)
        return true;
    return false;
  }

  void judge(const RandomScene &scene,
             const Trial       &trial,
             const std::string &file,
             Counts            &counts)
  {
    counts.cpu_s += trial.cpu_s;
    const std::string fault = trial.complaint();
    if (fault.empty())
      {
        ++counts.n_right;
        counts.n_fallbacks +=
          trial.cell("solver").find("fallback") != std::string::npos;
      }
    else if (rightly_refused(trial))
      ++counts.n_refused;
    else if (rightly_not_converged(scene, trial))
      ++counts.n_told;
    else
      {
        ++counts.n_failed;
        std::printf("FAILED: %s: %s\n%s\n",
                    file.c_str(),
                    fault.c_str(),
                    trial.messages.c_str());
        std::fflush(stdout);
        return;
      }
    fs::remove(file);
  }
} // namespace

int main(const int argc, char **argv)
{
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--help")
      {
        std::cout << usage << '\n';
        return 0;
      }
  try
    {
      Options           options = read_options(argc, argv);
      const std::string folder  = make_work_folder();
      if (options.keep.empty())
        options.keep = folder;
      fs::create_directories(options.keep);
      Counts counts;
      for (unsigned int k = 0; k < options.count; ++k)
        {
          const RandomScene  scene(options.seed * 1000003 + k,
                                  options.dimension);
          std::ostringstream name;
          name << "random_" << options.dimension << "d_" << options.seed << '_'
               << k << ".prm";
          const std::string file =
            (fs::path(options.keep) / name.str()).string();
          std::ofstream(file) << scene.prm();
          judge(
            scene,
            run_trial(options.program, {file}, folder + "/run", TrialLimits()),
            file,
            counts);
        }
      if (counts.n_failed == 0 || options.keep != folder)
        fs::remove_all(folder);
      std::printf(
        "%u scenes: %u right (%u by a fallback), %u refused as input, "
        "%u rightly not converged, %u failed; %.0f s CPU\n",
        options.count,
        counts.n_right,
        counts.n_fallbacks,
        counts.n_refused,
        counts.n_told,
        counts.n_failed,
        counts.cpu_s);
      return counts.n_failed == 0 ? 0 : 1;
    }
  catch (const std::exception &error)
    {
      std::cerr << "random_scenes: " << error.what() << '\n';
      return 2;
    }
}
