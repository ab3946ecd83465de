#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <rolling_contact/base/files.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/history_table.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/written_names.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <regex>
#include <sstream>

BOOST_AUTO_TEST_SUITE(run_folders)

using namespace RollingContact;
namespace fs = std::filesystem;

namespace
{
  void open_folder(const fs::path &folder)
  {
    RunFolder run(folder, "", "");
    run.open();
  }

  std::string said_of(const fs::path &folder)
  {
    return complaint([&]() { open_folder(folder); });
  }

  void make_socket(const fs::path &file)
  {
    const int   descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    file.string().copy(address.sun_path, sizeof(address.sun_path) - 1);
    BOOST_REQUIRE(bind(descriptor,
                       reinterpret_cast<sockaddr *>(&address),
                       sizeof(address)) == 0);
    close(descriptor);
  }

  /** What may stand where a run writes, and what the message calls it. */
  std::map<std::string, std::function<void(const fs::path &)>>
  obstacles(const fs::path &victim)
  {
    return {{"a symbolic link",
             [=](const fs::path &file) { fs::create_symlink(victim, file); }},
            {"a folder", [](const auto &file) { fs::create_directory(file); }},
            {"a pipe, a socket or a device",
             [](const auto &file) {
               BOOST_REQUIRE(mkfifo(file.c_str(), 0666) == 0);
             }},
            {"no regular file", &make_socket}};
  }
} // namespace

BOOST_AUTO_TEST_CASE(names_that_a_run_writes)
{
  for (const std::string name : {"results.csv",
                                 "results_rank_12.csv",
                                 "history.bin",
                                 "tractions.gp",
                                 "table_12.svg",
                                 "across_leading_left_3.csv",
                                 "wheel_003_right.txt",
                                 "wheel_right_003.vtu",
                                 "rail.prr",
                                 "wheel-0000200-1.vtu",
                                 "wheel-0.vtu",
                                 "rail.pvtu",
                                 "cycle-07.vtu",
                                 "wheel_mode_001_23.vtu",
                                 "vibration_2_wheel_00.vtu",
                                 "vibration_2.pvd",
                                 "worn_wheel_left.dat"})
    {
      BOOST_TEST(is_written_name(name), name);
      BOOST_TEST(written_name_of('.' + name + ".part") == name);
      BOOST_TEST(written_name_of(name + ".part") == name);
    }
  for (const std::string name : {"",
                                 ".part",
                                 "run.json",
                                 "thesis.csv",
                                 "results.csv ",
                                 "results.csv\n",
                                 "../results.csv",
                                 "/results.csv",
                                 "Results.csv",
                                 "results.csv.bak",
                                 "my_results.csv",
                                 "wheel.stl",
                                 "wheel_of_fortune.txt",
                                 "notes.txt"})
    BOOST_TEST(!is_written_name(name), name);
  BOOST_TEST(!is_written_name(std::string(100000, 'a')));
  BOOST_TEST(written_name_of(".run.json.part") == "run.json");
  BOOST_TEST(written_name_of("thesis.csv.part").empty());
  BOOST_TEST(vouch_for({"tractions.gp"}, "tractions.svg"));
  BOOST_TEST(!vouch_for({"tractions.gp"}, "tractions.dat"));
  BOOST_TEST(!vouch_for({}, "svg"));
}

BOOST_FIXTURE_TEST_CASE(names_of_the_files_of_ranks, ScratchFolder)
{
  const std::string name = "results.csv";
  BOOST_TEST(rank_file_name(name, 12) == "results_rank_12.csv");
  BOOST_TEST(rank_of_file(name, "results_rank_12.csv").value() == 12u);
  for (const std::string other : {"results.csv",
                                  "results_rank_.csv",
                                  "results_rank_012.csv",
                                  "results_rank_-1.csv",
                                  "results_rank_1e3.csv",
                                  "results_rank_1.csv.part",
                                  "results_rank_99999999999.csv",
                                  "my_results_rank_1.csv",
                                  "history_rank_1.csv"})
    BOOST_TEST(!rank_of_file(name, other), other);
  BOOST_TEST(!has_checkpoint(folder, name));
  open_folder(folder);
  BOOST_TEST(!has_checkpoint(folder, name));
  for (const std::string file :
       {"results_rank_10.csv", "results_rank_2.csv", "results_rank_x.csv"})
    write(folder / file, "");
  fs::create_directory(folder / "results_rank_3.csv");
  BOOST_TEST(
    (files_of_ranks(folder, name) ==
     std::vector<std::string>{"results_rank_2.csv", "results_rank_10.csv"}));
  BOOST_TEST(has_checkpoint(folder, name));
}

