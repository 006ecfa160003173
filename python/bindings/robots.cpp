// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/robots/robot_queries.hpp"
#include "hardball/robots/sphere_file.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/python_simulation.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

using Links = Typed<"Mapping[str, ArrayLike]">;
using Joints = Typed<"Sequence[Mapping[str, Any]]">;
using LinkPairs = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t kSphereColumns = 4;

// The rows of an array of two dimensions, the second of which has this length, if any is given.
std::vector<std::vector<double>> table_of(const py::handle& object, const std::string& name,
                                          std::optional<std::size_t> columns = std::nullopt) {
  const Doubles array = doubles(object, name);
  if (array.size() == 0 && array.ndim() < 2) return {};
  if (array.ndim() != 2 || (columns && static_cast<std::size_t>(array.shape(1)) != *columns)) {
    throw Error("it is no table of numbers", name,
                columns ? "give an array of shape (n, " + to_text(*columns) + ")"
                        : std::string("give an array with a row for each time"));
  }
  std::vector<std::vector<double>> rows;
  for (py::ssize_t row = 0; row < array.shape(0); ++row)
    rows.emplace_back(array.data(row), array.data(row) + array.shape(1));
  return rows;
}

std::vector<double> flat_list_of(const py::handle& object, const std::string& name) {
  const Doubles array = doubles(object, name);
  if (array.ndim() != 1) throw Error("it is no list of numbers", name, "give an array of shape (n,)");
  return {array.data(), array.data() + array.size()};
}

// From a matrix, or from a quaternion (w, x, y, z).
RotationMatrix rotation_of(const py::handle& object, const std::string& name) {
  const Doubles array = doubles(object, name);
  const double* const n = array.data();
  if (array.ndim() == 1 && array.size() == 4) {
    const RotationMatrix rotation = RotationMatrix::from_quaternion(n[0], n[1], n[2], n[3]);
    if (rotation.is_sound()) return rotation;
  } else if (array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 3) {
    // Its columns are the axes.
    return {{n[0], n[3], n[6]}, {n[1], n[4], n[7]}, {n[2], n[5], n[8]}};
  }
  throw Error("it is no rotation", name, "give a matrix of shape (3, 3) or a quaternion (w, x, y, z)");
}

std::vector<Link> links_of(const Links& given) {
  if (!py::isinstance<py::dict>(given))
    throw Error("it is not a dict", "links", "give one such as {'hand': [[x, y, z, radius]]}");
  std::vector<Link> links;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    Link link{py::str(key)};
    for (const std::vector<double>& row : table_of(value, "link '" + link.name + "'", kSphereColumns))
      link.spheres.push_back({{row[0], row[1], row[2]}, row[3]});
    links.push_back(std::move(link));
  }
  return links;
}

Joint joint_of(const py::handle& given, std::size_t number) {
  std::string where = "joint " + to_text(number);
  if (!py::isinstance<py::dict>(given))
    throw Error("it is not a dict", where, "give one with at least 'parent' and 'child'");
  Joint joint;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const std::string name = py::str(key);
    const std::string place = where + ": " + name;
    if (name == "name") {
      joint.name = py::str(value);
    } else if (name == "parent") {
      joint.parent = py::str(value);
    } else if (name == "child") {
      joint.child = py::str(value);
    } else if (name == "kind") {
      const std::string kind = py::str(value);
      if (kind == "revolute") {
        joint.kind = JointKind::revolute;
      } else if (kind == "prismatic") {
        joint.kind = JointKind::prismatic;
      } else if (kind == "fixed") {
        joint.kind = JointKind::fixed;
      } else {
        throw Error("there is no kind '" + shortened(kind) + "'", place,
                    "choose among 'revolute', 'prismatic' and 'fixed'");
      }
    } else if (name == "origin") {
      joint.origin = vector_of(value, place, false);
    } else if (name == "axis") {
      joint.axis = vector_of(value, place, false);
    } else if (name == "locked") {
      const Doubles coordinate = doubles(value, place);
      if (coordinate.ndim() != 0) throw Error("it is not one number", place, "give a number");
      joint.locked = *coordinate.data();
    } else if (name == "rotation") {
      joint.rotation = rotation_of(value, place);
    } else if (name == "rpy") {
      const Vec3 angles = vector_of(value, place, false);
      joint.rotation = RotationMatrix::from_angles(angles.x, angles.y, angles.z);
    } else {
      throw Error("there is no key '" + shortened(name) + "'", where,
                  "choose among name, kind, parent, child, origin, rotation, rpy, axis and locked");
    }
  }
  if (joint.parent.empty() || joint.child.empty())
    throw Error("it has no parent or no child", where, "name the two links that it joins");
  if (joint.name.empty()) joint.name = where;
  return joint;
}

