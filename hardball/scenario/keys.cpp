// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/keys.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

using enum ValueType;
using enum NumberRange;

std::shared_ptr<const TableDescription> make(TableDescription table) {
  return std::make_shared<const TableDescription>(std::move(table));
}

// How a fixed surface reflects spheres.
std::vector<KeyDescription> surface_keys() {
  return {
      {.name = "restitution",
       .range = fraction,
       .meaning = "the restitution of contacts with it; that of `[response]` if not given",
       .example = "0.8"},
      {.name = "temperature",
       .range = not_negative,
       .dimension = "M L²/T²",
       .meaning = "instead of `restitution`: a thermal wall, which spheres leave with velocities of this kT",
       .example = "1.0"}};
}

TableDescription faces_keys() {
  std::vector<KeyDescription> keys = surface_keys();
  keys.push_back({.name = "velocity",
                  .type = vector,
                  .dimension = "L/T",
                  .default_value = "[0.0, 0.0, 0.0]",
                  .meaning =
                      "its constant velocity, along the face: it drags spheres along if it is thermal, or if "
                      "they are rough",
                  .example = "[1.0, 0.0, 0.0]"});
  const std::shared_ptr<const TableDescription> face = make({.title = "face", .keys = std::move(keys)});
  constexpr std::array<std::string_view, kFaces> kMeanings{
      "the face at x = 0", "the face at the size along x",
      "the face at y = 0", "the face at the size along y",
      "the face at z = 0", "the face at the size along z"};
  TableDescription faces{.title = "[box.faces]", .keys = {}};
  for (Face number = 0; number < kFaces; ++number) {
    faces.keys.push_back(
        {.name = kFaceNames[number], .type = table, .meaning = kMeanings[number], .table = face});
  }
  return faces;
}

TableDescription box_keys() {
  return {
      .title = "[box]",
      .keys = {
          {.name = "dimensions",
           .type = integer,
           .least = 2,
           .most = 3,
           .default_value = "3",
           .meaning = "2 for discs in a plane: the spheres have z = 0. Then `boundary` and `size` are for x "
                      "and y, vectors may have two numbers, and volumes are areas",
           .example = "2"},
          {.name = "boundary",
           .type = choices,
           .choices = {"wall", "periodic", "open"},
           .is_required = true,
           .meaning = "the boundaries of the box along x, y and z",
           .example = R"(["wall", "wall", "wall"])"},
          {.name = "size",
           .type = numbers,
           .range = positive,
           .dimension = "L",
           .meaning =
               "edge lengths; the box spans 0 to size. Three numbers, or one for each axis that is not "
               "open. For an open axis it only says where placement puts spheres",
           .example = "[10.0, 10.0, 10.0]"},
          {.name = "packing_fraction",
           .range = positive,
           .meaning = "instead of `size`: the fraction of the volume that the spheres fill; the box is a "
                      "cube, in two dimensions a square, with the edge that follows",
           .example = "0.3"},
          {.name = "gravity",
           .type = vector,
           .dimension = "L/T²",
           .default_value = "[0.0, 0.0, 0.0]",
           .meaning = "the acceleration of every sphere",
           .example = "[0.0, 0.0, -9.81]"},
          {.name = "shear_rate",
           .dimension = "1/T",
           .default_value = "0.0",
           .meaning = "how much the flow along x grows along y: images of the box above and below slide "
                      "along x (Lees-Edwards boundaries). x and y must be periodic. Velocities that are "
                      "drawn are relative to this flow",
           .example = "0.1"},
          {.name = "shear_offset",
           .dimension = "L",
           .default_value = "0.0",
           .meaning = "the displacement of the image above along x at time zero, modulo the width of the "
                      "box. If not given, it is the tilt of the box in a start file",
           .example = "3.5"},
          {.name = "faces",
           .type = table,
           .meaning = "properties of its faces that are walls",
           .table = make(faces_keys())},
      }};
}

