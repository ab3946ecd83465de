#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/plausibility.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Collects the sentences.
     */
    class Doubts
    {
    public:
      Doubts(const SceneParameters &scene, const Creepages &creepages)
        : scene(scene)
        , creepages(creepages)
      {}

      std::vector<std::string> find();

    private:
      /** "entry = value unit is why; meant so?" */
      void doubt(const std::string &entry,
                 const double       value,
                 const std::string &unit,
                 const std::string &why,
                 const std::string &meant)
      {
        sentences.push_back(entry + " = " + significant(value, 6) +
                            (unit.empty() ? "" : ' ' + unit) +
                            " is unlikely: " + why +
                            (meant.empty() ? "." : "; meant " + meant + "?"));
      }

      void check_length(const BodyParameters &body,
                        const std::string    &entry,
                        const double          value);
      void check_sizes(const BodyParameters &body);
      void check_material(const BodyParameters &body);
      void check_modal_damping(const BodyParameters &body);
      void check_model(const BodyParameters &body);
      void check_approach();
      void check_load();
      void check_creepage(const std::string         &entry,
                          const std::vector<double> &list);
      void check_spin(const std::string         &entry,
                      const std::vector<double> &list);
      void check_rolling();
      void check_histories();

      /** Whether the masses of the bodies matter. */
      bool has_inertia() const
      {
        return (scene.marches() && scene.time.inertia) || vibrates();
      }

      /** Whether the analysis is one of modes. */
      bool vibrates() const
      {
        return scene.analysis.linearises || scene.analysis.has_lone_bodies();
      }

      const SceneParameters   &scene;
      const Creepages          creepages;
      std::vector<std::string> sentences;
    };

    void Doubts::check_length(const BodyParameters &body,
                              const std::string    &entry,
                              const double          value)
    {
      const double largest = 10.; // m
      if (std::abs(value) > largest)
        doubt(body.section + '/' + entry,
              value,
              "m",
              "lengths are in m",
              significant(1e-3 * value, 6) + " (" + significant(value, 6) +
                " mm)");
    }

    void Doubts::check_sizes(const BodyParameters &body)
    {
      check_length(body, "Radius", body.radius);
      if (scene.dimension == 3)
        check_length(body, "Lateral radius", body.lateral_radius);
      if (body.rigid)
        return;
      if (scene.dimension == 2)
        check_length(body, "Thickness", body.thickness);
      if (body.is_from_file())
        return;
      if (scene.dimension == 3)
        check_length(body, "Width", body.width);
      if (body.shape == "disc")
        check_length(body, "Hub radius", body.hub_radius);
      if (body.shape == "block")
        {
          check_length(body, "Block length", body.block_length);
          check_length(body, "Block depth", body.block_depth);
        }
    }

    void Doubts::check_material(const BodyParameters &body)
    {
      if (body.rigid)
        return;
      const double E       = body.material.young_modulus,
                   density = body.material.density;
      const double softest = 1e6, hardest = 1e14; // rubber, above diamond; Pa
      if (E < softest || E > hardest)
        doubt(body.section + "/Young modulus",
              E,
              "Pa",
              E < softest ? "rubber has 1e6 Pa" : "diamond has 1.2e12 Pa",
              E < 2e3       ? significant(E, 6) + "e9 (GPa)"
              : E < softest ? significant(E, 6) + "e6 (MPa)"
                            : "");
      if (has_inertia() &&
          (density < 100. || density > 3e4)) // foams; osmium has 22.6e3
        doubt(body.section + "/Density",
              density,
              "kg/m^3",
              "steel has 7800 kg/m^3",
              density < 30. ? significant(density, 6) + "e3 (g/cm^3)" : "");
    }

    void Doubts::check_modal_damping(const BodyParameters &body)
    {
      const std::vector<double> &ratios = body.model.damping.modal;
      if (body.rigid || ratios.empty() || !(vibrates() || scene.marches()))
        return;
      const double largest = *std::max_element(ratios.begin(), ratios.end()),
                   most    = 0.1;
      if (largest >= most)
        doubt(body.section + "/Modal damping",
              largest,
              "",
              "damping ratios of steel wheels are 1e-4 to 1e-2",
              significant(largest, 6) + "e-2 (" + significant(largest, 6) +
                " %)");
    }

    void Doubts::check_model(const BodyParameters &body)
    {
      if (body.rigid)
        return;
      const double locking = 0.45;
      if (body.model.elements == ElementKind::enhanced &&
          body.material.poisson_ratio > locking)
        sentences.push_back(
          body.section + "/Elements = enhanced and Poisson ratio = " +
          significant(body.material.poisson_ratio, 6) +
          ": near 0.5 such elements are too stiff where cells are distorted; "
          "take B-bar.");
      if (body.hub != Hub::elastic)
        return;
      const double softest = 1e5, stiffest = 1e12; // per metre, N/m^2
      const double stiffness = body.model.foundation.stiffness[2];
      if (stiffness < softest || stiffness > stiffest)
        doubt(body.section + "/Foundation stiffness z",
              stiffness,
              "N/m^2",
              "rails lie on 1e7 to 1e9 N/m^2, of a metre of length",
              "");
    }

    void Doubts::check_approach()
    {
      if (!scene.contact.approach)
        return;
      double radius = 0.;
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        if (body->radius != 0. &&
            (radius == 0. || std::abs(body->radius) < radius))
          radius = std::abs(body->radius);
      const double approach = *scene.contact.approach, largest = 0.05;
      if (approach > largest * radius && radius > 0.)
        doubt("Contact/Approach",
              approach,
              "m",
              "it is " + significant(approach / radius, 3) +
                " times the smallest radius, and it is in m",
              significant(approach, 6) + "e-3 (mm)");
    }

    /**
     * Whether the density is that of the material: the default is that of
     * steel, and may be unsaid where it does not matter.
     */
    bool knows_density(const Material &material)
    {
      const Material steel = BodyParameters("Wheel").material;
      const double   E     = material.young_modulus;
      return material.density != steel.density ||
             (E > 0.7 * steel.young_modulus && E < 1.3 * steel.young_modulus);
    }

    void Doubts::check_load()
    {
      const BodyParameters       &wheel       = scene.wheel;
      const bool                  is_vertical = !!scene.contact.vertical_load;
      const std::optional<double> given =
        is_vertical ? scene.contact.vertical_load : scene.contact.normal_load;
      if (!given || *given <= 0. || wheel.rigid || wheel.shape != "disc" ||
          !knows_density(wheel.material))
        return;
      const double gravity = 9.81, least = 0.2, pi = std::acos(-1.),
                   load  = *given,
                   width = scene.dimension == 2 ? wheel.thickness : wheel.width,
                   weight = gravity * wheel.material.density * pi * width *
                            (std::pow(wheel.radius, 2) -
                             std::pow(wheel.hub_radius, 2));
      if (load < least * weight)
        doubt(is_vertical ? "Contact/Vertical load" : "Contact/Normal load",
              load,
              "N",
              "the wheel alone weighs " + significant(weight, 3) + " N",
              significant(load, 6) + "e3 (kN)");
    }

    void Doubts::check_creepage(const std::string         &entry,
                                const std::vector<double> &list)
    {
      const auto largest = std::max_element(list.begin(),
                                            list.end(),
                                            [](const double a, const double b) {
                                              return std::abs(a) < std::abs(b);
                                            });
      if (std::abs(*largest) > 1.)
        doubt(entry,
              *largest,
              "",
              "a wheel that is blocked has a creepage of 1",
              significant(*largest / 100, 6) + " (" + significant(*largest, 6) +
                " %)");
    }

    void Doubts::check_spin(const std::string         &entry,
                            const std::vector<double> &list)
    {
      for (const double spin : list)
        if (std::abs(spin) > 100.)
          {
            doubt(entry,
                  spin,
                  "1/m",
                  "it is that of a cone of " + significant(1e3 / spin, 3) +
                    " mm that does not roll",
                  "");
            return;
          }
    }

    void Doubts::check_rolling()
    {
      const ContactParameters &contact = scene.contact;
      const double             mu      = contact.friction_coefficient;
      if (mu > 10.)
        doubt("Contact/Friction coefficient",
              mu,
              "",
              "dry steel has 0.3 to 0.6, rubber 1",
              significant(mu / 100, 6) + " (" + significant(mu, 6) + " %)");
      if (scene.analysis.own_creepages)
        {
          for (const TableAxis &list : scene.analysis.own_creepages(scene))
            if (list.entry == "Contact/Spin")
              check_spin(list.name, list.values);
            else
              check_creepage(list.name, list.values);
          return;
        }
      const double angle = contact.creepage_direction;
      if (std::abs(angle) > 2 * pi)
        doubt("Contact/Creepage direction",
              angle,
              "rad",
              "a full circle has 6.28 rad",
              significant(angle * pi / 180, 6) + " (" + significant(angle, 6) +
                " degrees)");
      check_creepage("Contact/Creepage x", {creepages.x});
      check_creepage("Contact/Creepage y", {creepages.y});
      check_spin("Contact/Spin", {creepages.spin});
    }

    void Doubts::check_histories()
    {
      const TimeParameters  &time = scene.time;
      const DrivingFunctions driving =
        time.histories(scene.contact, scene.prm_folder);
      const TimeSteps     steps = time.steps(driving.speed);
      const unsigned int  n     = 100;
      std::vector<double> x, y, spin;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const Creepages now =
            driving.creepages(steps.length * steps.number * i / n);
          x.push_back(now.x);
          y.push_back(now.y);
          spin.push_back(now.spin);
        }
      if (!time.creepage_x.empty())
        check_creepage("Time/Creepage x", x);
      if (!time.creepage_y.empty())
        check_creepage("Time/Creepage y", y);
      if (!time.spin.empty())
        check_spin("Time/Spin", spin);
    }

    std::vector<std::string> Doubts::find()
    {
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        {
          check_sizes(*body);
          check_material(*body);
          check_modal_damping(*body);
          check_model(*body);
        }
      check_approach();
      check_load();
      check_rolling();
      if (scene.marches())
        check_histories();
      return sentences;
    }
  } // namespace

  std::vector<std::string> implausible_values(const SceneParameters &scene,
                                              const Creepages       &creepages)
  {
    return Doubts(scene, creepages).find();
  }
} // namespace RollingContact