Robot robot_of(const Links& links, const Joints& given, const LinkPairs& ignored) {
  if (!py::isinstance<py::sequence>(given))
    throw Error("it is not a list", "joints", "give a list of dicts, one for each joint");
  std::vector<Joint> joints;
  for (const py::handle& each : given) joints.push_back(joint_of(each, joints.size()));
  return Robot::from_spheres(links_of(links), joints, ignored);
}

SplineEnds ends_of(const std::string& name) {
  if (name == "natural") return SplineEnds::natural;
  if (name == "clamped") return SplineEnds::clamped;
  throw Error("there is no '" + shortened(name) + "'", "ends", "choose 'natural' or 'clamped'");
}

JointTrajectory trajectory_of_pieces(const ArrayLike& times, const ArrayLike& coefficients) {
  const Doubles array = doubles(coefficients, "coefficients");
  if (array.ndim() != 3 || array.shape(2) != 4) {
    throw Error("it is no table of cubic polynomials", "coefficients",
                "give an array of shape (pieces, joints, 4)");
  }
  std::vector<std::vector<JointTrajectory::Cubic>> pieces;
  for (py::ssize_t piece = 0; piece < array.shape(0); ++piece) {
    pieces.emplace_back();
    for (py::ssize_t joint = 0; joint < array.shape(1); ++joint) {
      const double* const c = array.data(piece, joint);
      pieces.back().push_back({c[0], c[1], c[2], c[3]});
    }
  }
  return JointTrajectory::from_pieces(flat_list_of(times, "times"), pieces);
}

std::size_t add_spheres(Obstacles& self, const ArrayLike& centers, const ArrayLike& radii,
                        const OptionalArrayLike& velocities, double time) {
  const std::vector<Vec3> places = vectors_of(centers, "centers", false);
  const std::vector<double> sizes = numbers_of(radii, "radii", places.size());
  std::vector<Vec3> ways(places.size());
  if (!velocities.is_none()) ways = vectors_of(velocities, "velocities", false, places.size());
  // To a copy, so that nothing changes where one is refused.
  Obstacles all = self;
  for (std::size_t k = 0; k < places.size(); ++k) all.add_sphere(places[k], sizes[k], ways[k], time);
  const std::size_t first = self.size();
  self = std::move(all);
  return first;
}

std::size_t add_mesh(Obstacles& self, const ArrayLike& vertices, const ArrayLike& triangles,
                     double thickness) {
  std::vector<std::array<std::uint32_t, 3>> corners;
  for (const std::vector<double>& row : table_of(triangles, "triangles", 3)) {
    corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(row[k] >= 0 && row[k] < 0x1p32)) {
        throw Error("a triangle has the vertex " + to_text(row[k]), "triangles",
                    "give the numbers of vertices");
      }
      corners.back()[k] = static_cast<std::uint32_t>(row[k]);
    }
  }
  return self.add_mesh(vectors_of(vertices, "vertices", false), corners, thickness);
}

std::string text_of(const RobotContact& contact) {
  return "<hardball.RobotContact at " + to_text(contact.time) + ": sphere " + to_text(contact.sphere) +
         (contact.obstacle ? " and obstacle " + to_text(*contact.obstacle)
                           : " and sphere " + to_text(contact.other_sphere.value_or(0))) +
         ", " + to_text(contact.distance) + " apart>";
}

