#ifndef rolling_contact_analyses_study_parameters_h
#define rolling_contact_analyses_study_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/contact/operators.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Section `Accuracy study`.
   */
  struct StudyParameters : public dealii::ParameterAcceptor
  {
    StudyParameters();

    /**
     * Throws InputError.
     */
    void
    check() const;

    std::vector<unsigned int> elements{12, 24, 48, 96};
    unsigned int              n_offsets          = 8;
    unsigned int              reference_elements = 192;
    std::vector<double>       creepages{0.1, 0.3, 0.5, 0.7, 0.9};
    std::vector<std::string>  slip_operators{"calibrated", "upwind 2"};
  };
} // namespace RollingContact

#endif
