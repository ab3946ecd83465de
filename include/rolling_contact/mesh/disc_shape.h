#ifndef rolling_contact_mesh_disc_shape_h
#define rolling_contact_mesh_disc_shape_h

#include <rolling_contact/mesh/body_shape.h>

namespace RollingContact
{
  /**
   * A disc that is held at its inner circle, in 3D with a crowned rim.
   */
  class DiscShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    void check(const unsigned int dimension, const bool rigid) const override;

    double thickness_below() const override;

    std::optional<Axle> axle() const override;

    std::optional<SectionMesh> section_about_axle() const override;

    double reach_x() const override;

    double largest_half_width() const override;

    double line_compression(const References::HertzLine &contact,
                            const double                 young_modulus,
                            const double poisson_ratio) const override;

    std::optional<References::Annulus>
    clamped_annulus(const double young_modulus,
                    const double poisson_ratio) const override;

    double largest_coarse_size() const override;

    std::unique_ptr<SurfaceChart>
    chart(const CoarseCells &cells) const override;

  protected:
    std::vector<double> dimensions() const override;
  };
} // namespace RollingContact

#endif
