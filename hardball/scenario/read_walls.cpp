// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/read_tables.hpp"

#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

// A vector of any length but zero.
Vec3 read_direction(const Section& section, const std::string& key, std::size_t dimensions) {
  const Value value = section.need(key);
  const Vec3 direction = value.vector(dimensions);
  check_positive(std::hypot(direction.x, direction.y, direction.z), "the length of " + key, value.location());
  return direction;
}

// Restitution and temperature of a face, a wall or an obstacle.
template <class Description>
void read_surface(const Section& section, Description& surface) {
  if (const auto restitution = section.find("restitution")) surface.restitution = restitution->number();
  if (const auto temperature = section.find("temperature")) {
    surface.temperature = temperature->number();
    if (surface.restitution) {
      throw Error(
          "both restitution and temperature are given", temperature->location(),
          "remove one of the two: the velocities with which spheres leave a thermal wall do not depend on "
          "those before");
    }
  }
}

void read_motion(const Section& section, std::size_t dimensions, WallDescription& wall) {
  const std::optional<Value> velocity = section.find("velocity");
  if (velocity) wall.velocity = velocity->vector(dimensions);
  if (wall.shape != WallDescription::Shape::plane) return;
  const std::optional<Value> amplitude = section.find("amplitude");
  const std::optional<Value> frequency = section.find("frequency");
  if (!amplitude && !frequency) return;
  if (velocity) {
    throw Error("both velocity and " + std::string(amplitude ? "amplitude" : "frequency") + " are given",
                velocity->location(), "a plane either moves evenly or oscillates; remove one of the two");
  }
  wall.amplitude = section.need("amplitude").number();
  wall.frequency = section.need("frequency").number();
}

WallDescription read_wall(const Section& section, std::size_t dimensions) {
  using Shape = WallDescription::Shape;
  WallDescription wall;
  wall.where = section.location();
  wall.shape = static_cast<Shape>(section.need("shape").choice());
  wall.point = section.need("point").vector(dimensions);
  if (wall.shape == Shape::plane) wall.direction = read_direction(section, "normal", dimensions);
  if (wall.shape == Shape::cylinder || wall.shape == Shape::cone)
    wall.direction = read_direction(section, "axis", dimensions);
  if (wall.shape == Shape::cone) wall.slope = section.need("slope").number();
  if (wall.shape == Shape::cylinder || wall.shape == Shape::sphere)
    wall.radius = section.need("radius").number();
  read_surface(section, wall);
  read_motion(section, dimensions, wall);
  return wall;
}

std::vector<Vec3> read_positions(const Section& section, std::size_t dimensions) {
  const std::optional<Value> position = section.find("position");
  const std::optional<Value> positions = section.find("positions");
  if (position && positions) {
    throw Error("both position and positions are given", positions->location(), "remove one of the two");
  }
  if (positions) return positions->vectors(dimensions);
  return {section.need("position").vector(dimensions)};
}

}  // namespace

std::vector<FaceDescription> read_faces(const Section& box, std::size_t dimensions) {
  std::vector<FaceDescription> faces;
  const std::optional<Section> table = box.section("faces");
  for (Face face = 0; table && face < kFaces; ++face) {
    const std::optional<Section> section = table->section(kFaceNames[face]);
    if (!section) continue;
    FaceDescription description;
    description.face = face;
    description.where = section->location();
    read_surface(*section, description);
    if (const auto velocity = section->find("velocity")) description.velocity = velocity->vector(dimensions);
    faces.push_back(description);
  }
  return faces;
}

std::vector<WallDescription> read_walls(const Section& root, std::size_t dimensions) {
  std::vector<WallDescription> walls;
  for (const Section& section : root.sections("walls")) walls.push_back(read_wall(section, dimensions));
  return walls;
}

std::vector<ObstacleDescription> read_obstacles(const Section& root, std::size_t dimensions) {
  std::vector<ObstacleDescription> obstacles;
  for (const Section& section : root.sections("obstacles")) {
    ObstacleDescription obstacle;
    obstacle.where = section.location();
    obstacle.radius = section.need("radius").number();
    read_surface(section, obstacle);
    for (const Vec3& position : read_positions(section, dimensions)) {
      obstacle.position = position;
      obstacles.push_back(obstacle);
    }
  }
  return obstacles;
}

}  // namespace hardball