TableDescription radius_keys() {
  return {
      .title = "radius",
      .keys = {
          {.name = "distribution",
           .type = choice,
           .choices = {"uniform", "lognormal", "powerlaw", "discrete", "file"},
           .is_required = true,
           .meaning = "the kind of distribution",
           .example = "\"uniform\""},
          {.name = "min",
           .range = positive,
           .dimension = "L",
           .is_required = true,
           .meaning = "the smallest radius",
           .example = "0.5",
           .only_for = {"uniform", "powerlaw"}},
          {.name = "max",
           .range = positive,
           .dimension = "L",
           .is_required = true,
           .meaning = "the largest radius",
           .example = "1.0",
           .only_for = {"uniform", "powerlaw"}},
          {.name = "mean",
           .range = positive,
           .dimension = "L",
           .is_required = true,
           .meaning = "the mean radius of the distribution without `min` and `max`",
           .example = "1.0",
           .only_for = {"lognormal"}},
          {.name = "sigma",
           .range = positive,
           .is_required = true,
           .meaning = "the standard deviation of the natural logarithm of the radius",
           .example = "0.25",
           .only_for = {"lognormal"}},
          {.name = "min",
           .range = positive,
           .dimension = "L",
           .meaning = "smaller radii are rejected and redrawn",
           .example = "0.5",
           .only_for = {"lognormal"}},
          {.name = "max",
           .range = positive,
           .dimension = "L",
           .meaning = "larger radii are rejected and redrawn",
           .example = "2.0",
           .only_for = {"lognormal"}},
          {.name = "exponent",
           .is_required = true,
           .meaning = "the density of radii is proportional to this power of the radius",
           .example = "-2.5",
           .only_for = {"powerlaw"}},
          {.name = "values",
           .type = numbers,
           .range = positive,
           .dimension = "L",
           .is_required = true,
           .meaning = "the radii",
           .example = "[0.5, 1.0]",
           .only_for = {"discrete"}},
          {.name = "weights",
           .type = numbers,
           .range = positive,
           .is_required = true,
           .meaning = "how many spheres have each of the `values`, in proportion: exactly, up to less than "
                      "one sphere",
           .example = "[3.0, 1.0]",
           .only_for = {"discrete"}},
          {.name = "file",
           .type = text,
           .is_required = true,
           .meaning =
               "a text file with a radius [L] on each of `count` lines; its path is relative to the scenario",
           .example = "\"radii.txt\"",
           .only_for = {"file"}},
      }};
}

TableDescription mass_keys() {
  return {.title = "mass",
          .keys = {{.name = "density",
                    .range = positive,
                    .dimension = "M/L³",
                    .is_required = true,
                    .meaning = "the density of the material: a sphere of radius r has the mass 4π/3 r³ times "
                               "this, a disc π r² times this [M/L²]",
                    .example = "2.0"}}};
}

