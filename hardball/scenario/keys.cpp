// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/keys.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/motions/prescribed_motion.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

using enum NumberRange;
using Names = std::vector<std::string_view>;

// What a value may be.
struct Values {
  ValueType type;
  NumberRange range = finite;
  std::string_view dimension = {};
  Names choices = {};
  std::uint64_t least = 0;
  std::uint64_t most = 0;
  std::shared_ptr<const TableDescription> table = {};

  Values or_table(TableDescription keys) && {
    table = std::make_shared<const TableDescription>(std::move(keys));
    return std::move(*this);
  }
};

Values number(NumberRange range, std::string_view dimension = {}) {
  return {ValueType::number, range, dimension};
}
Values numbers(NumberRange range, std::string_view dimension = {}) {
  return {ValueType::numbers, range, dimension};
}
Values named_numbers(NumberRange range, std::string_view dimension = {}) {
  return {ValueType::named_numbers, range, dimension};
}
Values integer(std::uint64_t least, std::uint64_t most) {
  return {.type = ValueType::integer, .least = least, .most = most};
}
Values truth() {
  return {ValueType::truth};
}
Values text() {
  return {ValueType::text};
}
Values texts() {
  return {ValueType::texts};
}
Values choice(Names choices) {
  return {.type = ValueType::choice, .choices = std::move(choices)};
}
Values choices(Names choices) {
  return {.type = ValueType::choices, .choices = std::move(choices)};
}
Values some(Names choices) {
  return {.type = ValueType::some, .choices = std::move(choices)};
}
Values vector(std::string_view dimension = {}) {
  return {ValueType::vector, finite, dimension};
}
Values vectors(std::string_view dimension) {
  return {ValueType::vectors, finite, dimension};
}
Values table(TableDescription keys) {
  return Values{ValueType::table}.or_table(std::move(keys));
}
Values tables(TableDescription keys) {
  return Values{ValueType::tables}.or_table(std::move(keys));
}

