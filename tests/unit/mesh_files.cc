#include "mesh_files.h"

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"

#include <rolling_contact/mesh/abaqus_text.h>
#include <rolling_contact/mesh/mesh_file.h>
#include <rolling_contact/pair/mesh_unit_check.h>
#include <rolling_contact/program/analysis_table.h>

#include <cmath>
#include <map>
#include <memory>
#include <new>

using namespace RollingContact;

/** What is said of mesh files that cannot be read or used. */
BOOST_AUTO_TEST_SUITE(mesh_files)

namespace
{
  /** What is said of a scene with this rail. */
  struct Complaints : public Files
  {
    std::string of(const std::string                            &name,
                   const std::string                            &text,
                   const std::function<void(SceneParameters &)> &change = {},
                   const unsigned int                            dim = 2) const
    {
      save(name, text);
      return of_scene(name, change, dim);
    }

    std::string
    of_scene(const std::string                            &name,
             const std::function<void(SceneParameters &)> &change = {},
             const unsigned int                            dim    = 2) const
    {
      return complaint([&]() {
        const auto take_it = [&](SceneParameters &scene) {
          scene.dimension            = dim;
          scene.mesh.growth          = 0.5;
          scene.wheel.lateral_radius = dim == 2 ? 0. : 0.3;
          scene.rail.radius          = 0.;
          scene.contact.normal_load  = dim == 2 ? 40e3 : 10e3;
          take(scene.rail, name);
          if (change)
            change(scene);
          scene.check();
        };
        if (dim == 2)
          SceneRun<2>(
            [](SceneParameters &scene) {
              scene.mesh.elements_across_patch = 12;
            },
            take_it);
        else
          SceneRun<3>(
            [](SceneParameters &scene) {
              scene.mesh.elements_across_patch = 6;
            },
            take_it);
      });
    }
  };

  std::string
  replaced(std::string text, const std::string &what, const std::string &by)
  {
    const std::size_t at = text.find(what);
    BOOST_REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), by);
  }
} // namespace

BOOST_AUTO_TEST_CASE(files_that_cannot_be_read)
{
  const Complaints  said;
  const WrittenMesh good = block(2, 40, 0.);
  BOOST_TEST(said.of("good.msh", good.gmsh()) == "");
  const auto check = [](const std::string &text, const std::string &part) {
    BOOST_TEST(contains(text, "Rail/"), text);
    BOOST_TEST(contains(text, part), text);
  };
  check(said.of_scene("none.msh"), "cannot be read: there is no such file");
  check(said.of_scene(""), "it is a folder");
  check(said.of("empty.msh", ""), "is empty");
  check(said.of("mesh.vtk", good.gmsh()), ".msh, or an Abaqus input file");
  check(said.of("text.msh", "hello"), "$MeshFormat");
  check(said.of("binary.msh", replaced(good.gmsh(), "2.2 0 8", "4.1 1 8")),
        "it is binary");
  check(said.of("old.msh", replaced(good.gmsh(), "2.2 0 8", "3.0 0 8")),
        "its format is not one of");
  check(said.of("short.msh", good.gmsh().substr(0, 4000)),
        "in its $Nodes a number is missing");
  check(said.of("cut.msh", good.gmsh().substr(0, good.gmsh().size() - 3000)),
        "in its $Elements a number is missing");
  check(said.of("node.msh",
                replaced(good.gmsh(), "3 2 3 1 1 ", "3 2 3 1 999 ")),
        "a node that is not there");
  check(said.of("order.msh",
                replaced(good.gmsh(), "3 2 3 1 1 ", "10 2 3 1 1 ")),
        "only those of first order");
  // what deal.II would wait for without end
  check(said.of("entities.msh",
                replaced(good.gmsh(),
                         "$Nodes",
                         "$Entities\n4000000000 0 0 0\n$EndEntities\n$Nodes")),
        "line 4: \"$Entities\" stands in place of $Nodes");
  check(said.of("names.msh",
                replaced(good.gmsh(), "$Nodes", "$PhysicalNames\n$Nodes")),
        "it has no $Nodes");
  check(said.of("comment.msh",
                replaced(good.gmsh(), "$Elements", "$Comments\n$EndComments")),
        "\"$Comments\" stands in place of $Elements");
  check(said.of("twice.msh", replaced(good.gmsh(), "\n2 ", "\n1 ")),
        "line 7: in its $Nodes node 1 is there twice");
  check(said.of("word.msh", replaced(good.gmsh(), "\n2 ", "\n2 zero ")),
        "line 7: in its $Nodes \"zero\" stands in place of a number");
}

