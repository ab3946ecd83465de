#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/modes/rotation.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** The modes at all degrees of freedom, hanging and held ones included. */
    DenseMatrix
    on_all_dofs(const DirectBody<3> &body, const DenseMatrix &shapes)
    {
      const std::size_t n = body.dof_handler().n_dofs();
      DenseMatrix       result(n, shapes.n_columns());
      for (std::size_t j = 0; j < shapes.n_columns(); ++j)
        {
          const double   *shape = shapes.data() + j * shapes.n_rows();
          const BodyField field = body.field({shape, shape + shapes.n_rows()});
          for (std::size_t i = 0; i < n; ++i)
            result(i, j) = field[i];
        }
      return result;
    }



    Tensor<1, 3>
    tensor(const std::array<double, 3> &v)
    {
      return Tensor<1, 3>({v[0], v[1], v[2]});
    }



    /** rho N_a r e_theta . grad N_b integrated over a cell. */
    void
    cell_rotation(const FEValues<3>  &values,
                  const double        density,
                  const Axle         &axle,
                  FullMatrix<double> &S)
    {
      S = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, 3> along =
            cross_product_3d(tensor(axle.direction),
                             values.quadrature_point(q) -
                               Point<3>(tensor(axle.point)));
          for (unsigned int a = 0; a < S.m(); ++a)
            for (unsigned int b = 0; b < S.n(); ++b)
              S(a, b) += density * values.JxW(q) * values.shape_value(a, q) *
                         (along * values.shape_grad(b, q));
        }
    }
  } // namespace



  DenseMatrix
  modal_rotation(const DirectBody<3>   &body,
                 const Axle            &axle,
                 const StructuralModes &modes)
  {
    const DenseMatrix  phi = on_all_dofs(body, modes.shapes);
    const std::size_t  n = phi.n_rows(), m = phi.n_columns();
    DenseMatrix        S_phi(n, m), S(m, m);
    const FE_Q<3>      element(1);
    FEValues<3>        values(element,
                       QGauss<3>(2),
                       update_values | update_gradients | update_JxW_values |
                         update_quadrature_points);
    FullMatrix<double> cell_matrix(8, 8);
    std::array<types::global_dof_index, 8> first;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      {
        values.reinit(
          static_cast<typename Triangulation<3>::cell_iterator>(cell));
        cell_rotation(values, body.elasticity().density, axle, cell_matrix);
        for (unsigned int v = 0; v < 8; ++v)
          first[v] = cell->vertex_dof_index(v, 0);
        for (std::size_t j = 0; j < m; ++j)
          for (unsigned int a = 0; a < 8; ++a)
            for (unsigned int c = 0; c < 3; ++c)
              {
                double sum = 0.;
                for (unsigned int b = 0; b < 8; ++b)
                  sum += cell_matrix(a, b) * phi(first[b] + c, j);
                S_phi(first[a] + c, j) += sum;
              }
      }
    const int    rows = n, columns = m;
    const double one = 1., zero = 0.;
    if (m > 0)
      dgemm_("T",
             "N",
             &columns,
             &columns,
             &rows,
             &one,
             phi.data(),
             &rows,
             S_phi.data(),
             &rows,
             &zero,
             S.data(),
             &columns);
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        {
          const double skew = (S(i, j) - S(j, i)) / 2;
          S(i, j)           = skew;
          S(j, i)           = -skew;
        }
    return S;
  }
} // namespace RollingContact
