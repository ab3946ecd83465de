#ifndef rolling_contact_bodies_split_vibration_h
#define rolling_contact_bodies_split_vibration_h

#include <rolling_contact/bodies/contact_vibration.h>
#include <rolling_contact/bodies/faded_fields.h>
#include <rolling_contact/mesh/body_model.h>

namespace RollingContact
{
  /**
   * What the nodes of a SplitBody move by, from its mesh and in all: F, Q and
   * inertia of its moments, S as its mesh has it, and the static compliance.
   * Units: see FadedFields, m/(N m^degrees), m/N.
   */
  struct SplitCompliance
  {
    const FadedFields  &fields;
    const FadedInertia &inertia;
    const DenseMatrix  &S;
    DenseMatrix         beyond; ///< what S of the body has more
    DenseMatrix         Phi, W;
  };

  /**
   * Contact nodes of a SplitBody in vibration. The field of moments m = Phi^T f
   * is chi u_hs m / (1 + s tau) + u_c, as the material near the nodes is damped
   * by tau = stiffness damping + loss factor / (2 pi loss frequency), and with
   * alpha the mass damping
   *
   *   D(s) u_c = (F - r B) m,             r = (s^2 + s alpha) / (1 + s tau),
   *   u = W / (1 + s tau) f + Phi (t - S m / (1 + s tau)),
   *   t = (F - r B)^T u_c + [Q - r N] m / (1 + s tau),
   *
   * B and N the inertia of the fields with the unknowns and with each other.
   * Ratios of damping that modes are given and rotation act on u_c alone. A
   * mode phi of eigenvalue lambda has the moments (F + lambda B)^T phi.
   */
  class SplitVibration : public ContactVibration
  {
  public:
    /** Keeps the references of @p parts. */
    SplitVibration(SplitCompliance parts, const BodyDamping &damping);

    DenseMatrix of_modes(const DenseMatrix         &motions,
                         const std::vector<double> &eigenvalues) const override;

    DenseMatrix beyond_mesh() const override
    {
      return parts.Phi * parts.beyond * parts.Phi.transpose();
    }

    ComplexVector load(const std::complex<double> s,
                       const ComplexVector       &forces) const override;

    ComplexVector of_nodes(const std::complex<double> s,
                           const ComplexVector       &forces,
                           const ComplexVector       &x) const override;

    ComplexVector of_body(const std::complex<double> s,
                          const ComplexVector       &forces,
                          const ComplexVector       &x) const override;

  private:
    /** 1 + s tau. */
    std::complex<double> stiffening(const std::complex<double> s) const
    {
      return 1. + s * tau;
    }

    /** r of the class. Units: 1/s^2. */
    std::complex<double> rate_of_inertia(const std::complex<double> s) const
    {
      return (s * s + s * alpha) / stiffening(s);
    }

    const SplitCompliance parts;
    const double          alpha, tau; ///< 1/s, s
  };
} // namespace RollingContact

#endif
