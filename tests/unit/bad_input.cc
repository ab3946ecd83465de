#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"

#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/base/expression_text.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/spelling.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/mesh/mesh_file.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/scene/table_parameters.h>
#include <rolling_contact/scene/time_function.h>
#include <rolling_contact/surfaces/profile_file.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <cmath>
#include <memory>

using namespace RollingContact;

/** Inputs that once ended in a crash, an endless read or a wrong scene. */
BOOST_AUTO_TEST_SUITE(bad_input)

BOOST_AUTO_TEST_CASE(files_that_include_files)
{
  const ScratchFolder scratch;
  const std::string   file = (scratch.scratch / "a.prm").string(),
                    part   = (scratch.scratch / "b.prm").string();
  const auto said          = [&](const std::string &text) {
    write(file, text);
    return complaint([&]() { read_prm(file); });
  };
  write(part, "set X = 1\n");
  BOOST_TEST(said("include " + part + "\n") == "");
  BOOST_TEST(contains(said("set X = 1\n\tinclude " + file + " # again\n"),
                      file + ": line 2: more than 100 inclusions"));
  BOOST_TEST(contains(said("incl\\\nude " + file), "more than 100 inclusions"));
  write(part, "include " + file + "\n");
  BOOST_TEST(contains(said("INCLUDE " + part), "more than 100 inclusions"));
  BOOST_TEST(contains(said("include none.prm"),
                      "none.prm: cannot be read: there is no such file"));
  BOOST_TEST(contains(said("include " + scratch.scratch.string()),
                      "cannot be read: it is a folder"));
}

BOOST_AUTO_TEST_CASE(files_that_are_no_scenes)
{
  const ScratchFolder scratch;
  const std::string   file = (scratch.scratch / "a.prm").string();
  const auto          said = [&](const std::string &text) {
    write(file, text);
    return complaint([&]() { read_prm(file); });
  };
  BOOST_TEST(contains(said(""), "is empty"));
  BOOST_TEST(contains(said("# c\nset X = {1 2}\n"), ": line 2: '{'"));
  BOOST_TEST(said("set X = 1 # {1 2}\n") == "");
  BOOST_TEST(contains(said(std::string((1 << 24) + 1, '\n')), "16 MiB"));
  write(file, "\xEF\xBB\xBFset X = 1\r\n");
  BOOST_TEST(read_prm(file).text == "set X = 1\r\n");
}

BOOST_AUTO_TEST_CASE(lines_of_a_scene)
{
  const ScratchFolder scratch;
  const std::string   file = (scratch.scratch / "a.prm").string(),
                    part   = (scratch.scratch / "b.prm").string();
  const auto said          = [&](const std::string &text) {
    write(file, text);
    return complaint([&]() { read_prm(file); });
  };
  BOOST_TEST(contains(said("set X = 1\n\nset X = 2\n"),
                      ": line 3: X is given here and in line 1"));
  BOOST_TEST(contains(said("subsection A\nset X = 1\nend\n"
                           "subsection A\n  set X = 2 # again\nend\n"),
                      ": line 5: A/X is given here and in line 2"));
  BOOST_TEST(contains(said("set X\n"), "'set X' has no '='"));
  BOOST_TEST(contains(said("end\n"), "line 1: 'end' without a section"));
  BOOST_TEST(contains(said("subsection A\n"), "section A is not ended"));
  BOOST_TEST(contains(said("X = 1\n"), "'X = 1' is no line of a .prm file"));
  BOOST_TEST(contains(said(std::string("set X = 1\n\0", 11)),
                      "line 2 holds the byte \\x00, so it is no text"));
  // an included file may be overridden
  write(part, "set X = 1\n");
  BOOST_TEST(said("subsection A\ninclude " + part + "\nset X = 2\nend\n") ==
             "");
  const PrmText found = read_prm(file);
  BOOST_REQUIRE(found.entries.size() == 2u);
  BOOST_TEST(found.entries[0].path == "A/X");
  BOOST_TEST(found.entries[1].value == "2");
  BOOST_TEST(contains(found.entries[0].place, part + ": line 1"));
}

