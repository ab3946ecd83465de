#ifndef rolling_contact_surfaces_crown_h
#define rolling_contact_surfaces_crown_h

#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * A crown of a roller against the pressure at its ends: a drop of the surface
   * over y that a load asks for. Units: m, N, Pa.
   */
  struct Crown
  {
    enum class Kind
    {
      lundberg,
      johns_gohar
    };

    /**
     * The contact that the drop is for.
     */
    struct Roller
    {
      double length;     ///< L, from side to side
      double half_width; ///< b, Hertz's under the load over the length
      double modulus;    ///< E*
    };

    /**
     * The drop at y from the middle, q = load/L:
     *   q/(pi E*) ln(1/(1 - c (2 y/L)^2)),
     * with c = 1 the crown of Lundberg (1939), whose pressure is the same all
     * along, and with c = 1 - 0.3033 (2 b/L) that of Johns and Gohar (1981),
     * which is finite at the ends. In the last thousandth of the half-length
     * that of Lundberg has the drop of its beginning, as it is infinite at the
     * end. A crown with a length of its own falls along its tangent beyond, as
     * a chamfer does.
     */
    double drop(const double y, const Roller &roller) const;

    Kind   kind;
    double load; ///< N, over the whole length
    /** Own length in place of the contact's, as of a roller with rounded ends;
     * none: from side to side. */
    std::optional<double> length = {};
  };

  /**
   * The crown that a text names, `lundberg : LOAD` or `johns-gohar : LOAD`,
   * each with `: LENGTH` behind it if it has its own; none for another text.
   * Throws InputError, naming the entry, if load or length is no number above
   * 0.
   */
  std::optional<Crown> crown_named(const std::string &entry,
                                   const std::string &text);
} // namespace RollingContact

#endif
