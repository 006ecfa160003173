// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/request_text.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/standard/number_text.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& where, const std::string& remedy) {
  throw Error("'" + text + "' is not accepted", where, remedy);
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, status] = from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

template <class Number>
Number parse(const std::string& text, const std::string& where, const std::string& remedy) {
  if (const auto number = number_in<Number>(text)) return *number;
  refuse(text, where, remedy);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

// Positive numbers with commas between them, or with colons if they are only proportions.
struct Lengths {
  std::vector<double> values;
  bool are_proportions = false;
};

Lengths parse_lengths(const std::string& text, std::size_t least, std::size_t most, const std::string& where,
                      const std::string& remedy) {
  Lengths lengths;
  lengths.are_proportions = text.find(':') != std::string::npos;
  for (const std::string& part : split(text, lengths.are_proportions ? ':' : ',')) {
    const auto value = number_in<double>(part);
    if (!value || !(*value >= kSmallestMagnitude && *value <= kLargestMagnitude)) refuse(text, where, remedy);
    lengths.values.push_back(*value);
  }
  if (lengths.values.size() < least || lengths.values.size() > most) refuse(text, where, remedy);
  return lengths;
}

void read_box(const PackingText& text, const std::string& prefix, PackingRequest& request) {
  const std::size_t dimensions = request.dimensions;
  Container container;
  container.dimensions = dimensions;
  container.size = {1, 1, dimensions == 2 ? 0.0 : 1.0};
  request.is_container_size_free = true;
  if (text.box) {
    const std::string remedy = dimensions == 2
                                   ? "give two edges, as in 10,20, or proportions, as in 1:2"
                                   : "give three edges, as in 10,10,20, or proportions, as in 1:1:2";
    const Lengths lengths = parse_lengths(*text.box, 1, dimensions, prefix + "box", remedy);
    if (lengths.values.size() != 1 && lengths.values.size() != dimensions)
      refuse(*text.box, prefix + "box", remedy);
    for (std::size_t axis = 0; axis < dimensions; ++axis)
      container.size[axis] = lengths.values[lengths.values.size() == 1 ? 0 : axis];
    request.is_container_size_free = lengths.are_proportions;
  }
  if (text.walls) {
    constexpr std::string_view kAxisNames = "xyz";
    for (const char letter : *text.walls) {
      const std::size_t axis = kAxisNames.find(letter);
      if (axis >= dimensions) refuse(*text.walls, prefix + "walls", "name axes with walls, as in z, or xy");
      container.has_walls[axis] = true;
    }
  }
  request.container = container;
}

// The mesh of a file, with a comma before its scale if that is given.
Container read_mesh_container(const std::string& text, std::optional<double>& scale) {
  const std::size_t comma = text.rfind(',');
  std::string file = text;
  if (comma != std::string::npos) scale = number_in<double>(std::string_view(text).substr(comma + 1));
  if (scale) file.resize(comma);
  return Container::within(std::make_shared<const Mesh>(read_mesh(file)), scale.value_or(1), file);
}

void read_container(const PackingText& text, const std::string& prefix, PackingRequest& request) {
  const std::string where = prefix + "container";
  const std::string& whole = *text.container;
  const std::string remedy =
      "give cylinder:DIAMETER,HEIGHT, sphere:DIAMETER, shell:INNER,OUTER, annulus:INNER,OUTER,HEIGHT, "
      "cone:DIAMETER,HEIGHT, "
      "truncated_cone:BOTTOM,TOP,HEIGHT or slab:X,Y,HEIGHT, with colons between proportions, or mesh:FILE or "
      "mesh:FILE,SCALE";
  const std::size_t colon = whole.find(':');
  const std::string name = whole.substr(0, colon);
  const std::string sizes = colon == std::string::npos ? "" : whole.substr(colon + 1);
  Container container;
  container.dimensions = request.dimensions;
  if (name == "sphere") {
    container.shape = Container::Shape::sphere;
    const double diameter = sizes.empty() ? 1 : parse_lengths(sizes, 1, 1, where, remedy).values.front();
    container.size = {diameter, diameter, request.dimensions == 2 ? 0 : diameter};
    request.is_container_size_free = sizes.empty();
  } else if (name == "cylinder" || name == "cone") {
    container.shape = name == "cone" ? Container::Shape::cone : Container::Shape::cylinder;
    const Lengths lengths = parse_lengths(sizes, 2, 2, where, remedy);
    container.size = {lengths.values[0], lengths.values[0], lengths.values[1]};
    request.is_container_size_free = lengths.are_proportions;
  } else if (name == "shell") {
    container.shape = Container::Shape::shell;
    const Lengths lengths = parse_lengths(sizes, 2, 2, where, remedy);
    container.inner = lengths.values[0];
    const double outer = lengths.values[1];
    container.size = {outer, outer, request.dimensions == 2 ? 0 : outer};
    request.is_container_size_free = lengths.are_proportions;
  } else if (name == "truncated_cone" || name == "annulus") {
    using enum Container::Shape;
    container.shape = name == "annulus" ? annulus : truncated_cone;
    const Lengths lengths = parse_lengths(sizes, 3, 3, where, remedy);
    container.inner = lengths.values[0];
    container.size = {lengths.values[1], lengths.values[1], lengths.values[2]};
    request.is_container_size_free = lengths.are_proportions;
  } else if (name == "mesh") {
    if (sizes.empty()) refuse(whole, where, remedy);
    std::optional<double> scale;
    container = read_mesh_container(sizes, scale);
    request.is_container_size_free = !scale;
  } else if (name == "slab") {
    const Lengths lengths = parse_lengths(sizes, request.dimensions, request.dimensions, where, remedy);
    for (std::size_t axis = 0; axis < request.dimensions; ++axis) container.size[axis] = lengths.values[axis];
    container.has_walls[request.dimensions - 1] = true;
    request.is_container_size_free = lengths.are_proportions;
  } else {
    refuse(whole, where, remedy);
  }
  request.container = container;
}

void read_sizes(const std::string& text, const std::string& where, PackingRequest& request) {
  const std::string remedy =
      "give lognormal:SIGMA, uniform:MIN,MAX, powerlaw:EXPONENT,MIN,MAX, discrete:SIZE=SHARE,SIZE=SHARE or "
      "file:FILE";
  using Kind = RadiusDistribution::Kind;
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (name == "file") {
    request.radii = read_radii(rest, where);
    if (request.radii.empty())
      throw Error("the file " + rest + " is empty", where, "give one radius on each line");
    return;
  }
  RadiusDistribution sizes;
  sizes.where = where;
  const auto numbers = [&](std::size_t count) {
    std::vector<double> found;
    for (const std::string& part : split(rest, ',')) {
      const auto number = number_in<double>(part);
      if (!number || !(std::fabs(*number) <= kLargestMagnitude)) refuse(text, where, remedy);
      found.push_back(*number);
    }
    if (found.size() != count) refuse(text, where, remedy);
    return found;
  };
  const auto set_range = [&](double min, double max) {
    if (!(min >= kSmallestMagnitude && min <= max)) refuse(text, where, remedy);
    sizes.min = min;
    sizes.max = max;
  };
  if (name == "lognormal") {
    sizes.kind = Kind::lognormal;
    sizes.mean = 1;
    sizes.sigma = numbers(1)[0];
    constexpr double kWidest = 3;
    if (!(sizes.sigma >= 0 && sizes.sigma <= kWidest)) refuse(text, where, remedy + "; SIGMA is at most 3");
    set_range(kSmallestMagnitude, kLargestMagnitude);
  } else if (name == "uniform") {
    sizes.kind = Kind::uniform;
    const std::vector<double> ends = numbers(2);
    set_range(ends[0], ends[1]);
  } else if (name == "powerlaw") {
    sizes.kind = Kind::powerlaw;
    const std::vector<double> all = numbers(3);
    sizes.exponent = all[0];
    set_range(all[1], all[2]);
  } else if (name == "discrete") {
    sizes.kind = Kind::discrete;
    for (const std::string& part : split(rest, ',')) {
      const std::size_t equals = part.find('=');
      const auto size = number_in<double>(std::string_view(part).substr(0, equals));
      const auto share = equals == std::string::npos
                             ? std::optional(1.0)
                             : number_in<double>(std::string_view(part).substr(equals + 1));
      const bool is_good = size && share && *size >= kSmallestMagnitude && *size <= kLargestMagnitude &&
                           *share >= kSmallestMagnitude && *share <= kLargestMagnitude;
      if (!is_good) refuse(text, where, remedy);
      sizes.values.push_back(*size);
      sizes.weights.push_back(*share);
    }
  } else {
    refuse(text, where, remedy);
  }
  request.distribution = sizes;
}

}  // namespace

