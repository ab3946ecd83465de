#ifndef rolling_contact_tests_scratch_folder_h
#define rolling_contact_tests_scratch_folder_h

#include <boost/test/unit_test.hpp>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace RollingContact
{
  /** A folder of its own for one test, gone at its end. */
  struct ScratchFolder
  {
    ScratchFolder()
    {
      std::string name =
        (std::filesystem::temp_directory_path() / "rolling_contact_XXXXXX")
          .string();
      BOOST_REQUIRE(mkdtemp(name.data()) != nullptr);
      scratch = name;
      folder  = scratch / "output" / "carter";
    }

    ~ScratchFolder()
    {
      std::error_code error;
      std::filesystem::remove_all(scratch, error);
    }

    std::filesystem::path scratch;
    std::filesystem::path folder;
  };

  inline std::string read(const std::filesystem::path &file)
  {
    std::ifstream      stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  inline void write(const std::filesystem::path &file, const std::string &text)
  {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
} // namespace RollingContact

#endif