// The names of the values of an enumeration up to `last`.
template <Named Enum>
Names names_until(Enum last) {
  return {kNames<Enum>.begin(), kNames<Enum>.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

// A key that may be left out. Its meaning is a sentence without its full stop; the example, and the default
// if it can be written, are values as in TOML.
KeyDescription key(std::string_view name, Values values, std::string meaning, std::string_view example = {},
                   std::string_view default_value = {}) {
  return {.name = name,
          .type = values.type,
          .range = values.range,
          .least = values.least,
          .most = values.most,
          .choices = std::move(values.choices),
          .dimension = values.dimension,
          .default_value = default_value,
          .meaning = std::move(meaning),
          .example = example,
          .table = std::move(values.table)};
}

KeyDescription required(std::string_view name, Values values, std::string meaning,
                        std::string_view example = {}) {
  KeyDescription required = key(name, std::move(values), std::move(meaning), example);
  required.is_required = true;
  return required;
}

// A key that goes with some choices of the table's first key.
KeyDescription only_for(Names choices, KeyDescription key) {
  key.only_for = std::move(choices);
  return key;
}

// The key of a field.
template <class Get>
KeyDescription key_of(const Field<Get>& field) {
  using Value = GivenValue<typename Field<Get>::Value>;
  Values values = number(field.range, field.dimension);
  if constexpr (std::is_same_v<Value, Vec3>) {
    values = vector();
  } else if constexpr (std::is_same_v<Value, bool>) {
    values = truth();
  } else if constexpr (std::is_integral_v<Value>) {
    values = integer(field.least, field.most);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    values = numbers(field.range, field.dimension);
  } else if constexpr (std::is_same_v<Value, NamedNumbers>) {
    values = named_numbers(field.range, field.dimension);
  } else if constexpr (ListOfChoices<Value>) {
    values = some({field.choices.begin(), field.choices.end()});
  } else if constexpr (!std::is_floating_point_v<Value>) {
    values = text();
  }
  KeyDescription description =
      key(field.name, std::move(values), std::string(field.meaning), field.example, field.default_value);
  description.is_required = field.is_required;
  return description;
}

// The keys of the fields of a type.
template <class Type>
std::vector<KeyDescription> keys_of() {
  std::vector<KeyDescription> keys;
  for_each_field<Type>([&](const auto& field) { keys.push_back(key_of(field)); });
  return keys;
}

// How a fixed surface reflects spheres.
std::vector<KeyDescription> surface_keys() {
  return {
      key("restitution", number(fraction),
          "the restitution of contacts with it; that of `[response]` if not given", "0.8"),
      key("tangential_restitution", number(signed_fraction),
          "how rough it is, by which it turns spheres; that of `[response]` if not given", "0.5"),
      key("temperature", number(not_negative, "M L²/T²"),
          "instead of `restitution`: a thermal wall, which spheres leave with velocities of this kT", "1.0")};
}

TableDescription faces_keys() {
  std::vector<KeyDescription> keys = surface_keys();
  keys.push_back(key(
      "velocity", vector("L/T"),
      "its constant velocity, along the face: it drags spheres along if it is thermal, or if they are rough",
      "[1.0, 0.0, 0.0]", "[0.0, 0.0, 0.0]"));
  const TableDescription face{.title = "face", .keys = std::move(keys)};
  constexpr std::array<std::string_view, kFaces> kMeanings{
      "the face at x = 0", "the face at the size along x",
      "the face at y = 0", "the face at the size along y",
      "the face at z = 0", "the face at the size along z"};
  TableDescription faces{.title = "[box.faces]", .keys = {}};
  for (Face number = 0; number < kFaces; ++number) {
    faces.keys.push_back(key(kFaceNames[number], table(face), std::string(kMeanings[number])));
  }
  return faces;
}

TableDescription box_keys() {
  return {.title = "[box]",
          .keys = {
              key("dimensions", integer(2, 3),
                  "2 for discs in a plane: the spheres have z = 0. Then `boundary` and `size` are for x and "
                  "y, vectors may have two numbers, and volumes are areas",
                  "2", "3"),
              required("boundary", choices(names_until(Boundary::open)),
                       "the boundaries of the box along x, y and z", R"(["wall", "wall", "wall"])"),
              key("size", numbers(positive, "L"),
                  "edge lengths; the box spans 0 to size. Three numbers, or one for each axis that is not "
                  "open. For an open axis it only says where placement puts spheres",
                  "[10.0, 10.0, 10.0]"),
              key("packing_fraction", number(positive),
                  "instead of `size`: the fraction of the volume that the spheres fill; the box is a cube, "
                  "in two dimensions a square, with the edge that follows",
                  "0.3"),
              key("gravity", vector("L/T²"), "the acceleration of every sphere", "[0.0, 0.0, -9.81]",
                  "[0.0, 0.0, 0.0]"),
              key("shear_rate", number(finite, "1/T"),
                  "how much the flow along x grows along y: images of the box above and below slide along x "
                  "(Lees-Edwards boundaries). x and y must be periodic. Velocities that are drawn are "
                  "relative to this flow",
                  "0.1", "0.0"),
              key("shear_offset", number(finite, "L"),
                  "the displacement of the image above along x at time zero, modulo the width of the box. If "
                  "not given, it is the tilt of the box in a start file",
                  "3.5", "0.0"),
              key("faces", table(faces_keys()), "properties of its faces that are walls"),
          }};
}

TableDescription radius_keys() {
  return {.title = "radius",
          .keys = {
              required("distribution", choice({"uniform", "lognormal", "powerlaw", "discrete", "file"}),
                       "the kind of distribution", "\"uniform\""),
              only_for({"uniform", "powerlaw"},
                       required("min", number(positive, "L"), "the smallest radius", "0.5")),
              only_for({"uniform", "powerlaw"},
                       required("max", number(positive, "L"), "the largest radius", "1.0")),
              only_for({"lognormal"},
                       required("mean", number(positive, "L"),
                                "the mean radius of the distribution without `min` and `max`", "1.0")),
              only_for({"lognormal"},
                       required("sigma", number(positive),
                                "the standard deviation of the natural logarithm of the radius", "0.25")),
              only_for({"lognormal"},
                       key("min", number(positive, "L"), "smaller radii are rejected and redrawn", "0.5")),
              only_for({"lognormal"},
                       key("max", number(positive, "L"), "larger radii are rejected and redrawn", "2.0")),
              only_for({"powerlaw"},
                       required("exponent", number(finite),
                                "the density of radii is proportional to this power of the radius", "-2.5")),
              only_for({"discrete"}, required("values", numbers(positive, "L"), "the radii", "[0.5, 1.0]")),
              only_for({"discrete"}, required("weights", numbers(positive),
                                              "how many spheres have each of the `values`, in proportion: "
                                              "exactly, up to less than one sphere",
                                              "[3.0, 1.0]")),
              only_for({"file"}, required("file", text(),
                                          "a text file with a radius [L] on each of `count` lines; its path "
                                          "is relative to the scenario",
                                          "\"radii.txt\"")),
          }};
}

TableDescription mass_keys() {
  return {.title = "mass",
          .keys = {required("density", number(positive, "M/L³"),
                            "the density of the material: a sphere of radius r has the mass 4π/3 r³ times "
                            "this, a disc π r² times this [M/L²]",
                            "2.0")}};
}

TableDescription spheres_keys() {
  // Ids are below 2^32, and the largest stands for none.
  constexpr std::uint64_t kMaxSpheres = std::numeric_limits<SphereId>::max() - 1;
  return {
      .title = "[[spheres]]",
      .keys =
          {
              key("count", integer(1, kMaxSpheres), "their number; may be left out where a list gives it",
                  "1000"),
              key("packing_fraction", number(positive),
                  "instead of `count`: the fraction of the volume of the box that these spheres fill, to the "
                  "nearest whole number of them",
                  "0.3"),
              required("radius", number(positive, "L").or_table(radius_keys()),
                       "their radius, or how their radii are distributed", "1.0"),
              key("mass", number(positive, "M").or_table(mass_keys()),
                  "their mass, or the density from which their masses follow", "2.0", "1.0"),
              key("placement", choice(names_until(Placement::hexagonal)),
                  "`\"random\"`: anywhere without overlap with each other and with spheres that are listed; "
                  "beyond a packing fraction of 0.36 for equal spheres and 0.54 for equal discs they grow "
                  "into place, up to .97 of the packing fraction at which they jam; `\"fcc\"`: on a "
                  "face-centered cubic lattice that fills the box; `\"hexagonal\"`: on a hexagonal lattice, "
                  "for discs",
                  "\"random\""),
              key("positions", vectors("L"), "instead of `placement`: their centers",
                  "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]"),
              key("mean_speed", number(not_negative, "L/T"), "Maxwell velocities with this mean of |v|",
                  "1.0"),
              key("temperature", number(not_negative, "M L²/T²"),
                  "or: Maxwell velocities with this kT = m⟨v²⟩/3, in two dimensions m⟨v²⟩/2", "1.0"),
              key("speed", number(not_negative, "L/T"), "or: this |v| in random directions", "1.0"),
              key("velocities", vectors("L/T"), "or: each velocity", "[[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]"),
              key("rotational_temperature", number(not_negative, "M L²/T²"),
                  "normally distributed spins with this I⟨w²⟩/3, or I⟨w²⟩ in two dimensions", "1.0", "0.0"),
              key("spins", vectors("1/T"), "instead of `rotational_temperature`: each angular velocity",
                  "[[0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]"),
              key("species", text(), "the name of their species; the first of `[[species]]` if not given",
                  "\"steel\""),
              key("kinematic", truth(),
                  "whether their mass is infinite, so that no collision deflects them; two of these pass "
                  "through each other",
                  "true", "false"),
              key("motion", text(),
                  "of kinematic spheres, instead of a velocity: the name of the motion that drives them",
                  "\"stirrer\""),
          },
      .one_of = {{"placement", "positions"}, {"mean_speed", "temperature", "speed", "velocities", "motion"}},
  };
}

TableDescription start_keys() {
  return {
      .title = "[start]",
      .keys = {required("file", text(),
                        "a file with spheres, whose last frame is used: extended XYZ (`.xyz`), GSD (`.gsd`), "
                        "LAMMPS dump (`.lammpstrj`), LAMMPS data file (`.data`), CSV (`.csv`), NumPy "
                        "(`.npy`) or the format of Smallenburg's EDMD codes (`.sph`); text may be compressed "
                        "(`.zst`); its path is relative to the scenario",
                        "\"start.xyz\""),
               key("mean_speed", number(not_negative, "L/T"),
                   "for spheres that have no velocities, or are all at rest: Maxwell velocities with this "
                   "mean of |v|",
                   "1.0"),
               key("temperature", number(not_negative, "M L²/T²"),
                   "or: Maxwell velocities with this kT; masses that the file does not give are 1", "1.0"),
               key("shrink", truth(),
                   "whether all radii are multiplied by the largest factor, up to 1, at which no spheres "
                   "overlap and none reaches through a wall; the run prints the factor",
                   "true", "false")}};
}

TableDescription restitution_keys() {
  return {
      .title = "restitution",
      .keys = {
          required(
              "law", choice({"viscoelastic", "tabulated"}),
              "how the restitution depends on the impact speed, the normal relative speed before the contact",
              "\"viscoelastic\""),
          only_for({"viscoelastic"},
                   required("value", number(fraction),
                            "the restitution at the impact speed `speed`; slower impacts are more elastic",
                            "0.8")),
          only_for({"viscoelastic"}, required("speed", number(positive, "L/T"), "an impact speed", "1.0")),
          only_for({"tabulated"}, required("speeds", numbers(not_negative, "L/T"),
                                           "increasing impact speeds; between two the restitution is linear",
                                           "[0.0, 1.0, 10.0]")),
          only_for({"tabulated"}, required("values", numbers(fraction),
                                           "the restitution at each of the `speeds`", "[1.0, 0.9, 0.6]")),
      }};
}

// How bodies bounce off each other.
std::vector<KeyDescription> bounce_keys() {
  std::vector<KeyDescription> keys = keys_of<BounceRules>();
  keys.insert(
      keys.begin(),
      key("restitution", number(fraction).or_table(restitution_keys()),
          "the ratio of normal speeds after and before a contact, 1 being elastic, or how it depends on "
          "the impact speed",
          "0.9"));
  return keys;
}

TableDescription pairs_keys() {
  TableDescription table{
      .title = "[[response.pairs]]",
      .keys = {
          required("kind", choice({"bounce", "merge", "pass"}),
                   "what spheres of these species do when they touch: bounce, merge into one, or pass "
                   "through each other",
                   "\"bounce\""),
          required("between", texts(),
                   "two species, which may be the same, or a species and `\"wall\"`, which means all walls",
                   R"(["steel", "glass"])")}};
  for (KeyDescription key : bounce_keys()) {
    key.only_for = {"bounce"};
    table.keys.push_back(std::move(key));
  }
  return table;
}

TableDescription response_keys() {
  TableDescription table{.title = "[response]", .keys = bounce_keys()};
  table.keys.front().default_value = "1.0";
  table.keys.push_back(key("kind", choice({"bounce", "merge"}),
                           "what spheres do when they touch: bounce, or merge into one with the mass, "
                           "momentum, angular momentum and volume of both; at walls they bounce",
                           "\"merge\"", "\"bounce\""));
  table.keys.push_back(
      key("settle", truth(),
          "whether spheres come to rest in a heap. Unless `contact_duration` is given, a contact is then "
          "elastic if it follows another within a hundredth of √(d / g), d being the smaller diameter. When "
          "all spheres are at rest, the run only waits for its end. If not given, true where spheres that "
          "lose energy fall on something and are not driven",
          "false"));
  table.keys.push_back(key("pairs", tables(pairs_keys()),
                           "rules for pairs of species; keys that they leave out are those of `[response]`"));
  return table;
}

TableDescription species_keys() {
  return {.title = "[[species]]", .keys = keys_of<SpeciesDescription>()};
}

// Names with commas, and `last` before the last.
std::string enumerated(const std::vector<std::string>& names, const std::string& last) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : last) + names[i];
  return text;
}

