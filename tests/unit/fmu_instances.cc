#include <boost/test/unit_test.hpp>

#include "fmu_table.h"

#include <rolling_contact/fmu/bytes.h>
#include <rolling_contact/fmu/description.h>
#include <rolling_contact/fmu/face.h>
#include <rolling_contact/fmu/program_forces.h>
#include <rolling_contact/fmu/resources.h>
#include <rolling_contact/fmu/state_messages.h>
#include <rolling_contact/fmu/stored_zip.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

/** Instances of an FMU, and what it is packed of. */
BOOST_AUTO_TEST_SUITE(fmu_instances)

using namespace FmuTable;

namespace
{
  /** The resources of an FMU in a folder that is removed. */
  struct Resources
  {
    Resources()
      : folder(std::filesystem::temp_directory_path() /
               ("rolling contact " + std::to_string(std::random_device()())))
    {
      std::filesystem::create_directories(folder);
      std::ofstream(folder / table_file, std::ios::binary)
        << model_of(table_of(smooth)).bytes();
      std::ofstream(folder / token_file) << "{token}";
    }

    ~Resources()
    {
      std::filesystem::remove_all(folder);
    }

    std::unique_ptr<Instance> make(const std::string &token = "{token}")
    {
      return Instance::make("one",
                            token,
                            folder.string(),
                            [this](const Status,
                                   const char *,
                                   const auto &text) {
                              messages.push_back(text);
                            });
    }

    std::filesystem::path    folder;
    std::vector<std::string> messages;
  };
} // namespace

BOOST_AUTO_TEST_CASE(instances_need_their_resources)
{
  Resources resources;
  BOOST_TEST(bool(resources.make()));
  BOOST_TEST(resources.messages.empty());
  BOOST_TEST(!resources.make("{another}"));
  BOOST_TEST(resources.messages.back().find("{another}") != std::string::npos);
  std::ofstream(resources.folder / table_file) << "none";
  BOOST_TEST(!resources.make());
  std::filesystem::remove(resources.folder / table_file);
  BOOST_TEST(!resources.make());
  BOOST_TEST(resources.messages.size() == 3);
}

BOOST_AUTO_TEST_CASE(states_are_kept_to_the_bit)
{
  Resources          resources;
  const auto         own          = resources.make();
  const unsigned int references[] = {1, 2};
  const double       before[] = {1. / 3e3, 1e-4 / 7}, later[] = {2e-3, 0.};
  BOOST_TEST((own->set_up("", 0.1, true, 9.) == Status::ok));
  BOOST_TEST((own->enter_initialisation("", true) == Status::ok));
  BOOST_TEST((own->exit_initialisation("") == Status::ok));
  BOOST_TEST((own->set("", references, 2, before) == Status::ok));
  BOOST_TEST((own->step("", 0.1, 1. / 3) == Status::ok));
  void *handle = nullptr;
  BOOST_TEST((own->keep("", &handle) == Status::ok));
  const auto        numbers = own->now().numbers();
  std::vector<char> bytes(1000);
  std::size_t       size = 0;
  BOOST_TEST((own->size_of_state("", handle, &size) == Status::ok));
  BOOST_TEST((own->serialise("", handle, bytes.data(), size) == Status::ok));
  BOOST_TEST(
    (own->serialise("", handle, bytes.data(), size - 1) == Status::error));
  BOOST_TEST((own->set("", references, 2, later) == Status::ok));
  BOOST_TEST((own->step("", own->now().time, 0.1) == Status::ok));
  BOOST_TEST((own->now().numbers() != numbers));
  BOOST_TEST((own->restore("", handle) == Status::ok));
  BOOST_TEST((own->now().numbers() == numbers));
  const auto other  = resources.make();
  void      *theirs = nullptr;
  BOOST_TEST(
    (other->deserialise("", bytes.data(), size, &theirs) == Status::ok));
  BOOST_TEST((other->restore("", theirs) == Status::ok));
  BOOST_TEST((other->now().numbers() == numbers));
  BOOST_TEST((other->restore("", handle) == Status::error));
  // the first input, no longer finite
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(bytes.data() + size - sizeof(numbers), &none, sizeof(none));
  theirs = nullptr;
  BOOST_TEST(
    (other->deserialise("", bytes.data(), size, &theirs) == Status::error));
  BOOST_TEST((own->forget("", &handle) == Status::ok));
  BOOST_TEST(handle == nullptr);
}

BOOST_AUTO_TEST_CASE(bytes_that_were_changed_are_no_state)
{
  Resources  resources;
  const auto own    = resources.make();
  void      *handle = nullptr;
  BOOST_TEST((own->keep("", &handle) == Status::ok));
  std::size_t size = 0;
  BOOST_TEST((own->size_of_state("", handle, &size) == Status::ok));
  std::string bytes(size, ' ');
  BOOST_TEST((own->serialise("", handle, bytes.data(), size) == Status::ok));
  for (std::size_t k = 0; k < size; k += 7)
    {
      std::string changed = bytes;
      changed[k] ^= 4;
      void *none = nullptr;
      BOOST_TEST(
        (own->deserialise("", changed.data(), size, &none) == Status::error));
    }
  BOOST_TEST((own->deserialise("", bytes.data(), size, &handle) == Status::ok));
}

