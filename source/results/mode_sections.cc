#include <rolling_contact/results/mode_sections.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const unsigned int per_row = 4;

    const double shown_of_height = 0.1;  ///< displacement over height
    const double apart           = 1.25; ///< of sections, over their size

    const double nothing = std::numeric_limits<double>::quiet_NaN();

    /** A corner of the section: across, height, displacements' numbers. */
    struct Corner
    {
      double                                 y, z;
      std::array<types::global_dof_index, 2> dofs;
    };

    using Edge = std::array<Corner, 2>;

    /** The middle of the body along z: what lies above is the contact's side.
     */
    std::array<double, 2> range_of_height(const DoFHandler<3> &dofs)
    {
      std::array<double, 2> range{{0., 0.}};
      for (const auto &vertex : dofs.get_triangulation().get_vertices())
        range = {
          {std::min(range[0], vertex[2]), std::max(range[1], vertex[2])}};
      return range;
    }

    /** Edges of boundary faces in the plane x = 0, each once. */
    std::vector<Edge> outline(const ElasticBody<3> &body, const bool upper_half)
    {
      const DoFHandler<3> &dofs   = body.dof_handler();
      const auto           height = range_of_height(dofs);
      const double         least =
                     upper_half ? (height[0] + height[1]) / 2 : height[0] - 1.,
                   tolerance = 1e-6 * (height[1] - height[0]);
      std::set<std::array<types::global_dof_index, 2>> seen;
      std::vector<Edge>                                edges;
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            const auto          face = cell->face(f);
            std::vector<Corner> corners;
            for (unsigned int v = 0; v < 4; ++v)
              if (std::abs(face->vertex(v)[0]) < tolerance &&
                  face->vertex(v)[2] > least)
                corners.push_back({face->vertex(v)[1],
                                   face->vertex(v)[2],
                                   {{face->vertex_dof_index(v, 1),
                                     face->vertex_dof_index(v, 2)}}});
            if (corners.size() != 2)
              continue;
            const std::array<types::global_dof_index, 2> ends{
              {std::min(corners[0].dofs[0], corners[1].dofs[0]),
               std::max(corners[0].dofs[0], corners[1].dofs[0])}};
            if (seen.insert(ends).second)
              edges.push_back({{corners[0], corners[1]}});
          }
      return edges;
    }

    /** Where a section is drawn, and how large. */
    struct Frame
    {
      double low_y = 0., low_z = 0., width = 0., height = 0.;

      explicit Frame(const std::vector<Edge> &edges)
      {
        low_y = low_z = std::numeric_limits<double>::infinity();
        double high_y = -low_y, high_z = -low_z;
        for (const Edge &edge : edges)
          for (const Corner &corner : edge)
            {
              low_y  = std::min(low_y, corner.y);
              high_y = std::max(high_y, corner.y);
              low_z  = std::min(low_z, corner.z);
              high_z = std::max(high_z, corner.z);
            }
        width  = high_y - low_y;
        height = high_z - low_z;
      }
    };
  } // namespace

  void plot_mode_sections(const ElasticBody<3>         &body,
                          const std::vector<ShownMode> &modes,
                          const bool                    mirrored,
                          const std::string            &title,
                          RunContext                   &context,
                          const std::string            &name)
  {
    const std::vector<Edge> edges = outline(body, mirrored);
    if (edges.empty() || modes.empty())
      return;
    const Frame         frame(edges);
    const double        sign = mirrored ? -1. : 1.;
    Figure              figure(title, "across (mm)", "height (mm)");
    std::vector<double> rest_y, rest_z;
    for (std::size_t k = 0; k < modes.size(); ++k)
      {
        const double right = 1e3 * apart * frame.width * (k % per_row),
                     down  = 1e3 * apart * frame.height * (k / per_row);
        // of the whole body: a section that stays at rest is shown_of_height at
        // rest
        const double largest = modes[k].shape.linfty_norm(),
                     scale   = largest > 0.
                                 ? shown_of_height * frame.height / largest
                                 : 0.;
        std::vector<double> y, z;
        for (const Edge &edge : edges)
          {
            for (const Corner &corner : edge)
              {
                rest_y.push_back(1e3 * corner.y + right);
                rest_z.push_back(sign * 1e3 * corner.z - down);
                y.push_back(
                  1e3 * (corner.y + scale * modes[k].shape[corner.dofs[0]]) +
                  right);
                z.push_back(
                  sign * 1e3 *
                    (corner.z + scale * modes[k].shape[corner.dofs[1]]) -
                  down);
              }
            for (auto *values : {&rest_y, &rest_z, &y, &z})
              values->push_back(nothing);
          }
        figure.add_curve(modes[k].name, y, z, CurveStyle::line);
      }
    figure.add_curve("at rest", rest_y, rest_z, CurveStyle::reference);
    figure.set_equal_scales();
    figure.draw(context, name);
  }
} // namespace RollingContact
