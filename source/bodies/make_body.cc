#include <rolling_contact/bodies/distributed_body.h>
#include <rolling_contact/bodies/make_body.h>

#include <cmath>

namespace RollingContact
{
  template <int dim>
  std::shared_ptr<ElasticBody<dim>>
  make_body(const BodySolver                        solver,
            const std::shared_ptr<const BodyShape> &shape,
            const Material                         &material,
            const double                            thickness,
            const Grading<dim>                     &grading,
            const bool                              recovers,
            const unsigned int                      model_rank,
            const BodyModel                        &model)
  {
    if (solver == BodySolver::distributed)
      return std::make_shared<DistributedBody<dim>>(
        shape, material, thickness, grading, model_rank, model);
    return std::make_shared<DirectBody<dim>>(
      shape, material, thickness, grading, recovers, model);
  }

  template <int dim>
  double direct_memory(const std::size_t n_unknowns)
  {
    const double n = n_unknowns;
    return dim == 2 ? 100 * n * std::log2(n + 2) : 200 * std::pow(n, 4. / 3);
  }

  template std::shared_ptr<ElasticBody<2>>
  make_body(const BodySolver,
            const std::shared_ptr<const BodyShape> &,
            const Material &,
            const double,
            const Grading<2> &,
            const bool,
            const unsigned int,
            const BodyModel &);
  template std::shared_ptr<ElasticBody<3>>
                  make_body(const BodySolver,
                            const std::shared_ptr<const BodyShape> &,
                            const Material &,
                            const double,
                            const Grading<3> &,
                            const bool,
                            const unsigned int,
                            const BodyModel &);
  template double direct_memory<2>(const std::size_t);
  template double direct_memory<3>(const std::size_t);
} // namespace RollingContact
