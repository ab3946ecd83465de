#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/direct_body.h>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  Discretisation<dim> DirectBody<dim>::discretisation() const
  {
    return {this->dofs,
            this->constraints,
            unknown_of_dof,
            n_unknowns(),
            this->materials,
            this->thickness,
            this->model.elements,
            this->supports};
  }

  template <int dim>
  SymmetricSparseMatrix DirectBody<dim>::stiffness() const
  {
    return assemble_stiffness(discretisation());
  }

  template <int dim>
  SymmetricSparseMatrix DirectBody<dim>::mass(const MassKind kind) const
  {
    return assemble_mass(discretisation(), kind);
  }

  template <int dim>
  std::vector<PointMass> DirectBody<dim>::clamped_masses() const
  {
    return RollingContact::clamped_masses(discretisation());
  }

  template <int dim>
  SkewSparseMatrix DirectBody<dim>::rotation(const Axle &axle) const
  {
    if constexpr (dim == 3)
      return assemble_rotation(discretisation(), axle);
    (void)axle;
    throw std::logic_error("The flow round an axle is in 3D.");
  }

  template <int dim>
  const Factorisation &DirectBody<dim>::factorisation() const
  {
    if (factor == nullptr)
      throw std::logic_error("There is no factor of the stiffness.");
    return *factor;
  }

  template <int dim>
  bool DirectBody<dim>::has_losses() const
  {
    const Foundation &foundation = this->model.foundation;
    return this->model.damping.loss_factor > 0. ||
           (this->hub == Hub::elastic &&
            (foundation.loss_factor > 0. ||
             (foundation.has_sleepers() &&
              foundation.ballast_loss_factor > 0.)));
  }

  template <int dim>
  SymmetricSparseMatrix DirectBody<dim>::loss_stiffness() const
  {
    return assemble_stiffness(discretisation(),
                              {this->model.damping.loss_factor,
                               this->model.foundation.loss_factor,
                               this->model.foundation.ballast_loss_factor});
  }

  template <int dim>
  std::vector<double> DirectBody<dim>::sponge() const
  {
    std::vector<Point<dim>> positions(this->dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                         this->dofs,
                                         positions);
    const auto [first, last] =
      std::minmax_element(positions.begin(),
                          positions.end(),
                          [](const auto &a, const auto &b) {
                            return a[0] < b[0];
                          });
    const BodyDamping &damping = this->model.damping;
    const double       from = (*first)[0], to = (*last)[0];
    const auto         rate = [&](const double x) {
      const double depth = damping.sponge_length - std::min(x - from, to - x);
      return depth > 0. ? damping.sponge_rate *
                            std::pow(depth / damping.sponge_length, 2)
                                : 0.;
    };
    const SymmetricSparseMatrix M = mass(MassKind::lumped);
    std::vector<double>         result(n_unknowns(), 0.);
    const std::size_t           n_nodal = positions.size(),
                      n_moving = n_nodal + this->supports.n_translations();
    for (std::size_t i = 0; i < n_moving; ++i)
      if (const int unknown = unknown_of_dof[i]; unknown >= 0)
        result[unknown] =
          M.values[M.column_starts[unknown]] *
          rate(i < n_nodal ? positions[i][0]
                           : this->supports.x_of_translation(i - n_nodal));
    return result;
  }

  template <int dim>
  SymmetricSparseMatrix DirectBody<dim>::damping(const MassKind kind) const
  {
    const BodyDamping    &damping = this->model.damping;
    SymmetricSparseMatrix C       = diagonal_matrix(
      damping.has_sponge() ? sponge() : std::vector<double>(n_unknowns(), 0.));
    if (damping.mass_damping > 0.)
      C = linear_combination(1., C, damping.mass_damping, mass(kind));
    if (damping.stiffness_damping > 0.)
      C = linear_combination(1., C, damping.stiffness_damping, stiffness());
    return C;
  }

  template <int dim>
  SymmetricSparseMatrix
  DirectBody<dim>::damping_in_time(const MassKind kind) const
  {
    const BodyDamping    &damping = this->model.damping;
    SymmetricSparseMatrix C;
    if (damping.is_viscous() || has_losses())
      C = this->damping(kind);
    if (has_losses())
      C = linear_combination(1.,
                             C,
                             1 / (2 * numbers::PI * damping.loss_frequency),
                             loss_stiffness());
    return C;
  }

  template Discretisation<2>     DirectBody<2>::discretisation() const;
  template Discretisation<3>     DirectBody<3>::discretisation() const;
  template SymmetricSparseMatrix DirectBody<2>::stiffness() const;
  template SymmetricSparseMatrix DirectBody<3>::stiffness() const;
  template SymmetricSparseMatrix DirectBody<2>::mass(const MassKind kind) const;
  template SymmetricSparseMatrix DirectBody<3>::mass(const MassKind kind) const;
  template std::vector<PointMass> DirectBody<2>::clamped_masses() const;
  template std::vector<PointMass> DirectBody<3>::clamped_masses() const;
  template SkewSparseMatrix     DirectBody<2>::rotation(const Axle &axle) const;
  template SkewSparseMatrix     DirectBody<3>::rotation(const Axle &axle) const;
  template const Factorisation &DirectBody<2>::factorisation() const;
  template const Factorisation &DirectBody<3>::factorisation() const;
  template bool                 DirectBody<2>::has_losses() const;
  template bool                 DirectBody<3>::has_losses() const;
  template SymmetricSparseMatrix DirectBody<2>::loss_stiffness() const;
  template SymmetricSparseMatrix DirectBody<3>::loss_stiffness() const;
  template std::vector<double>   DirectBody<2>::sponge() const;
  template std::vector<double>   DirectBody<3>::sponge() const;
  template SymmetricSparseMatrix
  DirectBody<2>::damping(const MassKind kind) const;
  template SymmetricSparseMatrix
  DirectBody<3>::damping(const MassKind kind) const;
  template SymmetricSparseMatrix
  DirectBody<2>::damping_in_time(const MassKind kind) const;
  template SymmetricSparseMatrix
  DirectBody<3>::damping_in_time(const MassKind kind) const;
} // namespace RollingContact