void bind_robot(py::module_& module) {
  py::class_<Robot>(module, "Robot", doc::Robot)
      .def_static(
          "from_spheres", &robot_of, py::arg("links"), py::arg("joints"), py::arg("ignored") = LinkPairs(),
          "A robot from its links and joints. `links` gives the spheres of each link, as an array of "
          "shape (n, 4) with x, y, z and the radius, in the frame of the link [L]; links that only "
          "joints name have no spheres. Each of the `joints` is a dict with `parent` and `child`, and "
          "if need be `name`, `kind` ('revolute', 'prismatic' or 'fixed'), `origin` [L], `axis`, and a "
          "`rotation`, as a matrix or a quaternion (w, x, y, z), or angles `rpy`, as URDF has them. A joint "
          "that is "
          "`locked` keeps this coordinate, and does not move. "
          "`ignored` are pairs of names of links that do not meet each other. Error: two links or "
          "joints of one name; links that are not one tree; a radius that is not positive; a number "
          "that is not finite; an axis of length zero; a rotation that is none; an ignored link that "
          "does not exist. Cost: O(spheres^2).")
      .def_property_readonly("sphere_count", &Robot::sphere_count, doc::Robot_sphere_count)
      .def_property_readonly("joint_count", &Robot::joint_count, doc::Robot_joint_count)
      .def_property_readonly(
          "joint_names",
          [](const Robot& self) {
            return std::vector<std::string>(self.joint_names().begin(), self.joint_names().end());
          },
          doc::Robot_joint_names)
      .def_property_readonly(
          "link_names",
          [](const Robot& self) {
            return std::vector<std::string>(self.link_names().begin(), self.link_names().end());
          },
          doc::Robot_link_names)
      .def(
          "link_of",
          [](const Robot& self, std::size_t sphere) {
            if (sphere >= self.sphere_count())
              throw Error("there is no sphere " + to_text(sphere), "link_of", "give the number of one");
            return self.link_names()[self.link_of(sphere)];
          },
          py::arg("sphere"), "The name of the link that has a sphere. Error: there is no such sphere.")
      .def_property_readonly(
          "radii",
          [](const Robot& self) {
            std::vector<double> radii;
            for (std::size_t k = 0; k < self.sphere_count(); ++k) radii.push_back(self.radius(k));
            return read_only(array_around(std::move(radii)));
          },
          "The radii of all spheres [L], of shape (spheres,).")
      .def(
          "centers",
          [](const Robot& self, const ArrayLike& coordinates) {
            return array_around(self.centers(flat_list_of(coordinates, "coordinates")));
          },
          py::arg("coordinates"), doc::Robot_centers)
      .def("__repr__", [](const Robot& self) {
        return "<hardball.Robot: " + to_text(self.sphere_count()) + " spheres, " +
               to_text(self.joint_count()) + " joints>";
      });
}

