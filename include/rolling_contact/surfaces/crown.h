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
     * The drop at y from the middle, with q = load/L:
     *
     *     q/(pi E*) ln(1/(1 - c (2 y/L)^2)).
     *
     * The crown of Lundberg (1939) has c = 1; its pressure is the same along
     * the whole length. The crown of Johns and Gohar (1981) has c = 1 - 0.3033
     * (2 b/L) and is finite at the ends. Lundberg's drop is infinite at the
     * end, so that its last thousandth of the half-length has the drop where
     * that part begins. A crown whose own length is given goes on along its
     * tangent beyond, as a chamfer does.
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
   * Throws InputError, naming the entry, if load or length is not a number
   * above 0.
   */
  std::optional<Crown> crown_named(const std::string &entry,
                                   const std::string &text);
} // namespace RollingContact

#endif