PackingRequest parse_request(const PackingText& text, const std::string& prefix) {
  PackingRequest request;
  const auto number = [&](const std::optional<std::string>& part, const std::string& name,
                          const std::string& remedy) -> std::optional<double> {
    if (!part) return {};
    const double value = parse<double>(*part, prefix + name, remedy);
    if (!std::isfinite(value)) refuse(*part, prefix + name, remedy);
    return value;
  };
  const auto positive = [&](const std::optional<std::string>& part, const std::string& name) {
    const std::optional<double> value = number(part, name, "give a positive number");
    if (value) check_positive(*value, name, prefix + name);
    return value;
  };
  if (text.dimensions) {
    const std::string remedy = "give 2 or 3";
    request.dimensions = parse<std::size_t>(*text.dimensions, prefix + "dimensions", remedy);
    if (request.dimensions != 2 && request.dimensions != 3)
      refuse(*text.dimensions, prefix + "dimensions", remedy);
  }
  constexpr std::size_t kMost = 4'000'000'000;
  if (text.count) {
    const std::string remedy = "give a number from 1 to 4000000000";
    request.count = parse<std::size_t>(*text.count, prefix + "count", remedy);
    if (*request.count < 1 || *request.count > kMost) refuse(*text.count, prefix + "count", remedy);
  }
  request.diameter = positive(text.diameter, "diameter");
  request.rate = positive(text.rate, "rate");
  request.gap = number(text.gap, "gap", "give a fraction of the diameter").value_or(0);
  if (text.seed) request.seed = parse<std::uint64_t>(*text.seed, prefix + "seed", "give a number from 0 on");
  if (text.sizes) read_sizes(*text.sizes, prefix + "sizes", request);
  if (text.container && (text.box || text.walls)) {
    throw Error("there is a container, and a box or its walls", prefix + "container", "give one of the two");
  }
  if (text.container) {
    read_container(text, prefix, request);
  } else if (text.box || text.walls) {
    read_box(text, prefix, request);
  }
  if (text.phi && text.pressure)
    throw Error("a packing fraction and a pressure are given", prefix + "pressure", "give one of the two");
  if (text.phi) {
    request.goal = *text.phi == "max" ? PackingRequest::Goal(PackingRequest::Densest{})
                                      : PackingRequest::Goal(*positive(text.phi, "phi"));
  }
  if (text.pressure) request.goal = PackingRequest::Pressure{*positive(text.pressure, "pressure")};
  if (text.start) request.start = read_snapshot(*text.start);
  return request;
}

}  // namespace hardball
