#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/reference_3d.h>

namespace RollingContact
{
  template <int dim>
  void describe_factors(const SteadyState<dim> &steady, RunContext &context)
  {
    auto &objects = context.report.objects;
    for (const Side side : both_sides)
      {
        const bool is_twin =
          side == Side::rail && steady.pair->bodies().twins();
        BuiltItem object;
        object.object = name_of(side) + ": mesh, stiffness, solver";
        object.built  = steady.pair->bodies().is_elastic(side) && !is_twin;
        if (!object.built)
          object.reason = is_twin ? "mirror image of the wheel" : "rigid";
        else if (const ElasticBody<dim> *body =
                   steady.pair->bodies().body(side))
          {
            object.bytes   = body->solver_memory();
            object.seconds = body->assembly_seconds() + body->solver_seconds();
            context.log.detail(name_of(side) + ": " + body->description());
          }
        objects.push_back(object);
      }
  }

  template <int dim>
  void describe_surfaces(const RollingPair<dim> &pair, RunContext &context)
  {
    for (const Side side : both_sides)
      {
        const SurfaceNote &note = pair.interface().note[side];
        if (!note.text.empty())
          context.log.message(note.text);
        if (!note.warning.empty())
          context.log.warning(note.warning);
      }
    for (const std::string &text : pair.moving_surfaces().notes)
      context.log.message(text);
    for (const std::string &text : pair.moving_surfaces().warnings)
      context.log.warning(text);
  }

  namespace
  {
    template <int dim>
    void describe_compliance(const BodyPair<dim> &bodies, RunContext &context)
    {
      if (bodies.is_split())
        context.log.message("The compliance is split: half-spaces in closed "
                            "form, and what the bodies add.");
      if (!bodies.reason_against_split().empty())
        context.log.message("Mesh/Compliance = automatic takes finite "
                            "elements: " +
                            bodies.reason_against_split() + ".");
    }
  } // namespace

  template <int dim>
  void describe_bodies(const SteadyState<dim> &steady, RunContext &context)
  {
    if (!steady.pair->bodies().reason_for_solver().empty())
      {
        const bool direct =
          steady.pair->bodies().body_solver() == BodySolver::direct;
        const std::string choice =
          "Body solver = automatic takes " +
          std::string(direct ? "direct" : "distributed") + ": " +
          steady.pair->bodies().reason_for_solver() + ".";
        direct ? context.log.detail(choice) : context.log.message(choice);
      }
    describe_compliance(steady.pair->bodies(), context);
    describe_surfaces(*steady.pair, context);
    describe_factors(steady, context);
    auto       &objects = context.report.objects;
    const auto &problem = steady.problem;
    objects.push_back({"compliance W",
                       true,
                       problem.operators.W().memory_consumption(),
                       0.,
                       problem.operators.W().on_grid()
                         ? "nodes on a grid: products, no matrix"
                         : ""});
    objects.push_back({"tangential compliance, B1",
                       problem.n_tangential() > 0,
                       0,
                       0.,
                       problem.n_tangential() > 0 ? "" : "frictionless"});
    objects.push_back({"mass, damping, B2", false, 0, 0., "quasi-static"});
    if (problem.loads.friction_law)
      objects.push_back({dim == 2 ? "reference: Carter"
                                  : "references: " + saturating_theories(),
                         false,
                         0,
                         0.,
                         "they have constant friction"});
  }

  template void describe_factors(const SteadyState<2> &, RunContext &);
  template void describe_factors(const SteadyState<3> &, RunContext &);
  template void describe_surfaces(const RollingPair<2> &, RunContext &);
  template void describe_surfaces(const RollingPair<3> &, RunContext &);
  template void describe_bodies(const SteadyState<2> &, RunContext &);
  template void describe_bodies(const SteadyState<3> &, RunContext &);
} // namespace RollingContact
