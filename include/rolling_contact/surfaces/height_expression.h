#ifndef rolling_contact_surfaces_height_expression_h
#define rolling_contact_surfaces_height_expression_h

#include <deal.II/base/function_parser.h>

#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * A height over x and y (m) that an entry gives as an expression for
   * muParser, with pi and deal.II's functions except the random ones; 0 if the
   * entry is empty. Units: m.
   */
  class HeightExpression
  {
  public:
    /**
     * Throws InputError naming the entry (Section/Entry), its text, what is
     * allowed and @p otherwise, what else may be given: ", or leave it empty.".
     */
    HeightExpression(const std::string &entry,
                     const std::string &text,
                     const std::string &otherwise);

    /**
     * Throws InputError where it is not finite.
     */
    double value(const double x, const double y) const;

    bool depends_on_y() const
    {
      return has_y;
    }

  private:
    [[noreturn]] void reject(const std::string &reason) const;

    std::string                                entry, text, otherwise;
    bool                                       has_y = false;
    std::shared_ptr<dealii::FunctionParser<2>> expression; ///< or none
  };
} // namespace RollingContact

#endif
