#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/contact/uniqueness.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    /**
     * L of the nodes: how far the traction can fall per slip, at most. Units:
     * Pa.
     */
    std::vector<double>
    steepest_falls(const TangentialProblem         &tangential,
                   const ContactState              &state,
                   const std::vector<unsigned int> &slipping)
    {
      const ContactLoads &loads = tangential.contact.loads;
      const unsigned int  n     = tangential.contact.n_nodes();
      std::vector<double> speeds =
        tangential.sliding_speeds(tangential.slip(state.traction));
      std::vector<bool> slips(n, false);
      for (const unsigned int i : slipping)
        slips[i] = true;
      std::vector<double>           falls(n, 0.);
      std::optional<FrictionMemory> memory;
      if (loads.memory_length > 0.)
        memory.emplace(tangential.contact, speeds);
      for (unsigned int i = 0; i < n; ++i)
        if (tangential.bound[i] > 0.)
          {
            const double most = loads.friction[i] * state.pressure[i];
            falls[i] =
              most * loads.speed *
              loads.friction_law->steepest_fall(state.traction.norm_at(i) /
                                                  most,
                                                slips[i] ? speeds[i] : 0.);
            if (memory)
              falls[i] *= memory->immediate_part(i);
          }
      return falls;
    }

    /**
     * The ratio with these nodes free to fall, all others sticking.
     */
    Uniqueness ratio_of(const TangentialProblem         &tangential,
                        const ContactState              &state,
                        const std::vector<double>       &falls,
                        const std::vector<unsigned int> &nodes)
    {
      const DenseMatrix R = sliding_response(tangential, state.traction, nodes);
      if (R.size() == 0)
        return {};
      // friction that rises with the speed endangers nothing
      const Eigen::VectorXd roots =
        as_vector(falls)(nodes).cwiseMax(0.).cwiseSqrt();
      DenseMatrix matrix =
        roots.asDiagonal() * (R + R.transpose()) / 2 * roots.asDiagonal();
      const double largest = symmetric_eigenpairs(matrix).back();
      Eigen::Index place   = 0;
      matrix.rightCols<1>().cwiseAbs().maxCoeff(&place);
      return {std::max(0., largest), nodes[place]};
    }
  } // namespace

  Uniqueness uniqueness(const ContactProblem &problem,
                        const ContactState   &state)
  {
    if (!problem.loads.friction_law || problem.n_tangential() == 0)
      return {};
    const TangentialProblem tangential = tangential_problem(problem, state);
    const auto slipping = slipping_nodes(tangential, state.traction);
    const std::vector<double> falls =
      steepest_falls(tangential, state, slipping);
    std::vector<unsigned int> can_fall;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (falls[i] > 0.)
        can_fall.push_back(i);
    const Uniqueness all = ratio_of(tangential, state, falls, can_fall);
    if (can_fall == slipping)
      return all;
    const Uniqueness some = ratio_of(tangential, state, falls, slipping);
    return some.ratio > all.ratio ? some : all;
  }
} // namespace RollingContact
