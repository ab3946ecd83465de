#ifndef rolling_contact_modes_waveguide_h
#define rolling_contact_modes_waveguide_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/mesh/material.h>
#include <rolling_contact/mesh/swept_mesh.h>
#include <rolling_contact/modes/harmonic_section.h>

#include <array>
#include <complex>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

namespace RollingContact
{
  /**
   * A body of constant section that has no ends, on a layer or on pads.
   */
  struct StraightBody
  {
    ExtrudedSection shape;
    Material        material;
    Foundation      foundation;
    BodyDamping     damping; ///< without absorbing ends and damping of modes
  };

  /** How the section of a straight body was reduced. */
  struct WaveguideSize
  {
    std::size_t n_unknowns = 0; ///< of the section
    std::size_t n_along    = 0; ///< fields of the motion along the body
    std::size_t n_across   = 0; ///< fields of the motion in the section
  };

  /**
   * Waves in a body of constant section without ends, whose displacement goes
   * as exp(s t - i k x): with the amplitudes U of HarmonicSection, u_x = i U_t
   * exp(-i k x),
   *
   *   D(k) U = f,   D = kappa (K_0 + k K_1 + k^2 K_2) + kappa_s K_s
   *                     + (s^2 + alpha s) M,
   *
   * K_s of springs under the whole hub boundary, kappa = 1 + eta s / |Im s| +
   * beta s with the loss factor eta, which counts where s is not real, and
   * Rayleigh's alpha and beta. K_1 alone couples U_t with the other two, so
   * that k^2 is the eigenvalue of a problem as large as U. A force at x = 0
   * moves the body at x >= 0 by
   *
   *   U = -i sum_j exp(-i k_j x) u_j v_j^T f / (v_j^T D'(k_j) u_j),
   *
   * u_j and v_j = u_j of the waves that leave it, see WaveguideResponse. The
   * section is reduced to fields that are those of its free waves at some k and
   * of forces at rest at the places given and under its foot. On pads K_s is
   * none of D, but theirs.
   *
   * Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 2,
   * semi-analytical processes; S. Finnveden, Evaluation of modal density and
   * group velocity by a finite element method, J. Sound Vib. 273 (2004).
   */
  class Waveguide
  {
  public:
    using Complex = std::complex<double>;

    /** A point of the body, in its frame: m. */
    using Place = std::array<double, 3>;

    /**
     * Free waves up to a frequency (Hz) are those of the whole section;
     * @p loaded: where forces act; @p degree: of the polynomials.
     */
    Waveguide(const StraightBody          &body,
              const double                 highest,
              const std::vector<Place>    &loaded,
              const std::function<void()> &interrupt,
              const unsigned int           degree = 3);

    /**
     * Displacements along x, y and z of the body at all places, one after the
     * other, under forces of 1 N there. Those of a place under a force on
     * itself lack the compliance of what is near, which this reduced section
     * does not know; but what a frequency changes of it is smooth. @p
     * added_damping: a ratio as modes have it, half a loss factor. Units: 1/s,
     * m/N.
     */
    ComplexMatrix receptances(const Complex             s,
                              const std::vector<Place> &places,
                              const double added_damping = 0.) const;

    /**
     * A wave that leaves a force towards positive x, 1/m, the amplitudes u_j of
     * the fields of the section and v_j / (i v_j^T D' u_j).
     */
    struct Wave
    {
      Complex       wavenumber;
      ComplexVector amplitudes, received;
    };

    /** Waves that leave a force, the one that fades least first. */
    std::vector<Wave> waves(const Complex s,
                            const double  added_damping = 0.) const;

    /** Shares of the kinetic energy of a wave, along the body, across and
     * outwards of its section. */
    std::array<double, 3> shares(const Wave &wave) const;

    const WaveguideSize &size() const
    {
      return sizes;
    }

    const Foundation &foundation() const
    {
      return springs;
    }

    /**
     * What a stiffness with a loss factor is multiplied by, kappa, with half of
     * that of @p added_damping in addition. Units: 1/s.
     */
    Complex stiffening(const Complex s,
                       const double  loss_factor,
                       const double  added_damping) const;

    /** What of a mass times the displacement is its inertia, s^2 + alpha s.
     * Units: 1/s, 1/s^2. */
    Complex rate_of_inertia(const Complex s) const
    {
      return s * s + s * damping.mass_damping;
    }

    /**
     * Pads: springs of a metre of foot, as many as have a motion of the foot of
     * their own, by the fields of the section, and which motions of the foot
     * are its translations along x, across and outwards. They act on two lines
     * across the foot of each pad, x of the one at Pad offset. Units: N/m^2, m.
     */
    struct Pads
    {
      Eigen::VectorXd     stiffness;
      DenseMatrix         shapes, translations;
      std::vector<double> lines;
    };

    bool has_pads() const
    {
      return springs.pad_spacing > 0.;
    }

    const Pads &pads() const
    {
      return pad_springs;
    }

    /** Rows of displacements along x, y and z by the fields at a place; from
     * any thread. */
    const ComplexMatrix &motion_at(const Place &place) const;

  private:
    /** K_0, K_1, K_2, K_s and M of the fields, those along the body first. */
    struct Matrices
    {
      DenseMatrix K_0, K_1, K_2, K_s, M;
    };

    /** Fields of a section with K(k) = K_0 + k K_1 + k^2 K_2. */
    struct Section;

    void reduce(const Section &whole, const std::vector<DenseMatrix> &fields);

    /** Fields of the section that moves along y, z and x and turns about x, z
     * and y as one. */
    DenseMatrix rigid_motions() const;

    void find_pads(const Section &whole);

    /** Whether the wave exp(-i k x), and not the one of -k, leaves. */
    bool leaves(const Wave &wave, const Complex s) const;

    const SectionPlacement placement;
    const HarmonicSection  section;
    const BodyDamping      damping;
    const Foundation       springs;
    Pads                   pad_springs;
    WaveguideSize          sizes;
    DenseMatrix            fields; ///< at the unknowns of the section
    Matrices               matrices;
    DenseMatrix            across_alone; ///< M of the motion across
    DenseMatrix            solved; ///< of [K_2tt 0; K_1^T K_2yy]: its inverse

    /** motion_at() of places of the section, across and outwards. */
    mutable std::map<std::array<double, 2>, ComplexMatrix> known_motions;
    mutable std::mutex                                     learning;
  };
} // namespace RollingContact

#endif