// The keys of several kinds, each in the order of its kind; those of the same name are one.
std::vector<KeyDescription> merged(std::vector<std::vector<KeyDescription>> of_kinds) {
  std::vector<KeyDescription> all;
  const auto is_first = [](const std::vector<KeyDescription>& keys, std::string_view name) {
    return keys.front().name == name;
  };
  const auto must_wait = [&](std::string_view name) {
    return ranges::any_of(of_kinds, [&](const std::vector<KeyDescription>& keys) {
      return ranges::find(keys, name, &KeyDescription::name) != keys.end() && !is_first(keys, name);
    });
  };
  while (true) {
    std::erase_if(of_kinds, [](const std::vector<KeyDescription>& keys) { return keys.empty(); });
    const auto next = ranges::find_if(
        of_kinds, [&](const std::vector<KeyDescription>& keys) { return !must_wait(keys.front().name); });
    if (next == of_kinds.end()) {
      HARDBALL_CHECK(of_kinds.empty());  // else two kinds have the same fields in opposite orders
      return all;
    }
    KeyDescription key = next->front();
    key.only_for.clear();
    for (std::vector<KeyDescription>& keys : of_kinds) {
      if (keys.empty() || !is_first(keys, key.name)) continue;
      key.only_for.push_back(keys.front().only_for.front());
      keys.erase(keys.begin());
    }
    all.push_back(std::move(key));
  }
}

