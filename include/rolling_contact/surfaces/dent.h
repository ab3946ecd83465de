#ifndef rolling_contact_surfaces_dent_h
#define rolling_contact_surfaces_dent_h

#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * A place where a surface lacks material, the same across. Units: m.
   */
  struct Dent
  {
    enum class Kind
    {
      flat,
      dip
    };

    /**
     * Height at an arc X from the middle, 0 beyond half of the length L.
     * A flat, the chord that sliding grinds off a disc of radius R:
     *   z = R (cos(phi_0)/cos(X/R) - 1), sin(phi_0) = L/(2 R),
     * L^2/(8 R) deep. A dip, as of a flat whose edges are rolled round:
     *   z = -depth cos^2(pi X/L).
     */
    double height(const double X, const double radius) const;

    Kind   kind;
    double length;
    double depth = 0.; ///< of a dip
  };

  /**
   * The dent that a text names, `flat : LENGTH` or `dip : LENGTH, DEPTH`; none
   * for another text. Throws InputError, naming the entry, if these are no
   * numbers above 0.
   */
  std::optional<Dent> dent_named(const std::string &entry,
                                 const std::string &text);
} // namespace RollingContact

#endif
