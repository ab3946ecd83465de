#ifndef rolling_contact_output_body_fields_h
#define rolling_contact_output_body_fields_h

#include <deal.II/lac/vector.h>

#include <rolling_contact/base/run_folder.h>
#include <rolling_contact/elasticity/elastic_body.h>

#include <string>

namespace RollingContact
{
  /**
   * From a body's own frame to the output: mirrored in z or not, then displaced
   * rigidly by shift_z, which the displacement shows and the mesh does not.
   * Units: m.
   */
  struct BodyPlacement
  {
    bool   mirrored = false;
    double shift_z  = 0.;
  };

  /**
   * Writes a VTU with the displacement and, constant in each cell, the stress
   * of its mean strain and the von Mises stress. @p displacement is that of
   * ElasticBody::recover(). Units: m, Pa. Throws InputError if the file cannot
   * be written.
   */
  template <int dim>
  void
  write_body_fields(const ElasticBody<dim>       &body,
                    const dealii::Vector<double> &displacement,
                    const BodyPlacement          &placement,
                    RunFolder                    &folder,
                    const std::string            &file_name);
} // namespace RollingContact

#endif
