#include "trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace
{
  namespace fs = std::filesystem;

  /**
   * The largest of what a run may show for its invariants: the tolerance of the
   * solver, 1e-10 unless a scene says otherwise, and rounding.
   */
  const double invariant_limit = 1.01e-10;

  /**
   * The largest residual of a mode, of omega^2.
   */
  const double residual_limit = 1e-6;

  std::vector<std::string> cells_of(const std::string &line)
  {
    std::vector<std::string> cells(1);
    bool                     quoted = false;
    for (const char c : line)
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        cells.emplace_back();
      else
        cells.back() += c;
    return cells;
  }

  std::vector<Trial::Row> read_table(const fs::path &file)
  {
    std::vector<Trial::Row>  rows;
    std::ifstream            stream(file);
    std::vector<std::string> names;
    for (std::string line; std::getline(stream, line);)
      {
        const auto cells = cells_of(line);
        if (names.empty())
          {
            names = cells;
            continue;
          }
        rows.emplace_back();
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i)
          rows.back()[names[i]] = cells[i];
      }
    return rows;
  }

  [[noreturn]] void become(const std::string              &program,
                           const std::vector<std::string> &arguments,
                           const std::string              &folder,
                           const unsigned int              cpu_s)
  {
    const rlimit limit{cpu_s, cpu_s + 5};
    setrlimit(RLIMIT_CPU, &limit);
    const int out = open("/dev/null", O_WRONLY);
    const int err =
      open((folder + ".err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    std::vector<char *> words;
    const auto          add = [&](const std::string &word) {
      words.push_back(const_cast<char *>(word.c_str()));
    };
    const std::string option = "--output";
    add(program);
    for (const std::string &argument : arguments)
      add(argument);
    add(option);
    add(folder);
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    _exit(127);
  }

  /**
   * Wait for a child at most so long, then kill it. Returns false if killed.
   */
  bool await(const pid_t        child,
             const unsigned int wall_s,
             int               &status,
             rusage            &usage)
  {
    const auto begin = std::chrono::steady_clock::now();
    while (wait4(child, &status, WNOHANG, &usage) == 0)
      {
        if (std::chrono::steady_clock::now() - begin >
            std::chrono::seconds(wall_s))
          {
            kill(child, SIGKILL);
            wait4(child, &status, 0, &usage);
            return false;
          }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    return true;
  }
} // namespace

std::string Trial::cell(const std::string &column) const
{
  if (rows.empty() || rows.back().count(column) == 0)
    return {};
  return rows.back().at(column);
}

double Trial::number(const std::string &column) const
{
  return std::atof(cell(column).c_str());
}

double Trial::largest(const std::string &column) const
{
  double result = 0.;
  for (const Row &row : rows)
    if (row.count(column) > 0)
      result = std::max(result, std::atof(row.at(column).c_str()));
  return result;
}

std::pair<double, std::string> Trial::worst_invariant() const
{
  const std::string              prefix = "invariant_";
  std::pair<double, std::string> worst{0., "-"};
  for (const Row &row : rows)
    for (const auto &entry : row)
      if (entry.first.compare(0, prefix.size(), prefix) == 0)
        {
          const double value = std::atof(entry.second.c_str());
          if (!(value <= worst.first))
            worst = {value, entry.first.substr(prefix.size())};
        }
  return worst;
}

std::string Trial::complaint() const
{
  if (end == End::crashed)
    return "crashed";
  if (end == End::hung)
    return "ran into its time limit";
  for (const Row &row : rows)
    for (const auto &entry : row)
      if (entry.second == "nan" || entry.second == "inf" ||
          entry.second == "-nan" || entry.second == "-inf")
        return entry.first + " = " + entry.second;
  if (exit_code != 0)
    return "exit " + std::to_string(exit_code);
  if (rows.empty())
    return "no results";
  if (!(largest("residual") <= residual_limit))
    return "residual " + short_number(largest("residual"));
  const auto worst = worst_invariant();
  if (!(worst.first <= invariant_limit))
    return "invariant " + worst.second + " " + short_number(worst.first);
  return {};
}

Trial run_trial(const std::string              &program,
                const std::vector<std::string> &arguments,
                const std::string              &folder,
                const TrialLimits              &limits)
{
  fs::remove_all(folder);
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("cannot start a process");
  if (child == 0)
    become(program, arguments, folder, limits.cpu_s);
  Trial  trial;
  int    status = 0;
  rusage usage{};
  if (!await(child, limits.wall_s, status, usage))
    trial.end = Trial::End::hung;
  else if (WIFSIGNALED(status))
    trial.end = WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
                  ? Trial::End::hung
                  : Trial::End::crashed;
  else
    trial.exit_code = WEXITSTATUS(status);
  trial.cpu_s = usage.ru_utime.tv_sec + 1e-6 * usage.ru_utime.tv_usec +
                usage.ru_stime.tv_sec + 1e-6 * usage.ru_stime.tv_usec;
  std::ifstream messages(folder + ".err");
  trial.messages.assign(std::istreambuf_iterator<char>(messages), {});
  for (const char *name : {"history.csv", "results.csv", "modes.csv"})
    if (trial.rows.empty())
      trial.rows = read_table(fs::path(folder) / name);
  return trial;
}

std::string make_work_folder()
{
  std::string folder =
    (std::filesystem::temp_directory_path() / "rolling_contact_trials_XXXXXX")
      .string();
  if (mkdtemp(folder.data()) == nullptr)
    throw std::runtime_error("cannot make a folder to work in");
  return folder;
}

std::string short_number(const double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}