BOOST_AUTO_TEST_CASE(names_that_are_meant)
{
  BOOST_TEST(edit_distance("Aproach", "approach") == 1u);
  BOOST_TEST(edit_distance("Sipn", "Spin") == 1u);
  BOOST_TEST(edit_distance("", "Spin") == 4u);
  const std::vector<std::string> known{"Analysis",
                                       "Contact/Spin",
                                       "Contact/Normal load",
                                       "Wheel/Radius",
                                       "Rail/Radius",
                                       "Rail/Lateral radius"};
  const auto                     meant = [&](const std::string &path) {
    return did_you_mean(likely_meant(path, known));
  };
  BOOST_TEST(meant("Contact/Sipn") == "did you mean Contact/Spin?");
  BOOST_TEST(meant("Cntact/Spin") == "did you mean Contact/Spin?");
  BOOST_TEST(meant("Contact/Load") == "did you mean Contact/Normal load?");
  BOOST_TEST(meant("analyses") == "did you mean Analysis?");
  BOOST_TEST(meant("Contact/Radius") ==
             "did you mean Wheel/Radius or Rail/Radius?");
  BOOST_TEST(meant("Contact/Temperature") == "");
}

BOOST_AUTO_TEST_CASE(what_entries_take_in_words)
{
  double                    number = 0.;
  unsigned int              whole  = 2;
  std::string               text;
  std::vector<unsigned int> several;
  bool                      flag = true;
  Entries                   entries;
  entries.section("Wheel");
  const auto said = [](const Entry &entry, const std::string &value) {
    return complaint([&]() { entry.check(value, "here: "); });
  };
  BOOST_TEST(said(entries.add("A", number, "Pa").at_least(0.), "-1") ==
             "here: Wheel/A = -1: give a number of at least 0 Pa.");
  BOOST_TEST(said(entries.add("B", number, "1").between(0.5, 1.), "0,5") ==
             "here: Wheel/B = 0,5: give a number from 0.5 to 1; decimals take "
             "a point.");
  BOOST_TEST(entries.add("C", number, "m").allowed() == "a number in m");
  BOOST_TEST(said(entries.add("D", whole, "1").between(2, 3), "2.5") ==
             "here: Wheel/D = 2.5: give a whole number from 2 to 3.");
  BOOST_TEST(said(entries.add("E", text).one_of("a|b c|d"), "b") ==
             "here: Wheel/E = b: give `a`, `b c` or `d`.");
  BOOST_TEST(entries.add("F", text).one_of("a|b c").allowed() ==
             "`a` or `b c`");
  const Entry &list = entries.add("G", several, "1").at_least(1).several();
  BOOST_TEST(said(list, "1, 0") ==
             "here: Wheel/G = 1, 0: give a list separated by commas, each a "
             "whole number of at least 1.");
  BOOST_TEST(said(list, "") != "");
  BOOST_TEST(said(list, "1, 2") == "");
  BOOST_TEST(entries.add("H", flag).allowed() == "`true` or `false`");
  BOOST_TEST(entries.add("I", text).allowed() == "");
  BOOST_TEST(&entries.find("Wheel/G") == &list);
}

/** Numbers say their unit, and an entry says when it has no effect. */
BOOST_AUTO_TEST_CASE(every_entry_is_described)
{
  SceneParameters scene;
  const auto     &kinds       = analysis_kinds();
  const Entries   entries     = scene.declare({kinds.begin(), kinds.end()});
  unsigned int    n_with_unit = 0;
  for (const Entry &entry : entries.rows())
    {
      if (entry.path() == "Analysis")
        continue; // the program knows which there are
      const bool is_number = entry.takes_numbers() ||
                             entry.kind == Entry::Kind::number ||
                             entry.kind == Entry::Kind::integer;
      BOOST_TEST((!is_number || !entry.unit.empty()), entry.path());
      BOOST_TEST((entry.help.size() > 10 && entry.help.back() != ' '),
                 entry.path());
      BOOST_TEST((entry.help.find("Units:") == std::string::npos),
                 entry.path());
      BOOST_TEST(entry.is_default(entry.default_text), entry.path());
      if (!entry.default_text.empty())
        BOOST_TEST(complaint([&]() { entry.check(entry.default_text, ""); }) ==
                     "",
                   entry.path());
      const std::string idle = entry.why_idle(scene);
      BOOST_TEST((idle.empty() || idle.back() != '.'), entry.path());
      n_with_unit += is_number;
    }
  BOOST_TEST(n_with_unit > 150u);
}

