#ifndef rolling_contact_vibration_rail_waves_h
#define rolling_contact_vibration_rail_waves_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/modes/modal_fit.h>
#include <rolling_contact/modes/waveguide_response.h>
#include <rolling_contact/scene/body_parameters.h>

#include <map>
#include <memory>
#include <vector>

namespace RollingContact
{
  /** Frequencies that a rail without ends is looked at in. Units: Hz. */
  struct WaveRange
  {
    double lowest  = 50.;
    double highest = 5000.;

    /** Up to which the section's own waves are all there. */
    double cut_off = 10000.;
  };

  /**
   * How a rail without ends answers forces at the contact, as its section says,
   * see Waveguide. The contact point moves along x, y and z, and the head turns
   * about x, by which points beside move up: four motions of a patch, and four
   * forces on it. At rest the body is what its mesh says; what a frequency
   * changes of that, which is smooth at the patch, is told here:
   *
   *   alpha(s) = (W + B beyond B^T) / kappa(s) + B change(s) B^T,
   *   change(s) = alpha_w(s) - alpha_w(0) / kappa(s),
   *
   * alpha_w of the waves, kappa = 1 + eta s / |Im s| + beta s of the material.
   */
  class RailWaves
  {
  public:
    using Complex = std::complex<double>;
    using Place   = Waveguide::Place;

    static constexpr unsigned int n_motions = 4;

    /** Throws InputError for a body that is not extruded. */
    RailWaves(const BodySpec              &body,
              const WaveRange             &range,
              const std::function<void()> &interrupt);

    /** Find the modes that stand for it where bodies must have modes. */
    void find_modes(const std::function<void()> &interrupt);

    /** What find_modes() found. */
    const FittedModes &modes() const
    {
      return fit;
    }

    /** What a frequency changes of the four motions; @p added_damping: a ratio
     * as modes have it. Units: 1/s, m/N. */
    ComplexMatrix change(const Complex s,
                         const double  added_damping = 0.) const;

    /** What a frequency changes of the displacements of places along x, y and
     * z under forces there. Units: 1/s, m/N. */
    ComplexMatrix change(const Complex             s,
                         const std::vector<Place> &places) const;

    /** alpha_w(0). Units: m/N. */
    const DenseMatrix &at_rest() const
    {
      return rest;
    }

    /**
     * What a rail without ends is softer by at rest than its mesh, which ends
     * and is of finite elements, in the four motions. It is smooth at the
     * contact and extrapolated to there from places beside, where no field of
     * the load alone is. @p factor: of K of the mesh. Throws InputError if the
     * mesh does not reach as far. Units: m/N.
     */
    DenseMatrix beyond_mesh(const DirectBody<3> &mesh,
                            const Factorisation &factor) const;

    /** As much of the displacements of places along x, y and z under forces
     * there. Units: m/N. */
    DenseMatrix beyond_mesh(const DirectBody<3>      &mesh,
                            const Factorisation      &factor,
                            const std::vector<Place> &places) const;

    /** The largest difference of change() from what polynomials of a lower
     * degree in the section and less fields say, in the range, over the largest
     * of change() at that frequency. */
    double lower_degree_error(const std::function<void()> &interrupt) const;

    /** kappa(s). Units: 1/s. */
    Complex stiffening(const Complex s, const double added_damping = 0.) const
    {
      return waves->stiffening(s, damping.loss_factor, added_damping);
    }

    /** Displacement of a point of the running surface along x, y and z by the
     * four motions: 3 x 4 values. */
    DenseMatrix motions_at(const Place &point) const;

    /**
     * Displacements of all places, x, y and z one after the other, under the
     * four forces. Units: 1/s, m/N.
     */
    ComplexMatrix field(const Complex             s,
                        const std::vector<Place> &places) const;

    /**
     * A field for each mode of the fit, by columns, that is its motion at the
     * contact and elsewhere that of forced waves at its frequency. Units:
     * 1/kg^(1/2).
     */
    DenseMatrix shapes(const std::vector<Place> &places) const;

    /**
     * int of quadratic forms of the amplitudes of the section's fields over the
     * whole rail, see WaveguideResponse::integrals(), as forms of the four
     * forces: 4 x 4. Units: 1/s.
     */
    std::vector<ComplexMatrix>
    integrals(const Complex                     s,
              const std::vector<ComplexMatrix> &forms,
              const double                      added_damping = 0.) const;

    const Waveguide &waveguide() const
    {
      return *waves;
    }

    std::size_t n_sampled() const
    {
      return sampled;
    }

  private:
    std::unique_ptr<const Waveguide>
    waveguide_of(const double                 cut_off,
                 const std::function<void()> &interrupt,
                 const unsigned int           degree) const;

    /** Throws InputError unless the mesh reaches to all places where it is
     * compared with waves. */
    void require_mesh_around(const std::vector<Place> &places) const;

    /** Displacements under forces along x, y and z at both places, N. */
    ComplexMatrix field(const WaveguideResponse  &response,
                        const std::vector<Place> &at,
                        const ComplexMatrix      &forces) const;

    /** Rate of what is as slow as at rest, 1/s. */
    Complex at_rest_rate() const;

    /** alpha_w. */
    ComplexMatrix at_contact(const Complex s,
                             const double  added_damping = 0.) const;

    const BodySpec                   body;
    const BodyDamping               &damping;
    const WaveRange                  range;
    std::vector<Place>               places; ///< beside the contact point
    std::unique_ptr<const Waveguide> waves;
    DenseMatrix                      rest;
    FittedModes                      fit;
    std::size_t                      sampled = 0;

    /** alpha_w(0) of other places. */
    mutable std::map<std::vector<Place>, DenseMatrix> known_rest;
  };
} // namespace RollingContact

#endif
