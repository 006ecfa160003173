// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/features.hpp"

#include <algorithm>
#include <array>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// By the number of the feature.
constexpr std::array<FeatureDescription, kFeatures> kDescriptions = {{
    {"two dimensions", "", "the box is flat, and the spheres are discs"},
    {"gravity", "", "all spheres have one constant acceleration"},
    {"growth", "growth", "the radii of all spheres change at one rate"},
    {"shear", "shear", "the periodic images of the box slide along each other"},
    {"potentials of steps", "potential", "wells, shoulders or bonds act between spheres"},
    {"merging", "", "spheres of some species merge when they touch"},
    {"response functions", "", "a function of the program decides what contacts do"},
    {"passing", "", "spheres of some species pass through each other"},
    {"roughness or spins", "", "contacts change spins, or spheres have spins"},
    {"kinematic spheres", "", "spheres of infinite mass, which no contact deflects"},
    {"moving walls", "", "walls have a velocity"},
    {"thermal walls", "", "walls have a temperature"},
    {"oscillating walls", "", "planes move to and fro"},
    {"walls other than planes", "", "cylinders, cones, hollow spheres, obstacles or meshes"},
    {"obstacles in a periodic box", "", "obstacles, which have images"},
    {"prescribed motions", "motions", "kinematic spheres or walls follow a timetable"},
    {"kinematic spheres without a motion", "", "spheres of infinite mass that no prescribed motion drives"},
    {"thermostats", "", "velocities are changed at times of their own"},
    {"births and deaths", "", "spheres are added or removed in a run"},
    {"measures", "measures", "quantities are measured in a run"},
    {"threads", "threads", "several threads share one system"},
    {"processes", "processes", "several processes share one system"},
    {"the engine all-pairs", "engine", "every sphere is compared with every other"},
    {"the engine paper", "engine", "the algorithm of the paper to the letter"},
    {"ray", "ray", "the question what a ray hits first"},
    {"first_contact", "first_contact", "the question what a sphere would touch first"},
}};

constexpr std::string_view kOneThread = "use one thread, or as many as pay";
constexpr std::string_view kOneProcess = "leave it out, or run it in one process";
constexpr std::string_view kSharedEngine = "use cells or neighbors, or run it in one process";
constexpr std::string_view kOtherEngine = "use another engine";
constexpr std::string_view kNoMeasures = "run without measures, in scenarios by names = []";
constexpr std::string_view kRemoveOne = "remove one of them";
constexpr std::string_view kBounce = "let them bounce";
constexpr std::string_view kSliding = "the box is sheared, and its images slide";
constexpr std::string_view kAtRest =
    "use a box at rest; next_contact of a simulation knows images that slide";

// Where several apply, errors state the first.
constexpr auto kExclusions = [] {
  using enum Feature;
  return std::to_array<Exclusion>({
      {growth, kinematic, "spheres grow, and some are kinematic, of infinite mass",
       "give them a finite mass"},
      {growth, roughness, "spheres grow, and spheres or walls are rough, or spheres spin",
       "make them smooth"},
      {growth, gravity, "spheres grow, and there is gravity", kRemoveOne},
      {growth, merging, "spheres grow, and some merge", kBounce},
      {growth, passing, "spheres grow, and some pass through each other", kBounce},
      {growth, steps, "spheres grow, and there are potentials of steps", kRemoveOne},
      {growth, shear, "spheres grow, and the box is sheared", kRemoveOne},
      {growth, moving_walls, "spheres grow, and a wall moves", "keep it at rest"},
      {growth, thermal_walls, "spheres grow, and a wall has a temperature", "let it reflect them"},
      {growth, oscillating_walls, "spheres grow, and a wall oscillates", "keep it at rest"},
      {shear, gravity, "the box is sheared, and there is gravity", kRemoveOne},
      {shear, steps, "the box is sheared, and there are potentials of steps", kRemoveOne},
      {shear, curved_walls, "the box is sheared, and a surface is not a plane",
       "use planes across z, or no surfaces"},
      {steps, gravity, "there are potentials of steps, and there is gravity", kRemoveOne},
      {steps, merging, "there are potentials of steps, and some spheres merge", kBounce},
      {undriven, gravity, "a kinematic sphere, of infinite mass, does not fall",
       "let a motion drive it, give it a finite mass, or remove gravity"},
      {motions, growth, "spheres grow, and motions are prescribed", kRemoveOne},
      {motions, shear, "the box is sheared, and motions are prescribed", kRemoveOne},
      {births, growth, "spheres grow, and their number must stay",
       "add or remove them before growth begins, or stop it"},
      {measures, kinematic, "measures do not support kinematic spheres", kNoMeasures},
      {measures, growth, "measures do not support spheres that grow", kNoMeasures},
      {measures, merging, "measures do not support spheres that merge", kNoMeasures},
      {processes, custom_response, "processes cannot share a response that is a function", kOneProcess},
      {processes, merging, "processes cannot share spheres that merge", kOneProcess},
      {processes, steps, "processes cannot share spheres with potentials of steps", kOneProcess},
      {processes, shear, "processes cannot share a sheared box", kOneProcess},
      {all_pairs, processes, "the engine all-pairs has one process", kSharedEngine},
      {paper, processes, "the engine paper has one process", kSharedEngine},
      {threads, custom_response, "threads cannot share a response that is a function", kOneThread},
      {threads, merging, "threads cannot share spheres that merge", kOneThread},
      {threads, steps, "threads cannot share spheres with potentials of steps", kOneThread},
      {threads, shear, "threads cannot share a sheared box", kOneThread},
      {paper, gravity, "the engine paper knows only straight paths, and there is gravity", kOtherEngine},
      {paper, shear, "the engine paper knows no images that slide, and the box is sheared", kOtherEngine},
      {paper, obstacle_images, "the engine paper knows no images of obstacles, and the box is periodic",
       kOtherEngine},
      {ray, shear, kSliding, kAtRest},
      {first_contact, growth, "spheres grow, and it is not known how long",
       "ask when their sizes are constant"},
      {first_contact, shear, kSliding, kAtRest},
      {first_contact, steps, "spheres have potentials of steps, by which paths bend",
       "ask for the next contact of the simulation"},
  });
}();

constexpr auto kExcluded = [] {
  std::array<Features, kFeatures> excluded;
  for (const Exclusion& pair : kExclusions) {
    excluded[static_cast<std::size_t>(pair.first)].add(pair.second, true);
    excluded[static_cast<std::size_t>(pair.second)].add(pair.first, true);
  }
  return excluded;
}();

}  // namespace

const FeatureDescription& description(Feature feature) {
  return kDescriptions[static_cast<std::size_t>(feature)];
}

std::span<const Exclusion> exclusions() {
  return kExclusions;
}

Features excluded_by(Features features) {
  Features excluded;
  for (std::size_t number = 0; number < kFeatures; ++number) {
    if (features.has(static_cast<Feature>(number))) excluded = excluded | kExcluded[number];
  }
  return excluded;
}

void check_exclusions(Features features) {
  if ((excluded_by(features) & features).is_empty()) return;
  for (const Exclusion& pair : kExclusions) {
    if (features.has(pair.first))
      check_exclusions(pair.first, features, std::string(description(pair.first).where));
  }
}

void check_exclusions(Feature feature, Features others, const std::string& where) {
  for (const Exclusion& pair : kExclusions) {
    if (pair.first == feature && others.has(pair.second))
      throw Error(std::string(pair.what), where, std::string(pair.remedy));
  }
}

}  // namespace hardball
