#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include "bindings.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>

#include <sstream>

namespace RollingContact::Bindings
{
  namespace
  {
    /** What a signal handler of Python raised inside a solve of this thread. */
    thread_local std::unique_ptr<py::error_already_set> raised;

    /**
     * Lets the handlers of Python run; they run in the main thread alone.
     */
    void ask_python()
    {
      if (!Py_IsInitialized())
        return;
      const py::gil_scoped_acquire hold;
      if (PyErr_CheckSignals() == 0)
        return;
      raised = std::make_unique<py::error_already_set>();
      throw Interrupted("Interrupted by a signal handler of Python.");
    }

    void translate_interrupt(std::exception_ptr pointer)
    {
      try
        {
          std::rethrow_exception(pointer);
        }
      catch (const Interrupted &error)
        {
          if (raised)
            {
              raised->restore();
              raised.reset();
            }
          else
            PyErr_SetString(PyExc_KeyboardInterrupt, error.what());
        }
      catch (const dealii::ExceptionBase &error)
        {
          std::ostringstream reason;
          error.print_info(reason);
          PyErr_SetString(PyExc_RuntimeError,
                          ("internal error: " + reason.str()).c_str());
        }
    }

    void define_errors(py::module_ &module)
    {
      py::register_exception<InputError>(module, "InputError", PyExc_ValueError)
        .doc() = "An error that the user can correct: the message names the "
                 "entry or file, its value, what is allowed and what to do.";
      py::register_exception<ConvergenceError>(module,
                                               "ConvergenceError",
                                               PyExc_RuntimeError)
        .doc() = "A solve that did not reach its tolerance.";
      py::register_exception_translator(&translate_interrupt);
    }
  } // namespace

  PYBIND11_MODULE(_core, module)
  {
    module.doc() = "Rolling contact with friction between a wheel and a rail.";
    module.attr("__version__") = ROLLING_CONTACT_VERSION;
    // as the program does: many small factors, each by one thread
    use_one_solver_thread();
    dealii::MultithreadInfo::set_thread_limit(1);
    set_interrupt_source(&ask_python);
    define_errors(module);
    define_scene(module);
    define_fields(module);
    define_session(module);
    define_transient(module);
    define_wheelset(module);
    define_references(module);
    module.def("print_parameters",
               &documented_parameters,
               "Every entry of a scene with its default, meaning and unit, as "
               "a .prm file.");
    module.def("parameters_as_json",
               &parameters_as_json,
               "Every entry of all sections of a scene, as JSON.");
    py::module_::import("atexit").attr("register")(
      py::cpp_function(&Ranks::finish));
  }
} // namespace RollingContact::Bindings