namespace
{
  /** A section as a new analysis brings it. */
  struct PloughingParameters
  {
    void declare(Entries &entries)
    {
      entries.section("Ploughing").read_by_analyses("ploughing");
      entries.add("Rate", rate, "m^2/N").at_least(0.).help =
        "Depth that is worn over the work of friction on an area.";
    }

    void check() const
    {
      if (rate == 0.)
        throw InputError("Ploughing/Rate = 0: nothing ploughs.");
    }

    double rate = 1.;
  };

  AnalysisTraits ploughing()
  {
    AnalysisTraits traits;
    traits.name     = "ploughing";
    traits.help     = "how surfaces are ploughed";
    traits.sections = {"Ploughing"};
    traits.own_section.emplace(PloughingParameters());
    traits.rules = {[](const SceneParameters &scene) {
      if (scene.wheel.rigid)
        throw InputError("Wheel/Rigid = true: nothing ploughs.");
    }};
    return traits;
  }
} // namespace

/** The section that an analysis brings is declared, read, copied, checked, and
 * said to have no effect in scenes of others. */
BOOST_AUTO_TEST_CASE(an_analysis_brings_its_section)
{
  SceneParameters scene;
  scene.contact.normal_load = 1e4;
  const Entries entries     = scene.declare({AnalysisTraits(), ploughing()});
  entries.find("Ploughing/Rate").read("2");
  BOOST_TEST(scene.own<PloughingParameters>().rate == 2.);
  const auto unused = unused_entries(scene, {{"Ploughing/Rate", "2"}});
  BOOST_REQUIRE(unused.size() == 1u);
  BOOST_TEST(unused[0] ==
             "Ploughing/Rate = 2 has no effect: Analysis = ploughing reads "
             "that section, not quasi-static.");
  entries.find("Analysis").read("ploughing");
  BOOST_TEST(unused_entries(scene, {{"Ploughing/Rate", "2"}}).empty());
  SceneEntries copy{Situation(scene)};
  copy.set("Ploughing/Rate", "0");
  BOOST_TEST(copy.unit("Ploughing/Rate") == "m^2/N");
  BOOST_TEST(scene.own<PloughingParameters>().rate == 2.);
  BOOST_TEST(complaint([&]() { scene.check(); }) == "");
  scene.wheel.rigid = true;
  BOOST_TEST(complaint([&]() { scene.check(); }) ==
             "Wheel/Rigid = true: nothing ploughs.");
  entries.find("Analysis").read("quasi-static");
  BOOST_TEST(complaint([&]() { scene.check(); }) == "");
  scene.own<PloughingParameters>().rate = 0.; // refused wherever it stands
  BOOST_TEST(complaint([&]() { scene.check(); }) ==
             "Ploughing/Rate = 0: nothing ploughs.");
}

/** A value that is none leaves the scene as it was, at the price of a text. */
BOOST_AUTO_TEST_CASE(entries_that_are_set_to_nothing)
{
  SceneParameters scene;
  scene.contact.normal_load = 1e4;
  scene.wheel.radius        = 0.46;
  const Situation first(scene);
  SceneEntries    entries(first);
  const auto refused = [&](const std::string &entry, const std::string &value) {
    return complaint([&]() { entries.set(entry, value); }) != "";
  };
  BOOST_TEST(refused("Contact/Normal load", "much"));
  BOOST_TEST(refused("Mesh/Patch offset", "2"));
  BOOST_TEST(refused("Profiles/Roll", "level"));
  BOOST_TEST(refused("Wheel/Modal damping", "1e-3, x"));
  BOOST_TEST(refused("Wheel/Mode damping", "392"));
  BOOST_TEST(refused("Contact/Load", "1"));
  BOOST_TEST(entries.bodies_key() == SceneEntries(first).bodies_key());
  BOOST_TEST(entries.situation().contact.normal_load.value() == 1e4);
}

