#include <rolling_contact/base/files.h>
#include <rolling_contact/base/hdf5_file.h>
#include <rolling_contact/tables/table_output.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    const double unknown = std::numeric_limits<double>::quiet_NaN();

    /**
     * "contact_creepage_x" of Contact/Creepage x.
     */
    std::string name_of_axis(const std::string &entry)
    {
      std::string name;
      for (const char character : entry)
        name += std::isalnum(static_cast<unsigned char>(character))
                  ? static_cast<char>(
                      std::tolower(static_cast<unsigned char>(character)))
                  : '_';
      return name;
    }

    /**
     * A column of results.csv without the '/', which HDF5 has for groups.
     */
    std::string name_of_array(std::string column)
    {
      for (std::size_t at; (at = column.find('/')) != std::string::npos;)
        column.replace(at, 1, "_per_");
      return column;
    }

    /**
     * The rows of results.csv as arrays over the states.
     */
    class TableArrays
    {
    public:
      TableArrays(const TablePlan &plan, const ResultsTable &results)
        : results(results)
        , row_of(plan.values.size(), results.n_rows())
      {
        for (std::size_t row = 0; row < results.n_rows(); ++row)
          row_of[state_of_row(results, row)] = row;
      }

      /** The numbers as results.csv has them, so that a run that was resumed
       * or joined gives the same; NaN where a state was not solved or the cell
       * is empty. */
      std::vector<double> column(const std::string &name) const
      {
        std::vector<double> values(row_of.size(), unknown);
        for (std::size_t state = 0; state < row_of.size(); ++state)
          if (is_known(state))
            values[state] =
              results.written_number(row_of[state], name).value_or(unknown);
        return values;
      }

      /** 0 not computed, 1 solved, 2 no contact, 3 not solved. */
      std::vector<std::int8_t> status() const
      {
        std::vector<std::int8_t> values(row_of.size(), 0);
        for (std::size_t state = 0; state < row_of.size(); ++state)
          if (row_of[state] < results.n_rows())
            values[state] =
              1 +
              std::min(2,
                       static_cast<int>(status_of_row(results, row_of[state])));
        return values;
      }

      /** The columns that hold numbers; not the time they took, for the file of
       * a scene is to be the same in every run. */
      std::vector<std::string> numbers() const
      {
        std::vector<std::string> names;
        for (const std::string &column : results.columns())
          if (column != "state" && column != "converged" &&
              column != "wall_s" && results.has_numbers(column))
            names.push_back(column);
        return names;
      }

    private:
      bool is_known(const std::size_t state) const
      {
        if (row_of[state] == results.n_rows())
          return false;
        const TableStatus status = status_of_row(results, row_of[state]);
        return status == TableStatus::solved ||
               status == TableStatus::no_contact;
      }

      const ResultsTable      &results;
      std::vector<std::size_t> row_of; ///< of a state; n_rows() for none
    };

    std::vector<double> product(std::vector<double>        a,
                                const std::vector<double> &b)
    {
      for (std::size_t k = 0; k < a.size(); ++k)
        a[k] *= b[k];
      return a;
    }

    /**
     * The friction coefficient of each state.
     */
    std::vector<double> friction_of(const TablePlan &plan,
                                    const Situation &scene)
    {
      std::vector<double> mu(plan.values.size(),
                             scene.contact.friction_coefficient);
      for (std::size_t d = 0; d < plan.entries.size(); ++d)
        if (plan.entries[d] == "Contact/Friction coefficient")
          for (std::size_t state = 0; state < mu.size(); ++state)
            mu[state] = plan.values[state][d];
      return mu;
    }

    /**
     * Writes arrays over the states, each with its axes.
     */
    class TableFile
    {
    public:
      TableFile(const TablePlan &plan, const std::filesystem::path &path)
        : file(path)
      {
        for (const char *group : {"axes", "results", "bounds"})
          file.make_group(group);
        const bool is_grid = !plan.axes.empty();
        for (std::size_t d = 0; d < plan.entries.size(); ++d)
          {
            const std::string   name = "/axes/" + name_of_axis(plan.entries[d]);
            std::vector<double> values;
            if (is_grid)
              values = plan.axes[d].values;
            else
              for (const auto &state : plan.values)
                values.push_back(state[d]);
            file.write(name, {values.size()}, values);
            file.set_attribute(name, "entry", plan.entries[d]);
            file.set_attribute(name, "unit", plan.units[d]);
            names += (d == 0 ? "" : ", ") + name_of_axis(plan.entries[d]);
            if (is_grid)
              {
                axes.push_back(name);
                shape.push_back(values.size());
              }
          }
        if (!is_grid)
          shape = {plan.values.size()};
        file.set_attribute("/", "axes", names);
        file.set_attribute("/", "kind", is_grid ? "grid" : "rows");
      }

      template <typename Number>
      void add(const std::string         &path,
               const std::vector<Number> &values,
               const std::string         &unit)
      {
        file.write(path, shape, values);
        for (std::size_t d = 0; d < axes.size(); ++d)
          file.attach_axis(path, d, axes[d]);
        file.set_attribute(path, "unit", unit);
      }

      Hdf5File file;

    private:
      Hdf5File::Shape          shape;
      std::vector<std::string> axes;
      std::string              names;
    };
  } // namespace

  void write_table_file(const TablePlan &plan,
                        const Situation &scene,
                        RunContext      &context)
  {
    const std::string name = "table.h5";
    const TableArrays arrays(plan, context.results);
    TableFile         table(plan, context.folder.get_path() / name);
    table.file.set_attribute("/",
                             "program",
                             "rolling-contact " + context.report.version);
    table.file.write("/scene",
                     read_bytes(context.folder.get_path() / "used.prm"));
    table.add("/status", arrays.status(), "1");
    table.file.set_attribute("/status",
                             "meaning",
                             "0 not computed, 1 solved, 2 no contact, 3 not "
                             "solved");
    for (const std::string &column : arrays.numbers())
      {
        const std::string path = "/results/" + name_of_array(column);
        table.add(path, arrays.column(column), unit_of_column(column));
        table.file.set_attribute(path, "column", column);
      }
    const auto bound = [&](const std::string         &column,
                           const std::string         &relative,
                           const std::vector<double> &scale) {
      const auto &columns = context.results.columns();
      for (const std::string &name : {column, relative})
        if (std::find(columns.begin(), columns.end(), name) == columns.end())
          return;
      const auto values = product(arrays.column(relative), scale);
      table.add("/bounds/" + column, values, unit_of_column(column));
      table.file.set_attribute("/results/" + column,
                               "bound",
                               "/bounds/" + column);
    };
    const auto friction =
      product(friction_of(plan, scene), arrays.column("normal_force_N"));
    for (const char *component : {"force_x_N", "force_y_N"})
      bound(component, "bound_force/muN", friction);
    bound("spin_moment_Nm",
          "bound_moment/muNa",
          product(friction, arrays.column("half_width_x_m")));
    bound("max_pressure_Pa",
          "bound_max_pressure",
          arrays.column("max_pressure_Pa"));
    context.folder.write_atomically(name, table.file.bytes());
  }
} // namespace RollingContact
