#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/surfaces/roughness_levels.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const double reference_roughness = 1e-6; ///< m
    const double half_a_band         = 0.05; ///< of the decimal logarithm

    /** Piecewise linear, and so beyond the ends. */
    double interpolated(const std::vector<double> &x,
                        const std::vector<double> &y,
                        const double               at)
    {
      const std::size_t i = std::clamp<std::ptrdiff_t>(
        std::upper_bound(x.begin(), x.end(), at) - x.begin(), 1, x.size() - 1);
      return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
    }

    RoughnessLevels limit_of_rails()
    {
      return RoughnessLevels(iso_3095_limit,
                             {0.4,    0.315, 0.25,  0.2,    0.16, 0.125,
                              0.1,    0.08,  0.063, 0.05,   0.04, 0.0315,
                              0.025,  0.02,  0.016, 0.0125, 0.01, 0.008,
                              0.0063, 0.005, 0.004, 0.00315},
                             {17.1, 15.,  13.,  11.,  9.,    7.,   4.9,  2.9,
                              0.9,  -1.1, -3.2, -5.,  -5.6,  -6.2, -6.8, -7.4,
                              -8.,  -8.6, -9.2, -9.8, -10.4, -11.});
    }

    RoughnessLevels levels_of_record(const std::string           &source,
                                     const std::string           &entry,
                                     const std::string           &text,
                                     const std::filesystem::path &folder)
    {
      const SurfaceRecord record =
        read_surface_record(entry, text, folder, RecordUnits());
      const std::size_t   n = record.heights.size();
      std::vector<double> wavelengths, levels;
      if (n >= 4)
        for (const Signals::ThirdOctave &band :
             Signals::third_octaves(Signals::welch(record.heights,
                                                   record.spacing,
                                                   Signals::chosen_segment(n))))
          if (band.mean_square.value_or(0.) > 0.)
            {
              wavelengths.push_back(1 / band.centre);
              levels.push_back(
                Signals::level(*band.mean_square, reference_roughness));
            }
      if (wavelengths.size() < 2)
        throw InputError(source + ": the record has fewer than two third "
                                  "octaves of wavelength with four lines of "
                                  "its spectrum; give a longer one.");
      return RoughnessLevels(source, wavelengths, levels);
    }

    bool has_levels(const std::filesystem::path &file)
    {
      std::istringstream in(read_bytes(file));
      std::string        line;
      while (std::getline(in, line))
        if (!line.empty() && line[0] != '#')
          return line.find("wavelength_m") != std::string::npos ||
                 line.find("level_dB") != std::string::npos;
      return false;
    }
  } // namespace

  RoughnessLevels::RoughnessLevels(const std::string         &source,
                                   const std::vector<double> &wavelengths,
                                   const std::vector<double> &given)
  {
    std::map<double, double> sorted;
    for (std::size_t i = 0; i < wavelengths.size(); ++i)
      {
        if (!(wavelengths[i] > 0.))
          throw InputError(source + ": a wavelength is " +
                           significant(wavelengths[i], 6) +
                           " m; give lengths above 0.");
        if (!sorted.emplace(std::log10(wavelengths[i]), given.at(i)).second)
          throw InputError(source + ": the wavelength " +
                           significant(wavelengths[i], 6) +
                           " m is there twice.");
      }
    if (sorted.size() < 2)
      throw InputError(source + ": there is one wavelength; give the levels of "
                                "two or more third octaves.");
    for (const auto &[logarithm, level] : sorted)
      {
        logarithms.push_back(logarithm);
        levels.push_back(level);
      }
  }

  double RoughnessLevels::shortest() const
  {
    return std::pow(10., logarithms.front() - half_a_band);
  }

  double RoughnessLevels::longest() const
  {
    return std::pow(10., logarithms.back() + half_a_band);
  }

  double RoughnessLevels::level(const double wavelength) const
  {
    return interpolated(logarithms, levels, std::log10(wavelength));
  }

  double RoughnessLevels::density(const double wavelength) const
  {
    return reference_roughness * reference_roughness *
           std::pow(10., level(wavelength) / 10) / (std::log(10.) / 10);
  }

  void Roughness::add(const RoughnessLevels &levels)
  {
    shortest = std::max(shortest, levels.shortest());
    longest  = std::min(longest, levels.longest());
    surfaces.push_back(levels);
  }

  double Roughness::density(const double wavelength) const
  {
    double sum = 0.;
    for (const RoughnessLevels &it : surfaces)
      sum += it.density(wavelength);
    return sum;
  }

  RoughnessLevels roughness_levels(const std::string           &entry,
                                   const std::string           &text,
                                   const std::filesystem::path &folder)
  {
    if (text == iso_3095_limit)
      return limit_of_rails();
    const std::string source = entry + " = " + text;
    if (!names_a_record(text))
      throw InputError(source + ": give `" + iso_3095_limit +
                       "`, or FILE.csv with the columns wavelength_m and "
                       "level_dB, or with a record of heights in m.");
    if (names_a_map(text))
      throw InputError(source +
                       ": a map has no levels over one wavelength; "
                       "give `middle line: " +
                       text + "`.");
    const std::filesystem::path file = folder / text;
    if (!has_levels(file))
      return levels_of_record(source, entry, text, folder);
    const NamedRows table  = read_rows(entry, file);
    const auto      column = [&](const std::string &name) {
      const auto at = std::find(table.names.begin(), table.names.end(), name);
      if (at == table.names.end())
        throw InputError(source + ": there is no column " + name +
                         "; give wavelength_m and level_dB (re 1 um).");
      std::vector<double> values;
      for (const auto &row : table.rows)
        values.push_back(row[at - table.names.begin()]);
      return values;
    };
    return RoughnessLevels(source, column("wavelength_m"), column("level_dB"));
  }

  double directive_contact_filter(const double load, const double wavelength)
  {
    const std::vector<double> millimetres{2.5,  3.15, 4,   5,   6.3,  8,  10,
                                          12.5, 16,   20,  25,  31.5, 40, 50,
                                          63,   80,   100, 125, 160,  200};
    const std::vector<double> loads{25e3, 50e3, 100e3};
    const std::array<std::vector<double>, 3> filters{
      {{-24.2, -22.8, -22., -20.5, -18.2, -17.7, -16.8, -12.8, -7.9, -5.3,
        -3.3,  -1.8,  -1.1, -0.5,  -0.3,  -0.1,  0.,    0.,    0.,   0.},
       {-24.5, -24., -22.8, -21.8, -21.5, -18., -17.7, -16.8, -12., -8.,
        -5.3,  -3.5, -1.3,  -1.1,  -0.6,  -0.3, -0.1,  -0.1,  0.,   0.},
       {-24.7, -24.5, -24., -22.8, -22.1, -20.7, -17.8, -17.7, -16.7, -12.2,
        -8.7,  -5.4,  -3.2, -1.8,  -1.,   -0.6,  -0.3,  -0.2,  -0.1,  0.}}};
    if (load < loads.front() || load > loads.back())
      throw InputError("Rolling noise/Contact filter = table: the load is " +
                       significant(load, 4) +
                       " N, and the tables are for 25 to 100 kN; take `random "
                       "across` or `patch`.");
    std::vector<double> x;
    for (const double length : millimetres)
      x.push_back(std::log(1e-3 * length));
    const double at = std::clamp(std::log(wavelength), x.front(), x.back());
    std::vector<double> of_loads, logarithms;
    for (std::size_t i = 0; i < loads.size(); ++i)
      {
        logarithms.push_back(std::log(loads[i]));
        of_loads.push_back(interpolated(x, filters[i], at));
      }
    return interpolated(logarithms, of_loads, std::log(load));
  }
} // namespace RollingContact