/** Bodies are the same whatever way their numbers are written. */
BOOST_AUTO_TEST_CASE(keys_of_bodies_compare_numbers)
{
  SceneParameters scene;
  scene.contact.normal_load = 1e4;
  const auto set = [&](const std::string &entry, const std::string &value) {
    auto entries = std::make_unique<SceneEntries>(Situation(scene));
    entries->set(entry, value);
    return entries;
  };
  const auto key = [&](const std::string &entry, const std::string &value) {
    return set(entry, value)->bodies_key();
  };
  BOOST_TEST(key("Wheel/Radius", "0.460") == key("Wheel/Radius", "4.6e-1"));
  BOOST_TEST(key("Wheel/Radius", "0.46").find("Wheel/Radius = 0.46") !=
             std::string::npos);
  BOOST_TEST(key("Wheel/Radius", "0.46") != key("Wheel/Radius", "0.461"));
  BOOST_TEST(key("Contact/Normal load", "1") == key("Contact/Spin", "0"));
  BOOST_TEST(key("Contact/Slip operator", "upwind 2") !=
             key("Contact/Spin", "0"));
  // where profiles touch is another place of the same bodies
  BOOST_TEST(key("Profiles/Yaw", "0.01") == key("Profiles/Yaw", "0.02"));
  BOOST_TEST(set("Profiles/Yaw", "0.01")->place_key() !=
             set("Profiles/Yaw", "0.02")->place_key());
  scene.analysis.linearises = true;
  BOOST_TEST(key("Profiles/Yaw", "0.01") != key("Profiles/Yaw", "0.02"));
}

/** What a run that is resumed may have changed follows from its analysis. */
BOOST_AUTO_TEST_CASE(entries_that_are_free_on_resume)
{
  SceneParameters scene;
  const auto      is_free = [&](const std::string &entry) {
    return entries_free_on_resume(scene).count(entry) > 0;
  };
  scene.analysis.records_run = scene.analysis.marches = true;
  for (const char *entry : {"Output/Plot",
                            "Spectrum/Write",
                            "Sound/Distance",
                            "Body solver",
                            "Time/End time",
                            "Time/Stop when periodic",
                            "Time/Checkpoint seconds"})
    BOOST_TEST(is_free(entry), entry);
  for (const char *entry : {"Sound/Estimate",
                            "Time/Time step",
                            "Time/Field interval",
                            "Contact/Spin",
                            "Dimension"})
    BOOST_TEST(!is_free(entry), entry);
  scene.analysis.records_run    = false;
  scene.analysis.until_periodic = true;
  BOOST_TEST(is_free("Output/Plot"));
  BOOST_TEST(is_free("Body threads"));
  BOOST_TEST(!is_free("Time/End time"));
  BOOST_TEST(!is_free("Body solver"));
  scene.analysis                 = AnalysisTraits();
  scene.analysis.has_many_states = true;
  BOOST_TEST(is_free("Table/Threads"));
  BOOST_TEST(!is_free("Table/Axis 1"));
}

BOOST_AUTO_TEST_CASE(traps_in_expressions)
{
  for (const char *text : {"2e-6*cos(2*pi*x/1e-3)",
                           "if(x >= 1, min(0, 5), x == 2)",
                           "x <= 1 && x != 2"})
    BOOST_TEST(trap_in_expression(text) == "", text);
  BOOST_TEST(contains(trap_in_expression("0,5e-6*cos(x)"), "take a point"));
  BOOST_TEST(contains(trap_in_expression("x; y"), "one expression"));
  BOOST_TEST(contains(trap_in_expression("x = 5"), "assign"));
  BOOST_TEST(contains(trap_in_expression("rand()"), "cannot be repeated"));
  BOOST_TEST(contains(unknown_name_in_expression("1e-3*cos(t)", {"x", "y"}),
                      "'t' is not known here; there are x, y, pi"));
  BOOST_TEST(unknown_name_in_expression("1e3*x+pi*_e", {"x"}) == "");
}

BOOST_AUTO_TEST_CASE(texts_of_unknown_origin)
{
  BOOST_TEST(quotable("a\x01\xFFz\xC3\xA9\xC2\x85") ==
             "a\\x01\\xFFz\xC3\xA9\\xC2\\x85");
  BOOST_TEST(quotable(std::string(70, 'a')) == std::string(60, 'a') + "...");
}

