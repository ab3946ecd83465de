#include <rolling_contact/mesh/hanging_vertices.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    using WeightedCorners = std::vector<std::pair<unsigned int, double>>;

    /**
     * WeightedCorners that do not hang, for one that may.
     */
    void add_share(const HangingVertices &hanging,
                   const unsigned int     vertex,
                   const double           share,
                   WeightedCorners       &corners)
    {
      const auto found = hanging.find(vertex);
      if (found == hanging.end())
        corners.emplace_back(vertex, share);
      else
        for (const auto &[corner, part] : found->second)
          add_share(hanging, corner, share * part, corners);
    }
  } // namespace

  HangingVertices hanging_vertices(const Triangulation<3> &cells)
  {
    HangingVertices hanging;
    for (const auto &cell : cells.active_cell_iterators())
      {
        for (const unsigned int l : cell->line_indices())
          if (const auto line = cell->line(l); line->has_children())
            hanging[line->child(0)->vertex_index(1)] = {
              {line->vertex_index(0), 0.5}, {line->vertex_index(1), 0.5}};
        for (const unsigned int f : cell->face_indices())
          if (const auto face = cell->face(f); face->has_children())
            {
              WeightedCorners corners;
              for (const unsigned int v : face->vertex_indices())
                corners.emplace_back(face->vertex_index(v), 0.25);
              hanging[face->child(0)->vertex_index(3)] = corners;
            }
      }
    HangingVertices result;
    for (const auto &entry : hanging)
      add_share(hanging, entry.first, 1., result[entry.first]);
    return result;
  }
} // namespace RollingContact
