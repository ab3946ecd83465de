#ifndef rolling_contact_scene_surface_parameters_h
#define rolling_contact_scene_surface_parameters_h

#include <rolling_contact/base/side.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <filesystem>
#include <memory>
#include <string>

namespace RollingContact
{
  class Entries;

  class HeightExpression;

  /**
   * Section `Surfaces`: heights of wheel and rail that pass through the contact
   * with the material.
   */
  struct SurfaceParameters
  {
    void declare(Entries &entries);

    /**
     * Rules across entries. Throws InputError.
     */
    void check(const unsigned int dimension) const;

    /**
     * Whether a surface moves.
     */
    bool in_use() const
    {
      return !height.wheel.empty() || !height.rail.empty();
    }

    /**
     * Whether a file gives heights, here or as @p roughness, which is
     * Contact/Roughness.
     */
    bool has_files(const std::string &roughness) const
    {
      return names_a_record(height.wheel) || names_a_record(height.rail) ||
             names_a_record(roughness);
    }

    /**
     * "Surfaces/Wheel height" or "Surfaces/Rail height".
     */
    static std::string entry(const Side side);

    PerSide<std::string> height;         ///< an expression, a file, or empty
    std::string          friction_share; ///< an expression, or empty
    double               position            = 0.; ///< m, rolled before t = 0
    double               shortest_wavelength = 0.; ///< m, or 0
    RecordUnits          units;
  };

  /**
   * Surfaces of wheel and rail: their entries, and the expressions and records
   * that those name.
   */
  struct SurfaceSpec : public SurfaceParameters
  {
    explicit SurfaceSpec(const SurfaceParameters &entries)
      : SurfaceParameters(entries)
    {}

    /**
     * Read expressions and records, and the file that @p roughness,
     * Contact/Roughness, may name; files are relative to the folder. Throws
     * InputError.
     */
    void read(const std::filesystem::path &folder,
              const std::string           &roughness);

    /** An expression or a record of each side, or none for a smooth one. */
    PerSide<std::shared_ptr<const SurfaceRecord>>    records;
    PerSide<std::shared_ptr<const HeightExpression>> expressions;
    std::shared_ptr<const HeightExpression>          share; ///< of mu; or none

    /** The file of Contact/Roughness, which stands; or none. */
    std::shared_ptr<const SurfaceRecord> standing;

    /** How far the wheel has rolled, `Position` included, while the run lasts.
     * Units: m. */
    double least_rolled = 0., most_rolled = 0.;
  };
} // namespace RollingContact

#endif
