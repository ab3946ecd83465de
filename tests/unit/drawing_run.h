#ifndef rolling_contact_tests_drawing_run_h
#define rolling_contact_tests_drawing_run_h

#include "complaint.h"
#include "scene_run.h"
#include "scratch_folder.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace RollingContact
{
  /** A run with a folder, and what it left there. */
  struct DrawingRun : public SceneInMemory
  {
    DrawingRun()
      : run_folder(files.folder, "", "")
      , table(run_folder)
      , drawing{run_folder, table, report, timer, log}
    {
      run_folder.open();
    }

    /** Columns of the block of a curve or a map, the first or, with a label of
     * the y axis, the one of that panel. */
    std::vector<std::vector<double>>
    block(const std::string &name,
          const std::string &label,
          const std::string &y_label = "") const
    {
      std::istringstream lines(read(files.folder / (name + ".dat")));
      std::string        line;
      do
        {
          while (line != "# " + label)
            BOOST_REQUIRE(std::getline(lines, line));
          std::getline(lines, line); // names of the columns
      } while (!contains(line, y_label));
      std::vector<std::vector<double>> columns;
      while (std::getline(lines, line) && !line.empty())
        {
          std::istringstream numbers(line);
          std::string        number;
          for (std::size_t k = 0; numbers >> number; ++k)
            {
              columns.resize(std::max(columns.size(), k + 1));
              columns[k].push_back(std::stod(number));
            }
        }
      return columns;
    }

    /** A column of results.csv or history.csv. */
    std::vector<double> column(const std::string &file,
                               const std::string &name) const
    {
      const auto cells = [](const std::string &line) {
        std::vector<std::string> texts;
        std::istringstream       stream(line);
        for (std::string text; std::getline(stream, text, ',');)
          texts.push_back(text);
        return texts;
      };
      std::istringstream lines(read(files.folder / file));
      std::string        line;
      std::getline(lines, line);
      const auto names = cells(line);
      const auto at    = std::find(names.begin(), names.end(), name);
      BOOST_REQUIRE(at != names.end());
      std::vector<double> values;
      while (std::getline(lines, line))
        values.push_back(std::stod(cells(line).at(at - names.begin())));
      return values;
    }

    std::string script(const std::string &name) const
    {
      return read(files.folder / (name + ".gp"));
    }

    /** Whether the picture is whole, and has been registered with its parts. */
    bool is_drawn(const std::string &name) const
    {
      const std::string listed = read(files.folder / "run.json");
      for (const std::string extension : {".dat", ".gp", ".svg"})
        if (!contains(listed, '"' + name + extension + '"'))
          return false;
      return contains(read(files.folder / (name + ".svg")), "</svg>");
    }

    ScratchFolder files;
    RunFolder     run_folder;
    ResultsTable  table;
    RunContext    drawing;
  };
} // namespace RollingContact

#endif
