#include <rolling_contact/mesh/abaqus_file.h>
#include <rolling_contact/mesh/abaqus_text.h>
#include <rolling_contact/mesh/shared_edges.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    using NodePlace = AbaqusFile::Point;

    NodePlace difference(const NodePlace &p, const NodePlace &q)
    {
      return {{p[0] - q[0], p[1] - q[1], p[2] - q[2]}};
    }

    /**
     * Sign of the area or, in the middle, of the Jacobian.
     */
    bool is_inverted(const std::vector<NodePlace> &c)
    {
      if (c.size() == 4)
        {
          const NodePlace d = difference(c[2], c[0]),
                          e = difference(c[3], c[1]);
          return d[0] * e[1] - d[1] * e[0] < 0.;
        }
      NodePlace axes[3] = {};
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          {
            axes[0][d] += (v % 4 == 1 || v % 4 == 2 ? 1. : -1.) * c[v][d];
            axes[1][d] += (v % 4 > 1 ? 1. : -1.) * c[v][d];
            axes[2][d] += (v > 3 ? 1. : -1.) * c[v][d];
          }
      double determinant = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        determinant +=
          axes[2][d] * (axes[0][(d + 1) % 3] * axes[1][(d + 2) % 3] -
                        axes[0][(d + 2) % 3] * axes[1][(d + 1) % 3]);
      return determinant < 0.;
    }

    /**
     * Turns an element with the orientation of a mirror image, and the labels
     * of its faces.
     */
    void orient(AbaqusFile &file)
    {
      std::vector<bool> turned;
      for (AbaqusFile::Element &element : file.elements)
        {
          auto                  &corners = element.corners;
          std::vector<NodePlace> points;
          for (const long node : corners)
            points.push_back(file.nodes.at(node));
          turned.push_back(is_inverted(points));
          if (turned.back() && corners.size() == 4)
            std::swap(corners[1], corners[3]);
          else if (turned.back())
            std::rotate(corners.begin(), corners.begin() + 4, corners.end());
        }
      const bool flat = file.elements[0].corners.size() == 4;
      for (AbaqusFile::Surface &surface : file.surfaces)
        for (auto &[element, label] : surface.faces)
          if (turned[element - 1] && (flat || label < 3))
            label = (flat ? 5 : 3) - label;
    }

    std::string written(const AbaqusFile &file)
    {
      std::ostringstream text;
      text << std::setprecision(17) << "*NODE\n";
      for (const auto &[number, point] : file.nodes)
        text << number << ", " << point[0] << ", " << point[1] << ", "
             << point[2] << '\n';
      text << "*ELEMENT\n";
      for (std::size_t i = 0; i < file.elements.size(); ++i)
        {
          text << i + 1;
          for (const long corner : file.elements[i].corners)
            text << ", " << corner;
          text << '\n';
        }
      for (const AbaqusFile::Surface &surface : file.surfaces)
        {
          text << "*SURFACE, NAME=SURF-" << surface.id << '\n';
          for (const auto &[element, label] : surface.faces)
            text << element << ", S" << label << '\n';
        }
      return text.str();
    }
  } // namespace

  std::string checked_abaqus(const std::string &text,
                             const unsigned int dimension)
  {
    AbaqusFile  file = read_abaqus_file(text, dimension);
    SharedEdges edges;
    for (const AbaqusFile::Element &element : file.elements)
      if (dimension == 2)
        edges.add(element.corners);
    edges.check();
    orient(file);
    return written(file);
  }
} // namespace RollingContact
