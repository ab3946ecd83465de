#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/distributed/distributed_body.h>
#include <rolling_contact/distributed/make_body.h>

#include <cmath>

namespace RollingContact
{
  BodySolver
  body_solver_of(const std::string &name)
  {
    if (name == "automatic")
      return BodySolver::automatic;
    if (name == "direct")
      return BodySolver::direct;
    if (name == "distributed")
      return BodySolver::distributed;
    throw InputError("Body solver = " + name +
                     ": it is automatic, direct or distributed.");
  }



  template <int dim>
  std::shared_ptr<ElasticBody<dim>>
  make_body(const BodySolver      solver,
            const BodyParameters &parameters,
            const Grading<dim>   &grading,
            const bool            recovers,
            const unsigned int    model_rank)
  {
    if (solver == BodySolver::distributed)
      return std::make_shared<DistributedBody<dim>>(parameters.body_shape(),
                                                    parameters.material,
                                                    parameters.thickness,
                                                    grading,
                                                    model_rank);
    return std::make_shared<DirectBody<dim>>(parameters.body_shape(),
                                             parameters.material,
                                             parameters.thickness,
                                             grading,
                                             recovers);
  }



  template <int dim>
  double
  direct_memory(const std::size_t n_unknowns)
  {
    const double n = n_unknowns;
    return dim == 2 ? 100 * n * std::log2(n + 2) : 200 * std::pow(n, 4. / 3);
  }



  template std::shared_ptr<ElasticBody<2>>
  make_body(const BodySolver,
            const BodyParameters &,
            const Grading<2> &,
            const bool,
            const unsigned int);
  template std::shared_ptr<ElasticBody<3>>
  make_body(const BodySolver,
            const BodyParameters &,
            const Grading<3> &,
            const bool,
            const unsigned int);
  template double
  direct_memory<2>(const std::size_t);
  template double
  direct_memory<3>(const std::size_t);
} // namespace RollingContact
