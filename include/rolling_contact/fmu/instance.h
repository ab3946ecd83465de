#ifndef rolling_contact_fmu_instance_h
#define rolling_contact_fmu_instance_h

#include <rolling_contact/fmu/force_model.h>
#include <rolling_contact/fmu/variables.h>

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace RollingContact::Fmu
{
  /** What a function of the interface answers, in the order of the standard. */
  enum class Status
  {
    ok,
    warning,
    discard,
    error,
    fatal
  };

  /** How far an instance has come. */
  enum class Mode
  {
    instantiated,
    initialising,
    stepping,
    terminated
  };

  /** Where messages go: status, category, text. */
  using Logger =
    std::function<void(const Status, const char *, const std::string &)>;

  /**
   * All that an instance remembers.
   */
  struct Snapshot
  {
    static constexpr std::size_t n_numbers = n_inputs + 6;

    /** Inputs, times and modes. */
    std::array<double, n_numbers> numbers() const;

    /** All, from which it follows to the last bit. */
    std::string bytes() const;

    /** Throws std::invalid_argument if they are none of a snapshot. */
    static Snapshot of_bytes(const std::string &bytes);

    Inputs inputs{};
    double least_speed = default_least_speed;
    double time = 0., stop_time = 0.;
    Mode   mode          = Mode::instantiated;
    bool   has_stop_time = false;
    bool   is_set_up     = false; ///< setupExperiment of FMI 2.0

    std::string program; ///< that is asked for
    std::string memory;  ///< what forces begin with, see ForceModel

    /** Outputs of the inputs as they are, if they are known. */
    std::optional<Outputs> found;
    /** Whether the memory is that of these outputs: a step has kept it. */
    bool is_of_step = false;

  private:
    void take(const std::array<double, n_numbers> &numbers);
  };

  /**
   * A wheelset of an FMU, whatever the version of the interface: what may be
   * called when, values by reference, steps and states. Each function refuses
   * what is not allowed, says why to the logger and answers Status::error; a
   * step to inputs that have no forces answers Status::discard, and is not
   * taken. Outputs are those of the inputs as they are. What they begin with is
   * kept by steps alone: to look at outputs changes nothing.
   */
  class Instance
  {
  public:
    /**
     * Reads the model of a folder of @p resources, which must have this @p
     * token. Null, and a message to the logger, if that cannot be.
     */
    static std::unique_ptr<Instance> make(const std::string &name,
                                          const std::string &token,
                                          const std::string &resources,
                                          const Logger      &logger);

    ~Instance();

    Instance(const Instance &)            = delete;
    Instance &operator=(const Instance &) = delete;

    /** Whether it is one that was made and not yet destroyed. */
    static bool is_alive(const void *instance);

    /** Says why, if messages of this kind are asked for, and answers error, or
     * what else is to be answered. */
    Status refuse(const std::string &function,
                  const std::string &why,
                  const Status       status = Status::error);

    /** Whether the instance is in one of these modes; else it is said. */
    bool is_in(const std::string                 &function,
               const std::initializer_list<Mode> &modes);

    /** Categories of messages that are asked for; none: all. */
    Status set_logging(const bool                      on,
                       const std::vector<std::string> &categories);

    Status set_up(const std::string &function,
                  const double       start_time,
                  const bool         has_stop_time,
                  const double       stop_time);

    /** @p is_set_up: set_up() is a function of its own, which comes first. */
    Status enter_initialisation(const std::string &function,
                                const bool         needs_set_up);

    Status exit_initialisation(const std::string &function);

    Status
    step(const std::string &function, const double from, const double size);

    Status terminate(const std::string &function);

    Status reset();

    /** Values of real numbers, by reference. */
    Status get(const std::string  &function,
               const unsigned int *references,
               const std::size_t   n,
               double             *values);

    Status get(const std::string  &function,
               const unsigned int *references,
               const std::size_t   n,
               std::vector<bool>  &values);

    Status get(const std::string  &function,
               const unsigned int *references,
               const std::size_t   n,
               const char        **values);

    Status set(const std::string  &function,
               const unsigned int *references,
               const std::size_t   n,
               const double       *values);

    /** Texts, by reference. */
    Status set(const std::string  &function,
               const unsigned int *references,
               const std::size_t   n,
               const char *const  *values);

    /** No variable of this type can be set, or there is none of it: success if
     * nothing is asked for. */
    Status none_of_type(const std::string  &function,
                        const unsigned int *references,
                        const std::size_t   n,
                        const std::string  &type);

    /** A state that was kept, in place of @p handle if that is one; it is
     * forgotten with the instance. */
    Status keep(const std::string &function, void **handle);

    Status restore(const std::string &function, const void *handle);

    Status forget(const std::string &function, void **handle);

    Status size_of_state(const std::string &function,
                         const void        *handle,
                         std::size_t       *size);

    Status serialise(const std::string &function,
                     const void        *handle,
                     char              *bytes,
                     const std::size_t  size);

    Status deserialise(const std::string &function,
                       const char        *bytes,
                       const std::size_t  size,
                       void             **handle);

    const Snapshot &now() const
    {
      return state;
    }

  private:
    Instance(const std::string &name, const Logger &logger);

    void log(const Status status, const std::string &text);

    /** Each of the references is one of a type, and there are arrays. */
    bool are_of_type(const std::string  &function,
                     const unsigned int *references,
                     const std::size_t   n,
                     const void         *values,
                     const VariableType  type);

    bool may_get(const std::string &function);

    /** Why a variable may not be set now; empty if it may. */
    std::string why_not_set(const Variable &variable) const;

    /** Whether a value may be set now. */
    bool may_set(const std::string &function,
                 const Variable    &variable,
                 const double       value);

    double value_of(const Variable &variable);

    const Outputs &outputs();

    Snapshot *kept(const std::string &function, const void *handle);

    /** The state without what was looked at since the last step. */
    Snapshot to_keep() const;

    std::string bytes_of(const Snapshot &snapshot) const;

    const Variable *find(const unsigned int reference) const
    {
      return find_variable(reference, model->kind());
    }

    const std::string           name;
    const Logger                logger;
    std::string                 token;
    std::unique_ptr<ForceModel> model;
    Snapshot                    state;
    std::string                 reached; ///< memory that a step would keep
    bool                        logs = true;
    std::set<std::string>       categories;
    std::set<std::unique_ptr<Snapshot>> snapshots;
  };
} // namespace RollingContact::Fmu

#endif
