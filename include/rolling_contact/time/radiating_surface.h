#ifndef rolling_contact_time_radiating_surface_h
#define rolling_contact_time_radiating_surface_h

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/time/modal_sound.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <array>
#include <functional>

namespace RollingContact::Sound
{
  /**
   * The quadratic form of the motion of a body's outer surface along unit
   * vectors e(x), of given displacements u_i,
   *
   *   R_ij = int (n . e)^2 (u_i . e) (u_j . e) dS,
   *
   * over all faces but those where the body is held (the bore of a wheel, the
   * foot of a rail). Units: those of u squared times m^2.
   */
  class OuterSurface
  {
  public:
    using Direction =
      std::function<dealii::Tensor<1, 3>(const dealii::Point<3> &)>;

    /** Keeps a reference to the body. Columns of @p motions: values at its
     * unknowns, of the first @p n of them. */
    OuterSurface(const DirectBody<3> &body,
                 const DenseMatrix   &motions,
                 const std::size_t    n);

    DenseMatrix form(const Direction &direction) const;

    /** int (n . e)^2 dS. Units: m^2. */
    double area(const Direction &direction) const;

    /** Smallest and largest coordinates of the body. Units: m. */
    std::array<dealii::Point<3>, 2> box() const;

    /** Units: m^3. */
    double volume() const;

  private:
    const DirectBody<3>   &body;
    std::vector<BodyField> fields;
  };

  /**
   * A body of a scene by the sound of its modes up to a frequency, those of its
   * first columns. A body with an axle radiates along it and away from it, each
   * number of nodal diameters by itself, see axial_efficiency_of_wheel() and
   * radial_efficiency_of_wheel(); another one along y and z as a long beam
   * along x, see efficiency_of_cylinder(). Throws InputError if modes about an
   * axle have no nodal diameters that could be counted. Units: Hz.
   */
  RadiatingBody radiating_body(const VibratingBody<3> &body,
                               const double            maximum_frequency,
                               const Air              &air);
} // namespace RollingContact::Sound

#endif
