#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/input/prm_declared.h>
#include <rolling_contact/scene/scene_entries.h>

#include <set>

namespace RollingContact
{
  using namespace dealii;

  /**
   * deal.II's reader, whose actions set the members of a scene, and what it
   * declares, found when it is asked for.
   */
  struct SceneEntries::Handler
  {
    const DeclaredEntries &
    declared()
    {
      if (!entries)
        entries = std::make_unique<DeclaredEntries>(prm);
      return *entries;
    }

    ParameterHandler                 prm;
    std::unique_ptr<DeclaredEntries> entries;
  };



  SceneEntries::SceneEntries(const SceneParameters &scene)
    : handler(std::make_unique<Handler>())
  {
    given.analysis = scene.analysis;
    given.declare(handler->prm, {{scene.analysis, ""}});
    given = scene; // declaring set what it has no default for
    if (given.contact.vertical_load)
      given.contact.normal_load.reset(); // it followed from that
    if (given.contact.creepage_size)
      given.contact.creepages.x = given.contact.creepages.y = 0.; // they did
  }



  SceneEntries::~SceneEntries() = default;



  bool
  is_load(const std::string &entry)
  {
    static const std::set<std::string> of_operators{"Contact/Slip operator",
                                                    "Contact/Contact matrices",
                                                    "Contact/Roughness"};
    static const std::set<std::string> of_dampers{"Wheel/Damper mass",
                                                  "Wheel/Damper frequency",
                                                  "Wheel/Damper damping ratio"};
    return (entry.compare(0, 8, "Contact/") == 0 &&
            of_operators.count(entry) == 0) ||
           of_dampers.count(entry) > 0 ||
           entry.compare(0, 10, "Stability/") == 0;
  }



  bool
  is_place(const std::string &entry)
  {
    return entry == "Profiles/Lateral shift" || entry == "Profiles/Roll" ||
           entry == "Profiles/Yaw";
  }



  void
  SceneEntries::check(const std::string &entry,
                      const std::string &value,
                      const std::string &place) const
  {
    handler->declared().check({entry, value, place});
  }



  void
  SceneEntries::check_variable(const std::string &entry,
                               const std::string &place) const
  {
    static const std::set<std::string> sections{
      "Wheel", "Rail", "Contact", "Mesh", "Profiles"};
    static const std::set<std::string> texts{"Contact/Roughness",
                                             "Wheel/Mesh file",
                                             "Wheel/Mode damping",
                                             "Rail/Mesh file",
                                             "Rail/Mode damping",
                                             "Profiles/Wheel profile",
                                             "Profiles/Rail profile"};
    const DeclaredEntries             &declared = handler->declared();
    declared.check_exists({entry, "", place});
    const std::string section   = entry.substr(0, entry.find('/'));
    const bool        has_modes = given.analysis == "stability map";
    if (sections.count(section) == 0 && !(has_modes && section == "Stability"))
      throw InputError(place + entry +
                       " is none that states may differ by; take one of "
                       "sections Wheel, Rail, Contact, Mesh and Profiles" +
                       (has_modes ? ", or of Stability." : "."));
    const std::string &pattern = declared.pattern(entry);
    const auto         begins  = [&](const std::string &kind) {
      return pattern.compare(0, kind.size(), kind) == 0;
    };
    if (texts.count(entry) > 0 ||
        !(begins("[Double") || begins("[Integer") || begins("[Anything")))
      throw InputError(place + entry +
                       " is no number; a state may differ from others by "
                       "numbers only.");
  }



  void
  SceneEntries::set(const std::string &entry, const std::string &value)
  {
    const std::size_t     slash  = entry.rfind('/');
    const bool            in_one = slash != std::string::npos;
    ParameterHandler     &prm    = handler->prm;
    const SceneParameters before = given;
    if (in_one)
      prm.enter_subsection(entry.substr(0, slash));
    try
      {
        prm.set(entry.substr(in_one ? slash + 1 : 0), value);
      }
    catch (...)
      {
        if (in_one)
          prm.leave_subsection();
        given = before;
        throw;
      }
    if (in_one)
      prm.leave_subsection();
    if (!is_load(entry))
      of_bodies[entry] = value;
  }



  std::string
  SceneEntries::unit(const std::string &entry) const
  {
    const std::string unit = handler->declared().unit(entry);
    return unit.empty() ? "1" : unit;
  }



  void
  SceneEntries::check_scene() const
  {
    given.check();
  }



  std::string
  SceneEntries::bodies_key() const
  {
    std::string key = given.contact.friction_coefficient > 0.
                        ? "with friction"
                        : "without friction";
    key += given.contact.flow() > 0 ? ", flow +x" : ", flow -x";
    for (const auto &[entry, value] : of_bodies)
      key += ", " + entry + " = " + value;
    return key;
  }



  SceneParameters
  SceneEntries::scene()
  {
    const std::string key = bodies_key();
    if (key == found_for)
      {
        SceneParameters scene = given;
        scene.take_derived_contact();
        return scene;
      }
    SceneParameters scene = given;
    scene.check();
    scene.read_meshes();
    scene.read_profiles();
    given.wheel          = scene.wheel;
    given.rail           = scene.rail;
    given.profiles.frame = scene.profiles.frame;
    found_for            = key;
    return scene;
  }
} // namespace RollingContact
