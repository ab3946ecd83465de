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
    /** The next number from @p least on that FFTW transforms fast. */
    std::size_t fast_size(const std::size_t least)
    {
      for (std::size_t n = least;; ++n)
        {
          std::size_t rest = n;
          for (const std::size_t prime : {2, 3, 5, 7})
            while (rest % prime == 0)
              rest /= prime;
          if (rest == 1 && n % 2 == 0)
            return n;
        }
    }
  } // namespace

  /** The grid of the circulant matrices and the transforms on it. */
  struct GridConvolution::Circle
  {
    Circle(const std::size_t n_x, const std::size_t n_y)
      : wide(fast_size(2 * n_x - 1))
      , high(fast_size(2 * n_y - 1))
    {
      std::vector<double> values(wide * high);
      Sums                sums(n_sums());
      there = planned([&]() {
        return fftw_plan_dft_r2c_2d(high,
                                    wide,
                                    values.data(),
                                    fftw_data(sums),
                                    FFTW_ESTIMATE | FFTW_UNALIGNED);
      });
      back  = planned([&]() {
        return fftw_plan_dft_c2r_2d(high,
                                    wide,
                                    fftw_data(sums),
                                    values.data(),
                                    FFTW_ESTIMATE | FFTW_UNALIGNED);
      });
    }

    std::size_t n_sums() const
    {
      return high * (wide / 2 + 1);
    }

    Sums sums(std::vector<double> values) const
    {
      Sums result(n_sums());
      fftw_execute_dft_r2c(there.get(), values.data(), fftw_data(result));
      return result;
    }

    /** Sums of values on a corner of n_x times n_y places, 0 elsewhere. */
    Sums sums_of_corner(const double     *values,
                        const std::size_t n_x,
                        const std::size_t n_y) const
    {
      std::vector<double> all(wide * high, 0.);
      for (std::size_t j = 0; j < n_y; ++j)
        std::copy_n(&values[n_x * j], n_x, &all[wide * j]);
      return sums(std::move(all));
    }

    /** The values on that corner, to the end of @p result. */
    void add_corner(Sums                 sums,
                    const std::size_t    n_x,
                    const std::size_t    n_y,
                    std::vector<double> &result) const
    {
      std::vector<double> all(wide * high);
      fftw_execute_dft_c2r(back.get(), fftw_data(sums), all.data());
      for (std::size_t j = 0; j < n_y; ++j)
        result.insert(result.end(), &all[wide * j], &all[wide * j] + n_x);
    }

    const std::size_t wide, high;

  private:
    Plan there, back;
  };

  GridConvolution::GridConvolution(const std::size_t  n_x,
                                   const std::size_t  n_y,
                                   const unsigned int n_components,
                                   const Influence   &influence)
    : n_x(n_x)
    , n_y(n_y)
    , n_components(n_components)
    , circle(std::make_shared<const Circle>(n_x, n_y))
  {
    const int wide = circle->wide, high = circle->high, reach_x = n_x - 1,
              reach_y = n_y - 1;
    for (unsigned int of = 0; of < n_components; ++of)
      for (unsigned int by = 0; by < n_components; ++by)
        {
          std::vector<double> values(circle->wide * circle->high, 0.);
          for (int j = -reach_y; j <= reach_y; ++j)
            for (int i = -reach_x; i <= reach_x; ++i)
              values[(j + high) % high * wide + (i + wide) % wide] =
                influence(i, j, of, by) / values.size();
          factors.push_back(circle->sums(std::move(values)));
        }
  }

  std::vector<double>
  GridConvolution::multiply(const std::vector<double> &values,
                            const unsigned int         by_first,
                            const unsigned int         of_first,
                            const unsigned int         of_end) const
  {
    const std::size_t n = n_x * n_y;
    std::vector<Sums> products(of_end - of_first, Sums(circle->n_sums(), 0.));
    for (std::size_t k = 0; k < values.size() / n; ++k)
      {
        const Sums sums = circle->sums_of_corner(&values[k * n], n_x, n_y);
        for (unsigned int of = of_first; of < of_end; ++of)
          {
            const Sums &factor  = factors[of * n_components + by_first + k];
            Sums       &product = products[of - of_first];
            for (std::size_t m = 0; m < sums.size(); ++m)
              product[m] += factor[m] * sums[m];
          }
      }
    std::vector<double> result;
    result.reserve(products.size() * n);
    for (Sums &product : products)
      circle->add_corner(std::move(product), n_x, n_y, result);
    return result;
  }

  std::vector<double>
  GridConvolution::divide(const std::vector<double> &product,
                          const unsigned int         component) const
  {
    const Sums  &factor = factors[component * n_components + component];
    Sums         sums   = circle->sums_of_corner(product.data(), n_x, n_y);
    const double n_all  = circle->wide * circle->high,
                 least  = 1e-4 * std::abs(factor[0].real());
    for (std::size_t m = 0; m < sums.size(); ++m)
      sums[m] /= n_all * n_all * std::max(least, std::abs(factor[m].real()));
    std::vector<double> result;
    circle->add_corner(std::move(sums), n_x, n_y, result);
    return result;
  }

  std::size_t GridConvolution::memory_consumption() const
  {
    return factors.size() * circle->n_sums() * sizeof(std::complex<double>);
  }

  namespace
  {
    /** What FFTW makes of a direction; of a single value itself. */
    struct Transform
    {
      fftw_r2r_kind       there, back;
      double              factor; ///< of there and back
      std::vector<double> wave_numbers;
    };

    Transform transform_of(const GridDirection &direction)
    {
      const std::size_t n        = direction.n;
      const bool        mirrored = !direction.again && n > 1;
      const double      period   = mirrored ? 2. * (n - 1.) : n;
      Transform         found{mirrored ? FFTW_REDFT00 : FFTW_R2HC,
                      mirrored ? FFTW_REDFT00 : FFTW_HC2R,
                      period,
                      {}};
      // real parts of waves come first, imaginary ones from the end
      for (std::size_t k = 0; k < n; ++k)
        found.wave_numbers.push_back((mirrored ? k : std::min(k, n - k)) /
                                     (period * direction.spacing));
      return found;
    }
  } // namespace

  void
  scale_waves(std::vector<double>                                     &values,
              const GridDirection                                     &along,
              const GridDirection                                     &across,
              const std::function<double(const double, const double)> &factor)
  {
    const Transform x = transform_of(along), y = transform_of(across);
    const auto      transform = [&](const fftw_r2r_kind of_x,
                               const fftw_r2r_kind of_y) {
      run([&]() {
        return fftw_plan_r2r_2d(static_cast<int>(across.n),
                                static_cast<int>(along.n),
                                values.data(),
                                values.data(),
                                of_y,
                                of_x,
                                FFTW_ESTIMATE);
      });
    };
    transform(x.there, y.there);
    for (std::size_t l = 0; l < across.n; ++l)
      for (std::size_t k = 0; k < along.n; ++k)
        values[l * along.n + k] *=
          factor(x.wave_numbers[k], y.wave_numbers[l]) / (x.factor * y.factor);
    transform(x.back, y.back);
  }
} // namespace RollingContact::Signals
