#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/gap_lines.h>
#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/surfaces/half_space_pressure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    ContactGrid grid_on(const ZoneBox &box, const std::size_t n_along)
    {
      const double widest = 5e-4, width = box.upper[1] - box.lower[1];
      ContactGrid  grid;
      grid.n_x     = n_along;
      grid.n_y     = std::max<std::size_t>(n_along, std::ceil(width / widest));
      grid.size_x  = (box.upper[0] - box.lower[0]) / grid.n_x;
      grid.size_y  = width / grid.n_y;
      grid.first_x = box.lower[0] + grid.size_x / 2;
      grid.first_y = box.lower[1] + grid.size_y / 2;
      return grid;
    }

    /** A grid, the gap there and the pressure. */
    struct Solution
    {
      ContactGrid       grid;
      HalfSpacePressure state;
    };

    /**
     * Finds the pressure on a rectangle that holds the patch: the place where
     * the surfaces would overlap.
     */
    class PatchSearch
    {
    public:
      PatchSearch(const Profiles::ContactFrame &frame,
                  const double                  contact_modulus,
                  const double                  load_angle)
        : frame(frame)
        , share(frame, load_angle)
        , modulus(contact_modulus)
        , lines(lines_across(frame, share))
      {}

      Solution with_approach(const double      approach,
                             const std::size_t n_along) const
      {
        return solve(overlap(lines, approach), n_along, {}, approach);
      }

      /**
       * By the approach that gives about the load, and then under it.
       */
      Solution under_load(const double load, const std::size_t n_along) const
      {
        const std::size_t coarse = 20;
        double            depth  = 2e-5;
        for (unsigned int round = 0; round < 12; ++round)
          {
            const double found  = with_approach(depth, coarse).state.load,
                         change = std::pow(load / std::max(found, 1e-3 * load),
                                           2. / 3);
            depth *= change;
            if (std::abs(change - 1) < 0.02)
              break;
          }
        if (depth > deepest_approach)
          throw InputError("Profiles: a load of " + significant(load, 4) +
                           " N presses the surfaces by more than " +
                           millimetres(deepest_approach) +
                           " into each other. Give a smaller load, in N.");
        const double ample = 1.1;
        return solve(overlap(lines, ample * depth), n_along, load, 0.);
      }

    private:
      Solution solve(const ZoneBox               &box,
                     const std::size_t            n_along,
                     const std::optional<double> &load,
                     const double                 approach) const
      {
        const double        beyond = 1e-2; // m, where a surface ends
        Solution            solution{grid_on(box, n_along), {}};
        const ContactGrid  &grid = solution.grid;
        std::vector<double> gap, shares;
        for (std::size_t j = 0; j < grid.n_y; ++j)
          for (std::size_t i = 0; i < grid.n_x; ++i)
            {
              const double s = grid.y(j);
              gap.push_back(frame.gap(grid.x(i), s).value_or(beyond));
              if (!share.is_one())
                shares.push_back(frame.covers(s)
                                   ? std::max(least_approach_share, share(s))
                                   : 1.);
            }
        try
          {
            solution.state =
              half_space_pressure(grid, gap, modulus, load, approach, shares);
          }
        catch (const std::runtime_error &error)
          {
            throw ConvergenceError(
              std::string("Profiles, estimate of the patch: ") + error.what() +
              " Take another Profiles/Lateral shift or smoother profiles.");
          }
        return solution;
      }

      const Profiles::ContactFrame &frame;
      const ApproachShare           share;
      const double                  modulus;
      const std::vector<GapLine>    lines;
    };

    /** Rows that touch, from .. to .., without one between that does not. */
    struct Rows
    {
      std::size_t begin, end;
    };

    /**
     * The load of each row, with its place.
     */
    std::vector<std::pair<double, double>> load_across(const Solution &found)
    {
      std::vector<std::pair<double, double>> load;
      const ContactGrid                     &grid = found.grid;
      for (std::size_t j = 0; j < grid.n_y; ++j)
        {
          double sum = 0.;
          for (std::size_t i = 0; i < grid.n_x; ++i)
            sum += found.state.pressure[j * grid.n_x + i];
          load.emplace_back(grid.y(j), sum * grid.size_x * grid.size_y);
        }
      return load;
    }

    std::vector<Rows>
    touching_rows(const std::vector<std::pair<double, double>> &load)
    {
      std::vector<Rows> patches;
      for (std::size_t j = 0; j < load.size(); ++j)
        if (load[j].second > 0.)
          {
            if (patches.empty() || patches.back().end != j)
              patches.push_back({j, j});
            patches.back().end = j + 1;
          }
      return patches;
    }

    /**
     * Stretches along x that touch in these rows, as boxes.
     */
    std::vector<ZoneBox> touching_boxes(const Solution &found, const Rows &rows)
    {
      const ContactGrid   &grid = found.grid;
      std::vector<ZoneBox> boxes;
      for (std::size_t j = rows.begin; j < rows.end; ++j)
        for (std::size_t i = 0; i < grid.n_x; ++i)
          {
            const auto touches = [&](const std::size_t k) {
              return k < grid.n_x &&
                     found.state.pressure[j * grid.n_x + k] > 0.;
            };
            const std::size_t begin = i;
            while (touches(i))
              ++i;
            if (i > begin)
              boxes.push_back({{{grid.x(begin) - grid.size_x / 2,
                                 grid.y(j) - grid.size_y / 2}},
                               {{grid.x(i - 1) + grid.size_x / 2,
                                 grid.y(j) + grid.size_y / 2}}});
          }
      return boxes;
    }

    double load_of(const Rows                                   &rows,
                   const std::vector<std::pair<double, double>> &load)
    {
      double sum = 0.;
      for (std::size_t j = rows.begin; j < rows.end; ++j)
        sum += load[j].second;
      return sum;
    }

    /**
     * Whether rows carry enough to be resolved.
     */
    bool matters(const Rows                                   &rows,
                 const std::vector<std::pair<double, double>> &load)
    {
      const double least = 0.1; // of the load
      return load_of(rows, load) >= least * load_of({0, load.size()}, load);
    }

    /**
     * Add a patch of these rows, which must be resolved or need not.
     */
    void add_patch(const Solution &found,
                   const Rows     &rows,
                   const bool      must_be_resolved,
                   ProfilePatch   &patch)
    {
      double half_length = 0.;
      for (const ZoneBox &box : touching_boxes(found, rows))
        {
          patch.boxes.push_back(box);
          half_length =
            std::max(half_length, (box.upper[0] - box.lower[0]) / 2);
        }
      const double half_width = (rows.end - rows.begin) * found.grid.size_y / 2;
      patch.half_width_x      = std::max(patch.half_width_x, half_length);
      patch.half_width_y      = std::max(patch.half_width_y, half_width);
      const auto least        = [](const double before, const double now) {
        return before > 0. ? std::min(before, now) : now;
      };
      if (must_be_resolved)
        {
          patch.shortest_x  = least(patch.shortest_x, half_length);
          patch.narrowest_y = least(patch.narrowest_y, half_width);
        }
    }
    void add_means(const Profiles::ContactFrame                 &frame,
                   const std::vector<std::pair<double, double>> &load,
                   ProfilePatch                                 &patch)
    {
      Rows heaviest{0, 0};
      for (const Rows &rows : touching_rows(load))
        if (load_of(rows, load) > load_of(heaviest, load))
          heaviest = rows;
      for (std::size_t j = heaviest.begin; j < heaviest.end; ++j)
        {
          const double share = load[j].second / load_of(heaviest, load);
          patch.middle += share * load[j].first;
          patch.slope += share * frame.rail_angle(load[j].first);
        }
    }
  } // namespace

  ProfilePatch profile_patch(const Profiles::ContactFrame &frame,
                             const double                  contact_modulus,
                             const std::optional<double>  &load,
                             const double                  approach,
                             const double                  load_angle)
  {
    ProfilePatch patch;
    if (!(load.value_or(approach) > 0.))
      return patch;
    const std::size_t n_along = 40;
    const PatchSearch search(frame, contact_modulus, load_angle);
    const Solution    found = load ? search.under_load(*load, n_along)
                                   : search.with_approach(approach, n_along);
    patch.normal_force      = found.state.load;
    patch.approach          = found.state.approach;
    const auto load_of_rows = load_across(found);
    for (const Rows &rows : touching_rows(load_of_rows))
      {
        add_patch(found, rows, matters(rows, load_of_rows), patch);
        for (const std::size_t row : {rows.begin, rows.end - 1})
          if (!frame.gap(0.,
                         found.grid.y(row) +
                           (row == rows.begin ? -1 : 1) * found.grid.size_y))
            throw InputError(
              "Profiles: the patch reaches the end of a profile, " +
              millimetres(found.grid.y(row)) +
              " from the first contact. Take another Profiles/Lateral shift, "
              "less load or longer profiles.");
      }
    patch.turn_of_normal = frame.turn_of_normal(load_of_rows);
    add_means(frame, load_of_rows, patch);
    return patch;
  }

  bool PressedHalfSpaces::operator==(const PressedHalfSpaces &other) const
  {
    return wheel == other.wheel && rail == other.rail && load == other.load &&
           approach == other.approach;
  }

  std::shared_ptr<const Profiles::ContactFrame>
  frame_at_patch(std::shared_ptr<const Profiles::ContactFrame> first,
                 const PressedHalfSpaces                      &bodies)
  {
    auto frame = std::move(first);
    if (!(bodies.load.value_or(bodies.approach) > 0.) ||
        !(bodies.wheel || bodies.rail))
      return frame;
    const auto modulus = [](const std::optional<Material> &material) {
      return material ? material->young_modulus
                      : std::numeric_limits<double>::infinity();
    };
    const auto ratio = [](const std::optional<Material> &material) {
      return material ? material->poisson_ratio : 0.;
    };
    for (unsigned int round = 0; round < 2; ++round)
      {
        const ProfilePatch patch =
          profile_patch(*frame,
                        References::contact_modulus(modulus(bodies.wheel),
                                                    ratio(bodies.wheel),
                                                    modulus(bodies.rail),
                                                    ratio(bodies.rail)),
                        bodies.load,
                        bodies.approach);
        frame = frame->at_patch(patch.middle, patch.slope);
      }
    return frame;
  }
} // namespace RollingContact
