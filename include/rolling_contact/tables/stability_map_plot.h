#ifndef rolling_contact_tables_stability_map_plot_h
#define rolling_contact_tables_stability_map_plot_h

#include <rolling_contact/tables/table_rows.h>

#include <vector>

namespace RollingContact
{
  /**
   * One vibration followed along an axis.
   */
  struct Branch
  {
    std::vector<double>          at; ///< values of the axis
    std::vector<ListedVibration> vibrations;

    double largest_growth() const;
  };

  /**
   * Join the vibrations of neighbouring values: each to the nearest one of its
   * neighbour by frequency and growth, in order of distance, up to a fiftieth
   * of the frequency.
   */
  std::vector<Branch>
  branches(const std::vector<double>                       &values,
           const std::vector<std::vector<ListedVibration>> &vibrations);

  /**
   * Rows with names are drawn as bars, one for each wheel, in growth.svg; over
   * two axes stability_map.svg, _frequency.svg and _count.svg, over one
   * root_locus.svg; nothing for more axes and rows without names.
   */
  void plot_stability_map(const TablePlan &plan, RunContext &context);
} // namespace RollingContact

#endif
