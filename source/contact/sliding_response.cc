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
    std::array<double, 2>
    direction(const NodalField &traction, const unsigned int node)
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
    void
    rotate(const std::vector<std::array<double, 2>> &directions, DenseMatrix &A)
    {
      const auto turn =
        [](const std::array<double, 2> &e, double &first, double &second) {
          const double along = e[0] * first + e[1] * second;
          second             = -e[1] * first + e[0] * second;
          first              = along;
        };
      for (std::size_t k = 0; k < directions.size(); ++k)
        {
          for (std::size_t i = 0; i < A.n_rows(); ++i)
            turn(directions[k], A(i, 2 * k), A(i, 2 * k + 1));
          for (std::size_t j = 0; j < A.n_columns(); ++j)
            turn(directions[k], A(2 * k, j), A(2 * k + 1, j));
        }
    }



    using Places = std::vector<std::size_t>;

    DenseMatrix
    block(const DenseMatrix &A, const Places &rows, const Places &columns)
    {
      DenseMatrix result(rows.size(), columns.size());
      for (std::size_t j = 0; j < columns.size(); ++j)
        for (std::size_t i = 0; i < rows.size(); ++i)
          result(i, j) = A(rows[i], columns[j]);
      return result;
    }



    /**
     * A_ee - A_eo (A_oo + C)^-1 A_oe.
     */
    DenseMatrix
    condensed(const DenseMatrix         &A,
              const Places              &e,
              const Places              &o,
              const std::vector<double> &C)
    {
      DenseMatrix result = block(A, e, e);
      if (o.empty() || e.empty())
        return result;
      DenseMatrix A_oo = block(A, o, o), X = block(A, o, e);
      for (std::size_t k = 0; k < o.size(); ++k)
        A_oo(k, k) += C[k];
      if (!solve_general(A_oo, X))
        return {};
      const DenseMatrix   A_eo = block(A, e, o);
      std::vector<double> x(o.size()), y(e.size());
      for (std::size_t j = 0; j < e.size(); ++j)
        {
          x.assign(X.data() + j * o.size(), X.data() + (j + 1) * o.size());
          A_eo.multiply_block(0, 0, x, y);
          for (std::size_t i = 0; i < e.size(); ++i)
            result(i, j) -= y[i];
        }
      return result;
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



  DenseMatrix
  sliding_response(const TangentialProblem         &problem,
                   const NodalField                &traction,
                   const std::vector<unsigned int> &nodes)
  {
    const Unknowns unknowns(problem, traction, nodes);
    DenseMatrix    A = problem.slip_compliance(unknowns.all);
    if (problem.contact.n_tangential() == 2)
      rotate(unknowns.directions, A);
    DenseMatrix R = condensed(A, unknowns.e, unknowns.o, unknowns.C);
    if (problem.contact.n_tangential() == 1) // directions are signs
      for (std::size_t j = 0; j < R.n_columns(); ++j)
        for (std::size_t i = 0; i < R.n_rows(); ++i)
          R(i, j) *= unknowns.directions[unknowns.e[i]][0] *
                     unknowns.directions[unknowns.e[j]][0];
    return R;
  }



  std::vector<unsigned int>
  slipping_nodes(const TangentialProblem &problem, const NodalField &traction)
  {
    const NodalField trial = problem.trial(traction, problem.slip(traction));
    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < problem.contact.n_nodes(); ++i)
      if (problem.bound[i] > 0. && trial.norm_at(i) > problem.bound[i])
        nodes.push_back(i);
    return nodes;
  }
} // namespace RollingContact
