#include <fftw3.h>

#include <rolling_contact/algebra/fourier.h>

#include <algorithm>
#include <mutex>

namespace RollingContact::Signals
{
  namespace
  {
    /**
     * Make a plan, execute it and destroy it. Of FFTW's functions only
     * fftw_execute() may be called by several threads at once.
     */
    void run(const std::function<fftw_plan()> &make_plan)
    {
      static std::mutex planner;
      const fftw_plan   plan = [&]() {
        const std::lock_guard<std::mutex> alone(planner);
        return make_plan();
      }();
      fftw_execute(plan);
      const std::lock_guard<std::mutex> alone(planner);
      fftw_destroy_plan(plan);
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

  namespace
  {
    using Sums = std::vector<std::complex<double>>;

    Sums sums_of_grid(std::vector<double> values,
                      const std::size_t   n_x,
                      const std::size_t   n_y)
    {
      Sums sums(n_y * (n_x / 2 + 1));
      run([&]() {
        return fftw_plan_dft_r2c_2d(
          n_y, n_x, values.data(), fftw_data(sums), FFTW_ESTIMATE);
      });
      return sums;
    }
  } // namespace

  EvenToeplitz::EvenToeplitz(
    const std::size_t                                  n_x,
    const std::size_t                                  n_y,
    const std::function<double(const int, const int)> &entry)
    : n_x(n_x)
    , n_y(n_y)
    , wide(2 * n_x)
    , high(2 * n_y)
  {
    std::vector<double> circle(wide * high, 0.);
    for (std::size_t j = 0; j < n_y; ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        {
          const double value = entry(i, j);
          for (const std::size_t row : {j, (high - j) % high})
            for (const std::size_t place : {i, (wide - i) % wide})
              circle[row * wide + place] = value;
        }
    for (const auto &sum : sums_of_grid(std::move(circle), wide, high))
      factors.push_back(sum.real() / (wide * high));
  }

  std::vector<double>
  EvenToeplitz::multiply(const std::vector<double> &values) const
  {
    std::vector<double> circle(wide * high, 0.), result;
    for (std::size_t j = 0; j < n_y; ++j)
      std::copy_n(&values[n_x * j], n_x, &circle[wide * j]);
    Sums sums = sums_of_grid(circle, wide, high);
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] *= factors[k];
    run([&]() {
      return fftw_plan_dft_c2r_2d(
        high, wide, fftw_data(sums), circle.data(), FFTW_ESTIMATE);
    });
    for (std::size_t j = 0; j < n_y; ++j)
      result.insert(result.end(), &circle[wide * j], &circle[wide * j + n_x]);
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
