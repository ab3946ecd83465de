#include <boost/pending/disjoint_sets.hpp>

#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/patches.h>

#include <algorithm>
#include <map>

namespace RollingContact
{
  namespace
  {
    /**
     * Touching nodes, those of a patch together.
     */
    std::vector<std::vector<unsigned int>>
    connected_nodes(const Trace &trace, const std::vector<double> &pressure)
    {
      std::vector<unsigned int> rank(pressure.size(), 0),
        parent(pressure.size());
      boost::disjoint_sets<unsigned int *, unsigned int *> sets(rank.data(),
                                                                parent.data());
      for (unsigned int i = 0; i < pressure.size(); ++i)
        sets.make_set(i);
      for (const Trace::Cell &cell : trace.cells)
        {
          std::vector<unsigned int> touching;
          for (const SparseRows::Row &corner : cell.corners)
            for (const auto &entry : corner)
              if (pressure[entry.first] > 0.)
                touching.push_back(entry.first);
          for (std::size_t k = 1; k < touching.size(); ++k)
            sets.union_set(touching[0], touching[k]);
        }
      std::map<unsigned int, std::vector<unsigned int>> by_root;
      for (unsigned int i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0.)
          by_root[sets.find_set(i)].push_back(i);
      std::vector<std::vector<unsigned int>> groups;
      for (auto &entry : by_root)
        groups.push_back(std::move(entry.second));
      return groups;
    }
  } // namespace

  std::vector<ContactPatch> contact_patches(const Trace          &trace,
                                            const ContactProblem &problem,
                                            const ContactState   &state)
  {
    const auto                   &at     = problem.operators.positions();
    const std::vector<double>     forces = nodal_forces(problem, state);
    const std::vector<NodalForce> plane_forces =
      forces_in_plane(problem, forces);
    const unsigned int n = problem.n_nodes(), first_normal = forces.size() - n;
    const NodalField   slip =
      problem.n_tangential() > 0
          ? tangential_problem(problem, state).mean_slip(state)
          : NodalField();
    const std::vector<double> inside =
      areas_in_contact(problem.operators, state.pressure);
    std::vector<ContactPatch> patches;
    for (auto &nodes : connected_nodes(trace, state.pressure))
      {
        ContactPatch patch;
        for (const unsigned int i : nodes)
          {
            const double normal = forces[first_normal + i],
                         area   = problem.operators.areas()[i];
            patch.area += inside[i];
            patch.normal_force += normal;
            patch.in_plane.x += plane_forces[i].x;
            patch.in_plane.y += plane_forces[i].y;
            patch.in_plane.z += plane_forces[i].z;
            patch.centre_x += normal * at[i][0];
            patch.centre_y += normal * at[i][1];
            patch.max_pressure =
              std::max(patch.max_pressure, state.pressure[i]);
            for (unsigned int c = 0; c < problem.n_tangential(); ++c)
              {
                (c == 0 ? patch.force_x : patch.force_y) += forces[c * n + i];
                patch.dissipation -= area * state.traction(c, i) * slip(c, i);
              }
          }
        patch.centre_x /= patch.normal_force;
        patch.centre_y /= patch.normal_force;
        patch.nodes = std::move(nodes);
        patches.push_back(std::move(patch));
      }
    std::sort(patches.begin(), patches.end(), [](const auto &a, const auto &b) {
      return a.normal_force > b.normal_force;
    });
    return patches;
  }
} // namespace RollingContact