BOOST_AUTO_TEST_CASE(questions_and_answers_as_bytes)
{
  StatesQuestion question;
  question.wheels[1] = {1e-3, 2e-3, 3e-4, 4e-5, 6e4, 0.3, {1., 2., 3.}};
  question.memories  = {{"", std::string("a\0b", 3)}};
  const auto again   = StatesQuestion::of_bytes(question.bytes());
  BOOST_TEST((again.wheels[1].numbers() == question.wheels[1].numbers()));
  BOOST_TEST((again.memories == question.memories));
  StatesAnswer answer;
  answer.why                       = "why";
  answer.wheels[0].roll            = 1. / 3;
  answer.wheels[1].values[force_y] = -1. / 7;
  answer.wheels[1].memory          = "m";
  const std::string bytes          = answer.bytes();
  const auto        same           = StatesAnswer::of_bytes(bytes);
  BOOST_TEST(same.bytes() == bytes);
  BOOST_TEST(same.wheels[1].values[force_y] == -1. / 7);
  for (std::size_t n = 0; n < bytes.size(); ++n)
    BOOST_CHECK_THROW(StatesAnswer::of_bytes(bytes.substr(0, n)),
                      std::invalid_argument);
  BOOST_CHECK_THROW(StatesAnswer::of_bytes(bytes + " "), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(programs_that_solve_nothing)
{
  Resources         resources;
  const std::string program = (resources.folder / "a program").string();
  std::ofstream(resources.folder / values_file, std::ios::binary)
    << program_values({radius, tape_circle, start()}, program);
  const auto own = resources.make();
  BOOST_REQUIRE(bool(own));
  own->set_up("", 0., false, 0.);
  own->enter_initialisation("", true);
  const auto ends_with = [&](const std::string &script,
                             const std::string &words) {
    std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    try
      {
        own->exit_initialisation("");
      }
    catch (const std::runtime_error &problem)
      {
        return std::string(problem.what()).find(words) != std::string::npos;
      }
    return false;
  };
  BOOST_TEST(ends_with("echo no such entry >&2; exit 7",
                       "ended with the exit code 7. It said: no such entry"));
  BOOST_TEST(ends_with("kill -SEGV $$", "ended by the signal 11"));
  // its first frame has one byte
  BOOST_TEST(
    ends_with("printf '\\1\\0\\0\\0\\0\\0\\0\\0a' >&0", "another version"));
}

BOOST_AUTO_TEST_CASE(messages_by_category)
{
  Resources  resources;
  const auto own = resources.make();
  own->set_logging(true, {"logStatusWarning"});
  BOOST_TEST((own->terminate("") == Status::error));
  BOOST_TEST(resources.messages.empty());
  own->set_logging(true, {"logAll"});
  own->terminate("fmi2Terminate");
  BOOST_TEST(resources.messages.size() == 1);
  own->set_logging(false, {});
  own->terminate("");
  BOOST_TEST(resources.messages.size() == 1);
}

BOOST_AUTO_TEST_CASE(places_of_resources)
{
  BOOST_TEST(folder_of("file:///tmp/a%20b/") == "/tmp/a b");
  BOOST_TEST(folder_of("file://localhost/tmp/c") == "/tmp/c");
  BOOST_TEST(folder_of("file:/tmp/c") == "/tmp/c");
  BOOST_TEST(folder_of("/tmp/100%/") == "/tmp/100%");
  BOOST_TEST(folder_of("file:///tmp/%zz%2") == "/tmp/%zz%2");
  BOOST_TEST(folder_of("file://") == "");
  BOOST_TEST(folder_of("/") == "/");
}

BOOST_AUTO_TEST_CASE(tokens_follow_from_bytes)
{
  BOOST_TEST(token_of("a") == token_of("a"));
  BOOST_TEST(token_of("a") != token_of("b"));
  BOOST_TEST(token_of("ab") != token_of("ba"));
  BOOST_TEST(token_of("").size() == 38);
}

BOOST_AUTO_TEST_CASE(zip_of_nothing_and_of_a_text)
{
  BOOST_TEST(stored_zip({}).size() == 22);
  const std::string zip = stored_zip({{"check", "123456789"}});
  // the checksum that the standard of zip files names, 0xcbf43926
  BOOST_TEST(zip.substr(14, 4) == "\x26\x39\xf4\xcb");
  BOOST_TEST(zip.size() == 30 + 5 + 9 + 46 + 5 + 22);
}

BOOST_AUTO_TEST_SUITE_END()