void bind_joint_trajectory(py::module_& module) {
  py::class_<JointTrajectory>(module, "JointTrajectory", doc::JointTrajectory)
      .def_static(
          "cubic",
          [](const ArrayLike& times, const ArrayLike& coordinates, const std::string& ends) {
            return JointTrajectory::cubic(flat_list_of(times, "times"), table_of(coordinates, "coordinates"),
                                          ends_of(ends));
          },
          py::arg("times"), py::arg("coordinates"), py::arg("ends") = "natural",
          (std::string(doc::JointTrajectory_cubic) +
           " `ends` is 'natural', for second derivatives of zero at both ends, or 'clamped', for first ones.")
              .c_str())
      .def_static(
          "linear",
          [](const ArrayLike& times, const ArrayLike& coordinates) {
            return JointTrajectory::linear(flat_list_of(times, "times"),
                                           table_of(coordinates, "coordinates"));
          },
          py::arg("times"), py::arg("coordinates"), doc::JointTrajectory_linear)
      .def_static(
          "from_rates",
          [](const ArrayLike& times, const ArrayLike& coordinates, const ArrayLike& rates) {
            return JointTrajectory::from_rates(
                flat_list_of(times, "times"), table_of(coordinates, "coordinates"), table_of(rates, "rates"));
          },
          py::arg("times"), py::arg("coordinates"), py::arg("rates"), doc::JointTrajectory_from_rates)
      .def_static(
          "from_pieces", &trajectory_of_pieces, py::arg("times"), py::arg("coefficients"),
          "Polynomials of the time since the last knot: coefficients[k, j] are those of joint j from "
          "knot k on, from the constant to the cube. Error: as for cubic; a coordinate that jumps at a "
          "knot by more than 1e-9 of it, or of one.")
      .def_property_readonly(
          "times",
          [](const JointTrajectory& self) {
            return read_only(array_around(std::vector<double>(self.times().begin(), self.times().end())));
          },
          doc::JointTrajectory_times)
      .def_property_readonly("joint_count", &JointTrajectory::joint_count, doc::JointTrajectory_joint_count)
      .def(
          "coordinates_at",
          [](const JointTrajectory& self, double time) { return array_around(self.coordinates_at(time)); },
          py::arg("time"), doc::JointTrajectory_coordinates_at)
      .def("__repr__", [](const JointTrajectory& self) {
        return "<hardball.JointTrajectory: " + to_text(self.joint_count()) + " joints from " +
               to_text(self.begin()) + " to " + to_text(self.end()) + ">";
      });
}

void bind_obstacles(py::module_& module) {
  py::class_<Obstacles>(module, "Obstacles", doc::Obstacles)
      .def(py::init<>(), "No obstacles; add them.")
      .def("add_spheres", &add_spheres, py::arg("centers"), py::arg("radii"),
           py::arg("velocities") = py::none(), py::arg("time") = 0.0,
           "Adds spheres around `centers`, of shape (n, 3) [L], and returns the number of the first. One "
           "radius [L] stands for all. With `velocities` [L/T] they move straight, and are at their centers "
           "at `time` [T]. Error: an array of another shape; a number that is not finite; a radius that is "
           "not "
           "positive.")
      .def(
          "add_box",
          [](Obstacles& self, const ArrayLike& center, const ArrayLike& size,
             const OptionalArrayLike& rotation) {
            return self.add_box(vector_of(center, "center", false), vector_of(size, "size", false),
                                rotation.is_none() ? RotationMatrix() : rotation_of(rotation, "rotation"));
          },
          py::arg("center"), py::arg("size"), py::arg("rotation") = py::none(),
          (std::string(doc::Obstacles_add_box) +
           " The rotation is a matrix of shape (3, 3) or a quaternion (w, x, y, z).")
              .c_str())
      .def(
          "add_capsule",
          [](Obstacles& self, const ArrayLike& begin, const ArrayLike& end, double radius) {
            return self.add_capsule(vector_of(begin, "begin", false), vector_of(end, "end", false), radius);
          },
          py::arg("begin"), py::arg("end"), py::arg("radius"), doc::Obstacles_add_capsule)
      .def(
          "add_plane",
          [](Obstacles& self, const ArrayLike& point, const ArrayLike& normal) {
            return self.add_plane(vector_of(point, "point", false), vector_of(normal, "normal", false));
          },
          py::arg("point"), py::arg("normal"), doc::Obstacles_add_plane)
      .def("add_mesh", &add_mesh, py::arg("vertices"), py::arg("triangles"), py::arg("thickness") = 0.0,
           doc::Obstacles_add_mesh)
      .def(
          "add_simulation",
          [](Obstacles& self, const PythonSimulation& simulation) {
            return self.add_world(simulation.simulation().world(), Time(simulation.simulation().time()));
          },
          py::arg("simulation"),
          "Adds everything in a simulation from its present on, as if nothing collided: its spheres, in the "
          "order of ids, then the walls of its box, by the number of the face, and its surfaces. Returns the "
          "number of the first. Error: a box that is periodic; gravity or growth; surfaces that are neither "
          "planes nor obstacles, or that move.")
      .def("__len__", &Obstacles::size)
      .def("__repr__",
           [](const Obstacles& self) { return "<hardball.Obstacles: " + to_text(self.size()) + ">"; });
}

