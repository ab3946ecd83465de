#include <rolling_contact/bodies/cell_matrices.h>
#include <rolling_contact/bodies/hookes_law.h>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  void cell_stiffness(const FEValues<dim, dim> &values,
                      const Material           &material,
                      FullMatrix<double>       &stiffness)
  {
    const FEValuesExtractors::Vector displacement(0);
    const unsigned int               n = values.dofs_per_cell;
    const double G = material.shear_modulus(), k = material.bulk_modulus();

    std::vector<double>                  mean_dilatation(n, 0.);
    std::vector<SymmetricTensor<2, dim>> strain(n);
    std::vector<double>                  dilatation(n);
    double                               volume = 0.;
    stiffness                                   = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double JxW = values.JxW(q);
        volume += JxW;
        for (unsigned int i = 0; i < n; ++i)
          {
            strain[i]     = values[displacement].symmetric_gradient(i, q);
            dilatation[i] = trace(strain[i]);
            mean_dilatation[i] += dilatation[i] * JxW;
          }
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            stiffness(i, j) +=
              2 * G *
              (strain[i] * strain[j] - dilatation[i] * dilatation[j] / 3) * JxW;
      }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          stiffness(i, j) +=
            k * mean_dilatation[i] * mean_dilatation[j] / volume;
          stiffness(j, i) = stiffness(i, j);
        }
  }

  namespace
  {
    /**
     * Jacobian of the trilinear map in the middle of a cell, from the
     * coordinates [0, 1]: row d is the derivative of the position by number d.
     */
    template <int dim>
    Tensor<2, dim> middle_jacobian(const FEValues<dim, dim> &values)
    {
      Tensor<2, dim> jacobian;
      const auto     cell = values.get_cell();
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          jacobian[d] +=
            ((v >> d) & 1 ? 1. : -1.) / (1 << (dim - 1)) * cell->vertex(v);
      return jacobian;
    }

    /**
     * Strains of the incompatible modes at a point of quadrature: mode i in
     * component c is number i dim + c.
     */
    template <int dim>
    void incompatible_strains(const FEValues<dim, dim>             &values,
                              const unsigned int                    q,
                              const Tensor<2, dim>                 &inverse,
                              const double                          determinant,
                              std::vector<SymmetricTensor<2, dim>> &strains)
    {
      const auto  &quadrature = values.get_quadrature();
      const double ratio =
        determinant * quadrature.weight(q) / values.JxW(q); // j0 / j
      for (unsigned int i = 0; i < dim; ++i)
        {
          const double slope = -2 * (2 * quadrature.point(q)[i] - 1) * ratio;
          for (unsigned int c = 0; c < dim; ++c)
            {
              Tensor<2, dim> gradient;
              for (unsigned int d = 0; d < dim; ++d)
                gradient[c][d] = slope * inverse[d][i];
              strains[i * dim + c] = symmetrize(gradient);
            }
        }
    }

    /**
     * K_uu - K_ua K_aa^-1 K_au from the lower triangle of K_uu, whole.
     */
    void condense(const FullMatrix<double> &coupling,
                  FullMatrix<double>       &internal,
                  FullMatrix<double>       &stiffness)
    {
      const unsigned int n = stiffness.m(), m = internal.m();
      internal.gauss_jordan();
      FullMatrix<double> response(n, m);
      coupling.mmult(response, internal);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          {
            for (unsigned int a = 0; a < m; ++a)
              stiffness(i, j) -= response(i, a) * coupling(j, a);
            stiffness(j, i) = stiffness(i, j);
          }
    }
  } // namespace

  template <int dim>
  void cell_stiffness_enhanced(const FEValues<dim, dim> &values,
                               const Material           &material,
                               FullMatrix<double>       &stiffness)
  {
    const FEValuesExtractors::Vector displacement(0);
    const unsigned int               n = values.dofs_per_cell, m = dim * dim;
    const Tensor<2, dim>             jacobian = middle_jacobian(values);
    const double         determinant          = dealii::determinant(jacobian);
    const Tensor<2, dim> inverse              = invert(jacobian);

    std::vector<SymmetricTensor<2, dim>> strain(n), internal_strain(m);
    FullMatrix<double>                   coupling(n, m), internal(m, m);
    stiffness = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double JxW = values.JxW(q);
        incompatible_strains(values, q, inverse, determinant, internal_strain);
        for (unsigned int i = 0; i < n; ++i)
          {
            strain[i]         = values[displacement].symmetric_gradient(i, q);
            const auto stress = JxW * stress_of(strain[i], material);
            for (unsigned int j = 0; j <= i; ++j)
              stiffness(i, j) += stress * strain[j];
            for (unsigned int a = 0; a < m; ++a)
              coupling(i, a) += stress * internal_strain[a];
          }
        for (unsigned int a = 0; a < m; ++a)
          for (unsigned int b = 0; b < m; ++b)
            internal(a, b) += JxW * (stress_of(internal_strain[a], material) *
                                     internal_strain[b]);
      }
    condense(coupling, internal, stiffness);
  }

  template <int dim>
  void cell_mass(const FEValues<dim, dim> &values,
                 const double              density,
                 FullMatrix<double>       &mass)
  {
    const auto        &element = values.get_fe();
    const unsigned int n       = values.dofs_per_cell;
    mass                       = 0.;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if (element.system_to_component_index(i).first ==
            element.system_to_component_index(j).first)
          for (const unsigned int q : values.quadrature_point_indices())
            mass(i, j) += density * values.shape_value(i, q) *
                          values.shape_value(j, q) * values.JxW(q);
  }

  template <int dim>
  void cell_lumped_mass(const FEValues<dim, dim> &values,
                        const double              density,
                        Vector<double>           &mass)
  {
    mass = 0.;
    for (unsigned int i = 0; i < values.dofs_per_cell; ++i)
      for (const unsigned int q : values.quadrature_point_indices())
        mass(i) += density * values.shape_value(i, q) * values.JxW(q);
  }

  template void cell_stiffness(const FEValues<2, 2> &,
                               const Material &,
                               FullMatrix<double> &);
  template void cell_stiffness_enhanced(const FEValues<2, 2> &,
                                        const Material &,
                                        FullMatrix<double> &);
  template void
  cell_mass(const FEValues<2, 2> &, const double, FullMatrix<double> &);
  template void
  cell_lumped_mass(const FEValues<2, 2> &, const double, Vector<double> &);
  template void cell_stiffness(const FEValues<3, 3> &,
                               const Material &,
                               FullMatrix<double> &);
  template void cell_stiffness_enhanced(const FEValues<3, 3> &,
                                        const Material &,
                                        FullMatrix<double> &);
  template void
  cell_mass(const FEValues<3, 3> &, const double, FullMatrix<double> &);
  template void
  cell_lumped_mass(const FEValues<3, 3> &, const double, Vector<double> &);
} // namespace RollingContact
