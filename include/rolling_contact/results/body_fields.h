#ifndef rolling_contact_results_body_fields_h
#define rolling_contact_results_body_fields_h

#include <rolling_contact/bodies/elastic_body.h>
#include <rolling_contact/results/nodal_stress.h>
#include <rolling_contact/run/pvd.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/state/steady_state.h>

#include <functional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * From a body's own frame to the output: in the axes of the contact, mirrored
   * in z or not, then displaced rigidly by shift_z, which the displacement
   * shows and the mesh does not; and the tractions on its surface, as far as
   * they are known. Units: m, Pa.
   */
  struct BodyPlacement
  {
    bool             mirrored  = false;
    double           shift_z   = 0.;
    AxesOfContact    axes      = {};
    SurfaceTractions tractions = {};
  };

  /**
   * The recovered tractions of a state on one of its bodies; none where the
   * surface of contact is curved or the body has contact nodes of its own, from
   * a file.
   */
  template <int dim>
  SurfaceTractions surface_tractions(const SteadyState<dim> &steady,
                                     const Side              side);

  /**
   * Writes name.vtu, of a distributed body name.pvtu and a piece of each rank,
   * with the displacement, the stress of NodalStress, the von Mises stress and
   * the estimated error of the stress at the nodes. @p displacement is that of
   * ElasticBody::recover(). Collective: @p rank has the body if it is on one
   * rank alone, on others @p body is nullptr; errors are thrown on all. Returns
   * the name of the file. Units: m, Pa. Throws InputError if a file cannot be
   * written.
   */
  template <int dim>
  std::string write_body_fields(const ElasticBody<dim> *body,
                                const unsigned int      rank,
                                const BodyField        &displacement,
                                const BodyPlacement    &placement,
                                RunFolder              &folder,
                                const std::string      &name);

  /**
   * Writes the elastic bodies of a state, displaced by @p displacement, under
   * the names that @p file_name makes of `wheel` and `rail`; what belongs into
   * a collection at @p time. Throws InputError if a file cannot be written.
   * Collective. Units: s.
   */
  template <int dim>
  std::vector<PvdBlock>
  write_bodies(const SteadyState<dim>               &steady,
               const std::function<BodyField(Side)> &displacement,
               const std::function<std::string(const std::string &)> &file_name,
               const double                                           time,
               RunFolder                                             &folder);
} // namespace RollingContact

#endif
