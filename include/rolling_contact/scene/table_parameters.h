#ifndef rolling_contact_scene_table_parameters_h
#define rolling_contact_scene_table_parameters_h

#include <array>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * An entry of a scene and the values it takes, ascending, in its own unit.
   */
  struct TableAxis
  {
    std::string         name;  ///< "Table/Axis 1", for messages
    std::string         entry; ///< "Contact/Creepage x"
    std::vector<double> values;
  };

  /**
   * A part of a table, the first of one for all of it.
   */
  struct TablePart
  {
    std::size_t number = 1, of = 1;

    bool is_all() const
    {
      return of == 1;
    }

    /** Whether a chain of states is of this part. */
    bool has(const std::size_t chain) const
    {
      return chain % of == number - 1;
    }
  };

  /**
   * Section `Table`: which states are tabulated, a full grid over axes or the
   * rows of a file.
   */
  struct TableParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError unless there are either axes, all of them with an
     * entry and numbers, or a file of rows.
     */
    void check() const;

    /**
     * The axes that are given, in their order. Throws InputError naming the one
     * that is none, whose entry another has, or that has a number twice.
     */
    std::vector<TableAxis> axes() const;

    /** Throws InputError unless it is none or "number/of", and none where parts
     * are joined. */
    TablePart part() const;

    static constexpr unsigned int max_axes = 8;

    std::array<std::string, max_axes> axis_texts;
    std::string                       file_of_rows;
    std::string                       part_text;   ///< "3/16"
    std::string                       join;        ///< folders of parts
    unsigned int                      threads = 0; ///< 0: as many as processors
  };
} // namespace RollingContact

#endif
