#include "bindings.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/results/nodal_values.h>

#include <cstring>
#include <stdexcept>

namespace RollingContact::Bindings
{
  namespace
  {
    py::array_t<double> zeros(const py::ssize_t n_rows,
                              const py::ssize_t n_columns)
    {
      py::array_t<double> result({n_rows, n_columns});
      std::fill(result.mutable_data(),
                result.mutable_data() + result.size(),
                0.);
      return result;
    }

    /** Vectors with x and y, y being 0 in 2D. */
    py::array_t<double> array_of(const std::string &name,
                                 const NodalState  &state)
    {
      const NodalQuantity &quantity = nodal_quantity(name);
      const NodalField     field    = quantity.of(state).value();
      if (!quantity.is_vector)
        return py::array_t<double>(field.size(), field.values().data());
      py::array_t<double> result = zeros(field.n_nodes(), 2);
      for (unsigned int k = 0; k < field.n_components(); ++k)
        for (std::size_t i = 0; i < field.n_nodes(); ++i)
          result.mutable_at(i, k) = field(k, i);
      return result;
    }

    /** The help of an array, with its unit. */
    std::string help(const std::string &text, const std::string &name)
    {
      return text + " Unit: " + nodal_quantity(name).unit + '.';
    }
  } // namespace

  Fields::Fields(const ContactProblem &problem, const ContactState &state)
  {
    const NodalState  all(problem, state);
    const std::size_t n_nodes = problem.n_nodes();
    const auto       &points  = problem.operators.positions();
    positions                 = zeros(n_nodes, 2);
    for (std::size_t i = 0; i < n_nodes; ++i)
      for (unsigned int k = 0; k < 2; ++k)
        positions.mutable_at(i, k) = points[i][k];
    pressure    = array_of("pressure", all);
    traction    = array_of("traction", all);
    gap         = array_of("gap", all);
    slip        = array_of("slip", all);
    areas       = array_of("area", all);
    node_states = py::array_t<std::int8_t>(array_of("state", all));

    const auto in_plane =
      forces_in_plane(problem, RollingContact::nodal_forces(problem, state));
    forces = zeros(n_nodes, 3);
    for (std::size_t i = 0; i < n_nodes; ++i)
      {
        forces.mutable_at(i, 0) = in_plane[i].x;
        forces.mutable_at(i, 1) = in_plane[i].y;
        forces.mutable_at(i, 2) = in_plane[i].z;
      }
  }

  void *InZeroedMemory::operator new(const std::size_t size)
  {
    void *memory = ::operator new(size);
    std::memset(memory, 0, size);
    return memory;
  }

  void InZeroedMemory::operator delete(void *memory)
  {
    ::operator delete(memory);
  }

  Speech::Speech(const std::string &given)
  {
    const std::map<std::string, Verbosity> names{{"quiet", Verbosity::quiet},
                                                 {"normal", Verbosity::normal},
                                                 {"verbose",
                                                  Verbosity::verbose}};
    const auto                             found = names.find(given);
    if (found == names.end())
      throw InputError("verbosity = " + given +
                       ": it is quiet, normal or verbose.");
    verbosity = found->second;
    if (verbosity == Verbosity::quiet)
      return;
    buffer = std::make_unique<py::detail::pythonbuf>(
      py::module_::import("sys").attr("stdout"));
    out = std::make_unique<std::ostream>(buffer.get());
  }

  InUse::InUse(std::atomic_flag &flag)
    : flag(flag)
  {
    if (flag.test_and_set())
      throw std::runtime_error("The session is in use by another thread: make "
                               "one session for each thread.");
  }

  InUse::~InUse()
  {
    flag.clear();
  }

  void define_fields(py::module_ &module)
  {
    py::class_<Fields, std::shared_ptr<Fields>> fields(
      module,
      "Fields",
      "Fields at the N contact nodes, as copies in numpy arrays.");
    define_copies(fields);
    fields
      .def_readonly("positions",
                    &Fields::positions,
                    "(N, 2): x in the rolling direction and y across. Unit: m.")
      .def_readonly("pressure",
                    &Fields::pressure,
                    help("(N,), >= 0.", "pressure").c_str())
      .def_readonly(
        "traction",
        &Fields::traction,
        help("(N, 2): traction of friction on the wheel.", "traction").c_str())
      .def_readonly(
        "gap",
        &Fields::gap,
        help("(N,): gap between the deformed surfaces, 0 in contact; in time "
             "the gap of the contact law.",
             "gap")
          .c_str())
      .def_readonly(
        "slip",
        &Fields::slip,
        help("(N, 2): sliding speed of the wheel over the rail over "
             "the rolling speed.",
             "slip")
          .c_str())
      .def_readonly("node_states",
                    &Fields::node_states,
                    "(N,) of int8: 0 open, 1 slip, 2 stick.")
      .def_readonly("areas",
                    &Fields::areas,
                    help("(N,): area of each node.", "area").c_str())
      .def_readonly("forces",
                    &Fields::forces,
                    "(N, 3): force of each node on the wheel along x, y and z, "
                    "whose sums are the forces of the state. Unit: N.");
  }
} // namespace RollingContact::Bindings