// The keys of the fields of the kinds for which for_each_kind(visit) calls visit(std::type_identity<Kind>()).
std::vector<KeyDescription> keys_of_kinds(const auto& for_each_kind) {
  std::vector<std::vector<KeyDescription>> of_kinds;
  for_each_kind([&]<class Kind>(std::type_identity<Kind>) {
    std::vector<KeyDescription>& keys = of_kinds.emplace_back();
    for_each_field<Kind>([&](const auto& field) { keys.push_back(only_for({Kind::kName}, key_of(field))); });
  });
  return merged(std::move(of_kinds));
}

// Calls visit(std::type_identity<S>()) for each shape S of walls.
void for_each_shape_of_walls(const auto& visit) {
  for_each_alternative<Shape>([&]<class S>(std::type_identity<S> shape) {
    if constexpr (requires { S::kPoint; }) visit(shape);
  });
}

// What only walls have that are meshes; capsules have a radius instead of a thickness.
std::vector<KeyDescription> mesh_keys() {
  const auto& [mesh, box, capsule, plate, height_field] = kMeshShapes;
  TableDescription groups{
      .title = "groups", .keys = {required("name", text(), "the name of the group in the file", "\"belt\"")}};
  for (const KeyDescription& key : surface_keys()) groups.keys.push_back(key);
  return {
      only_for(
          {mesh, height_field},
          required("file", text(),
                   "a file of triangles, `.stl`, `.obj` or `.ply`, or of the heights of a `height_field`: "
                   "rows along x of numbers along y; its path is relative to the scenario",
                   "\"hopper.stl\"")),
      only_for({box}, required("size", vector("L"), "its edges, along the axes before it is turned",
                               "[2.0, 2.0, 1.0]")),
      only_for({capsule},
               required("end", vector("L"), "the vector from the center of one of its ends to the other",
                        "[0.0, 0.0, 3.0]")),
      only_for({plate},
               required("edges", vectors("L"), "the vectors from one of its corners to the next ones",
                        "[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]")),
      only_for({mesh}, key("scale", number(positive), "by which all lengths of the file are multiplied",
                           "0.001", "1.0")),
      only_for({mesh, box},
               key("rotation", vector(""),
                   "turned about its origin, around this vector, by as many degrees as it is long",
                   "[90.0, 0.0, 0.0]", "[0.0, 0.0, 0.0]")),
      only_for({mesh, box},
               key("spheres", choice(names_until(MeshSide::outside)),
                   "where spheres are placed and stay; a mesh has an inside if it is closed. If not "
                   "given, outside a box, and on both sides of a mesh",
                   "\"inside\"")),
      only_for({height_field}, required("spacing", number(positive, "L"),
                                        "how far apart its points are along x and y", "0.5")),
      only_for({mesh, box, plate, height_field},
               key("thickness", number(not_negative, "L"),
                   "spheres touch it from this distance on, so that its edges are round", "0.1", "0.0")),
      only_for({mesh}, key("weld", number(fraction),
                           "vertices that are closer than this fraction of the median edge are made one",
                           "1e-6", "0.0")),
      only_for({mesh}, key("groups", tables(groups), "how groups of its triangles reflect spheres")),
  };
}