BOOST_AUTO_TEST_CASE(format_4_files_that_cannot_be_read)
{
  const Complaints  said;
  const std::string good = block(2, 40, 0.).gmsh41();
  BOOST_TEST(said.of("good.msh", good) == "");
  const auto check = [&](const std::string &line,
                         const std::string &by,
                         const std::string &part) {
    const std::string text =
      said.of("bad.msh", replaced(good, '\n' + line + '\n', '\n' + by + '\n'));
    BOOST_TEST(contains(text, "Rail/"), text);
    BOOST_TEST(contains(text, part), text);
  };
  // dimensions, numbers and counts deal.II believes
  for (const char *dimension : {"7", "9", "15", "40", "-1", "1.5", "x"})
    check("2 1 3 120",
          std::string(dimension) + " 1 3 120",
          "in its $Elements \"" + std::string(dimension) +
            "\" stands in place of a whole number from 0 to 3");
  const std::string number = "stands in place of a whole number from 0 to 2147";
  check("3 200 1 200", "3 200 1 4000000000", number);
  check("3 200 1 200", "3 200 4000000000 200", number);
  check("3 200 1 200", "4000000000 200 1 200", number);
  check("2 1 3 120", "2 1 3 1.2e2", "in its $Elements \"1.2e2\"");
  check("2 1 0 164", "2 4000000000 0 164", number);
  check("2 1 0 164", "4 1 0 164", "a whole number from 0 to 3");
  check("1 164 1 164", "1 164 1 1e9", "in its $Nodes \"1e9\"");
  check("1 164 1 164", "1 1e9 1 164", "in its $Nodes \"1e9\"");
  check("0 2 1 0", "0 2 1 4000000000", "in its $Entities \"4000000000\"");
  check("0 2 1 0", "0 2 1 -1", "in its $Entities \"-1\"");
  check("2 1 0 164", "2 1 1 164", "it has parametric coordinates");
  check("3 200 1 200", "3 199 1 200", "more entries than announced, 199");
  check("3 200 1 200", "3 201 1 200", "fewer entries than announced, 201");
  check("1 164 1 164", "1 163 1 164", "more entries than announced, 163");
  check("1 164 1 164", "1 165 1 164", "fewer entries than announced, 165");
}

BOOST_AUTO_TEST_CASE(the_order_of_dimension_and_entity_in_format_4_0)
{
  const Complaints said;
  std::string      text = block(2, 2, 0.).gmsh41();
  for (const auto &[line, by] :
       std::map<std::string, std::string>{{"4.1 0 8", "4.0 0 8"},
                                          {"3 10 1 10", "3 10"},
                                          {"1 2 1 2", "2 1 1 2"},
                                          {"2 1 3 6", "7 2 3 6"}})
    text = replaced(text, '\n' + line + '\n', '\n' + by + '\n');
  // numbers and coordinates of nodes are together there
  const std::size_t begin = text.find("$Nodes"), end = text.find("$EndNodes");
  const std::string nodes = block(2, 2, 0.).gmsh();
  const std::size_t lines = nodes.find("$Nodes\n12\n") + 10;
  text.replace(begin,
               end - begin,
               "$Nodes\n1 12\n7 2 0 12\n" +
                 nodes.substr(lines, nodes.find("$EndNodes") - lines));
  text = replaced(text, "\n1 0 0 0 0 0 0 1 3", "\n7 0 0 0 0 0 0 1 3");
  const auto read = [&](const std::string &file) {
    said.save("block.msh", file);
    MeshFile mesh;
    mesh.section = "Rail";
    mesh.path    = said.scratch / "block.msh";
    return complaint([&]() { read_mesh_file<2>(mesh); });
  };
  BOOST_TEST(read(text) == "");
  BOOST_TEST(contains(read(replaced(text, "\n7 2 3 6\n", "\n2 7 3 6\n")),
                      "\"7\" stands in place of a whole number from 0 to 3"));
}

