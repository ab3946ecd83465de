#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/roughness.h>
#include <rolling_contact/pair/parallel_bodies.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/pair/rolling_pair.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  RollingPair<dim>::RollingPair(const SceneParameters &scene,
                                const Grading<dim>    &grading,
                                const PairDemands     &demands,
                                const bool             statics)
    : BodyPair<dim>(scene, grading, demands, statics)
  {
    if (scene.contact.friction_coefficient > 0.)
      for (unsigned int d = 0; d < dim - 1; ++d)
        components.push_back(d);
    components.push_back(dim - 1);
  }



  namespace
  {
    /**
     * Add a body's compliance, given in its own frame. In the wheel's frame z
     * is mirrored: the blocks between tangential and normal components change
     * sign.
     */
    void
    add_compliance(const DenseMatrix &body,
                   const bool         mirrored,
                   const std::size_t  n_nodes,
                   DenseMatrix       &pair)
    {
      const std::size_t n = body.n_rows(), first_normal = n - n_nodes;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          {
            const bool flips =
              mirrored && ((i < first_normal) != (j < first_normal));
            pair(i, j) += flips ? -body(i, j) : body(i, j);
          }
    }
  } // namespace



  namespace
  {
    /**
     * Throws InputError if the dense matrices of contact space, W of each body
     * and of the pair and products of it, do not fit into 70 % of the free
     * memory.
     */
    void
    check_contact_memory(const std::size_t n_nodes,
                         const std::size_t n_components)
    {
      const double n = double(n_nodes) * n_components, n_matrices = 5;
      const double bytes = n_matrices * n * n * sizeof(double);
      const double free  = available_memory();
      if (free > 0. && bytes > 0.7 * free)
        throw InputError("The " + std::to_string(n_nodes) +
                         " contact nodes need about " + human_bytes(bytes) +
                         " for their compliance, more than 70 % of the " +
                         human_bytes(free) +
                         " free: take fewer Mesh/Elements across patch, a "
                         "smaller Mesh/Candidate zone or a smaller "
                         "Mesh/Contact node budget.");
    }
  } // namespace



  template <int dim>
  DenseMatrix
  RollingPair<dim>::pair_compliance()
  {
    check_contact_memory(std::max({this->trace().nodes.size(),
                                   this->nodes(Side::wheel).size(),
                                   this->nodes(Side::rail).size()}),
                         components.size());
    DenseMatrix wheel, rail;
    for_both_bodies(
      this->n_threads(),
      [&]() {
        if (this->body(Side::wheel))
          wheel = this->body(Side::wheel)
                    ->compliance(this->nodes(Side::wheel), components);
      },
      [&]() {
        if (this->body(Side::rail) && !this->twins())
          rail = this->body(Side::rail)
                   ->compliance(this->nodes(Side::rail), components);
      });
    return combined(std::move(wheel), std::move(rail));
  }



  template <int dim>
  DenseMatrix
  RollingPair<dim>::combined(DenseMatrix wheel, DenseMatrix rail) const
  {
    const std::size_t n_nodes = this->trace().nodes.size();
    if (this->is_elastic(Side::wheel))
      Ranks::broadcast(wheel, this->rank_of(Side::wheel));
    if (this->is_elastic(Side::rail) && !this->twins())
      Ranks::broadcast(rail, this->rank_of(Side::rail));
    wheel = this->coupling(Side::wheel).to_interface(std::move(wheel));
    rail  = this->coupling(Side::rail).to_interface(std::move(rail));
    DenseMatrix W(components.size() * n_nodes, components.size() * n_nodes);
    if (wheel.n_rows() > 0)
      add_compliance(wheel, true, n_nodes, W);
    if (this->is_elastic(Side::rail) &&
        (this->twins() ? wheel : rail).n_rows() > 0)
      add_compliance(this->twins() ? wheel : rail, false, n_nodes, W);
    return W;
  }



  template <int dim>
  std::vector<double>
  RollingPair<dim>::relative(std::vector<double> wheel,
                             std::vector<double> rail) const
  {
    const std::size_t n_nodes  = this->trace().nodes.size(),
                      n_values = components.size() * n_nodes;
    wheel                      = this->coupling(Side::wheel)
              .to_interface(this->on_all_ranks(Side::wheel, std::move(wheel)));
    rail = this->coupling(Side::rail)
             .to_interface(this->on_all_ranks(Side::rail, std::move(rail)));
    std::vector<double> result(n_values, 0.);
    for (std::size_t i = 0; i < wheel.size(); ++i)
      result[i] += i + n_nodes >= n_values ? -wheel[i] : wheel[i];
    for (std::size_t i = 0; i < rail.size(); ++i)
      result[i] -= rail[i];
    return result;
  }



  template <int dim>
  bool
  RollingPair<dim>::compliance_is_exact() const
  {
    return this->body_solver() != BodySolver::distributed;
  }



  namespace
  {
    using Loads = std::vector<std::vector<double>>;

    /**
     * Twins answer tangential forces with opposite, normal ones with equal
     * motions: of each set of forces the tangential and the normal part, where
     * there are any.
     */
    Loads
    parts_of(const Loads &forces, const std::size_t n_nodes)
    {
      Loads parts;
      for (const std::vector<double> &load : forces)
        {
          const std::size_t n_tangential = load.size() - n_nodes;
          for (const bool normal : {false, true})
            {
              std::vector<double> part = load;
              std::fill(normal ? part.begin() : part.begin() + n_tangential,
                        normal ? part.begin() + n_tangential : part.end(),
                        0.);
              parts.push_back(part);
            }
        }
      return parts;
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<double>>
  RollingPair<dim>::response(const Loads &forces, const bool roughly) const
  {
    const std::size_t n_nodes = this->trace().nodes.size();
    const auto        answers = [&](const Side side, const Loads &of) {
      Loads loads;
      for (const std::vector<double> &load : of)
        loads.push_back(on_body(side, load));
      return this->body(side)->response(this->nodes(side),
                                        components,
                                        loads,
                                        roughly);
    };
    Loads result;
    if (this->twins())
      {
        const Loads own = answers(Side::rail, parts_of(forces, n_nodes));
        for (std::size_t k = 0; k < forces.size(); ++k)
          {
            // under mirrored forces the wheel moves by -(tangential) + normal
            std::vector<double> wheel = own[2 * k + 1], rail = wheel;
            for (std::size_t i = 0; i < wheel.size(); ++i)
              {
                wheel[i] -= own[2 * k][i];
                rail[i] += own[2 * k][i];
              }
            result.push_back(relative(wheel, rail));
          }
        return result;
      }
    Loads bodies[2];
    for (const Side side : {Side::wheel, Side::rail})
      bodies[static_cast<int>(side)] =
        this->body(side) ? answers(side, forces) : Loads(forces.size());
    for (std::size_t k = 0; k < forces.size(); ++k)
      result.push_back(relative(bodies[0][k], bodies[1][k]));
    return result;
  }



  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const ContactParameters &contact)
  {
    return contact_problem(contact, pair_compliance());
  }



  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const ContactParameters &contact,
                                    DenseMatrix              W) const
  {
    const bool     friction = components.size() > 1;
    const auto    &at       = this->trace().nodes;
    ContactProblem problem;
    problem.operators =
      ContactOperators(at,
                       contact_matrix(this->trace(),
                                      contact.contact_matrices,
                                      dim == 2 ? this->scene.thickness() : 1.),
                       std::move(W),
                       friction ? SlipOperator(this->trace(),
                                               contact.slip_operator,
                                               contact.contact_matrices,
                                               contact.flow())
                                : SlipOperator(contact.slip_operator),
                       {!this->twins() && friction,
                        pair_constants(this->scene).dundurs_beta});
    const auto wheel = this->scene.wheel.body_shape(),
               rail  = this->scene.rail.body_shape();
    const Roughness roughness(contact.roughness);
    const auto      height =
      [&](const Side side, const BodyShape &shape, const std::size_t i) {
        const std::vector<double> &given = this->heights(side);
        return given.empty() ? shape.surface_height(at[i][0], at[i][1])
                             : given[i];
      };
    ContactLoads &loads = problem.loads;
    for (std::size_t i = 0; i < at.size(); ++i)
      loads.gap.push_back(-height(Side::wheel, *wheel, i) -
                          height(Side::rail, *rail, i) +
                          roughness.value(at[i][0], at[i][1]));
    loads.friction.assign(at.size(), contact.friction_coefficient);
    loads.friction_law = contact.falling_friction();
    loads.speed        = std::abs(contact.rolling_speed());
    loads.creepages    = contact.creepages;
    loads.normal_load  = contact.normal_load;
    loads.approach     = contact.approach.value_or(0.);
    return problem;
  }



  template <int dim>
  std::vector<double>
  RollingPair<dim>::on_body(const Side side, std::vector<double> forces) const
  {
    const std::size_t n_tangential = forces.size() - this->trace().nodes.size();
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (side == Side::rail || i >= n_tangential)
        forces[i] = -forces[i];
    return this->coupling(side).to_body(std::move(forces));
  }



  template <int dim>
  BodyField
  RollingPair<dim>::displacement(const Side            side,
                                 const ContactProblem &problem,
                                 const ContactState   &state) const
  {
    if (!this->body(side))
      return {};
    return this->body(side)->recover(this->nodes(side),
                                     components,
                                     on_body(side,
                                             nodal_forces(problem, state)));
  }



  template <int dim>
  std::unique_ptr<BodyDynamics>
  RollingPair<dim>::in_time(const Side         side,
                            const ThetaScheme &scheme,
                            const MassKind     mass) const
  {
    if (!this->body(side))
      return nullptr;
    return this->body(side)->in_time(scheme,
                                     mass,
                                     this->nodes(side),
                                     components);
  }



  template class RollingPair<2>;
  template class RollingPair<3>;
} // namespace RollingContact