// What only walls have that stand for several surfaces.
std::vector<KeyDescription> joined_keys() {
  const auto& [cone, shell, annulus] = kJoinedShapes;
  return {
      only_for({cone}, required("bottom_radius", number(positive, "L"), "its radius at `point`", "1.0")),
      only_for({cone}, required("top_radius", number(positive, "L"),
                                "its radius at the other end, which must differ", "4.0")),
      only_for({cone, annulus},
               required("height", number(positive, "L"),
                        "how far along `axis` the other end is; both ends are planes", "6.0")),
      only_for({shell, annulus},
               required("inner_radius", number(positive, "L"),
                        "the radius of the sphere or the pillar around which the spheres are", "2.0")),
  };
}

TableDescription walls_keys() {
  Names shapes;
  std::vector<std::string> points;
  std::vector<std::string> around;
  for_each_shape_of_walls([&]<class S>(std::type_identity<S>) {
    shapes.push_back(S::kName);
    points.emplace_back(S::kPoint);
    if (!std::is_same_v<S, Plane> && !std::is_same_v<S, Pillar>)
      around.push_back("a " + std::string(S::kName));
  });
  shapes.insert(shapes.end(), kMeshShapes.begin(), kMeshShapes.end());
  shapes.insert(shapes.end(), kJoinedShapes.begin(), kJoinedShapes.end());
  around.insert(around.end(), {"a truncated cone", "a shell", "an annulus"});
  for (const char* const point :
       {"the origin of the file of a mesh", "the center of the box", "the center of one end of the capsule",
        "a corner of the plate", "below the first point of the heights",
        "the center of one end of the truncated cone", "the center of the shell",
        "the center of one end of the annulus"})
    points.emplace_back(point);
  std::vector<KeyDescription> keys{
      required("shape", choice(shapes), "its shape; the spheres are inside " + enumerated(around, " or "),
               "\"plane\""),
      required("point", vector("L"), enumerated(points, ", or "), "[5.0, 5.0, 5.0]")};
  for (const KeyDescription& key : keys_of_kinds([](const auto& visit) { for_each_shape_of_walls(visit); }))
    keys.push_back(key);
  for (KeyDescription& key : keys) {
    if (key.name == "radius")
      key.only_for.insert(key.only_for.end(), {kMeshShapes[2], kJoinedShapes[1], kJoinedShapes[2]});
    if (key.name == "axis") key.only_for.insert(key.only_for.end(), {kJoinedShapes[0], kJoinedShapes[2]});
  }
  for (const KeyDescription& key : mesh_keys()) keys.push_back(key);
  for (const KeyDescription& key : joined_keys()) keys.push_back(key);
  keys.push_back(
      key("velocity", vector("L/T"), "its constant velocity", "[0.0, 0.0, 0.1]", "[0.0, 0.0, 0.0]"));
  for_each_field<OscillatingPlane>([&](const auto& field) {
    KeyDescription key = only_for({Plane::kName}, key_of(field));
    key.is_required = false;
    const bool is_of_rest = ranges::find(keys, key.name, &KeyDescription::name) != keys.end();
    if (!is_of_rest) keys.push_back(std::move(key));
  });
  for (const KeyDescription& key : surface_keys()) keys.push_back(key);
  keys.push_back(
      key("motion", text(), "instead of `velocity`: the name of the motion that drives it", "\"piston\""));
  keys.push_back(key("torque_about", vector("L"),
                     "the point about which torque on it is measured, which moves with the wall; if not "
                     "given, `point`",
                     "[5.0, 5.0, 0.0]"));
  return {.title = "[[walls]]", .keys = keys};
}

