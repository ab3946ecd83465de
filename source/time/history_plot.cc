#include <rolling_contact/results/uniqueness_warning.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/history_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/history_plot.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    Values scaled(Values values, const double factor)
    {
      for (double &value : values)
        value *= factor;
      return values;
    }

    /** Whether a value exceeds so small a part of what it is measured by. */
    bool any_beyond(const Values &values, const double limit)
    {
      return std::any_of(values.begin(), values.end(), [&](const double value) {
        return std::abs(value) > limit;
      });
    }

    bool varies(const Values &values)
    {
      const auto range = std::minmax_element(values.begin(), values.end());
      return range.first != values.end() &&
             *range.second - *range.first >
               1e-9 * std::max(std::abs(*range.first), std::abs(*range.second));
    }

    /**
     * The panels from above, over one abscissa.
     */
    class Panels
    {
    public:
      Panels(const Situation &scene, const HistoryColumns &history);

      void draw(RunContext &context) const
      {
        figure->draw(context, "history");
      }

    private:
      struct Curve
      {
        std::string label;
        Values      values;
        CurveStyle  style = CurveStyle::line;
        bool        force = false; ///< acts at force_time_s
      };

      const Values &column(const std::string &name) const
      {
        return history.at(name);
      }

      /** Time or rolled distance when the forces act. */
      Values places_of_forces() const;

      void add_panel(const std::string        &y_label,
                     const std::vector<Curve> &curves);
      void add_forces();
      void add_load();
      void add_creepages();

      const Situation      &scene;
      const HistoryColumns  history;
      const bool            rolls;
      const Values          abscissa;
      std::optional<Figure> figure;
    };

    Panels::Panels(const Situation &scene, const HistoryColumns &history)
      : scene(scene)
      , history(history)
      , rolls(scene.contact.friction_coefficient > 0. &&
              any_beyond(column("rolled_m"), 0.))
      , abscissa(scaled(column(rolls ? "rolled_m" : "time_s"), 1e3))
    {
      if (rolls)
        add_forces();
      add_load();
      if (scene.surfaces.in_use())
        add_panel("height (\u00b5m)",
                  {{"height of the surfaces",
                    scaled(column("surface_height_m"), 1e6),
                    CurveStyle::line,
                    true}});
      if (rolls)
        add_creepages();
      if (varies(column("approach_m")) && scene.contact.approach)
        add_panel("approach (\u00b5m)",
                  {{"approach", scaled(column("approach_m"), 1e6)}});
      if (any_beyond(column("wheel_velocity_m/s"), 0.))
        add_panel("v (m/s)", {{"wheel along z", column("wheel_velocity_m/s")}});
      if (rolls && varies(column("speed_m/s")))
        add_panel("V (m/s)", {{"rolling speed", column("speed_m/s")}});
    }

    Values Panels::places_of_forces() const
    {
      const Values &time = column("time_s"), &acts = column("force_time_s");
      if (!rolls)
        return scaled(acts, 1e3);
      Values places = abscissa;
      for (std::size_t i = 0; i < places.size(); ++i)
        places[i] -=
          1e3 * std::abs(column("speed_m/s")[i]) * (time[i] - acts[i]);
      return places;
    }

    void Panels::add_panel(const std::string        &y_label,
                           const std::vector<Curve> &curves)
    {
      Figure panel(rolls ? "Forces on the wheel and what drives it"
                         : "Load and motion",
                   rolls ? "rolled distance (mm)" : "time (ms)",
                   y_label);
      for (const Curve &curve : curves)
        panel.add_curve(curve.label,
                        curve.force ? places_of_forces() : abscissa,
                        curve.values,
                        curve.style);
      if (figure)
        figure->add_panel(panel);
      else
        figure.emplace(panel);
    }

    void Panels::add_forces()
    {
      const double  mu     = scene.contact.friction_coefficient;
      const Values &load   = column("normal_force_N");
      const auto    over_N = [&](Values force) {
        for (std::size_t i = 0; i < force.size(); ++i)
          force[i] = load[i] > 0. ? force[i] / (mu * load[i]) : 0.;
        return force;
      };
      std::vector<Curve> curves{
        {"longitudinal", over_N(column("force_x_N")), CurveStyle::line, true}};
      const Values lateral = over_N(column("force_y_N"));
      if (scene.dimension == 3 && any_beyond(lateral, 1e-6))
        curves.push_back({"lateral", lateral, CurveStyle::line, true});
      add_panel("T / (" + scale_of_friction(scene.contact) + "N)", curves);
    }

    void Panels::add_load()
    {
      std::vector<Curve> curves{{"load N",
                                 scaled(column("normal_force_N"), 1e-3),
                                 CurveStyle::line,
                                 true}};
      if (!scene.inputs->time.normal_load.empty())
        {
          const DrivingFunctions driving =
            scene.inputs->time.histories(scene.contact,
                                         scene.inputs->prm_folder);
          Values given;
          for (const double time : column("force_time_s"))
            given.push_back(1e-3 * driving.normal_load->value(time));
          curves.push_back({"given load", given, CurveStyle::reference, true});
        }
      add_panel("N (kN)", curves);
    }

    void Panels::add_creepages()
    {
      std::vector<Curve> curves;
      for (const auto &[name, label] :
           {std::pair("creepage_x", "longitudinal creepage"),
            std::pair("creepage_y", "lateral creepage")})
        if (any_beyond(column(name), 0.))
          curves.push_back({label, scaled(column(name), 100.)});
      if (!curves.empty())
        add_panel("creepage (%)", curves);
      if (any_beyond(column("spin_1/m"), 0.))
        add_panel("spin (1/m)", {{"spin", column("spin_1/m")}});
    }
  } // namespace

  void plot_history(const Situation    &scene,
                    const HistoryTable &history,
                    RunContext         &context)
  {
    Panels(scene,
           history.columns({"time_s",
                            "force_time_s",
                            "rolled_m",
                            "approach_m",
                            "creepage_x",
                            "creepage_y",
                            "spin_1/m",
                            "speed_m/s",
                            "wheel_velocity_m/s",
                            "surface_height_m",
                            "normal_force_N",
                            "force_x_N",
                            "force_y_N"}))
      .draw(context);
  }
} // namespace RollingContact
