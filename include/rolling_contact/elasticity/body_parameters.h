#ifndef rolling_contact_elasticity_body_parameters_h
#define rolling_contact_elasticity_body_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/mesh/geometry.h>

#include <string>

namespace RollingContact
{
  /**
   * Section `Wheel` or `Rail`: shape and material of one body.
   */
  struct BodyParameters : public dealii::ParameterAcceptor
  {
    explicit BodyParameters(const std::string &section);

    /**
     * Rules across entries. Throws InputError.
     */
    void
    check(const unsigned int dimension) const;

    BodyGeometry
    geometry() const;

    std::string section;
    std::string shape          = "disc";
    bool        rigid          = false;
    double      radius         = 0.46;
    double      lateral_radius = 0.;
    double      hub_radius     = 0.08;
    double      block_length   = 1.;
    double      block_depth    = 0.5;
    double      thickness      = 0.02;
    double      width          = 0.1;
    std::string hub            = "clamped";
    Material    material       = {210e9, 0.3};
  };
} // namespace RollingContact

#endif
