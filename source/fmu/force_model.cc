#include <rolling_contact/fmu/program_forces.h>
#include <rolling_contact/fmu/resources.h>

#include <fstream>
#include <iterator>

namespace RollingContact::Fmu
{
  namespace
  {
    /** Forces of a table, for which nothing has to be remembered. */
    class TableForces : public ForceModel
    {
    public:
      explicit TableForces(const std::string &bytes)
        : model(WheelsetModel::of_bytes(bytes))
      {
        wheelset = model;
      }

      ForceKind kind() const override
      {
        return ForceKind::table;
      }

      Forces forces(const Inputs &inputs,
                    const double  least_speed,
                    const std::string &,
                    const std::string &) override
      {
        return {model.evaluate(inputs, least_speed), ""};
      }

    private:
      const WheelsetModel model;
    };
  } // namespace

  std::optional<std::string> content_of(const std::string &file)
  {
    std::ifstream in(file, std::ios::binary);
    if (!in)
      return {};
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  std::unique_ptr<ForceModel> ForceModel::of_folder(const std::string &folder)
  {
    std::string file = folder + '/' + values_file;
    try
      {
        if (const auto values = content_of(file))
          return std::make_unique<ProgramForces>(*values,
                                                 folder + '/' + scene_file);
        file = folder + '/' + table_file;
        if (const auto table = content_of(file))
          return std::make_unique<TableForces>(*table);
        throw std::invalid_argument("there is no such file");
      }
    catch (const std::invalid_argument &problem)
      {
        throw std::invalid_argument(file + ": " + problem.what());
      }
  }
} // namespace RollingContact::Fmu