TableDescription spheres_keys() {
  // Ids are below 2^32, and the largest stands for none.
  constexpr std::uint64_t kMaxSpheres = std::numeric_limits<SphereId>::max() - 1;
  return {
      .title = "[[spheres]]",
      .keys =
          {
              {.name = "count",
               .type = integer,
               .least = 1,
               .most = kMaxSpheres,
               .meaning = "their number; may be left out where a list gives it",
               .example = "1000"},
              {.name = "packing_fraction",
               .range = positive,
               .meaning =
                   "instead of `count`: the fraction of the volume of the box that these spheres fill, "
                   "to the nearest whole number of them",
               .example = "0.3"},
              {.name = "radius",
               .range = positive,
               .dimension = "L",
               .is_required = true,
               .meaning = "their radius, or how their radii are distributed",
               .example = "1.0",
               .table = make(radius_keys())},
              {.name = "mass",
               .range = positive,
               .dimension = "M",
               .default_value = "1.0",
               .meaning = "their mass, or the density from which their masses follow",
               .example = "2.0",
               .table = make(mass_keys())},
              {.name = "placement",
               .type = choice,
               .choices = {"random", "fcc", "hexagonal"},
               .meaning = "`\"random\"`: anywhere without overlap with each other and with spheres that are "
                          "listed; beyond a packing fraction of 0.36 for equal spheres and 0.54 for equal "
                          "discs they grow into place, up to .97 of the packing fraction at which they jam; "
                          "`\"fcc\"`: on a face-centered cubic lattice that fills the box; "
                          "`\"hexagonal\"`: on a hexagonal lattice, for discs",
               .example = "\"random\""},
              {.name = "positions",
               .type = vectors,
               .dimension = "L",
               .meaning = "instead of `placement`: their centers",
               .example = "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]"},
              {.name = "mean_speed",
               .range = not_negative,
               .dimension = "L/T",
               .meaning = "Maxwell velocities with this mean of |v|",
               .example = "1.0"},
              {.name = "temperature",
               .range = not_negative,
               .dimension = "M L²/T²",
               .meaning = "or: Maxwell velocities with this kT = m⟨v²⟩/3, in two dimensions m⟨v²⟩/2",
               .example = "1.0"},
              {.name = "speed",
               .range = not_negative,
               .dimension = "L/T",
               .meaning = "or: this |v| in random directions",
               .example = "1.0"},
              {.name = "velocities",
               .type = vectors,
               .dimension = "L/T",
               .meaning = "or: each velocity",
               .example = "[[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]"},
              {.name = "rotational_temperature",
               .range = not_negative,
               .dimension = "M L²/T²",
               .default_value = "0.0",
               .meaning = "normally distributed spins with this I⟨w²⟩/3, or I⟨w²⟩ in two dimensions",
               .example = "1.0"},
              {.name = "spins",
               .type = vectors,
               .dimension = "1/T",
               .meaning = "instead of `rotational_temperature`: each angular velocity",
               .example = "[[0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]"},
              {.name = "species",
               .type = text,
               .meaning = "the name of their species; the first of `[[species]]` if not given",
               .example = "\"steel\""},
              {.name = "kinematic",
               .type = truth,
               .default_value = "false",
               .meaning = "whether their mass is infinite, so that no collision deflects them; two of these "
                          "pass through each other",
               .example = "true"},
          },
      .one_of = {{"placement", "positions"}, {"mean_speed", "temperature", "speed", "velocities"}},
  };
}

TableDescription start_keys() {
  return {
      .title = "[start]",
      .keys = {
          {.name = "file",
           .type = text,
           .is_required = true,
           .meaning = "a file with spheres, whose last frame is used: extended XYZ (`.xyz`), GSD (`.gsd`), "
                      "LAMMPS dump (`.lammpstrj`), LAMMPS data file (`.data`), CSV (`.csv`), NumPy (`.npy`) "
                      "or the format of Smallenburg's EDMD codes (`.sph`); text may be compressed (`.zst`); "
                      "its path is relative to the scenario",
           .example = "\"start.xyz\""},
          {.name = "mean_speed",
           .range = not_negative,
           .dimension = "L/T",
           .meaning = "for spheres that have no velocities, or are all at rest: Maxwell velocities with this "
                      "mean of |v|",
           .example = "1.0"},
          {.name = "temperature",
           .range = not_negative,
           .dimension = "M L²/T²",
           .meaning = "or: Maxwell velocities with this kT; masses that the file does not give are 1",
           .example = "1.0"},
          {.name = "shrink",
           .type = truth,
           .default_value = "false",
           .meaning = "whether all radii are multiplied by the largest factor, up to 1, at which no spheres "
                      "overlap and none reaches through a wall; the run prints the factor",
           .example = "true"}}};
}

TableDescription restitution_keys() {
  return {.title = "restitution",
          .keys = {
              {.name = "law",
               .type = choice,
               .choices = {"viscoelastic", "tabulated"},
               .is_required = true,
               .meaning = "how the restitution depends on the impact speed, the normal relative speed before "
                          "the contact",
               .example = "\"viscoelastic\""},
              {.name = "value",
               .range = fraction,
               .is_required = true,
               .meaning = "the restitution at the impact speed `speed`; slower impacts are more elastic",
               .example = "0.8",
               .only_for = {"viscoelastic"}},
              {.name = "speed",
               .range = positive,
               .dimension = "L/T",
               .is_required = true,
               .meaning = "an impact speed",
               .example = "1.0",
               .only_for = {"viscoelastic"}},
              {.name = "speeds",
               .type = numbers,
               .range = not_negative,
               .dimension = "L/T",
               .is_required = true,
               .meaning = "increasing impact speeds; between two the restitution is linear",
               .example = "[0.0, 1.0, 10.0]",
               .only_for = {"tabulated"}},
              {.name = "values",
               .type = numbers,
               .range = fraction,
               .is_required = true,
               .meaning = "the restitution at each of the `speeds`",
               .example = "[1.0, 0.9, 0.6]",
               .only_for = {"tabulated"}},
          }};
}

