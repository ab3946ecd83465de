#include <rolling_contact/results/local_fit.h>
#include <rolling_contact/results/nodal_stress.h>
#include <rolling_contact/results/stress_samples.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * What squares count for in elements that do not touch the node, at the
     * distance of those that do, and the power of the distance it falls with:
     * elements that grow fast lie far away.
     */
    const double weight_beyond = 0.1, fall_of_weight = 4.;

    double distance(const KnownPlace &place)
    {
      return std::hypot(place.at[0], place.at[1], place.at[2]);
    }

    /**
     * Places of samples from a vertex, or of their faces.
     */
    template <int dim>
    struct PlacesAround
    {
      std::vector<unsigned int> samples;
      std::vector<KnownPlace>   places;

      PlacesAround(StressSamples<dim> &all,
                   const unsigned int  vertex,
                   const Point<dim>   &at,
                   const bool          of_faces)
      {
        const auto around = all.around(vertex);
        const auto add    = [&](const std::vector<unsigned int> &found) {
          for (const unsigned int c : found)
            if (!of_faces || all[c].has_face)
              {
                const Tensor<1, dim> place =
                  (of_faces ? all[c].middle_of_face : all[c].middle) - at;
                samples.push_back(c);
                places.push_back({{}, 1.});
                for (unsigned int d = 0; d < dim; ++d)
                  places.back().at[d] = place[d];
              }
        };
        add(around.first);
        const std::size_t n_next = places.size();
        double            next   = 0.;
        for (const KnownPlace &place : places)
          next = std::max(next, distance(place));
        add(around.second);
        for (std::size_t s = n_next; s < places.size(); ++s)
          places[s].weight =
            weight_beyond *
            std::pow(std::min(1., next / distance(places[s])), fall_of_weight);
      }
    };

    template <int dim>
    StressValue stress_inside(StressSamples<dim> &all,
                              const unsigned int  vertex,
                              const Point<dim>   &at)
    {
      const PlacesAround<dim> around(all, vertex, at, false);
      const FitWeights        fit = fit_in_origin(around.places, dim);
      StressValue             value;
      SymmetricTensor<2, 3>   linear;
      for (std::size_t s = 0; s < around.samples.size(); ++s)
        {
          value.stress += fit.quadratic[s] * all[around.samples[s]].stress;
          linear += fit.linear[s] * all[around.samples[s]].stress;
        }
      value.error = (value.stress - linear).norm();
      return value;
    }

    /**
     * The stress of tractions zz, xz, yz on a surface with a strain xx, yy, xy
     * in it.
     */
    SymmetricTensor<2, 3>
    stress_of_surface(const std::array<double, 3> &traction,
                      const std::array<double, 3> &strain,
                      const Material              &material)
    {
      const double E = material.young_modulus, nu = material.poisson_ratio,
                   plane = E / (1 - nu * nu);
      SymmetricTensor<2, 3> stress;
      stress[2][2] = traction[0];
      stress[0][2] = traction[1];
      stress[1][2] = traction[2];
      stress[0][0] =
        plane * (strain[0] + nu * strain[1]) + nu / (1 - nu) * traction[0];
      stress[1][1] =
        plane * (strain[1] + nu * strain[0]) + nu / (1 - nu) * traction[0];
      stress[0][1] = 2 * material.shear_modulus() * strain[2];
      return stress;
    }

    template <int dim>
    StressValue stress_at_surface(StressSamples<dim>          &all,
                                  const unsigned int           vertex,
                                  const Point<dim>            &at,
                                  const std::array<double, 3> &traction,
                                  const Material              &material)
    {
      const PlacesAround<dim> around(all, vertex, at, true);
      const FitWeights        fit = fit_in_origin(around.places, dim - 1);
      std::array<double, 3>   strain{};
      for (std::size_t s = 0; s < around.samples.size(); ++s)
        for (unsigned int c = 0; c < 3; ++c)
          strain[c] += fit.quadratic[s] * all[around.samples[s]].strain[c];
      StressValue value{stress_of_surface(traction, strain, material)};
      value.error =
        (value.stress - stress_inside(all, vertex, at).stress).norm();
      return value;
    }
  } // namespace

  template <int dim>
  NodalStress<dim>::NodalStress(const ElasticBody<dim> &body,
                                const BodyField        &displacement,
                                const double            angle,
                                const SurfaceTractions &tractions)
    : values(body.dof_handler().get_triangulation().n_vertices())
  {
    StressSamples<dim> samples(body, displacement, angle);
    std::vector<bool>  done(values.size(), false);
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          {
            const unsigned int vertex = cell->vertex_index(v);
            if (done[vertex])
              continue;
            done[vertex]     = true;
            const auto known = tractions.find(cell->vertex_dof_index(v, 0));
            values[vertex]   = known == tractions.end()
                                 ? stress_inside(samples, vertex, cell->vertex(v))
                                 : stress_at_surface(samples,
                                                   vertex,
                                                   cell->vertex(v),
                                                   known->second,
                                                   body.elasticity().cover);
          }
  }

  template class NodalStress<2>;
  template class NodalStress<3>;
} // namespace RollingContact