BOOST_AUTO_TEST_CASE(a_group_with_a_minus_is_the_group)
{
  const Files files;
  const auto  read = [&](const std::string &text) {
    MeshFile file;
    file.section = "Rail";
    file.path    = files.save("rail.msh", text);
    return read_mesh_file<2>(file)->fingerprint();
  };
  const std::string good = block(2, 4, 0.).gmsh41(),
                    old  = block(2, 4, 0.).gmsh();
  BOOST_TEST(read(replaced(replaced(good, " 1 1 0\n", " 1 -1 0\n"),
                           " 1 2 0\n",
                           " 1 -2 0\n")) == read(good));
  BOOST_TEST(read(replaced(old, "2 1 2 1 1", "2 1 2 -1 1")) == read(old));
}

BOOST_AUTO_TEST_CASE(abaqus_files_that_cannot_be_read)
{
  const Complaints  said;
  const WrittenMesh good = block(2, 40, 0.);
  BOOST_TEST(said.of("good.inp", good.abaqus()) == "");
  const auto check = [](const std::string &text, const std::string &part) {
    BOOST_TEST(contains(text, "Rail/"), text);
    BOOST_TEST(contains(text, part), text);
  };
  check(said.of("text.inp", "hello"), "it has no *ELEMENT");
  check(said.of("triangle.inp",
                "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n*ELEMENT, TYPE=CPE3\n"
                "1, 1, 2, 3\n"),
        "line 6: an element of type CPE3 with 3 nodes");
  check(said.of("numbers.inp",
                "*NODE\n1, 0, 0\n*ELEMENT, TYPE=CPE4\n5, 1, 2, 3, 4\n"),
        "element 5 is number 1");
  check(said.of("face.inp",
                replaced(good.abaqus(), "_Top_S, S4", "_Top_S, S7")),
        "no face of an element");
  check(said.of("set.inp", replaced(good.abaqus(), "_Top_S, S4", "_Bot_S, S4")),
        "neither the name of an *ELSET");
}

namespace
{
  /** Two squares, their top in surface 1 and their bottom in 2; with other
   * nodes of the elements, faces, or lines before nodes and after elements. */
  struct TwoSquares
  {
    std::string text() const
    {
      return before + "*NODE\n" + nodes +
             "*ELEMENT, TYPE=CPE4, ELSET=ALL\n1, " + first + "\n2, " + second +
             "\n" + after + "*SURFACE, NAME=SURF-1\n" + top +
             "*SURFACE, NAME=SURF-2\n" + bottom;
    }

    std::string before, after, first = "1, 4, 5, 2", second = "2, 5, 6, 3",
                               top = "1, S4\n2, S4\n", bottom = "ALL, S2\n",
                               nodes = "1, -1, 0\n2, 0, 0\n3, 1, 0\n4, -1, -1\n"
                                       "5, 0, -1\n6, 1, -1\n";
  };

  std::shared_ptr<const FileMesh> read_text(const std::string &text)
  {
    const Files files;
    MeshFile    file;
    file.section = "Rail";
    file.name    = "rail.inp";
    file.path    = files.save("rail.inp", text);
    return read_mesh_file<2>(file);
  }

