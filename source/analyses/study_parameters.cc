#include <rolling_contact/analyses/study_parameters.h>
#include <rolling_contact/base/exceptions.h>

namespace RollingContact
{
  using namespace dealii;

  StudyParameters::StudyParameters()
    : ParameterAcceptor("/Accuracy study")
  {
    add_parameter("Elements across patch",
                  elements,
                  "Meshes to compare. Units: 1.",
                  prm,
                  Patterns::List(Patterns::Integer(1), 1));
    add_parameter(
      "Offsets",
      n_offsets,
      "Positions of each mesh under the patch, equally spaced over one "
      "element. Units: 1.",
      prm,
      Patterns::Integer(1, 1000));
    add_parameter(
      "Reference elements across patch",
      reference_elements,
      "Mesh of the converged solution that forces are compared with, "
      "mean over the offsets with `calibrated`; finer than the others. "
      "Units: 1.",
      prm,
      Patterns::Integer(1));
    add_parameter("Creepages over saturation",
                  creepages,
                  "Longitudinal creepages, over mu a/R of the Hertz estimate. "
                  "Units: 1.",
                  prm,
                  Patterns::List(Patterns::Double(), 1));
    add_parameter("Slip operators",
                  slip_operators,
                  "Operators to compare, as Contact/Slip operator.",
                  prm,
                  Patterns::List(Patterns::Selection(
                                   "upwind 1|upwind 2|calibrated|galerkin"),
                                 1));
  }



  void
  StudyParameters::check() const
  {
    for (const unsigned int n : elements)
      if (n >= reference_elements)
        throw InputError("Accuracy study/Elements across patch contains " +
                         std::to_string(n) +
                         ": take fewer than the reference mesh's " +
                         std::to_string(reference_elements) +
                         " (Reference elements across patch).");
  }
} // namespace RollingContact
