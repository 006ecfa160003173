// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/sphere_csv.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/append_text.hpp"
#include "hardball/trajectory/sphere_columns.hpp"

namespace hardball {
namespace {

bool is_comment(const Lines& lines) {
  return next_token(lines.line(), 0).text.starts_with('#');
}

// The values between the commas, without blanks around them.
std::vector<Token> values_of(std::string_view line) {
  std::vector<Token> values;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::size_t first = std::min(line.find_first_not_of(kBlanks, begin), end);
    std::size_t last = end;
    while (last > first && kBlanks.find(line[last - 1]) != std::string_view::npos) --last;
    values.push_back({line.substr(first, last - first), first});
    begin = end + 1;
  }
  return values;
}

void skip_table(Lines& lines) {
  while (lines.next()) continue;
}

Snapshot read_table(Lines& lines) {
  while (is_comment(lines)) {
    if (lines.next_text()) continue;
    throw Error("the file has only comments", lines.location().text(), csv_format().remedy);
  }
  const std::string names(lines.line());
  const SphereColumns columns(values_of(names), lines.location());
  Snapshot snapshot;
  while (lines.next_text()) {
    if (!is_comment(lines)) columns.add(values_of(lines.line()), lines.location(), snapshot);
  }
  return snapshot;
}

}  // namespace

void append_csv(const Snapshot& snapshot, std::uint64_t /*frame*/, const AppendText& append) {
  append(snapshot.has_spins ? "id,type,x,y,z,vx,vy,vz,radius,mass,ix,iy,iz,omegax,omegay,omegaz,moment\n"
                            : "id,type,x,y,z,vx,vy,vz,radius,mass,ix,iy,iz\n");
  std::string line;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line.clear();
    append_text(line, snapshot.id(i));
    append_text(line, sphere.species + 1);
    append_text(line, sphere.position);
    append_text(line, sphere.velocity);
    append_text(line, sphere.radius);
    append_text(line, sphere.mass);
    append_text(line, snapshot.image(i));
    if (snapshot.has_spins) {
      append_text(line, sphere.spin);
      append_text(line, sphere.inertia_factor);
    }
    std::ranges::replace(line, ' ', ',');
    line.back() = '\n';
    append(line);
  }
}

TextFormat csv_format() {
  return {skip_table, read_table, "begin with a line that names the columns, such as x,y,z,vx,vy,vz,radius"};
}

}  // namespace hardball
