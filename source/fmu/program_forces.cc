#include <rolling_contact/fmu/bytes.h>
#include <rolling_contact/fmu/program_forces.h>
#include <rolling_contact/fmu/state_messages.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Fmu
{
  namespace
  {
    const std::string mark_of_values = "rolling-contact wheelset of states 1";

    std::array<std::string, 2> memories_of(const std::string &memory)
    {
      std::array<std::string, 2> both;
      if (memory.empty())
        return both;
      BytesIn in(memory);
      for (std::string &one : both)
        one = in.text();
      return both;
    }
  } // namespace

  std::string program_values(const Wheelset    &wheelset,
                             const std::string &program)
  {
    BytesOut out;
    out.add(mark_of_values);
    out.add(wheelset.radius);
    out.add(wheelset.tape_circle);
    out.add(wheelset.start);
    out.add(program);
    return out.all();
  }

  ProgramForces::ProgramForces(const std::string &values,
                               const std::string &scene)
    : scene(scene)
  {
    BytesIn in(values);
    if (in.text() != mark_of_values)
      throw std::invalid_argument("they are not of this version");
    wheelset.radius      = in.number();
    wheelset.tape_circle = in.number();
    wheelset.start       = in.numbers<n_inputs>();
    known_program        = in.text();
    wheelset.check();
  }

  void ProgramForces::begin(const std::string &program)
  {
    if (process && program == asked)
      return;
    process.reset();
    asked   = program;
    process = std::make_unique<ProgramProcess>(program_of_states(program,
                                                                 known_program),
                                               scene);
  }

  ForceModel::Forces ProgramForces::forces(const Inputs      &inputs,
                                           const double       least_speed,
                                           const std::string &memory,
                                           const std::string &program)
  {
    StatesQuestion question;
    question.memories = memories_of(memory);
    for (const unsigned int k : {0, 1})
      question.wheels[k] = question_of(inputs, k, least_speed);
    begin(program);
    StatesAnswer answer;
    try
      {
        answer = StatesAnswer::of_bytes(process->exchange(question.bytes()));
      }
    catch (...)
      {
        process.reset();
        throw;
      }
    if (!answer.is_solved)
      throw NoForces(answer.why);
    for (const WheelAnswer &wheel : answer.wheels)
      if (!std::isfinite(wheel.roll) ||
          !std::all_of(wheel.values.begin(),
                       wheel.values.end(),
                       [](const double value) { return std::isfinite(value); }))
        throw NoForces("the state has numbers that are not finite");
    const bool inside = inputs[speed] >= least_speed;
    Forces     found;
    BytesOut   memories;
    for (const unsigned int k : {0, 1})
      {
        if (question.wheels[k].load > 0.)
          found.outputs.wheels[k] =
            outputs_of(answer.wheels[k].values, inside, inputs, k);
        memories.add(answer.wheels[k].memory);
      }
    found.outputs.roll = answer.wheels[0].roll;
    found.memory       = memories.all();
    return found;
  }
} // namespace RollingContact::Fmu
