#ifndef rolling_contact_python_bindings_h
#define rolling_contact_python_bindings_h

#include <pybind11/iostream.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/tables/session.h>

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /** The module rolling_contact for Python; see doc/howto/python.md. */
  namespace Bindings
  {
    namespace py = pybind11;

    using NamedValue = Session::NamedValue;

    /**
     * Objects that Class.__new__(Class) of Python makes without a constructor
     * lie in memory of zeros, where pointers and optionals are empty.
     */
    struct InZeroedMemory
    {
      static void *operator new(const std::size_t size);
      static void  operator delete(void *memory);
    };

    /**
     * A scene for Python: a text with what was set beside it.
     */
    struct Scene : public InZeroedMemory
    {
      PrmText                            text;
      std::string                        name; ///< of the file, for messages
      std::filesystem::path              folder;
      std::vector<CommandLine::Setting>  settings;
      std::map<std::string, std::string> entries; ///< all that were given
      std::vector<std::string>           warnings;
      std::optional<Situation>           situation;
    };

    /**
     * Scene of a path, a text (which has line ends) or a Scene, with settings
     * {entry: value} on top. Throws InputError.
     */
    std::shared_ptr<const Scene> make_scene(const py::object &source,
                                            const py::object &settings);

    /** With Analysis as named. */
    std::shared_ptr<const Scene> make_scene_of(const std::string &analysis,
                                               const py::object  &source,
                                               const py::object  &settings);

    /**
     * Scene in time of a path, a text or a Scene: Analysis is transient, and
     * there is an end where none is given. Units: s.
     */
    std::shared_ptr<const Scene>
    make_scene_in_time(const py::object           &source,
                       const py::object           &settings,
                       const std::optional<double> time_step);

    /**
     * What a value of Python stands for in a .prm file. Throws TypeError unless
     * it is a text, a number or true or false.
     */
    std::string text_of_value(const std::string &entry,
                              const py::handle  &value);

    /**
     * Fields at the N contact nodes, copies of their own. Units: SI.
     */
    struct Fields : public InZeroedMemory
    {
      Fields() = default;
      Fields(const ContactProblem &problem, const ContactState &state);

      py::array_t<double>      positions, pressure, traction, gap, slip;
      py::array_t<double>      areas, forces;
      py::array_t<std::int8_t> node_states;
    };

    /** A state of its own, whatever the session does next. */
    struct State : public InZeroedMemory
    {
      SessionState                           found;
      std::shared_ptr<const Fields>          fields;
      std::optional<std::vector<NamedValue>> columns; ///< of results.csv
    };

    /** A dict of columns. */
    py::dict dict_of(const std::vector<NamedValue> &columns);

    /**
     * Where a session says what it does: sys.stdout, unless it is quiet.
     */
    class Speech
    {
    public:
      /** Throws InputError unless it is quiet, normal or verbose. */
      explicit Speech(const std::string &verbosity);

      std::ostream *stream()
      {
        return out.get();
      }

      Verbosity verbosity;

    private:
      std::unique_ptr<py::detail::pythonbuf> buffer;
      std::unique_ptr<std::ostream>          out;
    };

    /**
     * A session of the library until it is closed.
     */
    template <typename Type>
    class Open
    {
    public:
      /** Throws InputError on several ranks. Other threads run meanwhile. */
      void open(const Scene &scene, Speech &speech)
      {
        if (Ranks::count() > 1)
          throw InputError("A session is for one rank, MPI has " +
                           std::to_string(Ranks::count()) +
                           ": start Python without mpirun.");
        const py::gil_scoped_release others_run;
        session.emplace(*scene.situation, speech.stream(), speech.verbosity);
      }

      void close()
      {
        session.reset();
      }

      /** Throws std::runtime_error if it is not open. */
      Type *operator->()
      {
        check();
        return &*session;
      }

      const Type *operator->() const
      {
        check();
        return &*session;
      }

    private:
      void check() const
      {
        if (!session)
          throw std::runtime_error("The session is closed: make another one.");
      }

      std::optional<Type> session;
    };

    /**
     * Keeps others from what one thread uses, as the interpreter runs on.
     */
    class InUse
    {
    public:
      /** Throws std::runtime_error if it is in use. */
      explicit InUse(std::atomic_flag &flag);
      ~InUse();

      InUse(const InUse &)            = delete;
      InUse &operator=(const InUse &) = delete;

    private:
      std::atomic_flag &flag;
    };

    void define_scene(py::module_ &module);
    void define_fields(py::module_ &module);
    void define_copies(py::class_<ErrorBounds> &bounds);
    void define_copies(py::class_<Fields, std::shared_ptr<Fields>> &fields);
    void define_copies(py::class_<State> &state);
    void define_references(py::module_ &module);
    void define_session(py::module_ &module);
    void define_transient(py::module_ &module);
    void define_wheelset(py::module_ &module);
  } // namespace Bindings
} // namespace RollingContact

#endif
