#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ordered_work.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/fmu/frames.h>
#include <rolling_contact/wheelset/fmu_parameters.h>
#include <rolling_contact/wheelset/fmu_server.h>
#include <rolling_contact/wheelset/fmu_wheel.h>

#include <algorithm>
#include <new>
#include <thread>

namespace RollingContact
{
  namespace
  {
    const int standard_input = 0;

    const char *const names[2] = {"The right-hand wheel: ",
                                  "The left-hand wheel: "};

    /** The state of a wheel; throws ConvergenceError that names the wheel if
     * there is none. */
    Fmu::WheelAnswer answer_of(FmuWheel                  &wheel,
                               const Fmu::StatesQuestion &question,
                               const std::size_t          k)
    {
      try
        {
          return wheel.answer(question.wheels[k], question.memories[k]);
        }
      catch (const InputError &problem)
        {
          throw ConvergenceError(names[k] + std::string(problem.what()));
        }
      catch (const ConvergenceError &problem)
        {
          throw ConvergenceError(names[k] + std::string(problem.what()));
        }
      catch (const std::bad_alloc &)
        {
          throw ConvergenceError(names[k] +
                                 std::string("There is not enough memory."));
        }
    }
  } // namespace

  void serve_fmu(const Situation &scene)
  {
    check_fmu(scene);
    const unsigned int wanted    = scene.inputs->table.threads,
                       n_threads = std::min(
                         2u,
                         wanted > 0
                           ? wanted
                           : std::max(1u, std::thread::hardware_concurrency()));
    reserve_blas_memory(n_threads * scene.body_threads);
    std::array<FmuWheel, 2> wheels{{FmuWheel(scene), FmuWheel(scene)}};
    if (!Fmu::send_frame(standard_input, Fmu::greeting_of_states))
      throw InputError(std::string(Fmu::option_of_states) +
                       ": standard input is not a socket with an FMU at its "
                       "other end. It is the FMU that gives this option.");
    while (const auto bytes = Fmu::receive_frame(standard_input, &interrupted))
      {
        const auto        question = Fmu::StatesQuestion::of_bytes(*bytes);
        Fmu::StatesAnswer answer;
        try
          {
            do_in_order(
              2,
              n_threads,
              [&]() {
                return [&](const std::size_t k) {
                  answer.wheels[k] = answer_of(wheels[k], question, k);
                };
              },
              [](const std::size_t) {});
          }
        catch (const ConvergenceError &problem)
          {
            answer           = {};
            answer.is_solved = false;
            answer.why       = problem.what();
          }
        if (!Fmu::send_frame(standard_input, answer.bytes()))
          return;
      }
    throw_if_interrupted();
  }
} // namespace RollingContact
