#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/sliding_response.h>

#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Unit vector along which a node slides, or would: against its traction.
     */
    std::array<double, 2> direction(const NodalField  &traction,
                                    const unsigned int node)
    {
      const double          size = traction.norm_at(node);
      std::array<double, 2> e{{1., 0.}};
      for (unsigned int c = 0; c < traction.n_components() && size > 0.; ++c)
        e[c] = -traction(c, node) / size;
      return e;
    }

    /**
     * Turn components x, y of rows and columns 2k, 2k + 1 into those along and
     * across the directions.
     */
    void rotate(const std::vector<std::array<double, 2>> &directions,
                DenseMatrix                              &A)
    {
      for (std::size_t k = 0; k < directions.size(); ++k)
        {
          Eigen::Matrix2d turn;
          turn << directions[k][0], directions[k][1], -directions[k][1],
            directions[k][0];
          A.middleCols<2>(2 * k) = A.middleCols<2>(2 * k) * turn.transpose();
          A.middleRows<2>(2 * k) = turn * A.middleRows<2>(2 * k);
        }
    }

    using Places = std::vector<std::size_t>;

    /**
     * A_ee - A_eo (A_oo + C)^-1 A_oe.
     */
    DenseMatrix condensed(const DenseMatrix         &A,
                          const Places              &e,
                          const Places              &o,
                          const std::vector<double> &C)
    {
      if (o.empty() || e.empty())
        return A(e, e);
      DenseMatrix A_oo = A(o, o), X = A(o, e);
      A_oo.diagonal() += as_vector(C);
      if (!solve_general(A_oo, X))
        return {};
      return A(e, e) - DenseMatrix(A(e, o)) * X;
    }
  } // namespace

  namespace
  {
    /**
     * The touching unknowns, components of a node side by side, and which of
     * them are the e and the others of sliding_response().
     */
    struct Unknowns
    {
      Unknowns(const TangentialProblem         &problem,
               const NodalField                &traction,
               const std::vector<unsigned int> &nodes);

      std::vector<NodalIndex>            all;
      std::vector<std::array<double, 2>> directions;
      Places                             e, o;
      std::vector<double>                C; ///< of the others, 1/Pa
    };

    Unknowns::Unknowns(const TangentialProblem         &problem,
                       const NodalField                &traction,
                       const std::vector<unsigned int> &nodes)
    {
      const std::size_t n    = problem.contact.n_nodes();
      const NodalField  slip = problem.slip(traction);
      std::vector<bool> moves(n, false), slips(n, false);
      for (const unsigned int i : nodes)
        moves[i] = true;
      for (const unsigned int i : slipping_nodes(problem, traction))
        slips[i] = true;
      std::vector<std::size_t> first(n, 0);
      for (unsigned int i = 0; i < n; ++i)
        if (problem.bound[i] > 0.)
          {
            first[i] = all.size();
            directions.push_back(direction(traction, i));
            for (unsigned int c = 0; c < problem.contact.n_tangential(); ++c)
              {
                const bool across = c == 1;
                if (across || !moves[i])
                  {
                    o.push_back(all.size());
                    C.push_back(across && slips[i]
                                  ? slip.norm_at(i) / problem.bound[i]
                                  : 0.);
                  }
                all.push_back({c, i});
              }
          }
      for (const unsigned int i : nodes)
        e.push_back(first[i]);
    }
  } // namespace

  DenseMatrix sliding_response(const TangentialProblem         &problem,
                               const NodalField                &traction,
                               const std::vector<unsigned int> &nodes)
  {
    const Unknowns unknowns(problem, traction, nodes);
    DenseMatrix    A = problem.slip_compliance(unknowns.all);
    if (problem.contact.n_tangential() == 2)
      rotate(unknowns.directions, A);
    DenseMatrix R = condensed(A, unknowns.e, unknowns.o, unknowns.C);
    if (problem.contact.n_tangential() == 1) // directions are signs
      for (Eigen::Index k = 0; k < R.rows(); ++k)
        {
          R.row(k) *= unknowns.directions[unknowns.e[k]][0];
          R.col(k) *= unknowns.directions[unknowns.e[k]][0];
        }
    return R;
  }

  std::vector<unsigned int> slipping_nodes(const TangentialProblem &problem,
                                           const NodalField        &traction)
  {
    const NodalField trial = problem.trial(traction, problem.slip(traction));
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < problem.contact.n_nodes(); ++i)
      if (problem.bound[i] > 0. && trial.norm_at(i) > problem.bound[i])
        nodes.push_back(i);
    return nodes;
  }
} // namespace RollingContact