BOOST_FIXTURE_TEST_CASE(what_is_no_regular_file_is_refused, ScratchFolder)
{
  const fs::path victim = scratch / "victim";
  write(victim, "mine");
  for (const auto &[kind, make] : obstacles(victim))
    for (const std::string name : {"run.json",
                                   ".run.json.part",
                                   "results.csv",
                                   ".results.csv.part",
                                   "history.csv.part",
                                   "wheel_mode_001_23.vtu"})
      {
        fs::remove_all(folder);
        open_folder(folder);
        fs::remove(folder / name);
        make(folder / name);
        const std::string said = said_of(folder);
        BOOST_TEST(contains(said, name + " in it is "), said);
        BOOST_TEST(contains(said, kind), said);
        BOOST_TEST(fs::exists(fs::symlink_status(folder / name)));
        BOOST_TEST(read(victim) == "mine");
      }
}

BOOST_FIXTURE_TEST_CASE(what_comes_while_a_run_goes_on_stays, ScratchFolder)
{
  const fs::path victim = scratch / "victim";
  write(victim, "mine");
  RunFolder run(folder, "", "");
  run.open();
  write(folder / "modes.csv", "mine");
  BOOST_TEST(
    contains(complaint([&]() { run.write_atomically("modes.csv", ""); }),
             "modes.csv\": a file of that name, not of this run"));
  BOOST_TEST(read(folder / "modes.csv") == "mine");

  run.write_atomically("results.csv", "first");
  for (const std::string name : {"results.csv", ".results.csv.part"})
    {
      fs::remove(folder / name);
      fs::create_symlink(victim, folder / name);
      BOOST_TEST(
        contains(complaint([&]() { run.write_atomically("results.csv", "x"); }),
                 name + "\": it is a symbolic link"));
      BOOST_TEST(read(victim) == "mine");
      fs::remove(folder / name);
    }
  run.write_atomically("results.csv", "second");
  BOOST_TEST(read(folder / "results.csv") == "second");
  fs::remove(folder / "modes.csv");
}

BOOST_FIXTURE_TEST_CASE(files_that_no_run_vouches_for, ScratchFolder)
{
  for (const std::string name : {"history.csv",
                                 "interface.pvd",
                                 ".history.csv.part",
                                 "history.csv.part"})
    {
      open_folder(folder);
      write(folder / name, "mine");
      const std::string said = said_of(folder);
      BOOST_TEST(contains(said, "did not write " + name + " in it"), said);
      BOOST_TEST(contains(said, "--output"), said);
      BOOST_TEST(read(folder / name) == "mine");
      fs::remove(folder / name);
    }
  // a picture that was drawn by hand from the script of a run
  {
    RunFolder run(folder, "", "");
    run.open();
    run.write_atomically("tractions.gp", "plot");
  }
  write(folder / "tractions.svg", "drawn");
  BOOST_TEST(said_of(folder) == "");
  BOOST_TEST(!fs::exists(folder / "tractions.svg"));
}

BOOST_FIXTURE_TEST_CASE(another_name_of_a_file_stays_whole, ScratchFolder)
{
  const fs::path              kept    = scratch / "kept";
  const std::string           history = "history.csv";
  const fs::path              part    = folder / (history + ".part");
  const RunFolder::Resumption resumption{{}, "checkpoint.bin", {history}};
  {
    RunFolder run(folder, "", "");
    run.open();
    run.write_atomically("checkpoint.bin", "there");
    write(run.growing(history), "a row\nhalf a r");
    fs::create_hard_link(part, kept);
    fs::copy_file(part, scratch / "copy");
    run.write_atomically("results.csv", "");
    fs::copy(folder, scratch / "killed");
  }
  fs::remove_all(folder);
  fs::rename(scratch / "killed", folder);
  fs::remove(part);
  fs::create_hard_link(kept, part);
  {
    RunFolder run(folder, "", "");
    run.reopen(resumption);
    BOOST_TEST(read(run.continued(history, 6)) == "a row\n");
    BOOST_TEST(read(kept) == "a row\nhalf a r");
  }

  // run.json is written over in place on a full disk, but not if it has two
  // names
  write(folder / "x", "0123456789");
  fs::create_hard_link(folder / "x", folder / "y");
  BOOST_TEST(!overwrite_file(folder / "x", "new"));
  fs::remove(folder / "y");
  BOOST_TEST(overwrite_file(folder / "x", "new"));
  fs::create_symlink(folder / "x", folder / "y");
  BOOST_TEST(!overwrite_file(folder / "y", "other"));
  BOOST_TEST(read(folder / "x") == "new");
}

BOOST_FIXTURE_TEST_CASE(a_pipe_is_read_without_waiting, ScratchFolder)
{
  BOOST_REQUIRE(mkfifo((scratch / "pipe").c_str(), 0666) == 0);
  BOOST_TEST(read_bytes(scratch / "pipe").empty());
  BOOST_TEST(contains(why_unreadable(scratch / "pipe"), "pipe"));
  fs::create_symlink(scratch / "pipe", scratch / "link");
  BOOST_TEST(read_bytes(scratch / "link").empty());
}

