#ifndef rolling_contact_mesh_mesh_file_shape_h
#define rolling_contact_mesh_mesh_file_shape_h

#include <rolling_contact/mesh/body_shape.h>

namespace RollingContact
{
  /**
   * A body whose mesh comes from a file, held at the file's hub boundary.
   */
  class MeshFileShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    void check(const unsigned int dimension, const bool rigid) const override;

    double thickness_below() const override;

    std::optional<Axle> axle() const override;

    double reach_x() const override;

    double reach_y() const override;

    std::shared_ptr<const FileMesh> mesh() const override;

  protected:
    std::vector<double> dimensions() const override;
  };
} // namespace RollingContact

#endif
