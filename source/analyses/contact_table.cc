#include <rolling_contact/analyses/contact_table.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/scene/shared_rules.h>
#include <rolling_contact/surfaces/profile_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    const char contact_table_file[] = "contact_table.csv";

    const double jump = 1e-3; // m, of a contact point from shift to shift

    const double widest_gap = 1e-3; // m, that the picture of gaps shows

    /**
     * 1 / curvature, 0 where it is flat. Units: m.
     */
    double radius_of(const double curvature)
    {
      return std::abs(curvature) < 1e-6 ? 0. : 1 / curvature;
    }

    void set_contact(const std::string            &side,
                     const Profiles::RigidContact &contact,
                     const double                  sign,
                     ResultsTable                 &table)
    {
      table.set(side + "_x_m", contact.x);
      table.set(side + "_y_track_m", sign * contact.y);
      table.set(side + "_z_track_m", contact.z);
      table.set(side + "_y_wheel_m", contact.y_wheel);
      table.set(side + "_y_rail_m", contact.y_rail);
      table.set(side + "_angle_rad", contact.angle);
      table.set(side + "_rolling_radius_m", contact.rolling_radius);
      table.set(side + "_wheel_lateral_radius_m",
                radius_of(contact.wheel_curvature));
      table.set(side + "_rail_lateral_radius_m",
                radius_of(contact.rail_curvature));
      table.set(side + "_spin_1/m",
                -sign * std::sin(contact.angle) / contact.rolling_radius);
    }

    std::vector<double> scaled(std::vector<double> values, const double factor)
    {
      for (double &value : values)
        value *= factor;
      return values;
    }
  } // namespace

  ContactTable::ContactTable(const Situation &scene, RunContext &context)
    : scene(scene)
    , context(context)
  {
    const std::filesystem::path &folder = scene.inputs->prm_folder;
    if (scene.profiles.has_radius_difference())
      radius_difference = scene.profiles.radius_difference(folder);
    else
      side.emplace(scene.profiles.wheel(folder),
                   scene.profiles.rail(folder),
                   scene.wheel.radius,
                   scene.profiles.tape_circle());
  }

  ContactTable::Row ContactTable::find(const double shift) const
  {
    const double yaw  = scene.profiles.yaw;
    const double roll = Profiles::resting_roll(*side, *side, shift, yaw);
    return {shift,
            roll,
            side->first_contact({shift, roll, yaw}),
            side->first_contact(Profiles::mirrored({shift, roll, yaw}))};
  }

  void ContactTable::run()
  {
    {
      PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
      if (side)
        for (const double shift : scene.profiles.shifts)
          {
            throw_if_interrupted();
            rows.push_back(find(shift));
            radius_difference.shift.push_back(shift);
            radius_difference.difference.push_back(
              rows.back().right.rolling_radius -
              rows.back().left.rolling_radius);
          }
    }
    find_conicities();
    write_rows();
    if (side)
      summarise_contacts();
    summarise_conicity();
    if (!scene.inputs->output.plot)
      return;
    PhaseTimer::Scope phase(context.timer, Phase::fields);
    if (side)
      plot_sections();
    if (rows.size() > 1)
      plot_gaps();
    if (radius_difference.shift.size() > 1)
      plot_steering();
  }

  void ContactTable::find_conicities()
  {
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    for (const double amplitude : radius_difference.shift)
      {
        const bool known = amplitude > 0. && radius_difference.shift.size() > 1;
        harmonic.push_back(
          known ? Profiles::harmonic_conicity(radius_difference, amplitude)
                : std::nan(""));
        equivalent.push_back(
          known ? Profiles::equivalent_conicity(radius_difference, amplitude)
                : std::nan(""));
      }
  }

  void ContactTable::write_rows()
  {
    ResultsTable table(context.folder, contact_table_file);
    for (std::size_t k = 0; k < radius_difference.shift.size(); ++k)
      {
        table.set("lateral_shift_m", radius_difference.shift[k]);
        if (side)
          {
            table.set("roll_rad", rows[k].roll);
            table.set("height_m", rows[k].right.height);
            set_contact("right", rows[k].right, 1., table);
            set_contact("left", rows[k].left, -1., table);
          }
        table.set("rolling_radius_difference_m",
                  radius_difference.difference[k]);
        for (const auto &[column, conicity] :
             {std::pair("conicity_harmonic", harmonic[k]),
              std::pair("conicity_en_15302", equivalent[k])})
          table.set_if(!std::isnan(conicity), column, conicity);
        table.end_row();
      }
    table.flush();
    const std::size_t n      = table.n_rows(),
                      stride = std::max<std::size_t>(1, (n + 18) / 20);
    context.log.message(table.screen_table({"lateral_shift_m",
                                            "right_y_rail_m",
                                            "rolling_radius_difference_m",
                                            "conicity_en_15302"},
                                           stride));
    if (stride > 1)
      context.log.message("One shift in " + std::to_string(stride) +
                          " is shown; all " + std::to_string(n) + " are in " +
                          contact_table_file + ".");
  }

  void ContactTable::summarise_contacts() const
  {
    std::string jumps;
    for (std::size_t k = 1; k < rows.size(); ++k)
      if (std::abs(rows[k].right.y_wheel - rows[k - 1].right.y_wheel) > jump)
        jumps += (jumps.empty() ? "" : ", ") +
                 significant(1e3 * rows[k - 1].right.y_wheel, 4) + " to " +
                 significant(1e3 * rows[k].right.y_wheel, 4) + " mm at " +
                 significant(1e3 * rows[k].shift, 4) + " mm";
    context.report.set_finding("touch",
                               std::to_string(rows.size()) +
                                 " shifts; the right contact jumps " +
                                 (jumps.empty()
                                    ? "nowhere by more than 1 mm"
                                    : "on the wheel from " + jumps));
    if (const auto flange = Profiles::flange_measures(side->wheel_profile()))
      context.report.set_finding("flange",
                                 "height Sh " + millimetres(flange->height, 5) +
                                   ", thickness Sd " +
                                   millimetres(flange->thickness, 5) + ", qR " +
                                   millimetres(flange->qr, 5));
    const bool measured = scene.profiles.has_files();
    context.report.errors.push_back(
      {"contact points",
       std::nan(""),
       "",
       "rigid surfaces; the search is exact for the profiles" +
         std::string(measured
                       ? ", but 5 um of noise in a file move the contact "
                         "of profiles that lie close by about 0.5 mm"
                       : ""),
       true,
       ""});
  }

  void ContactTable::summarise_conicity() const
  {
    if (!side)
      context.report.errors.push_back({"conicity",
                                       std::nan(""),
                                       "",
                                       "exact for straight lines between the "
                                       "rows of the file",
                                       true,
                                       ""});
    const double amplitude = scene.profiles.conicity_amplitude;
    const double harmonic =
      radius_difference.shift.size() > 1
        ? Profiles::harmonic_conicity(radius_difference, amplitude)
        : std::nan("");
    if (std::isnan(harmonic))
      {
        context.report.set_finding("cone",
                                   "conicity not known at an amplitude of " +
                                     millimetres(amplitude) +
                                     ": the shifts do not reach it on both "
                                     "sides");
        return;
      }
    const double equivalent =
      Profiles::equivalent_conicity(radius_difference, amplitude);
    context.report.set_finding(
      "cone",
      "conicity " + significant(harmonic, 4) + " (harmonic), " +
        (std::isnan(equivalent)
           ? std::string("the wheelset is not driven back (EN 15302)")
           : significant(equivalent, 4) + " (EN 15302)") +
        " at an amplitude of " + millimetres(amplitude));
  }

  /**
   * Both sections of the right-hand side in the first position of the wheelset
   * without shift or the nearest to it, and where they touch at every shift.
   */
  void ContactTable::plot_sections() const
  {
    const Profiles::ProfileCurve &rail  = side->rail_profile(),
                                 &wheel = side->wheel_profile();
    const Row &middle =
      *std::min_element(rows.begin(),
                        rows.end(),
                        [](const Row &a, const Row &b) {
                          return std::abs(a.shift) < std::abs(b.shift);
                        });
    std::vector<double> y, z, points_y, points_z;
    Figure              figure("Contact points on the rail, right-hand side",
                  "y from the middle of the track (mm)",
                  "height (mm)");
    const auto          add = [&](const std::string &label) {
      figure.add_curve(label, y, z, CurveStyle::line);
      y.clear();
      z.clear();
    };
    for (const auto &point : rail.points())
      {
        y.push_back(1e3 * point.y);
        z.push_back(-1e3 * point.z);
      }
    add("rail");
    const Profiles::WheelsetPosition position{middle.shift,
                                              middle.roll,
                                              scene.profiles.yaw};
    for (const double s : wheel.arc_lengths())
      {
        const auto [across, down] = side->section(position, s);
        y.push_back(1e3 * across);
        z.push_back(-1e3 * (down + middle.right.height));
      }
    add("wheel, shifted by " + millimetres(middle.shift));
    for (const Row &row : rows)
      {
        points_y.push_back(1e3 * row.right.y);
        points_z.push_back(-1e3 * row.right.z);
      }
    figure.add_curve("first contact of each shift",
                     points_y,
                     points_z,
                     CurveStyle::points);
    figure.draw(context, "contact_points");
  }

  /**
   * The gap between wheel and rail over the place on the wheel and the shift.
   */
  void ContactTable::plot_gaps() const
  {
    const unsigned int  n      = 400;
    const double        length = side->wheel_profile().length();
    std::vector<double> y, gaps;
    for (unsigned int k = 0; k <= n; ++k)
      y.push_back(1e3 * side->wheel_profile().at(length * k / n).y);
    for (const Row &row : rows)
      for (unsigned int k = 0; k <= n; ++k)
        {
          const auto gap = side->gap({row.shift, row.roll, scene.profiles.yaw},
                                     length * k / n);
          gaps.push_back(gap
                           ? 1e3 * std::min(*gap - row.right.height, widest_gap)
                           : std::numeric_limits<double>::quiet_NaN());
        }
    Figure figure("Gap between wheel and rail, right-hand side",
                  "y on the wheel's profile (mm)",
                  "lateral shift (mm)");
    figure.add_map("gap in mm, yellow: 1 mm and more",
                   y,
                   scaled(radius_difference.shift, 1e3),
                   gaps);
    figure.draw(context, "gaps");
  }

  /**
   * The difference of the rolling radii and the conicities.
   */
  void ContactTable::plot_steering() const
  {
    Figure figure("Steering of the wheelset",
                  "lateral shift, amplitude (mm)",
                  "r right \u2212 r left (mm)");
    figure.add_curve("",
                     scaled(radius_difference.shift, 1e3),
                     scaled(radius_difference.difference, 1e3));
    const std::vector<double> amplitude = scaled(radius_difference.shift, 1e3);
    Figure conicity("", "lateral shift, amplitude (mm)", "conicity");
    conicity.add_curve("harmonic", amplitude, harmonic);
    conicity.add_curve("EN 15302", amplitude, equivalent, CurveStyle::dashed);
    figure.add_panel(conicity);
    figure.draw(context, "steering");
  }

  AnalysisKind contact_table_kind()
  {
    AnalysisKind kind = kind_of<ContactTable>(
      "contact table",
      "where rigid wheel and rail profiles touch, see section Profiles");
    kind.sections   = {"Contact table"};
    kind.has_bodies = kind.has_contact = false;
    kind.on_ranks                      = false;
    kind.rules                         = {&check_rigid_profiles};
    return kind;
  }
} // namespace RollingContact
