#include "random_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{
  std::string text_of(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
  }
} // namespace

RandomScene::RandomScene(const std::uint64_t seed, const unsigned int dimension)
  : random(seed)
  , dimension(dimension)
{
  sections[""]["Dimension"] = std::to_string(dimension);
  for (const std::string entry : {"Body fields", "Interface fields", "Plot"})
    sections["Output"][entry] = "false";
  choose_analysis();
  choose_shapes();
  choose_materials();
  choose_contact();
  choose_mesh();
  if (analysis == "transient")
    choose_time();
  if (analysis == "creep curve")
    sections["Creep curve"]["Creepage x"] =
      text_of(-largest_creepage) + " : " + text_of(largest_creepage) + " : " +
      std::to_string(random.integer(2, 5));
}

std::string RandomScene::prm() const
{
  std::string text;
  for (const auto &section : sections)
    {
      if (!section.first.empty())
        text += "subsection " + section.first + "\n";
      for (const auto &entry : section.second)
        text += "  set " + entry.first + " = " + entry.second + "\n";
      if (!section.first.empty())
        text += "end\n";
    }
  return text;
}

bool RandomScene::may_not_converge() const
{
  return papers_operators;
}

void RandomScene::set(const std::string &section,
                      const std::string &entry,
                      const double       value)
{
  sections[section][entry] = text_of(value);
}

void RandomScene::choose_analysis()
{
  const double draw        = random.between(0., 1.);
  analysis                 = draw < 0.6   ? "quasi-static"
                             : draw < 0.8 ? "creep curve"
                                          : "transient";
  sections[""]["Analysis"] = analysis;
}

void RandomScene::choose_shapes()
{
  wheel_radius = random.scale(0.05, 2.);
  smallest     = wheel_radius;
  set("Wheel", "Radius", wheel_radius);
  set("Wheel", "Hub radius", wheel_radius * random.between(0.1, 0.8));
  const bool twins       = random.chance(0.3);
  double     rail_radius = wheel_radius;
  if (twins)
    sections["Rail"] = sections["Wheel"];
  else if (random.chance(0.3))
    {
      rail_radius = random.scale(0.05, 20.);
      smallest    = std::min(smallest, rail_radius);
      set("Rail", "Radius", rail_radius);
      set("Rail", "Hub radius", rail_radius * random.between(0.1, 0.8));
    }
  else
    rail_radius = choose_block();
  relative_radius =
    1 / (1 / wheel_radius + (rail_radius == 0. ? 0. : 1 / rail_radius));
  are_twins = twins;
  if (dimension == 3)
    choose_lateral_shapes();
  else
    {
      thickness = random.scale(1e-3, 1.);
      for (const std::string body : {"Wheel", "Rail"})
        set(body, "Thickness", thickness);
    }
}

double RandomScene::choose_block()
{
  const double size         = wheel_radius * random.between(0.3, 2.);
  smallest                  = std::min(smallest, size);
  sections["Rail"]["Shape"] = "block";
  set("Rail", "Block depth", size);
  set("Rail", "Block length", 2 * size);
  const double draw = random.between(0., 1.);
  // deep grooves would reach the bottom of the block
  const double radius = draw < 0.4   ? 0.
                        : draw < 0.7 ? size * random.scale(1.5, 100.)
                                     : -std::max(wheel_radius, 1.5 * size) *
                                         random.scale(1.02, 20.);
  set("Rail", "Radius", radius);
  return radius;
}

void RandomScene::choose_lateral_shapes()
{
  const double wheel = wheel_radius * random.scale(0.3, 3.),
               rail =
                 random.chance(0.5) ? 0. : wheel_radius * random.scale(0.3, 3.);
  width = std::min(smallest, wheel) * 0.4;
  set("Wheel", "Lateral radius", wheel);
  set("Rail", "Lateral radius", are_twins ? wheel : rail);
  for (const std::string body : {"Wheel", "Rail"})
    set(body, "Width", width);
  smallest = std::min(smallest, width);
  relative_lateral =
    are_twins ? wheel / 2 : 1 / (1 / wheel + (rail > 0. ? 1 / rail : 0.));
}

void RandomScene::choose_materials()
{
  for (const std::string body : {"Wheel", "Rail"})
    {
      set(body, "Young modulus", random.scale(1e8, 1e12));
      set(body,
          "Poisson ratio",
          random.chance(0.1) ? 0.4999 : random.between(0., 0.49));
    }
  if (are_twins)
    for (const std::string entry : {"Young modulus", "Poisson ratio"})
      sections["Rail"][entry] = sections["Wheel"][entry];
  else if (random.chance(0.15))
    {
      rigid                    = random.chance(0.5) ? "Wheel" : "Rail";
      sections[rigid]["Rigid"] = "true";
    }
  double compliance = 0.;
  for (const std::string body : {"Wheel", "Rail"})
    if (body != rigid)
      compliance +=
        (1 - std::pow(std::stod(sections[body]["Poisson ratio"]), 2)) /
        std::stod(sections[body]["Young modulus"]);
  modulus = 1 / compliance;
}

