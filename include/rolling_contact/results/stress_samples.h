#ifndef rolling_contact_results_stress_samples_h
#define rolling_contact_results_stress_samples_h

#include <deal.II/base/symmetric_tensor.h>

#include <rolling_contact/bodies/elastic_body.h>

#include <array>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * What an element knows: its stress, and the strain xx, yy, xy of its face
   * in the surface of contact, if it has one, at their middles; in the
   * axes of the contact. Units: m, Pa, 1.
   */
  template <int dim>
  struct StressSample
  {
    dealii::Point<dim>            middle, middle_of_face;
    dealii::SymmetricTensor<2, 3> stress;
    bool                          has_face = false;
    std::array<double, 3>         strain{};

    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &middle &middle_of_face &stress &has_face &strain;
    }
  };

  /**
   * What the elements of a body on this rank and around its ghosts know, and
   * which of them lie around which. Collective.
   */
  template <int dim>
  class StressSamples
  {
  public:
    /**
     * The axes of the contact are turned about x by @p angle. Units: rad.
     */
    StressSamples(const ElasticBody<dim> &body,
                  const BodyField        &displacement,
                  const double            angle);

    /**
     * The elements around a vertex of an element of this rank, then those
     * around these.
     */
    std::pair<std::vector<unsigned int>, std::vector<unsigned int>>
    around(const unsigned int vertex);

    const StressSample<dim> &operator[](const unsigned int element) const
    {
      return samples[element];
    }

  private:
    /**
     * Learn what lies around ghosts from the ranks that own them.
     */
    void exchange();

    const dealii::DoFHandler<dim>         &dofs;
    std::vector<std::vector<unsigned int>> of_vertex; ///< cells
    std::vector<StressSample<dim>>         samples;
    std::vector<std::vector<unsigned int>> vertices, beyond; ///< of cells
    std::vector<unsigned int>              visited; ///< when last, of samples
    unsigned int                           visit = 0;
  };
} // namespace RollingContact

#endif
