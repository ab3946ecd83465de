#include "bindings.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/patch/resultants.h>

#include <stdexcept>

namespace RollingContact::Bindings
{
  namespace
  {
    py::array_t<double>
    array_of(const std::vector<double> &values)
    {
      return py::array_t<double>(values.size(), values.data());
    }



    py::array_t<double>
    zeros(const py::ssize_t n_rows, const py::ssize_t n_columns)
    {
      py::array_t<double> result({n_rows, n_columns});
      std::fill(result.mutable_data(),
                result.mutable_data() + result.size(),
                0.);
      return result;
    }



    /** With x and y, y being 0 in 2D. */
    py::array_t<double>
    array_of(const std::size_t n_nodes, const NodalField &field)
    {
      py::array_t<double> result = zeros(n_nodes, 2);
      for (unsigned int k = 0; k < field.n_components(); ++k)
        for (std::size_t i = 0; i < n_nodes; ++i)
          result.mutable_at(i, k) = field(k, i);
      return result;
    }
  } // namespace



  Fields::Fields(const ContactProblem &problem, const ContactState &state)
  {
    const std::size_t n_nodes = problem.n_nodes();
    const auto       &points  = problem.operators.positions();
    positions                 = zeros(n_nodes, 2);
    for (std::size_t i = 0; i < n_nodes; ++i)
      for (unsigned int k = 0; k < 2; ++k)
        positions.mutable_at(i, k) = points[i][k];
    pressure = array_of(state.pressure);
    traction = array_of(n_nodes, state.traction);
    gap      = array_of(normal_gap(problem, state));
    areas    = array_of(problem.operators.areas());

    const auto in_plane =
      forces_in_plane(problem, RollingContact::nodal_forces(problem, state));
    forces = zeros(n_nodes, 3);
    for (std::size_t i = 0; i < n_nodes; ++i)
      {
        forces.mutable_at(i, 0) = in_plane[i].x;
        forces.mutable_at(i, 1) = in_plane[i].y;
        forces.mutable_at(i, 2) = in_plane[i].z;
      }

    const TangentialProblem tangential = tangential_problem(problem, state);
    slip                               = problem.n_tangential() > 0
                                           ? array_of(n_nodes, tangential.slip(state.traction))
                                           : zeros(n_nodes, 2);
    const auto states = RollingContact::node_states(tangential, state);
    node_states       = py::array_t<std::int8_t>(n_nodes);
    for (std::size_t i = 0; i < n_nodes; ++i)
      node_states.mutable_at(i) = static_cast<std::int8_t>(states[i]);
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



  void
  define_fields(py::module_ &module)
  {
    py::class_<Fields, std::shared_ptr<Fields>>(
      module,
      "Fields",
      "Fields at the N contact nodes as numpy arrays, copies of their own.")
      .def_readonly("positions",
                    &Fields::positions,
                    "(N, 2): x in the rolling direction and y across. Unit: m.")
      .def_readonly("pressure", &Fields::pressure, "(N,), >= 0. Unit: Pa.")
      .def_readonly("traction",
                    &Fields::traction,
                    "(N, 2): of friction on the wheel. Unit: Pa.")
      .def_readonly("gap",
                    &Fields::gap,
                    "(N,): between the deformed surfaces, 0 in contact; in "
                    "time that of the contact law. Unit: m.")
      .def_readonly("slip",
                    &Fields::slip,
                    "(N, 2): sliding speed of the wheel over the rail over the "
                    "rolling speed. Unit: 1.")
      .def_readonly("node_states",
                    &Fields::node_states,
                    "(N,) of int8: 0 open, 1 slip, 2 stick.")
      .def_readonly("areas",
                    &Fields::areas,
                    "(N,): area of each node. Unit: m^2.")
      .def_readonly("forces",
                    &Fields::forces,
                    "(N, 3): force of each node on the wheel along x, y and z, "
                    "whose sums are the forces of the state. Unit: N.");
  }
} // namespace RollingContact::Bindings
