#ifndef rolling_contact_base_spelling_h
#define rolling_contact_base_spelling_h

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Least number of characters to insert, delete or replace, and of neighbours
   * to swap, to turn one word into the other (Levenshtein's distance with
   * transpositions); capitals and small letters are alike.
   */
  std::size_t edit_distance(const std::string &first,
                            const std::string &second);

  /**
   * Names among @p known, Section/Entry or Entry, that may be meant by @p path,
   * which is not among them: names that differ by a few letters, contain its
   * words, or stand in another section. At most three; none if nothing is near.
   */
  std::vector<std::string> likely_meant(const std::string              &path,
                                        const std::vector<std::string> &known);

  /**
   * "did you mean A, B or C?"; empty for none.
   */
  std::string did_you_mean(const std::vector<std::string> &meant);
} // namespace RollingContact

#endif