void RandomScene::choose_contact()
{
  // a half-width that small strains, small angles and the bodies allow
  // in 3D not so small that the bodies around it take gigabytes
  half_width = random.scale(dimension == 2 ? 1e-4 : 2e-3, 0.04) *
               std::min(relative_radius, smallest);
  const double load = dimension == 2
                        ? std::acos(-1.) * modulus * half_width * half_width /
                            (4 * relative_radius) * thickness
                        : 4. / 3 * modulus * std::pow(half_width, 3) /
                            std::max(relative_radius, relative_lateral);
  if (random.chance(0.7))
    set("Contact", "Normal load", load);
  else
    set("Contact",
        "Approach",
        half_width * half_width / relative_radius * random.between(0.3, 3.));
  const double mu = random.chance(0.07)   ? 0.
                    : random.chance(0.05) ? 10.
                                          : random.scale(1e-3, 2.);
  set("Contact",
      "Friction coefficient",
      analysis == "creep curve" ? std::max(mu, 0.01) : mu);
  largest_creepage =
    std::max(mu, 0.01) * half_width / relative_radius * random.scale(0.01, 5.);
  set("Contact",
      "Creepage x",
      random.chance(0.1) ? 0. : random.sign() * largest_creepage);
  set("Contact", "Speed", random.sign() * random.scale(0.1, 100.));
  if (dimension == 3)
    {
      if (random.chance(0.5))
        set("Contact", "Creepage y", random.sign() * largest_creepage);
      if (random.chance(0.5))
        set("Contact",
            "Spin",
            random.sign() * largest_creepage / half_width *
              random.scale(0.1, 3.));
    }
  if (analysis == "quasi-static" && random.chance(0.1))
    sections["Contact"]["Roughness"] =
      text_of(half_width * half_width / relative_radius *
              random.between(0.01, 0.3)) +
      "*cos(2*pi*x/" + text_of(half_width * random.between(0.3, 2.)) + ")";
  const double draw                    = random.between(0., 1.);
  papers_operators                     = draw > 0.95;
  sections["Contact"]["Slip operator"] = draw < 0.7    ? "calibrated"
                                         : draw < 0.85 ? "upwind 2"
                                         : draw < 0.95 ? "upwind 1"
                                                       : "galerkin";
  if (random.chance(0.1))
    sections["Contact"]["Contact matrices"] = "balanced";
}

void RandomScene::choose_mesh()
{
  const bool flat = dimension == 2;
  set("Mesh", "Elements across patch", random.integer(2, flat ? 40 : 8));
  if (random.chance(0.1))
    sections["Mesh"]["Patch offset"] = "aligned";
  else
    set("Mesh", "Patch offset", random.between(-1., 1.));
  set("Mesh", "Candidate zone", random.between(1.1, flat ? 3. : 1.5));
  set("Mesh",
      "Growth",
      flat ? random.between(0.2, 1.5) : random.between(0.8, 1.5));
  set("Mesh", "Zone depth", random.between(0., flat ? 2. : 0.8));
  if (random.chance(0.15))
    {
      set("Mesh", "Rim levels", random.integer(1, flat ? 3 : 1));
      sections["Mesh"]["Rim edges"] = random.chance(0.5) ? "leading" : "both";
    }
  if (analysis != "transient" && random.chance(0.2))
    {
      set("Mesh", "Adaptive levels", random.integer(1, flat ? 3 : 1));
      set("Mesh", "Contact node budget", 400);
      sections["Mesh"]["Level marking"] =
        random.chance(0.5) ? "adaptive" : "uniform";
    }
}

void RandomScene::choose_time()
{
  const double speed   = std::abs(std::stod(sections["Contact"]["Speed"]));
  const double step    = half_width / speed * random.scale(1e-4, 1.);
  const int    n       = random.integer(3, dimension == 2 ? 20 : 5);
  const bool   inertia = random.chance(0.5);
  set("Time", "Time step", step);
  set("Time", "End time", n * step);
  sections["Time"]["Inertia"] = inertia ? "true" : "false";
  sections["Time"]["Initial state"] =
    inertia || random.chance(0.5) ? "steady" : "rest";
  set("Time", "Theta", random.between(0.5, 1.));
  set("Time", "Field interval", 0);
  sections["Time"]["Creepage x"] =
    sections["Contact"]["Creepage x"] + " * cos(" +
    text_of(random.between(0., 3.) / step) + " * t)";
}
