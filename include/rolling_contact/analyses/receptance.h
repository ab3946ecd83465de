#ifndef rolling_contact_analyses_receptance_h
#define rolling_contact_analyses_receptance_h

#include <rolling_contact/analyses/receptance_parameters.h>
#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Analysis = receptance: how much each elastic body moves under a harmonic
   * force of 1 N, at its contact point and between named places, over
   * frequency: receptances.csv, pictures, and the error of the modes where the
   * whole structure is solved as well.
   */
  template <int dim>
  class Receptance : public Analysis
  {
  public:
    Receptance(const Situation &scene, RunContext &context)
      : scene(scene)
      , section(scene.inputs->own<ReceptanceParameters>())
      , context(context)
    {}

    void run() override;

  private:
    /** What was measured, to be drawn. */
    struct Curve
    {
      std::string         label;
      std::vector<double> frequencies, sizes;
    };

    /** Throws InputError if the file of a body cannot be used. */
    void read_measured(const Side side);

    /** A place and a direction on a body. */
    struct Station
    {
      std::string  place;
      unsigned int axis;
      double       sign; ///< of the body's own axis in the rail's frame
    };

    /** The forces of 1 N at the stations, and their names. */
    std::vector<std::vector<double>>
    loads(const VibratingBody<dim> &body, std::vector<Station> &stations) const;

    void add_rows(const Side                  side,
                  const std::vector<Station> &stations,
                  const double                frequency,
                  const ComplexMatrix        &alpha,
                  ResultsTable               &table) const;

    void sweep(const VibratingBody<dim> &body, ResultsTable &table);

    /** A rail without ends, and the waves in it. */
    void sweep_waves(const VibratingBody<dim> &body, ResultsTable &table);

    /** waves.csv and its picture. */
    void write_waves(const RailWaves &waves) const;

    void note_peak(const VibratingBody<dim>         &body,
                   const std::string                &found_by,
                   const std::vector<Station>       &stations,
                   const std::vector<double>        &frequencies,
                   const std::vector<ComplexMatrix> &alpha) const;

    /** Solve the whole structure at the check frequencies; the largest error of
     * the modes over the largest of the receptances at that frequency. */
    void check(const VibratingBody<dim>               &body,
               const VibratingStructure               &structure,
               const FrequencyResponse                &response,
               const std::vector<std::vector<double>> &forces) const;

    void plot(const Side                        side,
              const std::vector<Station>       &stations,
              const std::vector<double>        &frequencies,
              const std::vector<ComplexMatrix> &alpha) const;

    const Situation              &scene;
    const ReceptanceParameters   &section;
    RunContext                   &context;
    PerSide<std::optional<Curve>> measured;
  };

  AnalysisKind receptance_kind();
} // namespace RollingContact

#endif