BOOST_FIXTURE_TEST_CASE(limits_of_control_groups, ScratchFolder)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  const auto            left = [&](const std::string &list) {
    write(scratch / "list", list);
    return memory_left_of_groups((scratch / "list").string(),
                                 (scratch / "groups").string());
  };
  const auto group = [&](const std::string &name, const std::string &text) {
    write(scratch / "groups" / name, text);
  };
  BOOST_TEST(left("") == none);
  BOOST_TEST(left("0::/job\n") == none);

  group("job/memory.max", "1000\n");
  group("job/memory.current", "300\n");
  group("job/memory.stat", "anon 100\ninactive_file 50\n");
  BOOST_TEST(left("0::/job\n") == 750u);
  BOOST_TEST(left("0::/job/step\n") == 750u);
  BOOST_TEST(left("0::/other\n") == none);

  group("memory/job/memory.limit_in_bytes", "2000\n");
  group("memory/job/memory.usage_in_bytes", "1500\n");
  group("memory/job/memory.stat", "inactive_file 7\ntotal_inactive_file 100\n");
  const std::string first = "5:cpu,cpuacct:/job\n4:name=systemd:/job\n";
  BOOST_TEST(left(first) == none);
  BOOST_TEST(left(first + "3:memory:/job\n") == 600u);
  BOOST_TEST(left(first + "3:hugetlb,memory:/job/step\n") == 600u);
  BOOST_TEST(left("3:memory:/job\n0::/job\n") == 600u);
  // a group that is full, and the unlimited number of version 1
  group("memory/job/memory.usage_in_bytes", "2500\n");
  BOOST_TEST(left("3:memory:/job\n") == 0u);
  group("memory/job/memory.limit_in_bytes", "9223372036854771712\n");
  BOOST_TEST(left("3:memory:/job\n") > 1000000000000u);
  // seen from within a container, the group of the list is not there
  group("memory/memory.limit_in_bytes", "4000\n");
  group("memory/memory.usage_in_bytes", "1000\n");
  BOOST_TEST(left("3:memory:/docker/4711\n") == 3000u);
}

BOOST_AUTO_TEST_CASE(names_that_the_documentation_has)
{
  const std::string text  = read(TEST_DATA "/../../doc/reference/output.md");
  const std::size_t begin = text.find("## Files"),
                    end   = text.find("Beside each plot", begin);
  BOOST_TEST_REQUIRE(end != std::string::npos);
  std::istringstream rows(text.substr(begin, end - begin));
  const std::regex   name("`([^`. ]+\\.[a-z0-9]+)`");
  std::size_t        n = 0;
  for (std::string row; std::getline(rows, row);)
    {
      const std::string files = row.substr(0, row.find('|', 1));
      for (std::sregex_iterator file(files.begin(), files.end(), name);
           file != std::sregex_iterator();
           ++file, ++n)
        BOOST_TEST((is_written_name((*file)[1]) || (*file)[1] == "run.json"),
                   "doc/reference/output.md has " << (*file)[1]);
    }
  BOOST_TEST(n > 90);
}

BOOST_AUTO_TEST_CASE(texts_that_a_spreadsheet_would_evaluate)
{
  const std::map<std::string, std::string> cells{{"=1+1", "'=1+1"},
                                                 {"+wheel", "'+wheel"},
                                                 {"-wheel", "'-wheel"},
                                                 {"@SUM(A1)", "'@SUM(A1)"},
                                                 {"\t=1", "'\t=1"},
                                                 {"'=1", "''=1"},
                                                 {"''=1", "'''=1"},
                                                 {"-1.5e-3", "-1.5e-3"},
                                                 {"wheel", "wheel"},
                                                 {"'wheel", "'wheel"},
                                                 {"'", "'"},
                                                 {"", ""}};
  for (const auto &[text, cell] : cells)
    {
      BOOST_TEST(no_formula(text) == cell);
      BOOST_TEST(without_apostrophe(cell) == text);
    }

  ResultsTable table;
  table.set("name", "=HYPERLINK(\"x\",\"y\")");
  table.set("load_N", -1.);
  table.set("force_N", std::nan(""));
  table.set("pull_N", -std::nan(""));
  table.end_row();
  const std::string csv = table.csv();
  BOOST_TEST(csv == "name,load_N,force_N,pull_N\n"
                    "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\",-1,,\n");
  ResultsTable again;
  again.restore(csv, "results.csv");
  BOOST_TEST(again.text(0, "name") == "=HYPERLINK(\"x\",\"y\")");
  BOOST_TEST(again.number(0, "load_N").value() == -1.);
  BOOST_TEST(!again.number(0, "force_N"));
  BOOST_TEST(!contains(table.screen_table({"name", "force_N"}), "nan"));
}

BOOST_FIXTURE_TEST_CASE(a_number_that_is_none_in_a_history, ScratchFolder)
{
  RunFolder run(folder, "", "");
  run.open();
  HistoryTable history(run, "history.csv", {"a", "b", "c"});
  history.add_row({std::nan(""), 1., -std::nan("")});
  history.publish();
  BOOST_TEST(read(folder / "history.csv") == "a,b,c\n,1,\n");
  BOOST_TEST(std::isnan(history.columns({"a"}).at("a").at(0)));
}

BOOST_AUTO_TEST_SUITE_END()
