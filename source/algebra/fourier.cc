#include <fftw3.h>

#include <rolling_contact/algebra/fourier.h>

#include <algorithm>
#include <functional>
#include <mutex>

namespace RollingContact::Signals
{
  namespace
  {
    using Plan = std::shared_ptr<std::remove_pointer_t<fftw_plan>>;

    /** A plan by FFTW, which makes and destroys one at a time; several threads
     * may execute theirs at once. */
    Plan planned(const std::function<fftw_plan()> &make_plan)
    {
      static std::mutex planner;
      const fftw_plan   plan = [&]() {
        const std::lock_guard<std::mutex> alone(planner);
        return make_plan();
      }();
      return Plan(plan, [](const fftw_plan done) {
        const std::lock_guard<std::mutex> alone(planner);
        fftw_destroy_plan(done);
      });
    }

    void run(const std::function<fftw_plan()> &make_plan)
    {
      fftw_execute(planned(make_plan).get());
    }

    fftw_complex *fftw_data(std::vector<std::complex<double>> &values)
    {
      return reinterpret_cast<fftw_complex *>(values.data());
    }

    /** Twice the value of each but the ends, by FFTW's REDFT00. */
    std::vector<double> cosine_sums(std::vector<double> values)
    {
      std::vector<double> sums(values.size());
      run([&]() {
        return fftw_plan_r2r_1d(static_cast<int>(values.size()),
                                values.data(),
                                sums.data(),
                                FFTW_REDFT00,
                                FFTW_ESTIMATE);
      });
      return sums;
    }
  } // namespace

  std::vector<std::complex<double>> fourier_sums(std::vector<double> values)
  {
    std::vector<std::complex<double>> sums(values.size() / 2 + 1);
    run([&]() {
      return fftw_plan_dft_r2c_1d(static_cast<int>(values.size()),
                                  values.data(),
                                  fftw_data(sums),
                                  FFTW_ESTIMATE);
    });
    return sums;
  }

  std::vector<double>
  values_of_fourier_sums(std::vector<std::complex<double>> sums,
                         const std::size_t                 n)
  {
    std::vector<double> values(n);
    run([&]() {
      return fftw_plan_dft_c2r_1d(static_cast<int>(n),
                                  fftw_data(sums),
                                  values.data(),
                                  FFTW_ESTIMATE);
    });
    for (double &value : values)
      value /= static_cast<double>(n);
    return values;
  }

  /** A vector of the circulant matrix, its Fourier sums, there and back. */
  struct EvenToeplitz::Circle
  {
    Circle(const int n_x, const int n_y)
      : values(n_x * n_y, 0.)
      , sums(n_y * (n_x / 2 + 1))
      , there(planned([&]() {
        return fftw_plan_dft_r2c_2d(
          n_y, n_x, values.data(), fftw_data(sums), FFTW_ESTIMATE);
      }))
      , back(planned([&]() {
        return fftw_plan_dft_c2r_2d(
          n_y, n_x, fftw_data(sums), values.data(), FFTW_ESTIMATE);
      }))
    {}

    std::vector<double>               values;
    std::vector<std::complex<double>> sums;
    const Plan                        there, back;
  };

  EvenToeplitz::EvenToeplitz(
    const std::size_t                                  n_x,
    const std::size_t                                  n_y,
    const std::function<double(const int, const int)> &entry)
    : n_x(n_x)
    , n_y(n_y)
    , wide(2 * n_x)
    , high(2 * n_y)
    , circle(std::make_shared<Circle>(wide, high))
  {
    for (std::size_t j = 0; j < n_y; ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        {
          const double value = entry(i, j);
          for (const std::size_t row : {j, (high - j) % high})
            for (const std::size_t place : {i, (wide - i) % wide})
              circle->values[row * wide + place] = value;
        }
    fftw_execute(circle->there.get());
    for (const auto &sum : circle->sums)
      factors.push_back(sum.real() / (wide * high));
  }

  std::vector<double> EvenToeplitz::multiply(const std::vector<double> &values)
  {
    std::vector<double> &all = circle->values, result;
    std::fill(all.begin(), all.end(), 0.);
    for (std::size_t j = 0; j < n_y; ++j)
      std::copy_n(&values[n_x * j], n_x, &all[wide * j]);
    fftw_execute(circle->there.get());
    for (std::size_t k = 0; k < factors.size(); ++k)
      circle->sums[k] *= factors[k];
    fftw_execute(circle->back.get());
    for (std::size_t j = 0; j < n_y; ++j)
      result.insert(result.end(), &all[wide * j], &all[wide * j + n_x]);
    return result;
  }

  std::vector<double> cosine_amplitudes(std::vector<double> values)
  {
    const std::size_t last = values.size() - 1;
    values                 = cosine_sums(std::move(values));
    for (std::size_t k = 0; k <= last; ++k)
      values[k] /= static_cast<double>(k == 0 || k == last ? 2 * last : last);
    return values;
  }

  std::vector<double>
  values_of_cosine_amplitudes(std::vector<double> amplitudes)
  {
    for (std::size_t k = 1; k + 1 < amplitudes.size(); ++k)
      amplitudes[k] /= 2;
    return cosine_sums(std::move(amplitudes));
  }
} // namespace RollingContact::Signals
