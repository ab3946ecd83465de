#ifndef rolling_contact_scene_mesh_parameters_h
#define rolling_contact_scene_mesh_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace RollingContact
{
  /**
   * Section `Mesh`: element sizes, measured in the patch of the Hertz estimate.
   */
  struct MeshParameters : public dealii::ParameterAcceptor
  {
    MeshParameters();

    /**
     * True if the mesh is to follow the leading edge it finds.
     */
    bool
    aligned() const
    {
      return patch_offset == "aligned";
    }

    /**
     * The given offset, 0 when aligned. Throws InputError.
     */
    double
    offset() const;

    void
    check() const;

    unsigned int elements_across_patch   = 48;
    unsigned int elements_across_patch_y = 0;
    std::string  patch_offset            = "0";
    double       candidate_zone          = 0.;
    double       zone_depth              = 0.75;
    double       growth                  = 0.1;
    unsigned int rim_levels              = 0;
    std::string  rim_edges               = "leading";
    unsigned int adaptive_levels         = 0;
    std::string  level_marking           = "adaptive";
    unsigned int contact_node_budget     = 2000;
    double       target_change           = 1e-3;

  private:
    void
    declare_patch();

    void
    declare_zone();

    void
    declare_levels();
  };
} // namespace RollingContact

#endif
