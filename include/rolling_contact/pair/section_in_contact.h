#ifndef rolling_contact_pair_section_in_contact_h
#define rolling_contact_pair_section_in_contact_h

#include <rolling_contact/mesh/profiled_section.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/scene/pair_spec.h>

#include <array>

namespace RollingContact
{
  /**
   * A body whose section from a file is under a profile, as seen from where it
   * touches. The axes of the body are those of the file; those of the contact
   * have their origin at its point of the profile and are turned about x by the
   * angle at which it touches. Where that surface is curved, across is the
   * length along it. Units: m, rad.
   */
  class SectionInContact
  {
  public:
    /**
     * Whether there is one on this side.
     */
    static bool is_on(const PairSpec &scene, const Side side);

    SectionInContact(const PairSpec &scene, const Side side);

    AxesOfContact axes() const
    {
      return {turn, origin[0], origin[1]};
    }

    /**
     * The mesh of the body in space with its vertices in the axes of the
     * contact, on a curved surface those of the contact faces alone, without
     * contact faces beyond the axle.
     */
    FileMesh seen_from_contact(const FileMesh &mesh) const;

    /**
     * How far a vertex of the mesh, in the axes of the body, is off the
     * profile.
     */
    double off_profile(const FileMesh::Point &vertex) const;

    /**
     * A vertex in the file's axes, across and out of the body.
     */
    ProfiledSection::Point in_file(const FileMesh::Point &vertex) const;

  private:
    bool                   is_left, is_curved;
    double                 radius; ///< of the revolved section, else 0
    ProfiledSection        profile;
    double                 turn;
    ProfiledSection::Point origin; ///< in the axes of the body
  };
} // namespace RollingContact

#endif