  /** Empty if the file can be read. */
  std::string said_of(const TwoSquares &file)
  {
    return complaint([&]() { read_text(file.text()); });
  }
} // namespace

BOOST_AUTO_TEST_CASE(nodes_of_abaqus)
{
  const auto said = [](const std::string &line, const std::string &by) {
    TwoSquares file;
    file.nodes = replaced(file.nodes, line, by);
    return said_of(file);
  };
  BOOST_TEST(said("1, -1, 0", "1, -1, 0") == "");
  for (const char *same : {"-1.0D+00, 0.", "-10.0d-1", "-1, , 3", "-1E0,0D0"})
    BOOST_TEST(said("1, -1, 0", std::string("1, ") + same) == "", same);
  for (const char *other :
       {"one", "1.0.0", "nan", "inf", "0x1", "1e999", "1 -"})
    {
      const std::string text = said("2, 0, 0", std::string("2, 0, ") + other);
      BOOST_TEST(contains(text, "Rail/Mesh file = rail.inp: line 3"), text);
      BOOST_TEST(contains(text, "is no coordinate of node 2"), text);
    }
  for (const char *number : {"0", "-1", "1.5", "x", "", "10000000000"})
    BOOST_TEST(contains(said("2, 0, 0", std::string(number) + ", 0, 0"),
                        "line 3: \"" +
                          std::string(*number == 'x' ? "X" : number) +
                          "\" is not a node number"));
  BOOST_TEST(contains(said("2, 0, 0", "1, 0, 0"), "line 3: node 1 is there"));
  TwoSquares file;
  file.second = "2, 5, 7, 3";
  BOOST_TEST(
    contains(said_of(file), "line 10: an element has node 7, which is not in"));
  file.second = "2, 5, 0, 3";
  BOOST_TEST(contains(said_of(file), "line 10: \"0\" is not a node number"));
}

BOOST_AUTO_TEST_CASE(parts_that_abaqus_moves)
{
  const auto said = [](const std::string &line) {
    TwoSquares file;
    file.before = line + '\n';
    return said_of(file);
  };
  for (const char *line : {"*SYSTEM\n0, 1, 0",
                           "*Node, system=C\n9, 1, 0",
                           "*NODE, NSET=A, SYSTEM=S"})
    BOOST_TEST(contains(said(line), "line 1: a system of coordinates"), line);
  BOOST_TEST(said("*NODE, SYSTEM=R\n9, 1, 0") == "");
  BOOST_TEST(said("*INSTANCE, NAME=I, PART=P\n0., 0., 0.\n") == "");
  BOOST_TEST(said("*INSTANCE, NAME=I, PART=P\n*END INSTANCE") == "");
  BOOST_TEST(contains(said("*INSTANCE, NAME=I, PART=P\n0., 5., 0."),
                      "line 2: *INSTANCE moves the part (5.); export it"));
  BOOST_TEST(contains(said("*INSTANCE, NAME=I\n0, 0, 0\n0, 0, 0, 0, 0, 1, 90"),
                      "line 3: *INSTANCE moves the part"));
  for (const char *line : {"*NCOPY, CHANGE NUMBER=10",
                           "*ELGEN",
                           "*INCLUDE, INPUT=nodes.inp",
                           "*NODE, INPUT=nodes.inp"})
    BOOST_TEST(contains(said(line), "write all nodes and elements"), line);
}

