// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/spheres.hpp"

#include <cstdint>
#include <limits>

#include "hardball/errors/error.hpp"
#include "python/bindings/arrays.hpp"

namespace py = pybind11;

namespace hardball::python {

std::vector<Sphere> spheres_of(const py::object& positions, const py::object& velocities,
                               const py::object& radius, const py::object& mass, const py::object& spin,
                               const py::object& species, const py::object& moment, bool is_flat) {
  const std::vector<Vec3> centers = vectors_of(positions, "positions", is_flat);
  const std::size_t count = centers.size();
  const std::vector<Vec3> all_velocities = vectors_of(velocities, "velocities", is_flat, count);
  const std::vector<double> radii = numbers_of(radius, "radius", count);
  const std::vector<double> masses = numbers_of(mass, "mass", count);
  const std::vector<Vec3> spins = vectors_of(spin, "spin", is_flat, count);
  const std::vector<std::uint32_t> kinds =
      counts_of(species, "species", count, std::numeric_limits<SpeciesId>::max());
  const std::vector<double> moments =
      moment.is_none() ? std::vector<double>(count, is_flat ? kDiscInertiaFactor : kSphereInertiaFactor)
                       : numbers_of(moment, "moment", count);
  std::vector<Sphere> spheres;
  spheres.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    spheres.push_back({.position = centers[i],
                       .velocity = all_velocities[i],
                       .radius = radii[i],
                       .mass = masses[i],
                       .spin = spins[i],
                       .species = static_cast<SpeciesId>(kinds[i]),
                       .inertia_factor = moments[i]});
  }
  return spheres;
}

}  // namespace hardball::python
