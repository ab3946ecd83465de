#ifndef rolling_contact_bodies_supports_h
#define rolling_contact_bodies_supports_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/mesh/shape_parameters.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Springs and masses at the hub boundary of a body on one rank, and the
   * unknowns they bring: three translations (in 2D two) for each sleeper, or
   * translations and rotations of the mass that the hub is fixed to. These are
   * numbered after the degrees of freedom of the mesh. Rotations are scaled by
   * a length, so that all unknowns are in m. Stiffness and inertia along x, y
   * and z are those along the axes of the hub, where a profile turns the body:
   * of a flat sole z is its normal, of a bore y is its axis.
   */
  template <int dim>
  class Supports
  {
  public:
    using Dof = dealii::types::global_dof_index;

    /**
     * What springs are spread over evenly, of one face of the hub boundary:
     * the integrals of the shape functions of its nodes and of their products,
     * over the area of all faces of a pad.
     */
    struct PadFace
    {
      std::vector<Dof>           nodes; ///< their first degrees of freedom
      std::vector<double>        shares;
      dealii::FullMatrix<double> products;
    };

    /**
     * Springs from the hub boundary to the ground or to a sleeper.
     */
    struct Pad
    {
      double               x      = 0.; ///< of its middle, m
      double               length = 0.; ///< along x that it stands for, m
      std::vector<PadFace> faces;
    };

    Supports() = default;

    /**
     * Find what lies at the hub boundary of a mesh. Throws InputError if no pad
     * lies wholly under the body.
     */
    Supports(const dealii::DoFHandler<dim> &dofs,
             const Hub                      hub,
             const BodyModel               &model);

    /**
     * Number of unknowns beside those of the mesh.
     */
    unsigned int n_extra() const;

    /**
     * How many of these, the first ones, are translations: number i is that
     * along component i modulo dim.
     */
    unsigned int n_translations() const;

    /**
     * x of a translation, for what varies along the body. Units: m.
     */
    double x_of_translation(const unsigned int i) const;

    /**
     * Constrain the nodes of the hub boundary that do not hang to move as the
     * rigid mass: u = t + r x (X - centre).
     */
    void tie_hub(dealii::AffineConstraints<double> &constraints) const;

    bool is_tied() const
    {
      return !hub_nodes.empty();
    }

    /**
     * Add the couplings of the extra unknowns among themselves and to pads.
     */
    void add_couplings(const dealii::AffineConstraints<double> &constraints,
                       dealii::DynamicSparsityPattern          &pattern) const;

    /**
     * Add @p of_foundation times the stiffness of layer or pads and
     * @p of_ballast times that of the ballast. Units: N/m.
     */
    void add_stiffness(const dealii::AffineConstraints<double> &constraints,
                       const double                             of_foundation,
                       const double                             of_ballast,
                       dealii::SparseMatrix<double>            &K) const;

    /**
     * An entry of a matrix of the extra unknowns, numbered from 0.
     */
    struct Entry
    {
      unsigned int i, j;
      double       value;
    };

    /**
     * Masses of the extra unknowns, of rotations over the square of their
     * length; both triangles. Units: kg.
     */
    std::vector<Entry> masses() const;

  private:
    /**
     * Sum of a value of each axis times the square of its direction.
     */
    dealii::Tensor<2, dim>
    along_axes(const std::array<double, 3> &values) const;

    /** Degrees of freedom of the nodes of a face, and of the sleeper. */
    std::vector<Dof> ends_of(const PadFace &face, const std::size_t pad) const;

    void find_pads(const dealii::DoFHandler<dim> &dofs);

    void find_hub(const dealii::DoFHandler<dim> &dofs);

    Foundation       foundation;
    HubMass          hub_mass;
    Dof              first_extra = 0;
    std::vector<Pad> springs;
    /**
     * Nodes of a tied hub by their first degree of freedom, and their places
     * relative to the centre. Units: m.
     */
    std::vector<std::pair<Dof, dealii::Tensor<1, dim>>> hub_nodes;
    double lever = 1.; ///< scale of rotations, m
    /** Axes of the hub, by rows: z off a sole, y along a bore. */
    dealii::Tensor<2, dim> axes;
  };
} // namespace RollingContact

#endif
