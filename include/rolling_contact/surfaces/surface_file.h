#ifndef rolling_contact_surfaces_surface_file_h
#define rolling_contact_surfaces_surface_file_h

#include <cstddef>
#include <filesystem>
#include <string>

namespace RollingContact
{
  /**
   * What an entry says of a file of heights: a line, or a map as text, after
   * ISO 25178-71 or in HDF5; and complaints about it.
   */
  class SurfaceFile
  {
  public:
    enum class Kind
    {
      none, ///< the text names no file
      line,
      grid,
      sdf,
      hdf5
    };

    /** What a text names, in front of it `mirrored:` or `middle line:`. */
    struct Source
    {
      Kind        kind = Kind::none;
      std::string file, dataset;
      std::string column      = "2"; ///< of the height of a line
      bool        mirrored    = false;
      bool        middle_line = false;
    };

    static Source source_of(const std::string &text);

    /**
     * Throws InputError if there is no such file or it is too large.
     */
    SurfaceFile(const std::string           &entry,
                const std::string           &text,
                const std::filesystem::path &folder);

    /** Throws InputError: the entry, its text, the file, the line, what is
     * wrong. */
    [[noreturn]] void reject(const std::string &reason,
                             const std::size_t  line = 0) const;

    /** The column of the height of a line. Throws InputError. */
    std::size_t column() const;

    const std::string entry, text;
    const Source      source;
    const std::string path;
  };
} // namespace RollingContact

#endif
