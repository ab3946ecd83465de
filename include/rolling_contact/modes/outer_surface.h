#ifndef rolling_contact_modes_outer_surface_h
#define rolling_contact_modes_outer_surface_h

#include <rolling_contact/bodies/direct_body.h>

#include <array>
#include <functional>
#include <vector>

namespace RollingContact
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
} // namespace RollingContact

#endif