std::string walls_meaning() {
  std::vector<std::string> shapes;
  for_each_shape_of_walls(
      [&]<class S>(std::type_identity<S>) { shapes.push_back(std::string(S::kName) + "s"); });
  for (const std::string_view shape : kMeshShapes) {
    shapes.push_back(std::string(shape) + (shape.ends_with("sh") || shape.ends_with('x') ? "es" : "s"));
  }
  shapes.insert(shapes.end(), {"truncated cones", "shells", "annuli"});
  return "walls besides those of the box: " + enumerated(shapes, " and ");
}

TableDescription obstacles_keys() {
  std::vector<KeyDescription> keys{
      key("position", vector("L"), "the center of an obstacle", "[5.0, 5.0, 5.0]"),
      key("positions", vectors("L"), "instead of `position`: the centers of several identical obstacles",
          "[[3.0, 5.0, 5.0], [7.0, 5.0, 5.0]]"),
      required("radius", number(positive, "L"), "their radius", "1.0")};
  for (const KeyDescription& key : surface_keys()) keys.push_back(key);
  return {.title = "[[obstacles]]", .keys = keys, .one_of = {{"position", "positions"}}};
}

KeyDescription steps_key(std::string_view meaning) {
  return key("steps", tables({.title = "steps", .keys = keys_of<Step>()}), std::string(meaning));
}