void bind_robot_contact(py::module_& module) {
  py::class_<RobotContact>(module, "RobotContact", doc::RobotContact)
      .def_readonly("time", &RobotContact::time, doc::RobotContact_time)
      .def_readonly("sphere", &RobotContact::sphere, doc::RobotContact_sphere)
      .def_readonly("obstacle", &RobotContact::obstacle, doc::RobotContact_obstacle)
      .def_readonly("other_sphere", &RobotContact::other_sphere, doc::RobotContact_other_sphere)
      .def_readonly("distance", &RobotContact::distance, doc::RobotContact_distance)
      .def_property_readonly(
          "point", [](const RobotContact& self) { return array_of(self.point); }, doc::RobotContact_point)
      .def_property_readonly(
          "normal", [](const RobotContact& self) { return array_of(self.normal); }, doc::RobotContact_normal)
      .def("__repr__", [](const RobotContact& self) { return text_of(self); });
}

}  // namespace

void bind_robots(py::module_& module) {
  bind_robot(module);
  bind_joint_trajectory(module);
  bind_obstacles(module);
  bind_robot_contact(module);
  const py::arg robot("robot");
  const py::arg trajectory("trajectory");
  const py::arg trajectories("trajectories");
  const py::arg obstacles("obstacles");
  const py::arg_v clearance = py::arg("clearance") = 0.0;
  const py::arg_v tolerance = py::arg("tolerance") = 1e-9;
  const py::arg_v threads = py::arg("threads") = 0;
  module.def(
      "first_contact",
      [](const Robot& its, const JointTrajectory& way, const Obstacles& others, double distance) {
        const py::gil_scoped_release released;
        return first_contact(its, way, others, distance);
      },
      robot, trajectory, obstacles, clearance, doc::first_contact_Robot);
  module.def(
      "first_contacts",
      [](const Robot& its, const std::vector<JointTrajectory>& ways, const Obstacles& others, double distance,
         std::size_t count) {
        const py::gil_scoped_release released;
        return first_contacts(its, ways, others, distance, count);
      },
      robot, trajectories, obstacles, clearance, threads, doc::first_contacts);
  module.def(
      "least_clearance",
      [](const Robot& its, const JointTrajectory& way, const Obstacles& others, double error) {
        const py::gil_scoped_release released;
        return least_clearance(its, way, others, error);
      },
      robot, trajectory, obstacles, tolerance, doc::least_clearance);
  module.def(
      "least_clearances",
      [](const Robot& its, const std::vector<JointTrajectory>& ways, const Obstacles& others, double error,
         std::size_t count) {
        const py::gil_scoped_release released;
        return least_clearances(its, ways, others, error, count);
      },
      robot, trajectories, obstacles, tolerance, threads, doc::least_clearances);
  module.def(
      "read_spheres",
      [](const std::filesystem::path& path) {
        const SphereFile file = read_spheres(path);
        py::dict links;
        for (const Link& link : file.links) {
          py::array_t<double> rows({link.spheres.size(), kSphereColumns});
          double* number = rows.mutable_data();
          for (const LinkSphere& sphere : link.spheres) {
            for (std::size_t axis = 0; axis < kAxes; ++axis) *number++ = sphere.center[axis];
            *number++ = sphere.radius;
          }
          links[py::str(link.name)] = rows;
        }
        return std::tuple<Typed<"dict[str, NDArray[numpy.float64]]">, LinkPairs>(links, file.ignored);
      },
      py::arg("path"),
      (std::string(doc::read_spheres) +
       " Returns the links and the ignored pairs, as Robot.from_spheres takes them.")
          .c_str());
}

}  // namespace hardball::python
