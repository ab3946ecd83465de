#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/harmonic_modes.h>
#include <rolling_contact/modes/harmonic_section.h>
#include <rolling_contact/modes/node_rings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    const unsigned int degree = 3, most_harmonics = 400;

    /// of the axle's distance, by which places of a section are told apart
    const double same_circle = 1e-7;

    /// longest edge of a quadrilateral: m, and over the wave length of shear at
    /// the cut-off
    const double longest_edge = 0.03, part_of_wave = 0.15;

    /** The section with edges that resolve waves up to the cut-off. */
    SectionMesh resolving(const SectionMesh &section,
                          const Material    &material,
                          const double       cut_off)
    {
      const double wave =
        std::sqrt(material.shear_modulus() / material.density) / cut_off;
      const double limit  = std::min(longest_edge, part_of_wave * wave);
      double       length = 0.;
      for (unsigned int quad = 0; quad < section.quads().size(); ++quad)
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto  ends = section.ends_of_edge(quad, edge);
            const auto &a    = section.vertices()[ends[0]],
                       &b    = section.vertices()[ends[1]];
            length = std::max(length, std::hypot(b[0] - a[0], b[1] - a[1]));
          }
      // as it is where it can be: new edges are straight
      return length > limit ? section.divided(limit) : section;
    }

    StructuralModes modes_with(const HarmonicSection &section,
                               const unsigned int     diameters,
                               const double           shift,
                               const ModeControls    &controls)
    {
      const auto [K, M] = section.matrices(diameters);
      Factorisation factor(shift > 0. ? linear_combination(1., K, shift, M) : K,
                           section.nodes_of_unknowns());
      factor.factorise();
      return structural_modes(
        K, M, factor, shift, section.nodes_of_unknowns(), controls);
    }

    /** Modes of the section, by the number of nodal diameters. */
    std::vector<StructuralModes> find_all(const HarmonicSection &section,
                                          const double           shift,
                                          const ModeControls    &controls)
    {
      std::vector<StructuralModes> all;
      for (unsigned int n = 0; n < most_harmonics; ++n)
        {
          controls.interrupt();
          all.push_back(modes_with(section, n, shift, controls));
          if (n > 2 && all[n].size() == 0 && all[n - 1].size() == 0)
            break;
        }
      return all;
    }

    double difference(const std::vector<StructuralModes> &a,
                      const std::vector<StructuralModes> &b)
    {
      double largest = 0.;
      for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
        for (std::size_t j = 0; j < std::min(a[n].size(), b[n].size()); ++j)
          if (a[n].frequencies[j] > 0.)
            largest =
              std::max(largest,
                       std::abs(b[n].frequencies[j] / a[n].frequencies[j] - 1));
      return largest;
    }

    /** A mode of the body: which of the section, and turned by how many
     * quarters of a wave. */
    struct OneMode
    {
      double       frequency;
      unsigned int diameters, number, quarters;
    };

    std::vector<OneMode>
    in_order(const std::vector<StructuralModes> &of_section)
    {
      std::vector<OneMode> result;
      for (unsigned int n = 0; n < of_section.size(); ++n)
        for (unsigned int j = 0; j < of_section[n].size(); ++j)
          for (unsigned int quarters = 0; quarters < (n == 0 ? 1 : 2);
               ++quarters)
            result.push_back({of_section[n].frequencies[j], n, j, quarters});
      std::stable_sort(result.begin(),
                       result.end(),
                       [](const OneMode &a, const OneMode &b) {
                         return a.frequency < b.frequency;
                       });
      return result;
    }

    /** Amplitudes of all modes at the circles of a body's nodes, each of which
     * is looked up once: U_y, U_r, U_t by columns of modes. */
    class Circles
    {
    public:
      Circles(const HarmonicSection              &section,
              const std::vector<StructuralModes> &of_section,
              const std::vector<OneMode>         &modes,
              const double                        radius)
        : section(section)
        , of_section(of_section)
        , modes(modes)
        , unit(same_circle * radius)
      {}

      const DenseMatrix &at(const CylindricalPlace &place)
      {
        const auto [found, is_new] = known.try_emplace(
          {std::lround(place.axial / unit), std::lround(place.radius / unit)});
        if (is_new)
          found->second = amplitudes(section.at(place.axial, place.radius));
        return found->second;
      }

    private:
      DenseMatrix amplitudes(const HarmonicSection::Interpolation &at) const
      {
        DenseMatrix U = DenseMatrix::Zero(3, modes.size());
        for (std::size_t j = 0; j < modes.size(); ++j)
          for (std::size_t k = 0; k < at.weights.size(); ++k)
            for (unsigned int d = 0; d < 3; ++d)
              if (at.unknowns[k][d] >= 0)
                U(d, j) +=
                  at.weights[k] *
                  of_section[modes[j].diameters].shapes(at.unknowns[k][d],
                                                        modes[j].number);
        return U;
      }

      const HarmonicSection                       &section;
      const std::vector<StructuralModes>          &of_section;
      const std::vector<OneMode>                  &modes;
      const double                                 unit;
      std::map<std::pair<long, long>, DenseMatrix> known;
    };

    DenseMatrix shapes_at(const BodyPlaces                   &places,
                          const Axle                         &axle,
                          const HarmonicSection              &section,
                          const std::vector<StructuralModes> &of_section,
                          const std::vector<OneMode>         &modes,
                          const std::size_t                   n_unknowns)
    {
      DenseMatrix  shapes  = DenseMatrix::Zero(n_unknowns, modes.size());
      const double largest = std::accumulate(
        places.nodes.begin(),
        places.nodes.end(),
        0.,
        [&](const double so_far, const BodyPlaces::Node &node) {
          return std::max(so_far, CylindricalPlace(axle, node.point).radius);
        });
      Circles circles(section, of_section, modes, largest);
      for (const BodyPlaces::Node &node : places.nodes)
        {
          const CylindricalPlace place(axle, node.point);
          const DenseMatrix     &U = circles.at(place);
          for (std::size_t j = 0; j < modes.size(); ++j)
            {
              const OneMode &mode = modes[j];
              const double   angle =
                mode.diameters * place.angle - mode.quarters * pi / 2;
              // without diameters all three are constant round the axle
              const double c = std::cos(angle),
                           s = mode.diameters == 0 ? 1. : std::sin(angle);
              for (unsigned int d = 0; d < 3; ++d)
                if (node.unknowns[d] >= 0)
                  shapes(node.unknowns[d], j) =
                    c * U(0, j) * place.along[d] +
                    c * U(1, j) * place.outwards[d] +
                    s * U(2, j) * place.around[d];
            }
        }
      return shapes;
    }
  } // namespace

  std::pair<StructuralModes, HarmonicAccuracy>
  harmonic_modes(const RevolvedBody &body,
                 const BodyPlaces   &places,
                 const std::size_t   n_unknowns,
                 const ModeControls &controls)
  {
    const SectionMesh mesh =
      resolving(body.section, body.material, controls.cut_off);
    const HarmonicSection section(mesh, body.material, body.clamped, degree),
      coarse(mesh, body.material, body.clamped, degree - 1);
    const double shift =
      body.clamped ? 0. : shift_of_free_body(controls.cut_off);
    const auto of_section = find_all(section, shift, controls);

    HarmonicAccuracy accuracy;
    accuracy.n_unknowns = section.nodes_of_unknowns().size();
    accuracy.lower_degree_error =
      difference(of_section, find_all(coarse, shift, controls));
    StructuralModes modes;
    modes.cut_off       = controls.cut_off;
    modes.n_subspaces   = of_section.size();
    std::size_t counted = 0;
    for (unsigned int n = 0; n < of_section.size(); ++n)
      {
        const StructuralModes &these = of_section[n];
        if (these.size() > 0)
          accuracy.most_diameters = n;
        counted += (n == 0 ? 1 : 2) * these.counted.value_or(0);
        modes.orthogonality =
          std::max(modes.orthogonality, these.orthogonality);
        modes.n_solves += these.n_solves;
        modes.n_basis     = std::max(modes.n_basis, these.n_basis);
        modes.basis_bytes = std::max(modes.basis_bytes, these.basis_bytes);
        modes.lanczos_seconds += these.lanczos_seconds;
        modes.count_seconds += these.count_seconds;
      }
    if (controls.count)
      modes.counted = counted;
    const auto order = in_order(of_section);
    for (const OneMode &mode : order)
      {
        modes.frequencies.push_back(mode.frequency);
        modes.residuals.push_back(
          of_section[mode.diameters].residuals[mode.number]);
      }
    modes.shapes =
      shapes_at(places, body.axle, section, of_section, order, n_unknowns);
    return {std::move(modes), accuracy};
  }
} // namespace RollingContact