KeyDescription core_key() {
  return key("core", number(not_negative),
             "the distance at which the spheres bounce off each other, over the sum of the radii; zero if "
             "they may take the same place",
             "0.0", "1.0");
}

TableDescription potentials_keys() {
  KeyDescription steps = steps_key("its steps, from the inside to the outside");
  steps.is_required = true;
  return {.title = "[[potentials]]",
          .keys = {
              key("between", texts(),
                  "two species, which may be the same; if not given, all pairs that no other potential names",
                  R"(["oil", "water"])"),
              steps, core_key()}};
}

TableDescription bonds_keys() {
  return {
      .title = "[[bonds]]",
      .keys = {key("between", numbers(not_negative), "the ids of two spheres that are tied together",
                   "[3, 17]"),
               key("chain", numbers(not_negative),
                   "the first and the last id of spheres of which each is tied to the next", "[0, 63]"),
               key("file", text(),
                   "a text file with two ids on each line; its path is relative to the scenario",
                   "\"bonds.txt\""),
               key("beads", integer(2, std::numeric_limits<SphereId>::max() - 1),
                   "with `chain`: the number of spheres in each of the chains into which it is cut", "16"),
               required("longest", number(positive),
                        "the greatest distance of the centers, over the sum of the radii", "1.2"),
               core_key(),
               steps_key(
                   "steps within the bond, from the inside to the outside; beyond them the energy is zero")},
      .one_of = {{"between", "chain", "file"}}};
}

TableDescription thermostat_keys() {
  Names kinds;
  std::string meaning;
  for_each_alternative<ThermostatKind>([&]<class Kind>(std::type_identity<Kind>) {
    kinds.push_back(Kind::kName);
    meaning += (meaning.empty() ? "`\"" : "; `\"") + std::string(Kind::kName) +
               "\"`: " + std::string(Kind::kMeaning);
  });
  std::vector<KeyDescription> keys{required("kind", choice(kinds), meaning, "\"andersen\"")};
  for (const KeyDescription& key :
       keys_of_kinds([](const auto& visit) { for_each_alternative<ThermostatKind>(visit); }))
    keys.push_back(key);
  return {.title = "[thermostat]", .keys = keys};
}

TableDescription motions_keys() {
  const Names periodic{Rotation::kName, Oscillation::kName};
  const Names straight{Oscillation::kName, Keyframes::kName};
  return {
      .title = "[[motions]]",
      .keys = {
          required("kind", choice({Rotation::kName, Oscillation::kName, Keyframes::kName}),
                   "`\"rotation\"`: about an axis, of kinematic spheres; `\"oscillation\"`: along a line; "
                   "`\"keyframes\"`: on straight lines from knot to knot of a table",
                   "\"rotation\""),
          required("name", text(), "its name, by which `[[spheres]]` and `[[walls]]` refer to it",
                   "\"stirrer\""),
          only_for({Rotation::kName},
                   required("point", vector("L"), "a point of the axis", "[5.0, 5.0, 5.0]")),
          only_for({Rotation::kName},
                   key("axis", vector(),
                       "a vector of any length along the axis, from whose end the rotation is "
                       "counterclockwise; in two dimensions z, and may be left out",
                       "[0.0, 0.0, 1.0]")),
          only_for(
              {Oscillation::kName},
              required("direction", vector(), "a vector of any length along the line", "[0.0, 0.0, 1.0]")),
          only_for({Oscillation::kName},
                   required("amplitude", number(positive, "L"),
                            "after the time t, bodies are displaced by amplitude · sin(2π · frequency · t)",
                            "0.1")),
          only_for(periodic,
                   required("frequency", number(finite, "1/T"),
                            "turns or oscillations in a unit of time; negative for the other way", "0.5")),
          only_for(
              {Keyframes::kName},
              required("file", text(),
                       "a text file (`.csv`) with a row t, x, y, z for each knot; its path is relative to "
                       "the scenario. Bodies move by the differences from the first row",
                       "\"lift.csv\"")),
          only_for({Keyframes::kName},
                   key("repeat", truth(),
                       "whether the motion begins anew at its end, where the first and the "
                       "last row must agree",
                       "true", "false")),
          only_for(periodic, required("tolerance", number(positive, "L"),
                                      "how far the chords may be from the curve", "1e-6")),
          only_for(
              {Keyframes::kName},
              key("tolerance", number(positive, "L"),
                  "how far spheres may be from the straight lines, which they need under gravity", "1e-6")),
          only_for(straight,
                   key("stop_pressure", number(positive, "M/(L T²)"),
                       "the pressure of the spheres on the planes that it drives, across axes of the box, at "
                       "which the motion ends",
                       "2.5")),
          only_for(straight,
                   key("stop_interval", number(positive, "T"),
                       "the time over which that pressure is averaged, again and again from the start on; "
                       "required with `stop_pressure`",
                       "10.0")),
      }};
}

