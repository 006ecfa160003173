// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/read_tables.hpp"

#include <array>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/scenario/density.hpp"

namespace hardball {
namespace {

void read_placement(const Section& section, SphereGroup& group) {
  section.refuse_both("placement", "positions", "remove one of the two", "placement");
  if (const auto positions = section.find("positions")) {
    group.placement = Placement::listed;
    group.positions = positions->vectors(group.dimensions);
    return;
  }
  const Value placement = section.need("placement");
  group.placement = static_cast<Placement>(placement.choice());
  const Placement lattice_of_others = group.dimensions == 2 ? Placement::fcc : Placement::hexagonal;
  if (group.placement != lattice_of_others) return;
  throw Error("placement is \"" + shortened(placement.text()) + "\" in a box of " +
                  (group.dimensions == 2 ? "two" : "three") + " dimensions",
              placement.location(),
              std::string("use \"") + (group.dimensions == 2 ? "hexagonal" : "fcc") + "\" or \"random\"");
}

void read_velocities(const Section& section, SphereGroup& group) {
  if (section.find("motion")) {
    for (const std::string_view name : kNames<VelocityRule>) {
      section.refuse_both("motion", name,
                          "remove one of the two: the motion gives the spheres their velocities", name);
    }
    return;
  }
  std::optional<VelocityRule> rule;
  for (std::size_t i = 0; i < kNames<VelocityRule>.size(); ++i) {
    const std::optional<Value> value = section.find(kNames<VelocityRule>[i]);
    if (!value) continue;
    if (rule) {
      const std::string_view first = name_of(*rule);
      throw Error(
          "both " + std::string(first) + " and " + std::string(kNames<VelocityRule>[i]) + " are given",
          value->location(), "keep one of mean_speed, temperature, speed and velocities");
    }
    rule = static_cast<VelocityRule>(i);
    if (rule == VelocityRule::listed) {
      group.velocities = value->vectors(group.dimensions);
    } else {
      group.velocity_scale = value->number();
    }
  }
  if (!rule) {
    throw Error("the spheres have no velocities", section.location(),
                "add mean_speed, temperature, speed (zero for rest) or velocities, or the motion of "
                "kinematic spheres");
  }
  group.velocity_rule = *rule;
}

// The number of spheres that fill a part of the box.
std::size_t read_packing_fraction(const Section& section, const Value& fraction, const SphereGroup& group,
                                  const Scenario& scenario) {
  for (const char* const other : {"count", "positions"})
    section.refuse_both("packing_fraction", other, "remove one of the two", "packing_fraction");
  if (scenario.packing_fraction) {
    throw Error("the box and the spheres both have a packing_fraction", fraction.location(),
                "give count here, from which the box follows, or give the box a size");
  }
  if (group.distribution) {
    throw Error("packing_fraction is given for spheres whose radii are distributed", fraction.location(),
                "give count here, and packing_fraction in [box] instead of size");
  }
  return count_for(fraction.number(), group, scenario.box, fraction.location());
}

// Lists give the count if it is missing, and must agree with it otherwise.
void read_count(const Section& section, const Scenario& scenario, SphereGroup& group) {
  const bool has_positions = group.placement == Placement::listed;
  const bool has_velocities = group.velocity_rule == VelocityRule::listed;
  if (const auto fraction = section.find("packing_fraction")) {
    group.count = read_packing_fraction(section, *fraction, group, scenario);
  } else if (const auto count = section.find("count")) {
    group.count = count->integer();
  } else if (has_positions || has_velocities) {
    group.count = has_positions ? group.positions.size() : group.velocities.size();
  } else {
    section.need("count", "packing_fraction");
  }
  const auto check_list = [&](std::string_view key, std::size_t length) {
    if (length == group.count && length > 0) return;
    section.need(key).wrong_length(length, "give one for each of the " + to_text(group.count) + " spheres");
  };
  if (has_positions) check_list("positions", group.positions.size());
  if (has_velocities) check_list("velocities", group.velocities.size());
}

RadiusDistribution read_distribution(const Section& section, const std::filesystem::path& folder) {
  using enum RadiusDistribution::Kind;
  RadiusDistribution radii;
  radii.where = section.location();
  radii.kind = static_cast<RadiusDistribution::Kind>(section.need("distribution").choice());
  switch (radii.kind) {
    case uniform:
    case powerlaw:
      radii.min = section.need("min").number();
      radii.max = section.need("max").number();
      if (radii.kind == powerlaw) radii.exponent = section.need("exponent").number();
      break;
    case lognormal:
      radii.mean = section.need("mean").number();
      radii.sigma = section.need("sigma").number();
      radii.min = kSmallestMagnitude;
      radii.max = kLargestMagnitude;
      if (const auto min = section.find("min")) radii.min = min->number();
      if (const auto max = section.find("max")) radii.max = max->number();
      break;
    case discrete: {
      radii.values = section.need("values").numbers();
      radii.weights = section.need("weights").numbers();
      if (radii.values.empty() || radii.weights.size() != radii.values.size()) {
        section.need("weights").wrong_length(radii.weights.size(),
                                             "give at least one radius, and as many weights");
      }
      return radii;
    }
    case file:
      radii.file = folder / section.need("file").text();
      return radii;
  }
  if (radii.min > radii.max) {
    throw Error("min is " + to_text(radii.min) + " and max is " + to_text(radii.max), radii.where,
                "give a max that is not less than min");
  }
  return radii;
}

void read_sizes(const Section& section, const std::filesystem::path& folder, SphereGroup& group) {
  const Value radius = section.need("radius");
  if (const auto distribution = radius.section()) {
    group.distribution = read_distribution(*distribution, folder);
  } else {
    group.radius = radius.number();
  }
  const std::optional<Value> mass = section.find("mass");
  if (!mass) return;
  if (const auto material = mass->section()) {
    group.density = material->need("density").number();
  } else {
    group.mass = mass->number();
  }
}

void read_spins(const Section& section, SphereGroup& group) {
  section.refuse_both("rotational_temperature", "spins");
  if (const auto temperature = section.find("rotational_temperature"))
    group.rotational_temperature = temperature->number();
  const std::optional<Value> spins = section.find("spins");
  if (!spins) return;
  group.spins = spins->vectors(kAxes);
  if (group.spins.size() != group.count) {
    spins->wrong_length(group.spins.size(), "give one for each of the " + to_text(group.count) + " spheres");
  }
}

}  // namespace

SphereGroup read_spheres(const Section& section, const std::filesystem::path& folder,
                         const Scenario& scenario) {
  SphereGroup group;
  group.dimensions = scenario.dimensions();
  group.where = section.location();
  read_placement(section, group);
  read_velocities(section, group);
  read_sizes(section, folder, group);
  read_count(section, scenario, group);
  read_spins(section, group);
  if (const auto name = section.find("species")) group.species = species_named(*name, scenario.species);
  if (const auto kinematic = section.find("kinematic")) group.is_kinematic = kinematic->truth();
  if (group.is_kinematic)
    section.refuse_both("mass", "kinematic",
                        "remove one of the two: the mass of kinematic spheres is infinite", "mass");
  if (const auto name = section.find("motion")) {
    group.motion = motion_named(*name, scenario.motions);
    if (!group.is_kinematic) {
      throw Error("a motion drives spheres that are not kinematic", name->location(),
                  "add kinematic = true, or remove the motion");
    }
  }
  return group;
}

}  // namespace hardball
