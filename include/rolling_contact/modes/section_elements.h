#ifndef rolling_contact_modes_section_elements_h
#define rolling_contact_modes_section_elements_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <rolling_contact/mesh/material.h>
#include <rolling_contact/mesh/section_mesh.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Isoparametric finite elements on the quadrilaterals of a section, which are
   * divided towards singular corners, with nodes that are numbered. Units: m.
   */
  class SectionElements
  {
  public:
    /** @p clamped: nothing moves on the hub boundary. */
    SectionElements(const SectionMesh &section,
                    const Material    &material,
                    const bool         clamped,
                    const unsigned int degree);

    /** The nodes and weights that the value at a node is made of; none where it
     * is held. */
    std::vector<std::pair<dealii::types::global_dof_index, double>>
    parts_of(const dealii::types::global_dof_index node) const;

    /** Whether an edge of a cell is part of the hub. */
    static bool
    is_of_hub(const dealii::DoFHandler<2>::active_face_iterator &edge);

    const Material material;

  private:
    dealii::Triangulation<2> triangulation;

  public:
    const dealii::FE_Q<2>             element;
    dealii::MappingQCache<2>          mapping;
    dealii::DoFHandler<2>             dofs; ///< a number for each node
    dealii::AffineConstraints<double> constraints;

  private:
    void find_hub(const SectionMesh &section);

    /** Towards the singularities. */
    void refine(const bool clamped);

    /** Let cells follow the curves of the section. */
    void map(const SectionMesh &section);
  };
} // namespace RollingContact

#endif
