#ifndef rolling_contact_results_nodal_stress_h
#define rolling_contact_results_nodal_stress_h

#include <deal.II/base/symmetric_tensor.h>

#include <rolling_contact/bodies/elastic_body.h>

#include <array>
#include <map>
#include <vector>

namespace RollingContact
{
  /**
   * Stresses zz, xz and yz that the tractions on the surface of a body give at
   * its contact nodes, by the number of their first degree of freedom; axes of
   * the contact, z out of the body. Units: Pa.
   */
  using SurfaceTractions =
    std::map<dealii::types::global_dof_index, std::array<double, 3>>;

  /**
   * A stress and what it may be off by, the Frobenius norm. Units: Pa.
   */
  struct StressValue
  {
    dealii::SymmetricTensor<2, 3> stress;
    double                        error = 0.;
  };

  /**
   * The stress at the nodes of a body, recovered from that of the mean strains
   * of elements, which is most exact in their middles (Zienkiewicz & Zhu 1992):
   * the value in the node of the complete quadratic polynomial through the
   * elements around it and around these, of which the first count ten times as
   * much; its error is estimated by its difference from that of the linear one.
   * Where the tractions on the surface are known they are the stress, and the
   * others follow by the law from the strain in the surface, which is recovered
   * likewise from its faces: sigma_xx = E/(1 - nu^2) (eps_xx + nu eps_yy) +
   * nu/(1 - nu) sigma_zz; the error there is estimated by the difference from
   * what the elements alone give. In the axes of the contact, which are turned
   * about x by @p angle, rad; plane strain in 2D. The same on any number of
   * ranks. Collective.
   */
  template <int dim>
  class NodalStress
  {
  public:
    NodalStress(const ElasticBody<dim> &body,
                const BodyField        &displacement,
                const double            angle,
                const SurfaceTractions &tractions);

    /**
     * At a vertex of a cell of this rank, by its index in the mesh.
     */
    const StressValue &at(const unsigned int vertex) const
    {
      return values[vertex];
    }

  private:
    std::vector<StressValue> values;
  };
} // namespace RollingContact

#endif
