#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"

#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/scene/time_function.h>

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

BOOST_AUTO_TEST_SUITE_END()
