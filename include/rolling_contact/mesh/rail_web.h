#ifndef rolling_contact_mesh_rail_web_h
#define rolling_contact_mesh_rail_web_h

#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/surfaces/outline.h>

#include <vector>

namespace RollingContact
{
  /**
   * Points from side to side at one height: columns from -1 to 1 over the inner
   * half-width, and so many of equal width beside them. Units: m.
   */
  std::vector<SectionPoint> row_with_sides(const SectionPoint &left,
                                           const SectionPoint &right,
                                           const double        inner_half,
                                           const std::vector<double> &columns,
                                           const unsigned int         beside);

  /**
   * The part of a rail's outline between head and foot, by its height over the
   * sole. Units: m.
   */
  class RailWeb
  {
  public:
    /**
     * Heights between which the outline is that of the web with its fillets.
     */
    static constexpr double top = 123.2e-3, bottom = 28.2e-3;

    /** Web of a rail whose field side has this outline, across and up. */
    explicit RailWeb(const Profiles::Outline &half_section);

    /**
     * Half the thickness.
     */
    double half(const double height) const;

    /**
     * Points from side to side: so many columns beside these, which take half
     * of the thickness.
     */
    std::vector<SectionPoint> row(const double               height,
                                  const std::vector<double> &columns,
                                  const unsigned int         beside) const;

  private:
    Profiles::Outline line;
  };
} // namespace RollingContact

#endif
