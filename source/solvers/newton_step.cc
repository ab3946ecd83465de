#include <rolling_contact/algebra/krylov_solver.h>
#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/solvers/newton_step.h>

#include <array>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * An unknown of a Newton step: how far the traction of a node goes in a
     * direction. A node that sticks has two of them, one that slides the one
     * along its bound, as the step across is known.
     */
    struct NewtonUnknown
    {
      std::size_t           first; ///< of the node's two tractions
      std::array<double, 2> direction;
      double                weight, diagonal; ///< of its row

      double along(const std::vector<double> &values) const
      {
        return direction[0] * values[first] + direction[1] * values[first + 1];
      }
    };

    /**
     * The linear system of a Newton step.
     */
    class StepSystem
    {
    public:
      StepSystem(const TouchingFriction    &friction,
                 const std::vector<double> &traction,
                 const double               rho)
        : friction(friction)
        , rho(rho)
        , known(traction.size(), 0.)
      {
        find_unknowns(traction);
      }

      /**
       * The right hand side of each unknown: -rho s of nodes that stick, the
       * step across the bound of those that slide, less what known steps do.
       */
      std::vector<double> right_side() const
      {
        const std::vector<double> slip_of_known =
          friction.change_of_slip(known);
        std::vector<double> values;
        for (const NewtonUnknown &of : unknowns)
          values.push_back(of.weight *
                           (of.along(right) - rho * of.along(slip_of_known)));
        return values;
      }

      DenseMatrix matrix() const;

      std::vector<double> operator()(const std::vector<double> &x) const
      {
        const std::vector<double> slip =
          friction.change_of_slip(step(x, std::vector<double>(known.size())));
        std::vector<double> result;
        for (std::size_t i = 0; i < x.size(); ++i)
          result.push_back(unknowns[i].weight * rho * unknowns[i].along(slip) +
                           unknowns[i].diagonal * x[i]);
        return result;
      }

      /**
       * The step of all tractions.
       */
      std::vector<double> step(const std::vector<double> &x) const
      {
        return step(x, known);
      }

      /**
       * Numbers of the unknowns of a node with these tractions.
       */
      std::vector<std::size_t> of_node(const std::size_t first) const
      {
        std::vector<std::size_t> numbers;
        for (std::size_t k = first_of_node[first / 2];
             k < unknowns.size() && unknowns[k].first == first;
             ++k)
          numbers.push_back(k);
        return numbers;
      }

      const TouchingFriction    &friction;
      const double               rho;
      std::vector<NewtonUnknown> unknowns;

    private:
      void find_unknowns(const std::vector<double> &traction);

      std::vector<double> step(const std::vector<double> &x,
                               std::vector<double>        from) const
      {
        for (std::size_t j = 0; j < x.size(); ++j)
          for (unsigned int c = 0; c < 2; ++c)
            from[unknowns[j].first + c] += x[j] * unknowns[j].direction[c];
        return from;
      }

      std::vector<double>      right, known;
      std::vector<std::size_t> first_of_node;
    };

    void StepSystem::find_unknowns(const std::vector<double> &traction)
    {
      const std::vector<double> slip = friction.slip(traction);
      right.assign(traction.size(), 0.);
      for (std::size_t k = 0; k < traction.size(); k += 2)
        {
          first_of_node.push_back(unknowns.size());
          const std::array<double, 2> z{
            {traction[k] - rho * slip[k], traction[k + 1] - rho * slip[k + 1]}};
          const double size = std::hypot(z[0], z[1]);
          if (size <= friction.bound[k])
            {
              right[k]     = -rho * slip[k];
              right[k + 1] = -rho * slip[k + 1];
              unknowns.push_back({k, {{1., 0.}}, 1., 0.});
              unknowns.push_back({k, {{0., 1.}}, 1., 0.});
              continue;
            }
          const double scale = friction.bound[k] / size;
          for (unsigned int c = 0; c < 2; ++c)
            right[k + c] = known[k + c] = scale * z[c] - traction[k + c];
          unknowns.push_back(
            {k, {{-z[1] / size, z[0] / size}}, scale, 1 - scale});
        }
    }

    DenseMatrix StepSystem::matrix() const
    {
      const DenseMatrix  &A = friction.slip_compliance;
      const std::size_t   m = unknowns.size();
      std::vector<double> column(known.size());
      DenseMatrix         M(m, m);
      for (std::size_t j = 0; j < m; ++j)
        {
          const NewtonUnknown &of = unknowns[j];
          as_vector(column)       = of.direction[0] * A.col(of.first) +
                              of.direction[1] * A.col(of.first + 1);
          for (std::size_t i = 0; i < m; ++i)
            M(i, j) = unknowns[i].weight * rho * unknowns[i].along(column);
          M(j, j) += of.diagonal;
        }
      return M;
    }

    /**
     * The inverse of what the nodes of each line along the flow do to each
     * other.
     */
    class LineInverses
    {
    public:
      explicit LineInverses(const StepSystem &system)
        : n(system.unknowns.size())
      {
        for (const TouchingFriction::Line &line : system.friction.lines)
          add(system, line);
      }

      /** False if one is singular. */
      bool exist() const
      {
        return all_exist;
      }

      std::vector<double> operator()(const std::vector<double> &x) const
      {
        std::vector<double> result(n);
        for (const auto &[numbers, inverse] : lines)
          as_vector(result)(numbers) = inverse * as_vector(x)(numbers);
        return result;
      }

    private:
      struct Inverse
      {
        std::vector<std::size_t> numbers;
        DenseMatrix              matrix;
      };

      void add(const StepSystem &system, const TouchingFriction::Line &line);

      std::size_t          n;
      std::vector<Inverse> lines;
      bool                 all_exist = true;
    };

    void LineInverses::add(const StepSystem             &system,
                           const TouchingFriction::Line &line)
    {
      std::vector<std::size_t> numbers, places; ///< and nodes on the line
      for (std::size_t k = 0; k < line.first.size(); ++k)
        for (const std::size_t number : system.of_node(line.first[k]))
          {
            numbers.push_back(number);
            places.push_back(2 * k);
          }
      const std::size_t m = numbers.size();
      DenseMatrix       M(m, m), inverse = DenseMatrix::Identity(m, m);
      for (std::size_t j = 0; j < m; ++j)
        for (std::size_t i = 0; i < m; ++i)
          {
            const NewtonUnknown &of = system.unknowns[numbers[i]],
                                &by = system.unknowns[numbers[j]];
            double slip             = 0.;
            for (unsigned int a = 0; a < 2; ++a)
              for (unsigned int b = 0; b < 2; ++b)
                slip += of.direction[a] * by.direction[b] *
                        line.slip_compliance(places[i] + a, places[j] + b);
            M(i, j) =
              of.weight * system.rho * slip + (i == j ? of.diagonal : 0.);
          }
      all_exist = all_exist && solve_general(M, inverse);
      lines.push_back({std::move(numbers), std::move(inverse)});
    }
  } // namespace

  bool newton_step(const TouchingFriction    &friction,
                   const std::vector<double> &traction,
                   const double               rho,
                   const double               tolerance,
                   std::vector<double>       &step)
  {
    const StepSystem    system(friction, traction, rho);
    std::vector<double> x = system.right_side();
    if (!friction.is_on_grid())
      {
        DenseMatrix matrix = system.matrix();
        if (!solve_general(matrix, as_vector(x)))
          return false;
        step = system.step(x);
        return true;
      }
    const LineInverses lines(system);
    if (!lines.exist())
      return false;
    // a step that falls short of the tolerance is one to try all the same
    const unsigned int most = 100;
    step                    = system.step(solved_by_krylov(
      std::cref(system), std::cref(lines), x, tolerance, most));
    return true;
  }
} // namespace RollingContact
