#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <rolling_contact/bodies/energy_errors.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Displacement gradients of several fields in the cells of a body.
     */
    template <int dim>
    class Gradients
    {
    public:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      Gradients(const std::vector<BodyField> &fields,
                const Quadrature<dim>        &points)
        : fields(fields)
        , shapes(1)
        , values(shapes,
                 points,
                 update_gradients | update_JxW_values | update_values)
      {}

      void reinit(const Cell &cell);

      Tensor<2, dim> at_point(const std::size_t  field,
                              const unsigned int point) const
      {
        Tensor<2, dim> gradient;
        for (unsigned int v = 0; v < n_corners; ++v)
          gradient += outer_product(corners[field * n_corners + v],
                                    values.shape_grad(v, point));
        return gradient;
      }

      const FEValues<dim> &at() const
      {
        return values;
      }

    private:
      static constexpr unsigned int n_corners =
        GeometryInfo<dim>::vertices_per_cell;

      const std::vector<BodyField> &fields;
      const FE_Q<dim>               shapes;
      FEValues<dim>                 values;
      std::vector<Tensor<1, dim>>   corners; ///< displacements of the cell
    };

    template <int dim>
    void Gradients<dim>::reinit(const Cell &cell)
    {
      values.reinit(
        static_cast<typename Triangulation<dim>::cell_iterator>(cell));
      corners.resize(fields.size() * n_corners);
      for (std::size_t f = 0; f < fields.size(); ++f)
        for (unsigned int v = 0; v < n_corners; ++v)
          for (unsigned int c = 0; c < dim; ++c)
            corners[f * n_corners + v][c] =
              fields[f][cell->vertex_dof_index(v, c)];
    }

    /**
     * How many times a cell is larger than small ones, as a power of two.
     */
    template <typename Cell>
    int coarseness(const Cell &cell, const double element_size)
    {
      const int dim = Cell::AccessorType::dimension;
      return std::lround(
        std::log2(cell->diameter() / (element_size * std::sqrt(dim))));
    }

    /**
     * The gradients of the fields at the wanted vertices of a body, field by
     * field for each.
     */
    template <int dim>
    std::vector<Tensor<2, dim>>
    averaged_gradients(const DoFHandler<dim>        &dofs,
                       const std::vector<BodyField> &fields,
                       const std::vector<bool>      &wanted)
    {
      const std::size_t           n = fields.size();
      std::vector<Tensor<2, dim>> sums(wanted.size() * n);
      std::vector<double>         weights(wanted.size(), 0.);
      Gradients<dim>              gradients(fields, QGauss<dim>(1));
      for (const auto &cell : dofs.active_cell_iterators())
        {
          bool is_wanted = false;
          if (!cell->is_artificial())
            for (const unsigned int v : cell->vertex_indices())
              is_wanted = is_wanted || wanted[cell->vertex_index(v)];
          if (!is_wanted)
            continue;
          gradients.reinit(cell);
          const double weight = 1 / cell->diameter();
          for (const unsigned int v : cell->vertex_indices())
            weights[cell->vertex_index(v)] += weight;
          for (std::size_t f = 0; f < n; ++f)
            {
              const Tensor<2, dim> gradient = weight * gradients.at_point(f, 0);
              for (const unsigned int v : cell->vertex_indices())
                sums[cell->vertex_index(v) * n + f] += gradient;
            }
        }
      for (std::size_t v = 0; v < weights.size(); ++v)
        for (std::size_t f = 0; f < n; ++f)
          if (weights[v] > 0.)
            sums[v * n + f] /= weights[v];
      return sums;
    }

    /**
     * Errors of the strains of a cell at a quadrature point: what averages at
     * the vertices are more. The volume changes by as much in all of the cell,
     * as B-bar has it.
     */
    template <int dim>
    std::vector<SymmetricTensor<2, dim>>
    strain_errors(const Gradients<dim>              &gradients,
                  const std::vector<Tensor<2, dim>> &averages,
                  const typename DoFHandler<dim>::active_cell_iterator &cell,
                  const std::vector<double> &mean_dilations,
                  const unsigned int         q)
    {
      const std::size_t                    n = mean_dilations.size();
      std::vector<SymmetricTensor<2, dim>> errors(n);
      for (std::size_t f = 0; f < n; ++f)
        {
          Tensor<2, dim> gradient = gradients.at_point(f, q);
          for (unsigned int d = 0; d < dim; ++d)
            gradient[d][d] += (mean_dilations[f] - trace(gradient)) / dim;
          gradient *= -1;
          for (const unsigned int v : cell->vertex_indices())
            gradient += gradients.at().shape_value(v, q) *
                        averages[cell->vertex_index(v) * n + f];
          errors[f] = symmetrize(gradient);
        }
      return errors;
    }

    /**
     * The mean changes of volume of the fields in the present cell.
     */
    template <int dim>
    std::vector<double> mean_dilations(const Gradients<dim> &gradients,
                                       const std::size_t     n)
    {
      std::vector<double> dilations(n, 0.);
      double              volume = 0.;
      for (const unsigned int q : gradients.at().quadrature_point_indices())
        {
          volume += gradients.at().JxW(q);
          for (std::size_t f = 0; f < n; ++f)
            dilations[f] +=
              gradients.at().JxW(q) * trace(gradients.at_point(f, q));
        }
      for (double &dilation : dilations)
        dilation /= volume;
      return dilations;
    }

    /**
     * Vertices of cells that are larger than the elements of the contact zone.
     */
    template <int dim>
    std::vector<bool> vertices_of_bulk(const DoFHandler<dim> &dofs,
                                       const double           element_size)
    {
      std::vector<bool> found(dofs.get_triangulation().n_vertices(), false);
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned() && coarseness(cell, element_size) > 0)
          for (const unsigned int v : cell->vertex_indices())
            found[cell->vertex_index(v)] = true;
      return found;
    }

    /**
     * Add the energy products of the errors in a cell to the lower triangle of
     * @p sum.
     */
    template <int dim>
    void
    add_products(const typename DoFHandler<dim>::active_cell_iterator &cell,
                 const std::vector<Tensor<2, dim>>                    &averages,
                 const Material                                       &material,
                 const double    thickness,
                 Gradients<dim> &gradients,
                 DenseMatrix    &sum)
    {
      const double G      = material.shear_modulus(),
                   lambda = material.bulk_modulus() - 2 * G / 3;
      gradients.reinit(cell);
      const auto dilations = mean_dilations(gradients, sum.rows());
      for (const unsigned int q : gradients.at().quadrature_point_indices())
        {
          const auto errors =
            strain_errors(gradients, averages, cell, dilations, q);
          const double weight =
            gradients.at().JxW(q) * (dim == 2 ? thickness : 1.);
          for (std::size_t k = 0; k < errors.size(); ++k)
            for (std::size_t l = 0; l <= k; ++l)
              sum(k, l) +=
                weight * (2 * G * (errors[k] * errors[l]) +
                          lambda * trace(errors[k]) * trace(errors[l]));
        }
    }
  } // namespace

  template <int dim>
  std::vector<DenseMatrix>
  energy_errors(const ElasticBody<dim>       &body,
                const double                  thickness,
                const double                  element_size,
                const std::vector<BodyField> &displacements)
  {
    const DoFHandler<dim> &dofs = body.dof_handler();
    const std::size_t      n    = displacements.size();
    const auto             averages =
      averaged_gradients(dofs,
                         displacements,
                         vertices_of_bulk(dofs, element_size));
    Gradients<dim>           gradients(displacements, QGauss<dim>(2));
    std::vector<DenseMatrix> sums;
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned() && coarseness(cell, element_size) > 0)
        {
          const std::size_t m = coarseness(cell, element_size) - 1;
          if (m >= sums.size())
            sums.resize(m + 1, DenseMatrix::Zero(n, n));
          add_products(cell,
                       averages,
                       body.elasticity().of(cell->material_id()),
                       thickness,
                       gradients,
                       sums[m]);
        }
    for (DenseMatrix &sum : sums)
      sum = DenseMatrix(sum.template selfadjointView<Eigen::Lower>());
    return sums;
  }

  template std::vector<DenseMatrix>
  energy_errors(const ElasticBody<2> &,
                const double,
                const double,
                const std::vector<BodyField> &);
  template std::vector<DenseMatrix>
  energy_errors(const ElasticBody<3> &,
                const double,
                const double,
                const std::vector<BodyField> &);
} // namespace RollingContact