BOOST_AUTO_TEST_CASE(values_that_a_file_cannot_hold)
{
  BOOST_TEST(problem_of_value("table: a b.csv 2") == "");
  for (const std::string value : {"1 # 2", "{1", "1\nset X = 2", "a\\"})
    BOOST_TEST(problem_of_value(value) != "");
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none)
{
  const ScratchFolder scratch;
  const std::string   file = (scratch.scratch / "a.prm").string();
  const auto          said = [&](const std::string &setting) {
    write(file, "subsection Contact\n  set Approach = 1e-4\nend\n");
    const char *words[] = {"rolling-contact",
                           file.c_str(),
                           "--set",
                           setting.c_str()};
    return complaint([&]() { read_scene(CommandLine(4, words)); });
  };
  BOOST_TEST(said("Mesh/Patch offset = aligned") == "");
  BOOST_TEST(contains(said("Mesh/Patch offset = near"),
                      "Mesh/Patch offset = near: give a number"));
  BOOST_TEST(contains(said("Mesh/Patch offset = 1.01"), "from -1 to 1"));
  for (const std::string approach : {"nan", "1 mm", "1e999"})
    BOOST_TEST(contains(said("Contact/Approach = " + approach),
                        "Contact/Approach = " + approach +
                          ": give a number in m, or leave it empty."));
  BOOST_TEST(contains(said("Contact/Speed = fast"), "a number in m/s"));
  BOOST_TEST(contains(said("Contact/Normal load = 4e4"),
                      "Contact/Normal load = 40000 and Contact/Approach"));
  BOOST_TEST(contains(said("Load curve/Shares of load = 0.1, 1.5"),
                      "Load curve/Shares of load contains 1.5"));
}

BOOST_AUTO_TEST_CASE(tables_with_short_rows_and_odd_blanks)
{
  const ScratchFolder scratch;
  const auto          said = [&](const std::string &text) {
    write(scratch.scratch / "a.csv", text);
    return complaint(
      [&]() { TimeFunction("Time/Spin", "table: a.csv d", scratch.scratch); });
  };
  BOOST_TEST(said("t,b,c,d\n0,1,2,3\n1,2,3,4\n") == "");
  BOOST_TEST(
    contains(said("t,b,c,d\n0,1,2,3\n1,2\n"), "line 3: there is no column d"));
  BOOST_TEST(said("t,b,c,d\n0,1,2,3\n\v\n\f \n1,2,3,4\n") == "");
}

BOOST_AUTO_TEST_CASE(records_of_runs)
{
  const ScratchFolder scratch;
  const auto          ours = [&](const std::string &text) {
    write(scratch.scratch / record_name, text);
    return read_previous_run(scratch.scratch).made_by_this_program;
  };
  const std::string begin = "{\"program\": \"" + program_name + "\"";
  BOOST_TEST(ours(begin + "}"));
  BOOST_TEST(ours(begin + ", \"words\": [\"[[[[[[[[[[[[[[\\\"[[[[\"]}"));
  BOOST_TEST(!ours(begin + ", \"x\": " + std::string(1000000, '[')));

  const PrmEntries entries =
    prm_entries("subsection\n  set A = 1\nend\nset B = 2\n"
                "subsection a/b\n  set C = 3\nend\nset D = 4\nend\n");
  const PrmEntries expected{{"/A", "1"},
                            {"B", "2"},
                            {"a/b/C", "3"},
                            {"D", "4"}};
  BOOST_TEST((entries == expected));
}

BOOST_AUTO_TEST_CASE(texts_that_are_numbers)
{
  BOOST_TEST(number_of("1e-3").value() == 1e-3);
  BOOST_TEST(number_of(" -.5").value() == -0.5);
  BOOST_TEST(number_of("1e-310").value() == 1e-310);
  BOOST_TEST(std::isinf(number_of("1e999").value()));
  const std::string zero(1, '\0');
  for (const std::string &text : {std::string(),
                                  std::string(" "),
                                  zero,
                                  zero + "1",
                                  "1" + zero,
                                  "1 " + zero,
                                  std::string("1,5"),
                                  std::string("1x"),
                                  std::string("x")})
    BOOST_TEST(!number_of(text), quotable(text));
}