BOOST_AUTO_TEST_CASE(sets_and_orders_of_abaqus)
{
  const auto good = read_text(TwoSquares().text());
  BOOST_TEST(good->hub_faces.size() == 2u);
  BOOST_TEST(good->contact_faces.size() == 2u);
  // clockwise, as Gmsh's may be, with their faces
  TwoSquares mixed;
  mixed.second = "2, 3, 6, 5";
  mixed.top    = "1, S4\n2, S1\n";
  mixed.bottom = "1, S2\n2, S3\n";
  BOOST_TEST(read_text(mixed.text())->fingerprint() == good->fingerprint());
  TwoSquares unknown;
  unknown.before = "*SOLID SECTION, ELSET=SOLID\n";
  unknown.top    = "SOLID, S4\n";
  BOOST_TEST(contains(said_of(unknown), "neither the name of an *ELSET"));
  TwoSquares generated;
  generated.after = "*ELSET, ELSET=ODD, GENERATE\n1, 2, 1\n";
  generated.top   = "ODD, S4\n";
  BOOST_TEST(read_text(generated.text())->fingerprint() == good->fingerprint());
  generated.after = "*ELSET, ELSET=ODD, GENERATE\n1\n";
  BOOST_TEST(contains(said_of(generated), "the first and the last number"));
  TwoSquares nodes;
  nodes.before = "*SURFACE, NAME=SURF-7, TYPE=NODE\n";
  BOOST_TEST(contains(said_of(nodes), "a surface of nodes"));
  TwoSquares inside;
  inside.top = "1, S4\n2, S4\n1, S3\n";
  BOOST_TEST(contains(said_of(inside), "a boundary id for an internal face"));
  TwoSquares large;
  large.before = "*SURFACE, NAME=SURF-4000000000\n";
  BOOST_TEST(contains(said_of(large), "line 1: the id 4000000000 of surface"));
}

