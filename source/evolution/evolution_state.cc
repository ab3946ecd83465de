#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/evolution/evolution_state.h>

#include <sstream>

namespace RollingContact
{
  namespace
  {
    /** The numbers of curves, three for each point. */
    using Numbers = std::vector<std::vector<std::vector<double>>>;

    Numbers numbers_of(const std::vector<RunningSurfaces::Side> &sides)
    {
      Numbers found;
      for (const RunningSurfaces::Side &side : sides)
        {
          found.emplace_back();
          for (const Profiles::ProfileCurve &curve : side)
            {
              found.back().emplace_back();
              for (const Profiles::CurvePoint &point : curve.points())
                for (const double value : {point.y, point.z, point.angle})
                  found.back().back().push_back(value);
            }
        }
      return found;
    }

    Profiles::ProfileCurve curve_of(const std::vector<double> &values)
    {
      std::vector<Profiles::CurvePoint> points;
      for (std::size_t k = 0; k + 2 < values.size(); k += 3)
        points.push_back({values[k], values[k + 1], values[k + 2]});
      return Profiles::ProfileCurve(points);
    }

    std::vector<RunningSurfaces::Side> sides_of(const Numbers &numbers)
    {
      std::vector<RunningSurfaces::Side> found;
      for (const auto &side : numbers)
        found.push_back({{curve_of(side.at(0)), curve_of(side.at(1))}});
      return found;
    }

    template <class Archive>
    void
    pass(Archive &archive, EvolutionState &state, std::vector<Numbers> &curves)
    {
      archive &state.duty &state.now.step &state.now.share &state.now.error;
      archive &state.now.depth &state.next_share &state.results &state.rows;
      archive &state.shares &curves;
    }
  } // namespace

  std::string text_of(const EvolutionState &state)
  {
    std::vector<Numbers> curves;
    for (const auto &sides : state.curves)
      curves.push_back(numbers_of(sides));
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream);
    EvolutionState                  copy = state;
    pass(archive, copy, curves);
    return stream.str();
  }

  EvolutionState read_evolution_state(const std::filesystem::path &file)
  {
    try
      {
        EvolutionState       state;
        std::vector<Numbers> curves;
        std::string          bytes;
        Ranks::on_root([&]() { bytes = read_bytes(file); });
        Ranks::broadcast(bytes);
        std::istringstream              stream(bytes);
        boost::archive::binary_iarchive archive(stream);
        pass(archive, state, curves);
        for (const Numbers &numbers : curves)
          state.curves.push_back(sides_of(numbers));
        if (state.curves.empty() || state.curves.size() != state.shares.size())
          throw std::invalid_argument("no curves");
        return state;
      }
    catch (const std::exception &)
      {
        throw InputError(file.string() +
                         " is not the state of an evolution of profiles as "
                         "this program wrote it. Start the run without "
                         "--resume.");
      }
  }
} // namespace RollingContact
