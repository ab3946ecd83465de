#ifndef rolling_contact_wheelset_fmu_wheel_h
#define rolling_contact_wheelset_fmu_wheel_h

#include <rolling_contact/fmu/state_messages.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/quiet_context.h>

#include <list>

namespace RollingContact
{
  /**
   * The states of a right-hand wheel, asked for one after the other by an FMU.
   * A state begins with the tractions of an earlier one, on the bodies of that.
   * Both are in what is remembered of it: the tractions themselves, and what
   * the bodies were made for. So an answer depends on the question and the
   * memory alone, to the last bit, whatever was asked in between and by which
   * process. Bodies are kept, which saves time only.
   */
  class FmuWheel
  {
  public:
    /** Throws InputError if profiles cannot be read. */
    explicit FmuWheel(const Situation &scene);

    /**
     * The state that is asked for, begun with that of a @p memory if there is
     * one. Throws InputError if the wheel is not on its rail or the memory is
     * none of this scene, ConvergenceError if the state is not found.
     */
    Fmu::WheelAnswer answer(const Fmu::WheelQuestion &asked,
                            const std::string        &memory);

    /** How many sets of bodies were made. */
    unsigned int n_made = 0;

  private:
    /** What bodies are made for: a state, and where patches of others were. */
    struct Recipe
    {
      Fmu::WheelQuestion   asked;
      std::vector<ZoneBox> others;

      std::string   bytes() const;
      static Recipe of_bytes(const std::string &bytes);
    };

    struct Kept : KeptBodies<3>
    {
      std::string  recipe;
      ContactState first   = {}; ///< state of the recipe
      std::string  failure = {}; ///< why there is none
    };

    Profiles::WheelsetPosition place_of(const Fmu::WheelQuestion &asked) const;

    PairSpec scene_of(const Fmu::WheelQuestion         &asked,
                      const Profiles::WheelsetPosition &place) const;

    /** Bodies of a recipe, which are made if they are not kept. */
    Kept &bodies_of(const Recipe &recipe);

    Kept made(const Recipe &recipe);

    /** Solve from a state; with its edges as they are if @p holds. */
    static bool solve_from(const PairSpec     &scene,
                           const ContactState &start,
                           const bool          holds,
                           Kept               &kept);

    /** Whether the state is found on bodies that suit it. */
    bool is_found(const PairSpec     &scene,
                  const ContactState &start,
                  Kept               &kept) const;

    /** The state that was solved last on bodies. */
    Fmu::WheelAnswer told(const PairSpec &scene, Kept &kept) const;

    const PairSpec                                     base;
    const double                                       speed;
    const std::shared_ptr<const Profiles::WheelOnRail> profiles;
    const std::shared_ptr<SplitBodies>                 split_bodies;
    QuietContext                                       context;
    std::list<Kept> kept; ///< the one that was used last first
  };
} // namespace RollingContact

#endif
