#ifndef rolling_contact_surfaces_roughness_levels_h
#define rolling_contact_surfaces_roughness_levels_h

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Roughness of a running surface as levels of third octaves of wavelength,
   *
   *   L = 10 lg(r^2 / (1 um)^2),     r^2 the mean square of the band,
   *
   * linear in the logarithm of the wavelength in between, and up to half a band
   * beyond the first and the last. Units: m, dB.
   */
  class RoughnessLevels
  {
  public:
    /** Throws InputError, beginning with @p source, unless there are two or
     * more different wavelengths above 0. */
    RoughnessLevels(const std::string         &source,
                    const std::vector<double> &wavelengths,
                    const std::vector<double> &levels);

    double shortest() const;

    double longest() const;

    double level(const double wavelength) const;

    /** Mean square for each unit of the logarithm of the wavelength: of a whole
     * third octave ln(10)/10 times as much. Units: m^2. */
    double density(const double wavelength) const;

  private:
    std::vector<double> logarithms, levels;
  };

  /**
   * The roughness of surfaces that roll over each other, which adds in energy,
   * and the waves for which it is known of all. Units: m.
   */
  class Roughness
  {
  public:
    void add(const RoughnessLevels &levels);

    /** See RoughnessLevels::density(). Units: m^2. */
    double density(const double wavelength) const;

    double shortest = 0.;
    double longest  = std::numeric_limits<double>::infinity();

  private:
    std::vector<RoughnessLevels> surfaces;
  };

  /** What the text of an entry calls the limit curve of rails for tests of
   * noise, ISO 3095:2013. */
  inline constexpr char iso_3095_limit[] = "ISO 3095 limit";

  /**
   * The levels that an entry gives: `ISO 3095 limit`, a file with the columns
   * `wavelength_m` and `level_dB`, or a record of heights in m, as
   * read_surface_record() takes it, whose third octaves with four or more lines
   * of its spectrum count. Throws InputError.
   */
  RoughnessLevels roughness_levels(const std::string           &entry,
                                   const std::string           &text,
                                   const std::filesystem::path &folder);

  /**
   * Contact filter of the directive (EU) 2021/1226 for a wheel of 920 mm: what
   * the load's roughness is below that of the surface, over the wavelength
   * (m), at a load between 25 and 100 kN, in between by the logarithms of
   * both. Throws InputError beyond these loads. Units: N, m; dB.
   */
  double directive_contact_filter(const double load, const double wavelength);
} // namespace RollingContact

#endif
