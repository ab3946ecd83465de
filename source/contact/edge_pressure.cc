#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/algebra/polynomial_fit.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/contact/edge_pressure.h>
#include <rolling_contact/contact/patch_edge.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Weight of corrections far from the edge: room for the rough pressures of
     * nearly incompressible elements. Empirical; with 0.3 corrections spread so
     * far that coupled half-planes lose the accuracy of the edge law.
     */
    const double far_correction = 0.03;

    /**
     * Largest length of the window in elements. Empirical: longer windows
     * average rough pressures better, but the displacement is less quadratic on
     * them and the system to be solved larger.
     */
    const double longest_window = 32.;

    /**
     * The smooth part of a displacement is fitted from the fourth node on,
     * without the last two, on the window or at least on so many nodes.
     * Empirical: nearer to the edges the fit takes what belongs to them.
     */
    const std::size_t first_smooth = 3, last_smooth = 2, least_smooth = 14;

    /**
     * It is a polynomial of the lowest degree between these that leaves at most
     * so many times what the highest leaves, which has at most this share of
     * the nodes. Layers as thin as half a patch need the highest; where
     * displacements are rough and not smooth, as on meshes that do not match,
     * high degrees would follow that. The lowest is what EdgePressure is free
     * to take by itself.
     */
    const unsigned int least_degree = 2, most_degree = 5;
    const double       smooth_gain = 3., smooth_share = 0.6;

    /**
     * Share of the first element next to the edges of the patch where the
     * logarithm of the coupling traction, infinite there, is left out.
     */
    const double edge_margin = 0.02;

    /**
     * Nodes next to the edge that corrections are for.
     */
    const std::size_t n_disturbed = 4;

    /**
     * Where the element size changes, corrections are needed far from the edge,
     * and a polynomial would take them for a smooth displacement.
     */
    bool has_equal_spacing(const std::vector<double> &x)
    {
      for (std::size_t k = 2; k < x.size(); ++k)
        if (std::abs(x[k] - 2 * x[k - 1] + x[k - 2]) > 1e-6 * (x[1] - x[0]))
          return false;
      return true;
    }
  } // namespace

  EdgePressure::EdgePressure(const ContactProblem &contact,
                             const TouchingRun    &run,
                             const unsigned int    component)
    : operators(contact.operators)
    , run(run)
    , direction(component)
    , flow(operators.slip_operator().flow_direction())
    , x(places(run, operators))
  {}

  double EdgePressure::compliance(const std::size_t k,
                                  const std::size_t j) const
  {
    const std::size_t first = direction * operators.n_nodes();
    double            sum   = 0.;
    for (const auto &entry : operators.H_column(run.nodes[j]))
      sum +=
        operators.W()(first + run.nodes[k], first + entry.first) * entry.second;
    return sum;
  }

  std::vector<unsigned int> EdgePressure::across_first() const
  {
    const auto               &positions = operators.positions();
    const unsigned int        first     = run.nodes[0];
    const double              h         = along(1) - along(0);
    std::vector<unsigned int> nodes{first};
    for (unsigned int j = 0; j < operators.n_nodes(); ++j)
      if (j != first &&
          std::abs(positions[j][0] - positions[first][0]) < 1e-6 * h &&
          std::abs(positions[j][1] - positions[first][1]) < (0.5 - 1e-6) * h)
        nodes.push_back(j);
    return nodes;
  }

  double EdgePressure::fall_of_compliance() const
  {
    const std::size_t offset = direction * operators.n_nodes();
    double            sum    = 0.;
    for (const unsigned int node : across_first())
      for (const auto &entry : operators.H_column(node))
        sum += (operators.W()(offset + run.nodes[0], offset + entry.first) -
                operators.W()(offset + run.nodes[1], offset + entry.first)) *
               entry.second;
    return sum;
  }

  std::vector<double>
  EdgePressure::on_run(const std::vector<double> &nodal) const
  {
    std::vector<double> values;
    for (const unsigned int node : run.nodes)
      values.push_back(nodal[node]);
    return values;
  }

  std::size_t EdgePressure::window() const
  {
    // two thirds of the line, at most 32 of its largest elements
    const std::size_t n_run = run.nodes.size(), n_least = run.cut ? 4 : 6;
    if (n_run < n_least)
      return 0;
    const double length = along(n_run - 1) - along(0);
    double       reach  = run.cut ? 2 * length : 2. / 3 * length;
    double       size   = 0.;
    for (std::size_t k = 1; k < n_run && along(k - 1) - along(0) < reach; ++k)
      size = std::max(size, along(k) - along(k - 1));
    reach         = (1 - 1e-9) * std::min(reach, longest_window * size);
    std::size_t n = 0;
    while (n < n_run && along(n) - along(0) < reach)
      ++n;
    return std::max(n, n_least);
  }

  std::vector<double>
  EdgePressure::correction_scales(const std::size_t          n_window,
                                  const std::vector<double> &pressure) const
  {
    const std::size_t   n_run = run.nodes.size();
    std::vector<double> scales(n_window, far_correction);
    const auto          disturb = [&](const std::size_t e, const double size) {
      for (std::size_t k = 0; k < n_window; ++k)
        scales[k] +=
          std::pow(size / std::max(size, std::abs(along(k) - along(e))), 3);
    };
    disturb(0, along(1) - along(0));
    for (std::size_t e = 1; e < n_run; ++e)
      {
        const double before = along(e) - along(e - 1),
                     after  = e + 1 < n_run ? along(e + 1) - along(e)
                              : run.cut     ? 2 * before
                                            : before;
        if (std::abs(after - before) > 1e-6 * before)
          disturb(e, std::max(before, after));
      }
    // the first node may barely touch
    for (std::size_t k = 0; k < n_window; ++k)
      scales[k] *= k == 0 ? pressure[1] : pressure[k];
    return scales;
  }

  void EdgePressure::smooth(const std::vector<double> &displacement,
                            const std::vector<double> &pressure,
                            std::vector<double>       &field) const
  {
    const std::size_t n = window();
    if (n == 0)
      return;
    // corrections that take the displacement away, and that give 1, x and x^2
    const double length = along(n - 1) - along(0);
    DenseMatrix  matrix(n, n), corrections(n, 4);
    for (std::size_t k = 0; k < n; ++k)
      {
        for (std::size_t j = 0; j < n; ++j)
          matrix(k, j) = compliance(k, j);
        corrections(k, 0) = -displacement[k];
        for (unsigned int power = 0; power < 3; ++power)
          corrections(k, 1 + power) =
            std::pow((along(k) - along(0)) / length, power);
      }
    if (!solve_general(matrix, corrections))
      return;
    const std::vector<double> scales = correction_scales(n, pressure);
    const auto          weight = as_vector(scales).cwiseInverse().asDiagonal();
    DenseMatrix         powers = weight * -corrections.rightCols<3>();
    std::vector<double> coefficients(n);
    as_vector(coefficients) = weight * corrections.col(0);
    if (solve_least_squares(powers, coefficients))
      as_vector(field).head(n) +=
        corrections.col(0) +
        corrections.rightCols<3>() * as_vector(coefficients);
  }

  std::vector<double>
  EdgePressure::without_smooth_part(std::vector<double>          displacement,
                                    const unsigned int           lowest,
                                    std::optional<unsigned int> &degree) const
  {
    const std::size_t n = run.nodes.size();
    if (run.cut || !has_equal_spacing(x) ||
        n <= least_degree + first_smooth + last_smooth)
      return displacement;
    const std::size_t end =
      std::min(n - last_smooth, std::max(window(), least_smooth));
    const unsigned int most =
      std::min<double>(most_degree, smooth_share * (end - first_smooth));
    if (most <= least_degree)
      return displacement;
    const auto rest = [&](const unsigned int of) {
      return without_polynomial(x, displacement, first_smooth, end, of);
    };
    const auto size = [&](const std::vector<double> &values) {
      double sum = 0.;
      for (std::size_t k = first_smooth; k < end; ++k)
        sum += values[k] * values[k];
      return std::sqrt(sum);
    };
    if (!degree)
      {
        const double smallest = size(rest(most));
        degree                = std::min(lowest, most);
        while (*degree < most && size(rest(*degree)) > smooth_gain * smallest)
          ++*degree;
      }
    return rest(*degree);
  }

  std::vector<double>
  EdgePressure::equivalent(const std::vector<double>   &pressure,
                           const std::vector<double>   &surplus,
                           std::optional<unsigned int> &degree) const
  {
    const std::vector<double> p     = on_run(pressure);
    std::vector<double>       field = p;
    smooth(without_smooth_part(on_run(surplus), least_degree, degree),
           p,
           field);
    return field;
  }

  double EdgePressure::irregularity(const std::vector<double> &equivalent,
                                    const std::vector<double> &pressure) const
  {
    double largest = 0.;
    for (std::size_t k = n_disturbed; k < window(); ++k)
      largest =
        std::max(largest, std::abs(equivalent[k] / pressure[run.nodes[k]] - 1));
    return largest;
  }

  std::vector<double>
  EdgePressure::coupling_traction(const std::vector<double>   &pressure,
                                  const std::vector<double>   &moved_along,
                                  std::optional<unsigned int> &degree) const
  {
    const std::size_t         n = run.nodes.size();
    const std::vector<double> p = on_run(pressure);
    std::vector<double>       field(n, 0.);
    if (!operators.coupling().exists || n < 10 || run.cut || direction > 0)
      return field;
    if (operators.coupling().dundurs_beta == 0. && !has_equal_spacing(x))
      return field;
    const std::vector<double> x_reversed(x.rbegin(), x.rend()),
      p_reversed(p.rbegin(), p.rend());
    const double        begin  = patch_edge(x, p);
    const double        end    = patch_edge(x_reversed, p_reversed);
    const double        margin = edge_margin * (x[1] - x[0]);
    std::vector<double> moved  = on_run(moved_along);
    for (std::size_t k = 0; k < n; ++k)
      if (x[k] > begin + margin && x[k] < end - margin)
        field[k] = flow * operators.coupling().dundurs_beta / pi * p[k] *
                   std::log((x[k] - begin) / (end - x[k]));
    for (std::size_t j = 0; j < n; ++j)
      if (field[j] != 0.)
        for (std::size_t k = 0; k < n; ++k)
          moved[k] += compliance(k, j) * field[j];
    // the logarithm of unlike materials leaves a displacement of many powers
    const bool alike = operators.coupling().dundurs_beta == 0.;
    smooth(without_smooth_part(moved,
                               alike ? least_degree : most_degree,
                               degree),
           p,
           field);
    return field;
  }
} // namespace RollingContact