// How bodies bounce off each other.
std::vector<KeyDescription> bounce_keys() {
  return {
      {.name = "restitution",
       .range = fraction,
       .meaning =
           "the ratio of normal speeds after and before a contact, 1 being elastic, or how it depends on "
           "the impact speed",
       .example = "0.9",
       .table = make(restitution_keys())},
      {.name = "elastic_below",
       .range = not_negative,
       .dimension = "L/T",
       .meaning = "impacts slower than this are elastic; under gravity a sphere pressed against a surface "
                  "leaves it with at least a tenth of this speed",
       .example = "0.01"},
      {.name = "contact_duration",
       .range = not_negative,
       .dimension = "T",
       .meaning = "a contact is elastic if the motion of one of the spheres changed within this time before "
                  "it: the TC model, which prevents inelastic collapse",
       .example = "1e-5"},
      {.name = "tangential_restitution",
       .range = signed_fraction,
       .meaning = "for rough spheres, whose spins change at contacts: minus the ratio of the tangential "
                  "velocities of the surfaces after and before a contact; 1 is perfectly rough, -1 smooth",
       .example = "0.5"}};
}

TableDescription pairs_keys() {
  TableDescription table{
      .title = "[[response.pairs]]",
      .keys = {
          {.name = "kind",
           .type = choice,
           .choices = {"bounce", "merge", "pass"},
           .is_required = true,
           .meaning = "what spheres of these species do when they touch: bounce, merge into one, or pass "
                      "through each other",
           .example = "\"bounce\""},
          {.name = "between",
           .type = texts,
           .is_required = true,
           .meaning =
               "two species, which may be the same, or a species and `\"wall\"`, which means all walls",
           .example = R"(["steel", "glass"])"}}};
  for (KeyDescription key : bounce_keys()) {
    key.only_for = {"bounce"};
    table.keys.push_back(std::move(key));
  }
  return table;
}

TableDescription response_keys() {
  TableDescription table{.title = "[response]", .keys = bounce_keys()};
  table.keys.front().default_value = "1.0";
  table.keys.push_back({.name = "kind",
                        .type = choice,
                        .choices = {"bounce", "merge"},
                        .default_value = "\"bounce\"",
                        .meaning =
                            "what spheres do when they touch: bounce, or merge into one with the mass, "
                            "momentum, angular momentum and volume of both; at walls they bounce",
                        .example = "\"merge\""});
  table.keys.push_back(
      {.name = "settle",
       .type = truth,
       .meaning = "whether spheres come to rest in a heap. Unless `contact_duration` is given, a contact is "
                  "then elastic if it follows another within a hundredth of √(d / g), d being the smaller "
                  "diameter. When all spheres are at rest, the run only waits for its end. If not given, "
                  "true where spheres that lose energy fall on something and are not driven",
       .example = "false"});
  table.keys.push_back(
      {.name = "pairs",
       .type = tables,
       .meaning = "rules for pairs of species; keys that they leave out are those of `[response]`",
       .table = make(pairs_keys())});
  return table;
}

TableDescription species_keys() {
  return {.title = "[[species]]",
          .keys = {{.name = "name",
                    .type = text,
                    .is_required = true,
                    .meaning = "its name, by which `[[spheres]]` and `[[response.pairs]]` refer to it",
                    .example = "\"steel\""},
                   {.name = "moment",
                    .range = positive,
                    .meaning = "the moment of inertia of its spheres over mass and squared radius: 2/5 for "
                               "uniform spheres and 1/2 for uniform discs, if not given; 2/3 for shells",
                    .example = "0.4"}}};
}

