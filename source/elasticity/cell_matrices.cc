#include <rolling_contact/elasticity/cell_matrices.h>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  void
  cell_stiffness(const FEValues<dim, dim> &values,
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



  template <int dim>
  void
  cell_mass(const FEValues<dim, dim> &values,
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
  void
  cell_lumped_mass(const FEValues<dim, dim> &values,
                   const double              density,
                   Vector<double>           &mass)
  {
    mass = 0.;
    for (unsigned int i = 0; i < values.dofs_per_cell; ++i)
      for (const unsigned int q : values.quadrature_point_indices())
        mass(i) += density * values.shape_value(i, q) * values.JxW(q);
  }



  template void
  cell_stiffness(const FEValues<2, 2> &,
                 const Material &,
                 FullMatrix<double> &);
  template void
  cell_mass(const FEValues<2, 2> &, const double, FullMatrix<double> &);
  template void
  cell_lumped_mass(const FEValues<2, 2> &, const double, Vector<double> &);
  template void
  cell_stiffness(const FEValues<3, 3> &,
                 const Material &,
                 FullMatrix<double> &);
  template void
  cell_mass(const FEValues<3, 3> &, const double, FullMatrix<double> &);
  template void
  cell_lumped_mass(const FEValues<3, 3> &, const double, Vector<double> &);
} // namespace RollingContact
