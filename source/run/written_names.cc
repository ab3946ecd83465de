#include <rolling_contact/base/number_text.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/written_names.h>

#include <map>
#include <regex>

namespace RollingContact
{
  namespace
  {
    /// wheels of a wheelset or a bogie, and the number of a curve
    const std::string of_wheel =
      "(_(leading|trailing))?(_(right|left))?(_[0-9]+)?";

    const std::string tables =
      "(results(_rank_[0-9]+)?|history|modal_velocities|impact_history|wheelset|duty"
      "|(across|nodes)" +
      of_wheel +
      "|sound|sound_modes|spectrum|third_octaves|lines|spectrogram|cycle"
      "|cycle_patch|summary|methods|best|contact_table|modes|receptances|waves"
      "|track_decay|stability|thresholds|rolling_noise|rolling_noise_speeds"
      "|corrugation|corrugation_peaks|corrugation_check|fmu_points"
      "|residuals)\\.csv";

    const std::string numbers =
      "(history|modal_velocities|impact_history|cycle_patch|checkpoint"
      "|evolution_state)\\.bin";

    const std::string pictures =
      "(tractions|(patch|profiles|shakedown)" + of_wheel +
      "|wheelset|evolution|worn_(wheel|rail)(_(right|left))?|creep_curve"
      "|load_curve|table_[0-9]+|history|sound|spectrum|spectrogram|cycle"
      "|cycle_patch|limit_cycles|error_cpu|contact_points|gaps|steering"
      "|(modes|mode_shapes|receptances)_(wheel|rail)|waves|track_decay"
      "|stability|stability_map|stability_map_frequency|stability_map_count"
      "|root_locus|growth|rolling_noise|corrugation|impacts)\\.(svg|dat|gp)";

    /// steps, phases, ranks, modes, sides
    const std::string fields = "(interface" + of_wheel +
                               "|(interface|wheel|rail|cycle)(-[0-9]+)*"
                               "|(wheel|rail)(_(right|left))?_[0-9]+"
                               "|(wheel|rail)_mode_[0-9]+(_[0-9]+)?"
                               "|vibration_[0-9]+_(wheel|rail)_[0-9]+)\\.p?vtu";

    const std::string collections =
      "(interface|bodies|cycle|profiles|(wheel|rail)_mode_[0-9]+"
      "|vibration_[0-9]+)\\.pvd";

    const std::string profiles =
      "(wheel|rail)(_[0-9]+)?(_(right|left))?\\.(txt|whl|prw|ban|prr)";

    const std::string others =
      "(original|used)\\.prm|wheelset(_states)?_fmi[23]\\.fmu|(table|contact_problem)\\.h5"
      "|pressure\\.wav"
      "|verdict\\.md|limit_cycle_state\\.txt";
  } // namespace

  bool is_written_name(const std::string &name)
  {
    static const std::regex names(tables + '|' + numbers + '|' + pictures +
                                    '|' + fields + '|' + collections + '|' +
                                    profiles + '|' + others,
                                  std::regex::optimize);
    const std::size_t       longest = 80; // a regular expression recurses
    return name.size() <= longest && std::regex_match(name, names);
  }

  std::string written_name_of(const std::string &entry)
  {
    const std::string ending = ".part";
    std::string       name   = entry;
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
      {
        name.erase(name.size() - ending.size());
        if (name.front() == '.')
          name.erase(0, 1);
      }
    return name == record_name || is_written_name(name) ? name : "";
  }

  std::string rank_file_name(const std::string &name, const unsigned int rank)
  {
    const std::size_t dot = name.rfind('.');
    return name.substr(0, dot) + "_rank_" + std::to_string(rank) +
           name.substr(dot);
  }

  std::optional<unsigned int> rank_of_file(const std::string &name,
                                           const std::string &file)
  {
    const std::size_t dot = name.rfind('.');
    const std::regex  form(name.substr(0, dot) + "_rank_([1-9][0-9]{0,8})\\" +
                          name.substr(dot));
    std::smatch       found;
    if (!std::regex_match(file, found, form))
      return {};
    return static_cast<unsigned int>(*number_of(found[1].str()));
  }

  std::vector<std::string> files_of_ranks(const std::filesystem::path &folder,
                                          const std::string           &name)
  {
    std::map<unsigned int, std::string> found;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
      {
        const std::string file = entry.path().filename().string();
        if (const auto rank = rank_of_file(name, file);
            rank && entry.is_regular_file())
          found[*rank] = file;
      }
    std::vector<std::string> files;
    for (const auto &[rank, file] : found)
      files.push_back(file);
    return files;
  }

  bool has_checkpoint(const std::filesystem::path &folder,
                      const std::string           &name)
  {
    return std::filesystem::is_regular_file(folder / name) ||
           (std::filesystem::is_directory(folder) &&
            !files_of_ranks(folder, name).empty());
  }

  bool vouch_for(const std::set<std::string> &files, const std::string &name)
  {
    const std::string picture = ".svg", script = ".gp";
    const std::size_t stem = name.rfind('.');
    return files.count(name) > 0 ||
           (stem != std::string::npos && name.substr(stem) == picture &&
            files.count(name.substr(0, stem) + script) > 0);
  }
} // namespace RollingContact
