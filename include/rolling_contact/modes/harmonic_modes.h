#ifndef rolling_contact_modes_harmonic_modes_h
#define rolling_contact_modes_harmonic_modes_h

#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/material.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/modes/structural_modes.h>

#include <utility>

namespace RollingContact
{
  /**
   * A body of revolution by its section.
   */
  struct RevolvedBody
  {
    SectionMesh section; ///< along the axle and from it, m
    Axle        axle;
    Material    material;
    bool        clamped = true; ///< at its hub, else free
  };

  /** How modes by Fourier series about the axle were found. */
  struct HarmonicAccuracy
  {
    unsigned int most_diameters = 0; ///< nodal diameters of any mode
    std::size_t  n_unknowns =
      0; ///< of the section, for each number of diameters

    /**
     * The largest difference of a frequency from that of elements one degree
     * lower, over it: a bound of the error of these.
     */
    double lower_degree_error = 0.;
  };

  /**
   * All modes up to the cut-off of HarmonicSection, cubic elements, with 0, 1,
   * ... nodal diameters until two numbers in a row have none. Shapes are values
   * at the unknowns of a mesh of the body, of whose @p places they are taken;
   * they are of unit modal mass by the section, so that only their
   * interpolation knows that mesh. Each mode with nodal diameters is there
   * twice, once turned by a quarter of a wave. Throws ConvergenceError as
   * structural_modes() does.
   */
  std::pair<StructuralModes, HarmonicAccuracy>
  harmonic_modes(const RevolvedBody &body,
                 const BodyPlaces   &places,
                 const std::size_t   n_unknowns,
                 const ModeControls &controls);
} // namespace RollingContact

#endif
