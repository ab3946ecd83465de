#include <rolling_contact/advice/idle_entries.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
    /** Of the supports of a body, entries without a use, and why. */
    void
    add_idle_supports(const BodyParameters               &body,
                      const unsigned int                  dimension,
                      std::map<std::string, std::string> &idle)
    {
      const Foundation &foundation = body.model.foundation;
      const auto        add = [&](const std::vector<std::string> &entries,
                           const std::string              &why) {
        for (const std::string &entry : entries)
          idle.emplace(body.section + '/' + entry, why);
      };
      const std::vector<std::string> pads{"Pad length",
                                          "Pad offset",
                                          "Sleeper mass"},
        ballast{"Ballast stiffness x",
                "Ballast stiffness y",
                "Ballast stiffness z",
                "Ballast loss factor"};
      if (dimension == 2)
        add({"Foundation stiffness y",
             "Ballast stiffness y",
             "Hub inertia x",
             "Hub inertia z"},
            "it has a meaning in 3D only");
      if (body.rigid || body.hub != Hub::elastic)
        {
          const std::string why = "an elastic body with Hub = elastic reads it";
          add({"Foundation stiffness x",
               "Foundation stiffness y",
               "Foundation stiffness z",
               "Foundation loss factor",
               "Pad spacing"},
              why);
          add(pads, why);
          add(ballast, why);
        }
      if (foundation.pad_spacing == 0.)
        add(pads, "the layer is continuous, Pad spacing = 0");
      if (!foundation.has_sleepers())
        add(ballast, "there are no sleepers, Sleeper mass = 0");
      if (body.rigid || body.hub != Hub::mass)
        add({"Hub mass", "Hub inertia x", "Hub inertia y", "Hub inertia z"},
            "an elastic body with Hub = mass reads it");
    }



    /** Of the damping of a body, entries without a use, and why. */
    void
    add_idle_damping(const SceneParameters              &scene,
                     const BodyParameters               &body,
                     std::map<std::string, std::string> &idle)
    {
      const BodyDamping &damping = body.model.damping;
      const auto         add     = [&](const std::vector<std::string> &entries,
                           const std::string              &why) {
        for (const std::string &entry : entries)
          idle.emplace(body.section + '/' + entry, why);
      };
      const std::vector<std::string> all{"Loss factor",
                                         "Loss frequency",
                                         "Foundation loss factor",
                                         "Ballast loss factor",
                                         "Rayleigh mass",
                                         "Rayleigh stiffness",
                                         "Sponge length",
                                         "Sponge rate"};
      const bool                     has_modes = scene.is_of_structures() ||
                             scene.is_of_stability() ||
                             scene.has_reduced_bodies();
      const bool moves = has_modes || (scene.time.inertia &&
                                       (scene.analysis == "transient" ||
                                        (scene.analysis == "accuracy study" &&
                                         scene.study.varies_time_step)));
      if (body.rigid)
        add(all, "a rigid body has no damping");
      if (!moves)
        add(all,
            "only bodies with inertia are damped, Analysis = transient with "
            "Time/Inertia = true, and those of analyses of modes");
      if (!has_modes)
        add({"Modal damping", "Mode damping"},
            "modes of a body have it, and this analysis finds none");
      if (scene.is_of_structures())
        add({"Loss frequency"},
            "in the frequency domain loss factors need none");
      if (damping.sponge_length == 0.)
        add({"Sponge rate"}, "there are no absorbing ends, Sponge length = 0");
      if (damping.loss_factor == 0. &&
          body.model.foundation.loss_factor == 0. &&
          body.model.foundation.ballast_loss_factor == 0.)
        add({"Loss frequency"}, "all loss factors are 0");
    }



    /** Of the dampers of the wheel, entries without a use, and why. */
    void
    add_idle_dampers(const SceneParameters              &scene,
                     std::map<std::string, std::string> &idle)
    {
      std::string why;
      if (!scene.is_of_stability() && !scene.has_reduced_bodies() &&
          scene.analysis != "receptance")
        why = "dampers hang on modes as receptance, stability, stability map "
              "and Time/Bodies = reduced have them";
      else if (scene.wheel.dampers.number.empty())
        why = "there are no dampers, Dampers is empty";
      else
        return;
      for (const char *entry : {"s",
                                " mass",
                                " frequency",
                                " damping ratio",
                                " radius",
                                " position",
                                " direction"})
        idle.emplace("Wheel/Damper" + std::string(entry), why);
    }
  } // namespace



  std::map<std::string, std::string>
  idle_body_entries(const SceneParameters &scene)
  {
    std::map<std::string, std::string> idle;
    for (const BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        add_idle_supports(*body, scene.dimension, idle);
        add_idle_damping(scene, *body, idle);
        if (body->rigid)
          idle[body->section + "/Velocity points"] =
            "a rigid body has no velocity of its own";
        else if (scene.analysis != "transient" || !scene.time.inertia)
          idle[body->section + "/Velocity points"] =
            "Analysis = transient with Time/Inertia = true reads it";
      }
    add_idle_dampers(scene, idle);
    return idle;
  }
} // namespace RollingContact