/** Far from the origin, on either side of it, and along both axes. */
BOOST_AUTO_TEST_CASE(a_quadrilateral_is_turned_wherever_it_lies)
{
  for (const int x : {-7, 0, 7})
    for (const int y : {-9, 0, 9})
      {
        std::ostringstream nodes;
        for (const auto &[dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
          nodes << 1 + (dy == 0 ? dx : 3 - dx) << ", " << x + dx << ", "
                << y + dy << '\n';
        for (const char *order : {"1, 2, 3, 4", "1, 4, 3, 2"})
          {
            const std::string read =
              checked_abaqus("*NODE\n" + nodes.str() +
                               "*ELEMENT, TYPE=CPE4\n1, " + order +
                               "\n*SURFACE, NAME=SURF-1\n1, S1\n"
                               "*SURFACE, NAME=SURF-2\n1, S3\n",
                             2);
            BOOST_TEST(contains(read, "*ELEMENT\n1, 1, 2, 3, 4\n"), read);
          }
      }
}

BOOST_AUTO_TEST_CASE(a_mirrored_hexahedron_of_abaqus)
{
  const Files files;
  const auto  read = [&](const std::string &elements) {
    MeshFile file;
    file.section = "Rail";
    file.path    = files.save(
      "rail.inp",
      "*NODE\n1, -1, -1, -1\n2, 0, -1, -1\n3, 0, 1, -1\n4, -1, 1, -1\n"
          "5, -1, -1, 0\n6, 0, -1, 0\n7, 0, 1, 0\n8, -1, 1, 0\n9, 1, -1, -1\n"
          "10, 1, 1, -1\n11, 1, -1, 0\n12, 1, 1, 0\n*ELEMENT, TYPE=C3D8\n" +
        elements);
    return read_mesh_file<3>(file)->fingerprint();
  };
  const std::string first = "1, 1, 2, 3, 4, 5, 6, 7, 8\n";
  BOOST_TEST(read(first + "2, 6, 11, 12, 7, 2, 9, 10, 3\n*SURFACE, NAME=S-1\n"
                          "1, S2\n2, S1\n*SURFACE, NAME=S-2\n1, S1\n2, S2\n") ==
             read(first + "2, 2, 9, 10, 3, 6, 11, 12, 7\n*SURFACE, NAME=S-1\n"
                          "1, S2\n2, S2\n*SURFACE, NAME=S-2\n1, S1\n2, S1\n"));
}

BOOST_AUTO_TEST_CASE(paths_that_are_no_files)
{
  const Complaints said;
  BOOST_TEST(contains(said.of_scene(std::string(304, 'a') + ".msh"),
                      "cannot be read: File name too long"));
  std::filesystem::create_symlink("loop.msh", said.scratch / "loop.msh");
  BOOST_TEST(contains(said.of_scene("loop.msh"), "symbolic links"));
  std::filesystem::create_directory(said.scratch / "folder.msh");
  BOOST_TEST(contains(said.of_scene("folder.msh"), "it is a folder"));
  // what is no fault of the file
  BOOST_CHECK_THROW(read_or_reject({}, 2, []() { throw std::bad_alloc(); }),
                    std::bad_alloc);
  BOOST_CHECK_THROW(
    read_or_reject({}, 2, []() { throw std::runtime_error("x"); }), InputError);
}

namespace
{
  void expect(const std::string &text, const std::string &part)
  {
    BOOST_TEST(contains(text, "Rail/"), text);
    BOOST_TEST(contains(text, part), text);
  }

  /** A mesh of other places than its map's. */
  WrittenMesh changed(
    const WrittenMesh &mesh,
    const std::function<void(WrittenMesh::Point &, const WrittenMesh::Point &)>
      &change)
  {
    WrittenMesh result = mesh;
    result.map         = [=](double a, double b, double c) {
      WrittenMesh::Point p = mesh.map(a, b, c);
      change(p, {{a, b, c}});
      return p;
    };
    return result;
  }
} // namespace

BOOST_AUTO_TEST_CASE(cells_that_cannot_be_used)
{
  const Complaints  said;
  const WrittenMesh good = block(2, 40, 0.), solid = block(3, 24, 0.);
  BOOST_TEST(said.of("good.msh", solid.gmsh(), {}, 3) == "");
  expect(said.of("solid.msh", solid.gmsh()), "Dimension = 2");
  expect(said.of("flat.msh", good.gmsh(), {}, 3), "Dimension = 3");
  expect(said.of("triangle.msh",
                 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 -1 0 0\n"
                 "2 1 0 0\n3 0 -1 0\n$EndNodes\n$Elements\n3\n1 1 2 1 1 1 2\n"
                 "2 1 2 2 1 2 3\n3 2 2 3 1 1 2 3\n$EndElements\n"),
         "it has triangles");
  expect(said.of("tetrahedron.msh",
                 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 -1 -1 0\n"
                 "2 1 -1 0\n3 0 1 0\n4 0 0 -1\n$EndNodes\n$Elements\n3\n"
                 "1 2 2 1 1 1 2 3\n2 2 2 2 1 1 2 4\n3 4 2 3 1 1 2 3 4\n"
                 "$EndElements\n",
                 {},
                 3),
         "it has tetrahedra");
  // a node drawn through the opposite side of its cells
  const WrittenMesh folded =
    changed(good, [](auto &p, const WrittenMesh::Point &at) {
      if (std::abs(at[0] - 0.01) < 1e-9 && at[2] > 0. && at[2] < 0.015)
        p[0] += 0.0015;
    });
  expect(said.of("folded.msh", folded.gmsh()), "inverted, folded or flat");
  // two cells, 8 m apart
  expect(said.of("two.msh",
                 "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 -1 0 0\n"
                 "2 1 0 0\n3 1 -1 0\n4 -1 -1 0\n5 9 0 0\n6 10 0 0\n7 10 -1 0\n"
                 "8 9 -1 0\n$EndNodes\n$Elements\n4\n1 1 2 1 1 1 2\n"
                 "2 1 2 2 1 3 4\n3 3 2 3 1 1 4 3 2\n4 3 2 3 1 5 8 7 6\n"
                 "$EndElements\n"),
         "1 of 2 hang together");
}

BOOST_AUTO_TEST_CASE(contact_boundaries_that_cannot_be_used)
{
  const Complaints  said;
  const WrittenMesh good = block(2, 40, 0.);
  expect(said.of("good.msh",
                 good.gmsh(),
                 [](SceneParameters &scene) {
                   scene.rail.contact_boundary = 7;
                 }),
         "Contact boundary id = 7; its boundary has 0, 1, 2");
  expect(said.of("good.msh",
                 good.gmsh(),
                 [](SceneParameters &scene) { scene.rail.hub_boundary = 5; }),
         "Hub boundary id = 5");
  const auto moved = [&](const double dx, const double dz, const double sign) {
    return changed(good,
                   [=](auto &p, const auto &) {
                     p = {{p[0] + dx, p[1], sign * p[2] + dz}};
                   })
      .gmsh();
  };
  expect(said.of("aside.msh", moved(0.1, 0., 1.)), "not around the origin");
  expect(said.of("above.msh", moved(0., 0., -1.)),
         "no face of it looks towards the other body; the rail must lie below");
  expect(said.of("low.msh", moved(0., -1e-4, 1.)), "off the surface of");
  expect(said.of("near.msh", moved(0.018, 0., 1.)), "and the file's origin");
  expect(said.of("good.msh",
                 good.gmsh(),
                 [](SceneParameters &scene) { scene.rail.radius = 0.46; }),
         "off the surface of Rail/Radius = 0.46");
  // a ring above the origin, whose top looks up
  WrittenMesh ring = good;
  ring.closed      = true;
  ring.a           = equal(0., 2 * dealii::numbers::PI, 16);
  ring.a.pop_back();
  ring.map = [](double a, double, double c) {
    const double radius = 0.1 - c;
    return WrittenMesh::Point{
      {radius * std::sin(a), 0., 0.1 + radius * std::cos(a)}};
  };
  expect(said.of("ring.msh", ring.gmsh()),
         "turns away from the other body at the origin: the rail must lie");
}

namespace
{
  /** A block that ends, on its right, inside a face beyond the zone. */
  WrittenMesh
  short_block(const unsigned int dim, const double length, const double width)
  {
    return changed(block(dim, 8, 0.), [=](auto &p, const auto &) {
      p[0] *= length / 0.04;
      p[1] *= width / 0.04;
    });
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_contact_boundary_that_lies_twice)
{
  // three floors, one over the other, of a band that turns back and forth
  WrittenMesh  band = block(2, 40, 0.);
  const double pi = dealii::numbers::PI, r = 0.004, end = 0.02;
  band.a   = equal(0., 6 * end + 2 * pi * r, 200);
  band.c   = {0., 0.001, 0.002};
  band.map = [=](double a, double, double c) -> WrittenMesh::Point {
    const double turn = 2 * end + pi * r;
    if (a < 2 * end)
      return {{a - end, 0., -c}};
    if (a < turn)
      {
        const double angle = (a - 2 * end) / r;
        return {{end + (r - c) * std::sin(angle),
                 0.,
                 -r + (r - c) * std::cos(angle)}};
      }
    if (a < turn + 2 * end)
      return {{end - (a - turn), 0., -2 * r + c}};
    if (a < 2 * turn)
      {
        const double angle = (a - turn - 2 * end) / r;
        return {{-end - (r + c) * std::sin(angle),
                 0.,
                 -3 * r + (r + c) * std::cos(angle)}};
      }
    return {{a - 2 * turn - end, 0., -4 * r - c}};
  };
  const Complaints said;
  expect(said.of("band.msh", band.gmsh()),
         "its contact boundary lies twice inside the contact zone");
}

BOOST_AUTO_TEST_CASE(a_hub_in_the_contact_zone)
{
  const Complaints said;
  const auto       of = [&](const std::string &text) {
    return said.of("hub.msh", text, [](SceneParameters &scene) {
      scene.rail.radius = 0.46;
    });
  };
  std::string text =
    changed(short_block(2, 0.0072, 0.), [](auto &p, const auto &) {
      p[2] = p[2] / 5 - crown_depth(0.46, p[0]);
    }).gmsh();
  BOOST_TEST(of(text) == "");
  text = replaced(text, "$Elements\n40\n", "$Elements\n41\n");
  text = replaced(text, "$EndElements", "41 1 2 2 1 1 2\n$EndElements");
  expect(of(text),
         "its hub (Rail/Hub boundary id = 2) reaches into the contact zone, at "
         "x = -3.6 mm");
}

BOOST_AUTO_TEST_CASE(a_face_that_is_not_convex)
{
  const Complaints  said;
  const WrittenMesh good = short_block(3, 0.0116, 0.008);
  // all columns lean; one at an edge is drawn in and down
  const WrittenMesh bad = changed(good, [](auto &p, const auto &at) {
    if (at[0] > 0.0199 && at[1] > 0.0199)
      p = {{p[0] - 0.8e-3, p[1] - 0.5e-3, p[2] - 0.5e-3}};
    p[0] -= 0.2 * at[2];
    p[1] -= 0.2 * at[2];
  });
  BOOST_TEST(said.of("good.msh", good.gmsh(), {}, 3) == "");
  expect(said.of("bad.msh", bad.gmsh(), {}, 3),
         "is no convex quadrilateral seen along z");
}

BOOST_AUTO_TEST_CASE(meshes_in_the_wrong_unit)
{
  const Complaints said;
  const auto       in_unit = [](const double unit, const unsigned int dim) {
    WrittenMesh mesh = block(dim, 24, 0.);
    mesh.unit        = unit;
    return mesh.gmsh();
  };
  for (const unsigned int dim : {2u, 3u})
    for (const double unit : {0.001, 1000.})
      for (const bool first : {true, false})
        expect(said.of(
                 "unit.msh",
                 in_unit(unit, dim),
                 [=](SceneParameters &scene) {
                   if (!first)
                     return;
                   check_mesh_units(Situation(scene));
                   BOOST_ERROR("a wrong unit is not noticed on reading");
                 },
                 dim),
               "Mesh unit");
  expect(said.of("approach.msh",
                 in_unit(1000., 2),
                 [](SceneParameters &scene) {
                   scene.contact.normal_load = {};
                   scene.contact.approach    = 0.2e-3;
                   check_mesh_units(Situation(scene));
                 }),
         "Mesh unit");
}

BOOST_AUTO_TEST_CASE(what_a_body_from_a_file_does_not_go_with)
{
  const Complaints said;
  said.save("good.msh", block(2, 40, 0.).gmsh());
  const auto with = [&](const std::function<void(SceneParameters &)> &change) {
    return said.of_scene("good.msh", change);
  };
  BOOST_TEST(contains(with([](SceneParameters &scene) {
                        scene.body_solver = BodySolver::distributed;
                      }),
                      "Body solver = distributed"));
  BOOST_TEST(contains(with([](SceneParameters &scene) {
                        scene.mesh.adaptive_levels = 1;
                      }),
                      "Mesh/Adaptive levels = 1"));
  BOOST_TEST(
    contains(with([](SceneParameters &scene) { scene.mesh.rim_levels = 1; }),
             "Mesh/Rim levels = 1"));
  BOOST_TEST(contains(with([](SceneParameters &scene) {
                        scene.analysis = analysis_kind("accuracy study");
                      }),
                      "Analysis = accuracy study"));
  BOOST_TEST(
    contains(with([](SceneParameters &scene) { scene.rail.rigid = true; }),
             "a rigid body has no mesh"));
  BOOST_TEST(
    contains(with([](SceneParameters &scene) { scene.rail.shape = "block"; }),
             "Shape = mesh file or section only"));
  BOOST_TEST(
    contains(with([](SceneParameters &scene) { scene.rail.hub_boundary = 1; }),
             "Hub boundary id are both 1"));
  BOOST_TEST(contains(with([](SceneParameters &scene) {
                        scene.wheel.rigid                = true;
                        scene.mesh.elements_across_patch = 12;
                      }),
                      "Mesh/Elements across patch: the interface's elements"));
}

BOOST_AUTO_TEST_SUITE_END()
