#ifndef rolling_contact_analyses_corrugation_report_h
#define rolling_contact_analyses_corrugation_report_h

#include <rolling_contact/analyses/corrugation_parameters.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/stability/wave_sweep.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A wave that passes at a speed and a place of the track, and how it grows.
   */
  struct CorrugationRow
  {
    std::optional<double> pad_offset; ///< m; none without pads
    double                speed      = 0.;
    double                wavelength = 0.;

    /** With the growth of the wear coefficient asked for. */
    PassedWave passed;

    /** How far Re G may be off, see uncertainty_by_halves(). */
    std::optional<double> uncertainty;

    /** Re G with whole bodies, where it was asked for. */
    std::optional<double> of_whole_bodies;

    double frequency() const
    {
      return speed / wavelength;
    }

    double rate() const
    {
      return passed.growth.total().real();
    }
  };

  /**
   * Rows by place, speed and ascending wavelength: numbers of those that grow
   * more than both neighbours do, or at the ends of the range than the one.
   */
  std::vector<std::size_t>
  peaks_of_growth(const std::vector<CorrugationRow> &rows);

  /** Whether Re G of one wave is below that of another. */
  bool grows_less(const CorrugationRow &a, const CorrugationRow &b);

  /** Set all columns of a row of corrugation.csv and end it. */
  void add_row(const CorrugationRow        &row,
               const CorrugationParameters &section,
               ResultsTable                &table);

  /** The text of what the run found: how many waves grow, and most where. */
  std::string verdict(const std::vector<CorrugationRow> &rows,
                      const CorrugationParameters       &section);

  /** Growth over wavelength and frequency at all speeds, at the place where it
   * is largest, above the receptances there: corrugation.svg. */
  void plot_growth(const std::vector<CorrugationRow> &rows,
                   const CorrugationParameters       &section,
                   RunContext                        &context);
} // namespace RollingContact

#endif
