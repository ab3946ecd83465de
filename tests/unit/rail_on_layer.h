#ifndef rolling_contact_tests_rail_on_layer_h
#define rolling_contact_tests_rail_on_layer_h

#include <rolling_contact/scene/body_parameters.h>

/** The rail of rail_waves.prm, its mesh as short as a test needs it. */
inline void set_rail_on_layer(RollingContact::BodyParameters &rail,
                              const double                    length,
                              const unsigned int              cells)
{
  using namespace RollingContact;
  rail.shape                        = "section";
  rail.mesh_file                    = "sections/rail_2.msh";
  rail.radius                       = 0.;
  rail.lateral_radius               = 0.3;
  rail.block_length                 = length;
  rail.cells_along                  = cells;
  rail.hub                          = Hub::elastic;
  rail.modes                        = ModeModel::waveguide;
  rail.model.elements               = ElementKind::enhanced;
  rail.model.foundation.stiffness   = {{5e7, 5e7, 3.3e8}};
  rail.model.foundation.loss_factor = 0.2;
  rail.model.damping.loss_factor    = 0.02;
  rail.material                     = {210e9, 0.3, 7850.};
}

#endif
