#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/references/falling_half_spaces.h>
#include <rolling_contact/results/ill_posed_friction.h>

namespace RollingContact
{
  namespace
  {
    std::vector<References::ShearedHalfSpace> half_spaces(const PairSpec &scene)
    {
      std::vector<References::ShearedHalfSpace> bodies;
      for (const Side side : both_sides)
        if (!scene.body(side).rigid)
          bodies.push_back({scene.body(side).surface_material().shear_modulus(),
                            scene.body(side).surface_material().density});
      return bodies;
    }
  } // namespace

  IllPosedFriction::IllPosedFriction(const PairSpec &scene,
                                     const double    element_size)
    : scene(scene)
    , element_size(element_size)
  {}

  void IllPosedFriction::add(const ContactProblem &problem,
                             const ContactState   &state)
  {
    const ContactLoads &loads = problem.loads;
    if (!loads.friction_law || loads.memory_length > 0. ||
        problem.n_tangential() == 0)
      return;
    const TangentialProblem   tangential = tangential_problem(problem, state);
    const std::vector<double> speeds =
      tangential.sliding_speeds(tangential.slip(state.traction));
    const auto bodies = half_spaces(scene);
    for (const unsigned int i : slipping_nodes(tangential, state.traction))
      {
        const double falls = loads.friction[i] * state.pressure[i] *
                             loads.friction_law->slope(speeds[i]),
                     gain = References::falling_friction_gain(falls, bodies);
        if (gain <= largest)
          continue;
        largest  = gain;
        fall     = falls;
        position = problem.operators.positions()[i];
      }
  }

  double IllPosedFriction::growth() const
  {
    return References::falling_friction_growth(fall,
                                               half_spaces(scene),
                                               2 * element_size);
  }

  std::string IllPosedFriction::complaint() const
  {
    const double s = growth();
    if (s == 0.)
      return "";
    return "Friction falls with the sliding speed of each node at once, up to "
           "p |dmu/dv| = " +
           significant(fall, 3) + " Pa s/m, " + significant(largest, 3) +
           " times what the bodies radiate as waves, at x = " +
           millimetres(position[0]) +
           (scene.dimension == 3 ? ", y = " + millimetres(position[1]) : "") +
           ". The contact alone is unstable then: waves of two elements (" +
           millimetres(2 * element_size) + ") grow by about " +
           significant(s, 2) +
           " 1/s and shorter ones faster, so that neither smaller steps nor "
           "finer elements have a limit. Give friction a memory: "
           "Contact/Friction response = patch mean with Contact/Friction "
           "memory (s), or Contact/Friction memory length (m).";
  }
} // namespace RollingContact
