#include <deal.II/base/data_out_base.h>

#include <rolling_contact/evolution/profile_film.h>

#include <cmath>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const double half_length = 20e-3; ///< m, of the strip along the track

    using Strip = DataOutBase::Patch<2, 3>;

    /** What is between two points of the profile. */
    Strip part_of(const Profiles::ProfileCurve &before,
                  const Profiles::ProfileCurve &now,
                  const double                  middle,
                  const double                  side,
                  const std::size_t             first)
    {
      Strip part;
      part.n_subdivisions = 1;
      part.patch_index    = first;
      part.reference_cell = ReferenceCells::get_hypercube<2>();
      part.data.reinit(4, 4);
      for (unsigned int v = 0; v < 4; ++v)
        {
          const std::size_t  i    = first + v / 2;
          const auto        &from = before.points()[i], &to = now.points()[i];
          const Tensor<1, 3> wear({0., side * (to.y - from.y), from.z - to.z});
          part.vertices[v] = Point<3>(v % 2 == 0 ? -half_length : half_length,
                                      side * (middle + to.y),
                                      -to.z);
          for (unsigned int d = 0; d < 3; ++d)
            part.data(d, v) = wear[d];
          part.data(3, v) = wear.norm();
        }
      return part;
    }
  } // namespace

  std::string worn_strip(const Profiles::ProfileCurve &before,
                         const Profiles::ProfileCurve &now,
                         const double                  middle,
                         const double                  side)
  {
    std::vector<Strip> strip;
    for (std::size_t i = 0; i + 1 < now.points().size(); ++i)
      strip.push_back(part_of(before, now, middle, side, i));
    DataOutBase::VtkFlags flags;
    flags.print_date_and_time = false;
    flags.physical_units      = {{"wear", "m"}, {"depth", "m"}};
    std::ostringstream vtu;
    DataOutBase::write_vtu(
      strip,
      {"wear", "wear", "wear", "depth"},
      {{0,
        2,
        "wear",
        DataComponentInterpretation::component_is_part_of_vector}},
      flags,
      vtu);
    return vtu.str();
  }
} // namespace RollingContact