TableDescription measures_keys() {
  Names known{"all"};
  known.insert(known.end(), measure_names().begin(), measure_names().end());
  TableDescription table{.title = "[measures]", .keys = keys_of<MeasureSettings>()};
  table.keys.insert(
      table.keys.begin(),
      key("names", choices(known), "the measures to take, see [measures.md](measures.md); `[]` for none",
          R"(["pressure", "collision_rate"])", R"(["all"])"));
  return table;
}

TableDescription all_keys() {
  return {.title = "",
          .keys = {required("box", table(box_keys()), "the space in which the spheres move"),
                   key("spheres", tables(spheres_keys()), "groups of spheres, in the order of ids"),
                   key("start", table(start_keys()), "instead of `[[spheres]]`: a state to start from"),
                   key("walls", tables(walls_keys()), walls_meaning()),
                   key("obstacles", tables(obstacles_keys()), "spheres that never move"),
                   key("species", tables(species_keys()), "kinds of spheres, if contacts depend on them"),
                   key("response", table(response_keys()), "what contacts do"),
                   key("potentials", tables(potentials_keys()),
                       "potentials of steps: wells, shoulders, sticky spheres; see steps.md"),
                   key("bonds", tables(bonds_keys()),
                       "spheres that are tied together: tethers and chains; see steps.md"),
                   key("thermostat", table(thermostat_keys()),
                       "a thermostat, which exchanges energy with the spheres between contacts"),
                   key("motions", tables(motions_keys()),
                       "motions that kinematic spheres and walls follow; see motions.md"),
                   key("growth", table({.title = "[growth]", .keys = keys_of<GrowthRules>()}),
                       "how all spheres grow, or shrink"),
                   key("run", table({.title = "[run]", .keys = keys_of<RunDescription>()}), "the run"),
                   key("output", table({.title = "[output]", .keys = keys_of<OutputDescription>()}),
                       "which files are written, and where"),
                   key("measures", table(measures_keys()), "the measures to take, and when")},
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
  using enum ValueType;
  switch (key.type) {
    case number:
      return range_of(key, "number");
    case numbers:
      return "list of " + range_of(key, "numbers");
    case named_numbers:
      return "table of names with a " + range_of(key, "number") + " each";
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
  return key.only_for.empty() || ranges::find(key.only_for, choice) != key.only_for.end();
}

}  // namespace

const KeyDescription* TableDescription::find(std::string_view name, std::string_view choice) const {
  const auto found = ranges::find_if(
      keys, [&](const KeyDescription& key) { return key.name == name && goes_with(key, choice); });
  return found == keys.end() ? nullptr : &*found;
}

bool TableDescription::has_variants() const {
  return ranges::any_of(keys, [](const KeyDescription& key) { return !key.only_for.empty(); });
}

std::vector<std::string_view> TableDescription::names() const {
  std::vector<std::string_view> names;
  for (const KeyDescription& key : keys) {
    if (ranges::find(names, key.name) == names.end()) names.push_back(key.name);
  }
  return names;
}

const TableDescription& scenario_keys() {
  static const TableDescription keys = all_keys();
  return keys;
}

std::string values_of(const KeyDescription& key) {
  std::string text = type_of(key);
  if (key.table && key.type != ValueType::table && key.type != ValueType::tables) text += ", or a table";
  if (!key.dimension.empty()) text += " [" + std::string(key.dimension) + "]";
  return text;
}

}  // namespace hardball
