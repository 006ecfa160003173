// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/extended_xyz_writer.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "hardball/geometry/range.hpp"
#include "hardball/trajectory/append_text.hpp"

namespace hardball {
namespace {

constexpr std::string_view kProperties = "type:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:map_shift:I:3";
// Only where types are finer than species.
constexpr std::string_view kSpeciesProperties = ":species_id:I:1";
// Only where spheres spin.
constexpr std::string_view kSpinProperties = ":angular_velocity:R:3:moment:R:1";
// From which ASE takes velocities and masses.
constexpr std::string_view kAseProperties = ":momenta:R:3:masses:R:1";

std::string comment_line(const Snapshot& snapshot, const SphereTypes& types) {
  const SnapshotBox box = box_of(snapshot);
  std::string line = "Lattice=\"";
  append_text(line, Vec3{box.size.x, 0, 0});
  append_text(line, Vec3{box.tilt, box.size.y, 0});
  append_text(line, Vec3{0, 0, box.size.z});
  line.back() = '"';
  if (box.corner() != Vec3{} || box.is_unbounded || box.is_flat) {
    line += " Origin=\"";
    append_text(line, box.corner());
    line.back() = '"';
  }
  line += " pbc=\"";
  for (const bool is_periodic : box.is_periodic) line += is_periodic ? "T " : "F ";
  line.back() = '"';
  if (box.is_unbounded) line += " unbounded=T";
  if (box.is_flat) line += " dimensions=2";
  line += ' ';
  if (snapshot.time) {
    line += "Time=";
    append_text(line, *snapshot.time);
  }
  line += "Properties=";
  line += kProperties;
  if (types.are_finer_than_species()) line += kSpeciesProperties;
  if (snapshot.has_spins) line += kSpinProperties;
  line += kAseProperties;
  line += '\n';
  return line;
}

// The text of a number that is often the one before, as radii and masses are: writing a number costs more
// than copying its text.
class RepeatedText {
 public:
  void append_to(std::string& line, double number) {
    if (text_.empty() || number != number_) {
      number_ = number;
      text_.clear();
      append_text(text_, number);
    }
    line += text_;
  }

 private:
  double number_ = 0;
  std::string text_;
};

void append_xyz_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                     std::uint64_t /*frame*/, const AppendText& append) {
  append(to_text(spheres) + "\n" + comment_line(head, types));
}

void append_xyz_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const bool has_species = types.are_finer_than_species();
  std::string line;
  RepeatedText radius;
  RepeatedText mass;
  RepeatedText finite_mass;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line.clear();
    append_text(line, types.type_of(sphere) + 1);
    append_text(line, sphere.position);
    const std::size_t velocity_begin = line.size();
    append_text(line, sphere.velocity);
    const std::size_t velocity_end = line.size();
    radius.append_to(line, sphere.radius);
    mass.append_to(line, sphere.mass);
    append_text(line, snapshot.id(i));
    append_text(line, snapshot.image(i));
    if (has_species) append_text(line, sphere.species + 1);
    if (snapshot.has_spins) {
      append_text(line, sphere.spin);
      append_text(line, sphere.inertia_factor);
    }
    // With an infinite mass there would be no momentum.
    const double inertia = std::min(sphere.mass, kLargestMagnitude);
    if (inertia == 1) {
      line.append(line, velocity_begin, velocity_end - velocity_begin);
    } else {
      append_text(line, inertia * sphere.velocity);
    }
    finite_mass.append_to(line, inertia);
    line.back() = '\n';
    append(line);
  }
}

}  // namespace

TextFrame extended_xyz_frame() {
  return {append_xyz_head, append_xyz_spheres};
}

}  // namespace hardball