TableDescription walls_keys() {
  std::vector<KeyDescription> keys{
      {.name = "shape",
       .type = choice,
       .choices = {"plane", "cylinder", "sphere", "cone"},
       .is_required = true,
       .meaning = "its shape; the spheres are inside a cylinder, a sphere or a cone",
       .example = "\"plane\""},
      {.name = "point",
       .type = vector,
       .dimension = "L",
       .is_required = true,
       .meaning =
           "a point of the plane, a point on the axis of the cylinder, the center of the sphere, or the "
           "apex of the cone",
       .example = "[5.0, 5.0, 5.0]"},
      {.name = "normal",
       .type = vector,
       .is_required = true,
       .meaning = "a vector of any length that points from the plane to the side where the spheres are",
       .example = "[0.0, 0.0, 1.0]",
       .only_for = {"plane"}},
      {.name = "axis",
       .type = vector,
       .is_required = true,
       .meaning = "a vector of any length along the axis; of a cone, from the apex into it",
       .example = "[0.0, 0.0, 1.0]",
       .only_for = {"cylinder", "cone"}},
      {.name = "radius",
       .range = positive,
       .dimension = "L",
       .is_required = true,
       .meaning = "its radius",
       .example = "4.0",
       .only_for = {"cylinder", "sphere"}},
      {.name = "slope",
       .range = positive,
       .is_required = true,
       .meaning = "its radius over the distance from its apex",
       .example = "0.5",
       .only_for = {"cone"}},
      {.name = "velocity",
       .type = vector,
       .dimension = "L/T",
       .default_value = "[0.0, 0.0, 0.0]",
       .meaning = "its constant velocity",
       .example = "[0.0, 0.0, 0.1]"},
      {.name = "amplitude",
       .range = positive,
       .dimension = "L",
       .meaning = "together with `frequency`, instead of `velocity`: at time t the plane is displaced along "
                  "its normal by "
                  "amplitude · sin(2π · frequency · t)",
       .example = "0.1",
       .only_for = {"plane"}},
      {.name = "frequency",
       .range = positive,
       .dimension = "1/T",
       .meaning = "the frequency of this oscillation",
       .example = "2.0",
       .only_for = {"plane"}},
  };
  for (const KeyDescription& key : surface_keys()) keys.push_back(key);
  return {.title = "[[walls]]", .keys = keys};
}

TableDescription obstacles_keys() {
  std::vector<KeyDescription> keys{
      {.name = "position",
       .type = vector,
       .dimension = "L",
       .meaning = "the center of an obstacle",
       .example = "[5.0, 5.0, 5.0]"},
      {.name = "positions",
       .type = vectors,
       .dimension = "L",
       .meaning = "instead of `position`: the centers of several identical obstacles",
       .example = "[[3.0, 5.0, 5.0], [7.0, 5.0, 5.0]]"},
      {.name = "radius",
       .range = positive,
       .dimension = "L",
       .is_required = true,
       .meaning = "their radius",
       .example = "1.0"}};
  for (const KeyDescription& key : surface_keys()) keys.push_back(key);
  return {.title = "[[obstacles]]", .keys = keys, .one_of = {{"position", "positions"}}};
}

KeyDescription steps_key(std::string_view meaning) {
  const std::shared_ptr<const TableDescription> step = make(
      {.title = "steps",
       .keys = {
           {.name = "ratio",
            .range = positive,
            .is_required = true,
            .meaning = "the distance of the centers at which the step is, over the sum of the radii",
            .example = "1.5"},
           {.name = "energy",
            .dimension = "M L²/T²",
            .is_required = true,
            .meaning = "the energy of two spheres between this step and the next one inward, or the core",
            .example = "-1.0"}}});
  return {.name = "steps", .type = tables, .meaning = meaning, .table = step};
}

KeyDescription core_key() {
  return {.name = "core",
          .range = not_negative,
          .default_value = "1.0",
          .meaning =
              "the distance at which the spheres bounce off each other, over the sum of the radii; zero "
              "if they may take the same place",
          .example = "0.0"};
}

TableDescription potentials_keys() {
  KeyDescription steps = steps_key("its steps, from the inside to the outside");
  steps.is_required = true;
  return {
      .title = "[[potentials]]",
      .keys = {
          {.name = "between",
           .type = texts,
           .meaning =
               "two species, which may be the same; if not given, all pairs that no other potential names",
           .example = R"(["oil", "water"])"},
          steps,
          core_key()}};
}

