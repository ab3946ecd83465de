#ifndef rolling_contact_mesh_block_shape_h
#define rolling_contact_mesh_block_shape_h

#include <rolling_contact/mesh/body_shape.h>

namespace RollingContact
{
  /**
   * A block under two circular profiles that is held at its bottom.
   */
  class BlockShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    void check(const unsigned int dimension, const bool rigid) const override;

    double thickness_below() const override;

    double reach_x() const override;

    std::unique_ptr<SurfaceChart>
    chart(const CoarseCells &cells) const override;

  protected:
    std::vector<double> dimensions() const override;
  };
} // namespace RollingContact

#endif