/** As a file system leaves the end of a file that was not written in time. */
BOOST_AUTO_TEST_CASE(bytes_of_zero_are_no_numbers)
{
  const ScratchFolder scratch;
  const std::string   zeros(8, '\0');
  const auto          said = [&](const std::string                      &text,
                        const std::function<void(std::string)> &reader) {
    write(scratch.scratch / "a.csv", text);
    return complaint([&]() { reader((scratch.scratch / "a.csv").string()); });
  };
  BOOST_TEST(contains(said("A,B\n1,2\n1," + zeros + "\n",
                           [](const std::string &file) {
                             read_rows("Table/File of rows", file);
                           }),
                      "line 3: '\\x00"));
  BOOST_TEST(contains(said("0,1\n1," + zeros + "\n",
                           [](const std::string &file) {
                             TimeFunction("Time/Spin", file, "");
                           }),
                      "line 2: not a number"));
  std::string record, profile;
  for (unsigned int k = 0; k < 12; ++k)
    {
      record += std::to_string(k) + ",0\n";
      profile += std::to_string(k) + " 0\n";
    }
  BOOST_TEST(contains(
    said(record + "12," + zeros + "\n",
         [](const std::string &file) {
           read_surface_record("Surfaces/Rail height", file, "", {1., 1.});
         }),
    "line 13"));
  BOOST_TEST(contains(said(profile + "12 " + zeros + "\n",
                           [](const std::string &file) {
                             Profiles::read_points(file, {});
                           }),
                      "line 13"));
}

BOOST_AUTO_TEST_CASE(axes_of_the_least_numbers)
{
  TableParameters table;
  table.axis_texts[0] = "Contact/Creepage x = 1e-310, 2e-310";
  BOOST_TEST(table.axes().at(0).values.at(1) == 2e-310);
}

BOOST_AUTO_TEST_CASE(states_of_sweeps_that_are_none)
{
  const ScratchFolder scratch;
  const auto          said = [&](const std::string &text) {
    write(scratch.scratch / "limit_cycle_state.txt", text);
    return complaint(
      [&]() { read_sweep_state(RunFolder(scratch.scratch, "", "")); });
  };
  const std::string head = "2 1\n1 566.25\n2 0.5 0.25\n";
  BOOST_TEST(said(head + "2 1 2\n2 1 2\n1 3\n1 4\n") == "");
  for (const std::string &text : {head + "2 1 2\n3 1 2 3\n1 3\n1 4\n",
                                  head + "2 1 2\n2 1 2\n1 3\n2 4 4\n",
                                  head + "2 1 nan\n2 1 2\n1 3\n1 4\n",
                                  head + "2 1 x\n2 1 2\n1 3\n1 4\n",
                                  head + "2 1 2\n2 1 2\n1 3\n",
                                  std::string("x"),
                                  std::string()})
    BOOST_TEST(contains(said(text), "is missing or damaged"), text);
}

/** deal.II looks without end for an order of such cells. */
BOOST_AUTO_TEST_CASE(three_cells_at_an_edge)
{
  const ScratchFolder scratch;
  const auto said = [&](const std::string &name, const std::string &text) {
    MeshFile file;
    file.section = "Rail";
    file.name    = name;
    file.path    = scratch.scratch / name;
    write(file.path, text);
    return complaint([&]() { read_mesh_file<2>(file); });
  };
  const std::string what = "the edge between its nodes 2 and 5 belongs to "
                           "three quadrilaterals or more",
                    gmsh =
                      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n"
                      "1 -1 0 0\n2 0 0 0\n3 1 0 0\n4 -1 -1 0\n5 0 -1 0\n"
                      "6 1 -1 0\n7 .5 0 0\n8 .5 -1 0\n$EndNodes\n$Elements\n3\n"
                      "1 3 2 3 1 1 4 5 2\n2 3 2 3 1 2 5 6 3\n"
                      "3 3 2 3 1 2 5 8 7\n$EndElements\n",
                    abaqus = "*NODE\n1, -1, 0\n2, 0, 0\n3, 1, 0\n4, -1, -1\n"
                             "5, 0, -1\n6, 1, -1\n7, .5, 0\n8, .5, -1\n"
                             "*ELEMENT, TYPE=CPE4\n1, 1, 4, 5, 2\n"
                             "2, 2, 5, 6, 3\n3, 2, 5, 8, 7\n";
  BOOST_TEST(
    contains(said("rail.msh", gmsh), "Rail/Mesh file = rail.msh: " + what));
  BOOST_TEST(
    contains(said("rail.inp", abaqus), "Rail/Mesh file = rail.inp: " + what));
}

BOOST_AUTO_TEST_SUITE_END()