TableDescription bonds_keys() {
  return {
      .title = "[[bonds]]",
      .keys = {{.name = "between",
                .type = numbers,
                .range = not_negative,
                .meaning = "the ids of two spheres that are tied together",
                .example = "[3, 17]"},
               {.name = "chain",
                .type = numbers,
                .range = not_negative,
                .meaning = "the first and the last id of spheres of which each is tied to the next",
                .example = "[0, 63]"},
               {.name = "file",
                .type = text,
                .meaning = "a text file with two ids on each line; its path is relative to the scenario",
                .example = "\"bonds.txt\""},
               {.name = "beads",
                .type = integer,
                .least = 2,
                .most = std::numeric_limits<SphereId>::max() - 1,
                .meaning = "with `chain`: the number of spheres in each of the chains into which it is cut",
                .example = "16"},
               {.name = "longest",
                .range = positive,
                .is_required = true,
                .meaning = "the greatest distance of the centers, over the sum of the radii",
                .example = "1.2"},
               core_key(),
               steps_key("steps within the bond, from the inside to the outside; beyond them the energy "
                         "is zero")},
      .one_of = {{"between", "chain", "file"}}};
}

TableDescription thermostat_keys() {
  return {
      .title = "[thermostat]",
      .keys = {{.name = "kind",
                .type = choice,
                .choices = {"andersen", "rescale", "heating"},
                .is_required = true,
                .meaning = "`\"andersen\"`: each sphere gets a new velocity from Maxwell's distribution at "
                           "random times of its own; `\"rescale\"`: all velocities are scaled; "
                           "`\"heating\"`: all velocities get random kicks",
                .example = "\"andersen\""},
               {.name = "temperature",
                .range = positive,
                .dimension = "M L²/T²",
                .is_required = true,
                .meaning = "the kT of the thermostat",
                .example = "1.0",
                .only_for = {"andersen", "rescale"}},
               {.name = "rate",
                .range = positive,
                .dimension = "1/T",
                .is_required = true,
                .meaning = "how often a sphere gets a new velocity, on average",
                .example = "0.5",
                .only_for = {"andersen"}},
               {.name = "strength",
                .range = positive,
                .dimension = "L²/T³",
                .is_required = true,
                .meaning = "how fast the kicks raise the mean square of each component of the velocities",
                .example = "0.1",
                .only_for = {"heating"}},
               {.name = "every",
                .range = positive,
                .dimension = "T",
                .is_required = true,
                .meaning = "the time between two actions on all spheres",
                .example = "0.1",
                .only_for = {"rescale", "heating"}},
               {.name = "slabs",
                .type = integer,
                .least = 1,
                .most = 10000,
                .meaning = "the number of slabs across y, each of which keeps its mean velocity: velocities "
                           "are scaled relative to it, whatever the profile of the flow. If not given, they "
                           "are scaled relative to the mean of all spheres and to the flow of the box",
                .example = "10",
                .only_for = {"rescale"}}}};
}

TableDescription growth_keys() {
  return {.title = "[growth]",
          .keys = {
              {.name = "rate",
               .default_value = "0.01",
               .meaning =
                   "the rate at which the mean diameter grows, over the thermal speed √(kT/m); negative if "
                   "the spheres shrink",
               .example = "0.01"},
              {.name = "packing_fraction",
               .range = positive,
               .meaning = "the fraction of the volume at which growth ends; spheres that shrink "
                          "need it; if not given, growth ends where the largest sphere just fits the box and "
                          "its walls, or by `compressibility`",
               .example = "0.6"},
              {.name = "compressibility",
               .range = positive,
               .meaning = "PV/NkT, averaged over some collisions, beyond which growth ends",
               .example = "1e4"}}};
}

TableDescription run_keys() {
  return {.title = "[run]",
          .keys = {{.name = "until",
                    .range = not_negative,
                    .dimension = "T",
                    .meaning = "when the run ends; `--until` takes precedence",
                    .example = "10.0"},
                   {.name = "seed",
                    .type = integer,
                    .least = 0,
                    .most = std::numeric_limits<std::int64_t>::max(),
                    .default_value = "1",
                    .meaning = "the seed of the random numbers for radii, placement, velocities and the "
                               "thermostat; `--seed` takes precedence",
                    .example = "1"}}};
}

