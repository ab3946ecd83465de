#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/crc.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/time/checkpoint.h>

#include <cstring>
#include <sstream>

namespace boost
{
  namespace serialization
  {
    template <typename Archive>
    void serialize(Archive                      &archive,
                   RollingContact::PvdBlock     &block,
                   [[maybe_unused]] unsigned int version)
    {
      archive &block.time &block.part &block.name &block.file;
    }

    template <typename Archive>
    void serialize(Archive                      &archive,
                   RollingContact::Checkpoint   &checkpoint,
                   [[maybe_unused]] unsigned int version)
    {
      auto    &c = checkpoint;
      auto    &p = checkpoint.progress;
      archive &c.tables;
      archive &p.step &p.time &p.rolled_distance &p.time_step;
      archive &c.motion &c.slip &c.state &c.patch_friction &c.last_step;
      archive &p.supplied_energy &p.friction_energy &p.damping_energy;
      archive &p.numerical_energy &p.energy_error &p.surface_energy &p
        .n_impacts;
      archive &c.history.n_rows &c.history.n_bytes;
      archive &c.modal_velocities.n_rows &c.modal_velocities.n_bytes;
      archive &c.body_fields &c.interface_fields;
    }
  } // namespace serialization
} // namespace boost

namespace RollingContact
{
  namespace
  {
    /** What stands before the archive. */
    struct Head
    {
      char          mark[24] = "rolling-contact restart"; ///< with its '\0'
      std::uint32_t version  = 11; ///< to be raised with every change above
      std::uint32_t checksum = 0;  ///< CRC-32 of the archive
      std::uint64_t n_bytes  = 0;  ///< of the archive
    };

    std::uint32_t checksum_of(const char *bytes, const std::size_t n_bytes)
    {
      boost::crc_32_type crc;
      crc.process_bytes(bytes, n_bytes);
      return crc.checksum();
    }

    [[noreturn]] void reject(const std::filesystem::path &file,
                             const std::string           &reason)
    {
      throw InputError("Cannot resume from \"" + file.string() +
                       "\": " + reason + " Start the run without --resume.");
    }

    void write_file_of(const Checkpoint &checkpoint, RunFolder &folder)
    {
      std::ostringstream stream(std::ios::binary);
      {
        boost::archive::binary_oarchive archive(stream);
        archive << checkpoint;
      }
      std::string bytes = stream.str();
      Head        head;
      head.n_bytes  = bytes.size();
      head.checksum = checksum_of(bytes.data(), bytes.size());

      bytes.insert(0, reinterpret_cast<const char *>(&head), sizeof(head));
      folder.write_durably(checkpoint_name, bytes);
    }

    /** The archive behind the head, checked. */
    std::string read_archive(const std::filesystem::path &file)
    {
      std::string bytes = read_bytes(file);
      Head        expected, head;
      if (bytes.size() < sizeof(Head))
        reject(file, "it is missing or truncated.");
      std::memcpy(&head, bytes.data(), sizeof(Head));
      if (std::memcmp(head.mark, expected.mark, sizeof(head.mark)) != 0)
        reject(file, "it is not a checkpoint of this program.");
      if (head.version != expected.version)
        reject(file,
               "its version is " + std::to_string(head.version) +
                 ", this program reads " + std::to_string(expected.version) +
                 '.');
      bytes.erase(0, sizeof(Head));
      if (bytes.size() != head.n_bytes ||
          checksum_of(bytes.data(), bytes.size()) != head.checksum)
        reject(file, "it is truncated or damaged.");
      return bytes;
    }
  } // namespace

  void write_checkpoint(const Checkpoint &checkpoint, RunFolder &folder)
  {
    Ranks::on_root([&]() { write_file_of(checkpoint, folder); });
  }

  namespace
  {
    Checkpoint checkpoint_of(const std::filesystem::path &file,
                             const std::string           &bytes)
    {
      std::istringstream stream(bytes, std::ios::binary);
      Checkpoint         checkpoint;
      try
        {
          boost::archive::binary_iarchive archive(stream);
          archive >> checkpoint;
        }
      catch (const std::exception &)
        {
          reject(file, "it was written on another platform.");
        }
      return checkpoint;
    }
  } // namespace

  Checkpoint read_checkpoint(const RunFolder &folder)
  {
    const auto  file = folder.get_path() / checkpoint_name;
    std::string bytes;
    Ranks::on_root([&]() { bytes = read_archive(file); });
    Ranks::broadcast(bytes);
    return checkpoint_of(file, bytes);
  }

  void check_resumable(const Situation             &scene,
                       const std::filesystem::path &folder)
  {
    const auto       file       = folder / checkpoint_name;
    const Checkpoint checkpoint = checkpoint_of(file, read_archive(file));
    refuse_changed_entries(checkpoint.tables, files_of(scene), {});
    const TimeSteps steps = scene.inputs->time.steps(
      scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder)
        .speed);
    const TransientProgress &done = checkpoint.progress;
    if (done.step <= steps.number)
      return;
    const bool by_time = scene.inputs->time.end_time > 0.;
    throw InputError(
      (by_time ? "Time/End time = " +
                   significant(scene.inputs->time.end_time, 6) + " s"
               : "Time/Rolled distance = " +
                   significant(scene.inputs->time.rolled_distance, 6) + " m") +
      " is reached after " + std::to_string(steps.number) +
      " steps, and the run in \"" + folder.string() + "\" has done " +
      std::to_string(done.step) + ", to " +
      (by_time ? significant(done.time, 6) + " s"
               : significant(done.rolled_distance, 6) + " m") +
      ": resume it to a later end, or start it without --resume.");
  }

  PrmEntries files_of(const Situation &scene)
  {
    PrmEntries names =
      scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder)
        .tables;
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      if (body->is_from_file())
        names[body->section + "/Mesh file (mesh)"] = body->mesh->fingerprint();
    for (const Side side : both_sides)
      if (const auto &record = scene.surfaces.records[side])
        names[SurfaceParameters::entry(side) + " (record)"] =
          record->fingerprint();
    if (const auto &standing = scene.surfaces.standing)
      names["Contact/Roughness (record)"] = standing->fingerprint();
    return names;
  }
} // namespace RollingContact
