#include <rolling_contact/analyses/convergence.h>
#include <rolling_contact/analyses/study_errors.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  bool StudyKey::operator<(const StudyKey &other) const
  {
    return std::tie(method, state, elements) <
           std::tie(other.method, other.state, other.elements);
  }

  void MeanAndLargest::add(const double value)
  {
    mean    = (n * mean + value) / (n + 1);
    largest = std::max(largest, std::abs(value));
    ++n;
  }

  namespace
  {
    using MeanForce = std::array<double, 2>;

    /** Means of forces and load over the samples of a mesh. */
    std::array<double, 3> mean_values(const std::vector<StudySample> &samples)
    {
      std::array<double, 3> mean{};
      for (const StudySample &sample : samples)
        {
          mean[0] += sample.force[0] / samples.size();
          mean[1] += sample.force[1] / samples.size();
          mean[2] += sample.load / samples.size();
        }
      return mean;
    }

    /**
     * The component a direction is judged by; none for the whole vector.
     */
    std::optional<unsigned int> judged_component(const std::string &direction)
    {
      if (direction == "combined")
        return {};
      return direction == "longitudinal" ? 0 : 1;
    }

    MeanForce difference(const MeanForce &a, const MeanForce &b)
    {
      return {{a[0] - b[0], a[1] - b[1]}};
    }

    double length(const MeanForce &force)
    {
      return std::hypot(force[0], force[1]);
    }
  } // namespace

  std::vector<unsigned int> reference_meshes(const StudyParameters &study)
  {
    const unsigned int n = study.reference_elements;
    return study.extrapolate_reference
             ? std::vector<unsigned int>{n, n / 2, n / 4}
             : std::vector<unsigned int>{n};
  }

  StudyReference study_reference(const StudyParameters &study,
                                 const StudyResults    &results,
                                 const std::size_t      state)
  {
    const unsigned int n    = study.reference_elements;
    const auto         mean = [&](const unsigned int elements) {
      return mean_values(
        results.samples.at({results.reference_method, state, elements}));
    };
    const auto     fine = mean(n);
    StudyReference reference{{{fine[0], fine[1]}}, fine[2], 0., 0.};
    if (!study.extrapolate_reference)
      return reference;
    const auto middle = mean(n / 2), coarse = mean(n / 4);
    const auto change = [](const auto &a, const auto &b) {
      return std::hypot(a[0] - b[0], a[1] - b[1]);
    };
    // one order for both components of the force
    reference.order =
      observed_order(change(middle, coarse), change(fine, middle));
    for (const unsigned int c : {0, 1})
      reference.force[c] =
        extrapolated(middle[c], fine[c], 2., reference.order);
    reference.load =
      extrapolated(middle[2],
                   fine[2],
                   2.,
                   observed_order(middle[2] - coarse[2], fine[2] - middle[2]));
    reference.change =
      std::hypot(reference.force[0] - fine[0], reference.force[1] - fine[1]);
    return reference;
  }

  namespace
  {
    void add_if_known(const std::optional<double> &value, MeanAndLargest &error)
    {
      if (value)
        error.add(*value);
    }

    /** Means of seconds and sizes, largest residual and memory. */
    void add_costs(const StudySample &sample,
                   const double       share,
                   StudyErrors       &errors)
    {
      errors.seconds.add(share, sample.seconds);
      errors.n_unknowns += share * sample.n_unknowns;
      errors.n_contact_nodes += share * sample.n_contact_nodes;
      errors.residual    = std::max(errors.residual, sample.residual);
      errors.peak_memory = std::max(errors.peak_memory, sample.peak_memory);
      ++errors.n_states;
      errors.n_not_converged += !sample.converged;
    }
  } // namespace

  StudyErrors study_errors(const StudyCase                &state,
                           const StudyReference           &limit,
                           const std::vector<StudySample> &samples)
  {
    const auto  component = judged_component(state.direction);
    StudyErrors errors;
    MeanForce   sum{};
    for (const StudySample &sample : samples)
      {
        add_costs(sample, 1. / samples.size(), errors);
        if (!sample.converged)
          continue;
        const MeanForce error = difference(sample.force, limit.force);
        for (const unsigned int c : {0, 1})
          sum[c] += error[c];
        errors.force.add(component
                           ? std::copysign(1., limit.force[*component]) *
                               error[*component]
                           : length(error));
        errors.load.add(
          sample.errors.load.value_or(sample.load / limit.load - 1));
        add_if_known(sample.errors.pressure_l2, errors.pressure);
        add_if_known(sample.errors.traction_l2, errors.traction);
        add_if_known(sample.errors.sawtooth, errors.sawtooth);
        add_if_known(sample.errors.stick_boundary, errors.stick_boundary);
      }
    if (!component && errors.force.n > 0)
      errors.force.mean = length(sum) / errors.force.n;
    return errors;
  }

  namespace
  {
    /** The largest of all; the mean of sizes of means. */
    void widen(MeanAndLargest &worst, const MeanAndLargest &error)
    {
      worst.largest = std::max(worst.largest, error.largest);
      if (error.n > 0)
        worst.mean = (worst.n * worst.mean + error.n * std::abs(error.mean)) /
                     (worst.n + error.n);
      worst.n += error.n;
    }
  } // namespace

  StudyErrors worst_case(const std::vector<StudyErrors> &cases)
  {
    StudyErrors worst;
    for (const StudyErrors &errors : cases)
      {
        const double share = 1. / cases.size();
        widen(worst.force, errors.force);
        widen(worst.load, errors.load);
        widen(worst.pressure, errors.pressure);
        widen(worst.traction, errors.traction);
        widen(worst.stick_boundary, errors.stick_boundary);
        worst.seconds.add(share, errors.seconds);
        worst.n_unknowns += share * errors.n_unknowns;
        worst.n_contact_nodes += share * errors.n_contact_nodes;
        worst.residual    = std::max(worst.residual, errors.residual);
        worst.peak_memory = std::max(worst.peak_memory, errors.peak_memory);
        worst.n_states += errors.n_states;
        worst.n_not_converged += errors.n_not_converged;
      }
    return worst;
  }
} // namespace RollingContact