TableDescription output_keys() {
  return {
      .title = "[output]",
      .keys = {
          {.name = "directory",
           .type = text,
           .meaning =
               "the directory of the files; `--out` takes precedence; without either, no files are written",
           .example = "\"out\""},
          {.name = "snapshots_every",
           .range = positive,
           .dimension = "T",
           .meaning = "interval of the snapshots in the trajectory; none are taken unless this, "
                      "`snapshots_per_decade` or `snapshots_every_contacts` is given",
           .example = "0.5"},
          {.name = "snapshots_per_decade",
           .type = integer,
           .least = 1,
           .most = 1000,
           .meaning = "or: how many snapshots are taken while the time grows tenfold, evenly in its "
                      "logarithm, from `first_snapshot` on",
           .example = "10"},
          {.name = "first_snapshot",
           .range = positive,
           .dimension = "T",
           .meaning = "goes with `snapshots_per_decade`: the time of the first snapshot after that "
                      "of the start",
           .example = "0.001"},
          {.name = "snapshots_every_contacts",
           .type = integer,
           .least = 1,
           .most = std::numeric_limits<std::int64_t>::max(),
           .meaning = "or: how many collisions and wall contacts lie between two snapshots",
           .example = "10000"},
          {.name = "trajectory",
           .type = some,
           .choices = {"xyz", "xyz.zst", "gsd", "lammps", "vtp"},
           .default_value = "\"xyz\"",
           .meaning = "the format of the trajectory: `trajectory.xyz`, `trajectory.xyz.zst`, "
                      "`trajectory.gsd`, `trajectory.lammpstrj` or `trajectory.pvd`",
           .example = "\"gsd\""},
          {.name = "event_log",
           .type = truth,
           .default_value = "false",
           .meaning = "whether to write `events.npy`",
           .example = "true"},
          {.name = "recording",
           .type = truth,
           .default_value = "false",
           .meaning = "whether to write `recording.hbr`, for the [viewer](viewer.md)",
           .example = "true"},
          {.name = "checkpoint_every",
           .range = positive,
           .default_value = "60.0",
           .meaning = "seconds of wall time between checkpoints, from which `hardball resume` resumes",
           .example = "600"},
          {.name = "checkpoint_at",
           .type = numbers,
           .dimension = "T",
           .meaning = "times at which a checkpoint is also written; each is kept as `checkpoints/T.hbc`",
           .example = "[10.0, 100.0]"},
          {.name = "report",
           .type = truth,
           .default_value = "true",
           .meaning = "whether to write `report.html`",
           .example = "false"}}};
}

TableDescription measures_keys() {
  std::vector<std::string_view> known{"all"};
  known.insert(known.end(), measure_names().begin(), measure_names().end());
  return {.title = "[measures]",
          .keys = {{.name = "names",
                    .type = choices,
                    .choices = known,
                    .default_value = R"(["all"])",
                    .meaning = "the measures to take, see [measures.md](measures.md); `[]` for none",
                    .example = R"(["pressure", "collision_rate"])"},
                   {.name = "every",
                    .range = positive,
                    .dimension = "T",
                    .meaning = "the time between samples; if not given, each measure has its own",
                    .example = "0.5"},
                   {.name = "from",
                    .range = not_negative,
                    .dimension = "T",
                    .default_value = "0.0",
                    .meaning = "when measuring starts",
                    .example = "2.0"}}};
}

