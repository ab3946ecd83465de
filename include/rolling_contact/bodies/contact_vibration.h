#ifndef rolling_contact_bodies_contact_vibration_h
#define rolling_contact_bodies_contact_vibration_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <complex>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * How the contact nodes of a body belong to a vibration of all its unknowns
   * that goes as exp(s t), D(s) x = b: which loads b forces on the nodes are,
   * and how the nodes move. Forces and motions of nodes are numbered as in
   * compliance(). Units: 1/s, N, m.
   */
  class ContactVibration
  {
  public:
    virtual ~ContactVibration() = default;

    /**
     * Motions of the nodes, which bear no forces, by columns, where the
     * unknowns have @p motions, modes of these @p eigenvalues (2 pi f)^2; 0 for
     * what loads away from the contact move at rest. Units: 1/s^2.
     */
    virtual DenseMatrix
    of_modes(const DenseMatrix         &motions,
             const std::vector<double> &eigenvalues) const = 0;

    /** What the nodes move at rest by, beyond what the mesh says: by forces on
     * them, as numbered; empty for nothing. Units: m/N. */
    virtual DenseMatrix beyond_mesh() const
    {
      return {};
    }

    /** The load b of forces on the nodes. */
    virtual ComplexVector load(const std::complex<double> s,
                               const ComplexVector       &forces) const = 0;

    /** Motion of the nodes where forces on them have moved the unknowns. */
    virtual ComplexVector of_nodes(const std::complex<double> s,
                                   const ComplexVector       &forces,
                                   const ComplexVector       &x) const = 0;

    /**
     * Motion of all nodes of the mesh, as unknowns of the body, where forces on
     * those of contact have moved the unknowns.
     */
    virtual ComplexVector of_body(const std::complex<double> s,
                                  const ComplexVector       &forces,
                                  const ComplexVector       &x) const = 0;
  };

  /**
   * Contact nodes that are unknowns of the body.
   */
  class VibrationOfUnknowns : public ContactVibration
  {
  public:
    /** @p contact: the numbers of the unknowns of contact among @p n. */
    VibrationOfUnknowns(std::vector<std::size_t> contact, const std::size_t n)
      : contact(std::move(contact))
      , n(n)
    {}

    DenseMatrix of_modes(const DenseMatrix &motions,
                         const std::vector<double> &) const override
    {
      return motions(contact, Eigen::all);
    }

    ComplexVector load(const std::complex<double>,
                       const ComplexVector &forces) const override
    {
      ComplexVector b = ComplexVector::Zero(n);
      for (std::size_t i = 0; i < contact.size(); ++i)
        b[contact[i]] += forces[i];
      return b;
    }

    ComplexVector of_nodes(const std::complex<double>,
                           const ComplexVector &,
                           const ComplexVector &x) const override
    {
      return x(contact);
    }

    ComplexVector of_body(const std::complex<double>,
                          const ComplexVector &,
                          const ComplexVector &x) const override
    {
      return x;
    }

  private:
    const std::vector<std::size_t> contact;
    const std::size_t              n;
  };
} // namespace RollingContact

#endif
