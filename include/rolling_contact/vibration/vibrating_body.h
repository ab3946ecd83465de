#ifndef rolling_contact_vibration_vibrating_body_h
#define rolling_contact_vibration_vibrating_body_h

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/modes/absorbers.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/modes/harmonic_modes.h>
#include <rolling_contact/modes/mode_character.h>
#include <rolling_contact/modes/structural_modes.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/modes_parameters.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/vibration/rail_waves.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * An elastic body of a scene without contact: its mesh, which has no zone of
   * contact nodes, its matrices, the factor of K + shift M, and its modes up to
   * a frequency.
   */
  template <int dim>
  struct VibratingBody
  {
    /**
     * Build all of it and tell the log. Units: Hz. Throws ConvergenceError if
     * the modes are not those that the inertia counts.
     */
    VibratingBody(const PairSpec        &scene,
                  const Side             side,
                  const ModesParameters &wanted,
                  const double           cut_off,
                  RunContext            &context);

    /**
     * Vibrating body made of a body that rolls, with its mesh and the factor of
     * K, which must outlive this.
     */
    VibratingBody(const PairSpec        &scene,
                  const Side             side,
                  const ModesParameters &wanted,
                  const DirectBody<dim> &rolling,
                  const double           cut_off,
                  RunContext            &context);

    /**
     * Damping ratio of each mode that the scene gives, by nodal diameters and
     * for single modes. Throws InputError for a single mode that there is not.
     */
    std::vector<double> given_damping() const;

    /**
     * Where the absorbers that the scene gives the body hang on it; empty if
     * it has none. Tells the log, and warns of modes up to a frequency with
     * more nodal diameters than they act on as a continuous ring. Units: Hz.
     * Throws InputError if there is no place for them.
     */
    AbsorberPlaces absorbers(const double highest, RunContext &context) const;

    /** The modes as fields of the unknowns, by columns, 1/kg^(1/2); of those
     * that stand for waves what they move of the mesh. From any thread. */
    const DenseMatrix &mode_shapes() const;

    /** Places of the nodes. Units: m. */
    std::vector<RailWaves::Place> points() const;

    /** Displacements of points() along x, y and z, by columns, at the unknowns.
     */
    template <class Matrix>
    Matrix at_unknowns(const Matrix &moved) const;

    /** Whether it is a rail by waves in its section. */
    bool is_without_ends() const
    {
      return dim == 3 && parameters.modes == ModeModel::waveguide;
    }

    const Side             side;
    const BodySpec         parameters;
    const DirectBody<dim> *body;
    BodyPlaces             places;
    SymmetricSparseMatrix  K, M, H, C;
    double                 shift; ///< 1/s^2
    const Factorisation   *factor;
    StructuralModes        modes;

    /** Set where the modes are those of the section, see harmonic_modes(). */
    std::optional<HarmonicAccuracy> harmonics;

    /** Set where the body is a rail without ends. In contact its modes are
     * those that stand for waves, alone it has none. */
    std::unique_ptr<RailWaves> waves;

    std::vector<ModeCharacter> characters;

  private:
    VibratingBody(const PairSpec                  &scene,
                  const Side                       side,
                  std::unique_ptr<DirectBody<dim>> own,
                  const DirectBody<dim>           *body,
                  const double                     shift);

    void find_matrices(RunContext &context);

    void factorise(RunContext &context);

    void find_modes(const ModesParameters &wanted,
                    const double           cut_off,
                    RunContext            &context);

    void find_modes_of_section(const ModeControls &controls);

    void find_waves(const ModesParameters &wanted,
                    const double           cut_off,
                    RunContext            &context);

    /** Let modes stand for the waves of a rail in contact. */
    void take_modes_of_waves(RunContext &context);

    void report_modes(const ModesParameters &wanted, RunContext &context) const;

    /** What the modes were found in. */
    std::string searched() const;

    std::vector<double> damping_of_single_modes() const;

    void warn_of_diameters(const std::vector<AbsorberRing> &rings,
                           const double                     highest,
                           RunContext                      &context) const;

    void warn_of_pairs(const std::optional<double> &speed,
                       RunContext                  &context) const;

    mutable DenseMatrix              shapes_of_waves; ///< once asked for
    mutable std::once_flag           has_shapes;
    std::unique_ptr<DirectBody<dim>> own_body;
    std::unique_ptr<Factorisation>   own_factor;
  };
} // namespace RollingContact

#endif