TableDescription all_keys() {
  return {.title = "",
          .keys = {{.name = "box",
                    .type = table,
                    .is_required = true,
                    .meaning = "the space in which the spheres move",
                    .table = make(box_keys())},
                   {.name = "spheres",
                    .type = tables,
                    .meaning = "groups of spheres, in the order of ids",
                    .table = make(spheres_keys())},
                   {.name = "start",
                    .type = table,
                    .meaning = "instead of `[[spheres]]`: a state to start from",
                    .table = make(start_keys())},
                   {.name = "walls",
                    .type = tables,
                    .meaning = "walls besides those of the box: planes, cylinders, spheres and cones",
                    .table = make(walls_keys())},
                   {.name = "obstacles",
                    .type = tables,
                    .meaning = "spheres that never move",
                    .table = make(obstacles_keys())},
                   {.name = "species",
                    .type = tables,
                    .meaning = "kinds of spheres, if contacts depend on them",
                    .table = make(species_keys())},
                   {.name = "response",
                    .type = table,
                    .meaning = "what contacts do",
                    .table = make(response_keys())},
                   {.name = "potentials",
                    .type = tables,
                    .meaning = "potentials of steps: wells, shoulders, sticky spheres; see steps.md",
                    .table = make(potentials_keys())},
                   {.name = "bonds",
                    .type = tables,
                    .meaning = "spheres that are tied together: tethers and chains; see steps.md",
                    .table = make(bonds_keys())},
                   {.name = "thermostat",
                    .type = table,
                    .meaning = "a thermostat, which exchanges energy with the spheres between contacts",
                    .table = make(thermostat_keys())},
                   {.name = "growth",
                    .type = table,
                    .meaning = "how all spheres grow, or shrink",
                    .table = make(growth_keys())},
                   {.name = "run", .type = table, .meaning = "the run", .table = make(run_keys())},
                   {.name = "output",
                    .type = table,
                    .meaning = "which files are written, and where",
                    .table = make(output_keys())},
                   {.name = "measures",
                    .type = table,
                    .meaning = "the measures to take, and when",
                    .table = make(measures_keys())}},
          .one_of = {{"spheres", "start"}}};
}

// The names in double quotes and backquotes.
std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names)
    text += (text.empty() ? "`\"" : ", `\"") + std::string(name) + "\"`";
  return text;
}

std::string range_of(const KeyDescription& key, const std::string& noun) {
  switch (key.range) {
    case finite:
      return noun;
    case positive:
      return "positive " + noun;
    case not_negative:
      return "zero or positive " + noun;
    case fraction:
      return noun + " from 0 to 1";
    case signed_fraction:
      return noun + " from -1 to 1";
  }
  return "";
}

std::string type_of(const KeyDescription& key) {
  switch (key.type) {
    case number:
      return range_of(key, "number");
    case numbers:
      return "list of " + range_of(key, "numbers");
    case integer:
      return "integer from " + to_text(key.least) + " to " + to_text(key.most);
    case truth:
      return "`true` or `false`";
    case text:
      return "string";
    case texts:
      return "list of strings";
    case choice:
      return listed(key.choices);
    case choices:
      return "list of " + listed(key.choices);
    case some:
      return listed(key.choices) + ", or a list of these";
    case vector:
      return "three numbers";
    case vectors:
      return "list of three numbers each";
    case table:
    case tables:
      return "table";
  }
  return "";
}

bool goes_with(const KeyDescription& key, std::string_view choice) {
  return key.only_for.empty() || std::ranges::find(key.only_for, choice) != key.only_for.end();
}

}  // namespace

const KeyDescription* TableDescription::find(std::string_view name, std::string_view choice) const {
  const auto found = std::ranges::find_if(
      keys, [&](const KeyDescription& key) { return key.name == name && goes_with(key, choice); });
  return found == keys.end() ? nullptr : &*found;
}

bool TableDescription::has_variants() const {
  return std::ranges::any_of(keys, [](const KeyDescription& key) { return !key.only_for.empty(); });
}

std::vector<std::string_view> TableDescription::names() const {
  std::vector<std::string_view> names;
  for (const KeyDescription& key : keys) {
    if (std::ranges::find(names, key.name) == names.end()) names.push_back(key.name);
  }
  return names;
}

const TableDescription& scenario_keys() {
  static const TableDescription keys = all_keys();
  return keys;
}

std::string values_of(const KeyDescription& key) {
  std::string text = type_of(key);
  if (key.table && key.type != table && key.type != tables) text += ", or a table";
  if (!key.dimension.empty()) text += " [" + std::string(key.dimension) + "]";
  return text;
}

}  // namespace hardball
