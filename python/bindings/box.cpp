// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/box.hpp"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/surfaces/surface.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"
#include "python/bindings/pickling.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

using Faces = Typed<"Mapping[str, Mapping[str, Any]] | None">;

// A surface does not know of which box it will be.
constexpr bool kMayBeFlat = true;

Boundary boundary_of(const py::handle& name) {
  const auto found = find_named<Boundary>(py::str(name).cast<std::string>());
  if (found) return *found;
  throw Error("there is no boundary " + py::repr(name).cast<std::string>(), "boundary",
              "choose among 'wall', 'periodic', 'open' and, for z, 'flat'");
}

std::array<Boundary, kAxes> boundaries_of(const py::handle& names) {
  if (py::isinstance<py::str>(names) || !py::isinstance<py::sequence>(names) || py::len(names) != kAxes) {
    throw Error("it is " + py::repr(names).cast<std::string>(), "boundary",
                "give three names, as in ('wall', 'periodic', 'open')");
  }
  const auto each = py::reinterpret_borrow<py::sequence>(names);
  return {boundary_of(each[0]), boundary_of(each[1]), boundary_of(each[2])};
}

Face face_named(const std::string& name) {
  std::string names;
  for (Face face = 0; face < kFaces; ++face) {
    if (name == kFaceNames[face]) return face;
    names += (face > 0 ? ", '" : "'") + std::string(kFaceNames[face]) + "'";
  }
  throw Error("there is no face '" + name + "'", "faces", "choose among " + names);
}

double number_of(const py::handle& given, const std::string& name) {
  const Doubles number = doubles(given, name);
  if (number.ndim() == 0) return *number.data();
  throw Error("it is not one number", name, "give a number");
}

// Of a face, by their names in scenarios, and the seed of its random numbers.
FaceProperties properties_of(const py::handle& given, const std::string& face) {
  const std::string where = "face " + face;
  if (!py::isinstance<py::dict>(given)) {
    throw Error("it is not a dict", where, "give one such as {'temperature': 2.0}");
  }
  FaceProperties properties;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const std::string name = py::str(key);
    if (name == "restitution") {
      properties.material.restitution = number_of(value, where + ": restitution");
    } else if (name == "tangential_restitution") {
      properties.material.tangential_restitution = number_of(value, where + ": tangential_restitution");
    } else if (name == "temperature") {
      properties.material.temperature = number_of(value, where + ": temperature");
    } else if (name == "seed") {
      properties.material.seed = static_cast<std::uint64_t>(number_of(value, where + ": seed"));
    } else if (name == "velocity") {
      properties.velocity = vector_of(value, where + ": velocity", kMayBeFlat);
    } else {
      throw Error(
          "there is no property '" + name + "'", where,
          "choose among 'restitution', 'tangential_restitution', 'temperature', 'velocity' and 'seed'");
    }
  }
  return properties;
}

Box with_faces(Box box, const Faces& faces) {
  if (faces.is_none()) return box;
  if (!py::isinstance<py::dict>(faces)) {
    throw Error("it is not a dict", "faces", "give one such as {'z_min': {'temperature': 2.0}}");
  }
  for (const auto& [key, value] : faces.cast<py::dict>()) {
    const std::string name = py::str(key);
    box.set_face(face_named(name), properties_of(value, name));
  }
  return box;
}

// What with_faces takes.
Typed<"dict[str, dict[str, Any]]"> faces_of(const Box& box) {
  py::dict faces;
  for (Face face = 0; face < kFaces; ++face) {
    if (!box.has_own_properties(face)) continue;
    const auto& [material, velocity] = box.face(face);
    py::dict properties;
    if (material.restitution) properties["restitution"] = *material.restitution;
    if (material.tangential_restitution)
      properties["tangential_restitution"] = *material.tangential_restitution;
    if (material.temperature) properties["temperature"] = *material.temperature;
    if (velocity != Vec3{}) properties["velocity"] = py::make_tuple(velocity.x, velocity.y, velocity.z);
    if (material.seed != 0) properties["seed"] = material.seed;
    faces[py::str(std::string(kFaceNames[face]))] = properties;
  }
  return faces;
}

// One length for all axes, or one for each; two lengths are those of a plane.
Box box_of(Boundary boundary, const py::handle& size, bool is_flat) {
  const Doubles lengths = doubles(size, "size");
  const std::string remedy = is_flat ? "give one length, or two" : "give one length, or three";
  const py::ssize_t axes = is_flat ? 2 : 3;
  if (lengths.ndim() > 1 || (lengths.ndim() == 1 && lengths.shape(0) != axes)) {
    throw Error("it is not one length, nor one for each axis", "size", remedy);
  }
  const auto length = [&](py::ssize_t axis) { return lengths.data()[lengths.ndim() == 0 ? 0 : axis]; };
  if (is_flat) return {{boundary, boundary, Boundary::flat}, {length(0), length(1), 0}};
  return {{boundary, boundary, boundary}, {length(0), length(1), length(2)}};
}

Box sheared(Box box, double rate, double offset) {
  box.set_shear({.rate = rate, .offset = offset});
  return box;
}

std::string text_of(const Box& box) {
  std::string boundaries;
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    boundaries += std::string(axis > 0 ? ", '" : "'") + std::string(name_of(box.boundary(axis))) + "'";
    if (box.is_bounded(axis)) size[axis] = box.size()[axis];
  }
  CallText call = CallText("Box").add("(" + boundaries + ")").add(size);
  if (!box.has_plain_faces()) call.add("faces", py::repr(faces_of(box)).cast<std::string>());
  if (box.shear().rate != 0) call.add("shear_rate", box.shear().rate);
  if (box.shear().offset != 0) call.add("shear_offset", box.shear().offset);
  return call.text();
}

std::string text_of(const Surface& surface) {
  const Shape shape = surface.shape_at_rest();
  CallText call = std::visit(
      [](const auto& its) {
        CallText made("Surface." + std::string(its.kName));
        for_each_value(its, [&](const auto&, const auto& value) { made.add(value); });
        return made;
      },
      shape);
  if (surface.mesh())
    call.add("<Mesh of " + to_text(surface.mesh()->mesh().triangles().size()) + " triangles>");
  if (surface.point() != Vec3{}) call.add("point", surface.point());
  if (surface.velocity() != Vec3{}) call.add("velocity", surface.velocity());
  if (const auto* const plane = std::get_if<OscillatingPlane>(&surface.shape())) {
    call.add("amplitude", plane->amplitude()).add("frequency", plane->frequency());
  }
  const SurfaceMaterial& material = surface.material();
  if (material.restitution) call.add("restitution", *material.restitution);
  if (material.tangential_restitution) call.add("tangential_restitution", *material.tangential_restitution);
  if (material.temperature) call.add("temperature", *material.temperature);
  if (material.seed != 0) call.add("seed", to_text(material.seed));
  return call.text();
}

Vec3 unit(const Vec3& direction) {
  const double norm = length(direction);
  if (!(norm > 0 && norm < std::numeric_limits<double>::infinity())) {
    throw Error("the direction has length zero", "surface", "give a vector that is not zero");
  }
  return (1 / norm) * direction;
}

// What a value of a field is in Python: a vector, of any length where it is a direction, or a number.
template <class Get>
using Given = std::conditional_t<std::is_same_v<typename Field<Get>::Value, Vec3>, ArrayLike, double>;

Vec3 value_of(const ArrayLike& direction, std::string_view name) {
  return unit(vector_of(direction, std::string(name), kMayBeFlat));
}
double value_of(double number, std::string_view) {
  return number;
}

Surface surface_of(const Shape& shape, const ArrayLike& point, const ArrayLike& velocity,
                   std::optional<double> restitution, std::optional<double> tangential_restitution,
                   std::optional<double> temperature, std::uint64_t seed) {
  return Surface(shape, vector_of(point, "point", kMayBeFlat), vector_of(velocity, "velocity", kMayBeFlat),
                 {.restitution = restitution,
                  .tangential_restitution = tangential_restitution,
                  .temperature = temperature,
                  .seed = seed});
}

// What it is, and the fields that describe it.
template <class S>
std::string documentation_of() {
  std::string text(S::kMeaning);
  for_each_field<S>([&](const auto& field) {
    const std::string unit = field.dimension.empty() ? "" : " [" + std::string(field.dimension) + "]";
    text += " `" + std::string(field.name) + "`" + unit + ": " + std::string(field.meaning) + ".";
  });
  if constexpr (requires { S::kPoint; }) text += " `point` [L]: " + std::string(S::kPoint) + ".";
  return text;
}

// Defines Surface.NAME(fields, point, *, velocity, extra, ...), by which a surface of this shape is made.
template <class S>
void define(py::class_<Surface>& surface, const auto& make, const std::string& remark, const auto&... extra) {
  const py::tuple origin = py::make_tuple(0.0, 0.0, 0.0);
  const auto with_fields = [&](const auto&... field) {
    surface.def_static(S::kName.data(), make, py::arg(field.name.data())..., py::arg("point") = origin,
                       py::kw_only(), py::arg("velocity") = origin, extra...,
                       py::arg("restitution") = py::none(), py::arg("tangential_restitution") = py::none(),
                       py::arg("temperature") = py::none(), py::arg("seed") = 0,
                       (documentation_of<S>() + remark).c_str());
  };
  std::apply(with_fields, S::fields());
}

template <class S>
void bind_shape(py::class_<Surface>& surface) {
  const auto with_fields = [&]<class... Get>(const Field<Get>&... field) {
    define<S>(
        surface,
        [field...](const Given<Get>&... given, const ArrayLike& point, const ArrayLike& velocity,
                   std::optional<double> restitution, std::optional<double> tangential_restitution,
                   std::optional<double> temperature, std::uint64_t seed) {
          return surface_of(S{value_of(given, field.name)...}, point, velocity, restitution,
                            tangential_restitution, temperature, seed);
        },
        "");
  };
  std::apply(with_fields, S::fields());
}

void bind_plane(py::class_<Surface>& surface) {
  define<Plane>(
      surface,
      [](const ArrayLike& normal, const ArrayLike& point, const ArrayLike& velocity, double amplitude,
         double frequency, std::optional<double> restitution, std::optional<double> tangential_restitution,
         std::optional<double> temperature, std::uint64_t seed) {
        const Plane plane(value_of(normal, "normal"));
        return surface_of(oscillating(plane, amplitude, frequency), point, velocity, restitution,
                          tangential_restitution, temperature, seed);
      },
      " It may move, or oscillate along the normal with `amplitude` [L] and `frequency` [1/T].",
      py::arg("amplitude") = 0.0, py::arg("frequency") = 0.0);
}

void bind_mesh(py::class_<Surface>& surface) {
  const py::tuple origin = py::make_tuple(0.0, 0.0, 0.0);
  surface.def_static(
      MeshShape::kName.data(),
      [](const std::shared_ptr<Mesh>& mesh, const ArrayLike& point, const std::string& spheres,
         double thickness, const Faces& groups, const ArrayLike& velocity, std::optional<double> restitution,
         std::optional<double> tangential_restitution, std::optional<double> temperature,
         std::uint64_t seed) {
        MeshShape shape(mesh, value_named<MeshSide>(spheres, "spheres"), thickness);
        if (!groups.is_none() && !py::isinstance<py::dict>(groups))
          throw Error("it is not a dict", "groups", "give one such as {'belt': {'restitution': 0.3}}");
        if (!groups.is_none()) {
          for (const auto& [key, value] : groups.cast<py::dict>()) {
            const std::string name = py::str(key);
            shape.set_group_material(name, properties_of(value, name).material);
          }
        }
        return surface_of(shape, point, velocity, restitution, tangential_restitution, temperature, seed);
      },
      py::arg("mesh"), py::arg("point") = origin, py::kw_only(), py::arg("spheres") = "both",
      py::arg("thickness") = 0.0, py::arg("groups") = py::none(), py::arg("velocity") = origin,
      py::arg("restitution") = py::none(), py::arg("tangential_restitution") = py::none(),
      py::arg("temperature") = py::none(), py::arg("seed") = 0,
      "A mesh that spheres touch from both sides. `point` [L]: where the origin of the mesh is. `spheres`: "
      "where they "
      "are placed and stay, 'inside' or 'outside' of a closed mesh, or on 'both' sides. `thickness` [L] is "
      "added to "
      "the radius of every sphere. `groups` gives groups of triangles their own properties: {'belt': "
      "{'restitution': "
      "0.3}}.");
}

void bind_surface(py::module_& module) {
  py::class_<Surface> surface(module, "Surface", doc::Surface);
  bind_plane(surface);
  bind_mesh(surface);
  for_each_alternative<Shape>([&]<class S>(std::type_identity<S>) {
    if constexpr (requires { S::kMeaning; } && !std::is_same_v<S, Plane>) bind_shape<S>(surface);
  });
  surface.def_property_readonly("name", [](const Surface& self) { return std::string(self.name()); })
      .def_property_readonly(
          "point", [](const Surface& self) { return read_only(array_of(self.point())); },
          "The point at time zero [L].")
      .def_property_readonly(
          "velocity", [](const Surface& self) { return read_only(array_of(self.velocity())); }, "[L/T]")
      .def("__repr__", [](const Surface& self) { return text_of(self); });
}

}  // namespace

void bind_box(py::module_& module) {
  py::class_<Box>(module, "Box", doc::Box)
      .def(
          py::init([](const Typed<"Sequence[str]">& boundary, const ArrayLike& size, const Faces& faces,
                      double shear_rate, double shear_offset) {
            const std::array<Boundary, kAxes> boundaries = boundaries_of(boundary);
            const Box box = with_faces({boundaries, vector_of(size, "size", kMayBeFlat)}, faces);
            return sheared(box, shear_rate, shear_offset);
          }),
          py::arg("boundary"), py::arg("size"), py::kw_only(), py::arg("faces") = py::none(),
          py::arg("shear_rate") = 0.0, py::arg("shear_offset") = 0.0,
          "`boundary` has one of 'wall', 'periodic', 'open' or, for z, 'flat' for each axis. `size` has the "
          "edge lengths [L], ignored for open and flat axes. `faces` gives walls their own properties: "
          "{'z_min': {'temperature': 2.0, 'velocity': [1, 0, 0]}, 'z_max': {'restitution': 0.8}}. "
          "`shear_rate` [1/T] is how much the flow along x grows along y, `shear_offset` [L] by how much the "
          "image above is displaced along x at time zero; both axes must be periodic.")
      .def_static(
          "walls",
          [](const ArrayLike& size, const Faces& faces) {
            return with_faces(box_of(Boundary::wall, size, false), faces);
          },
          py::arg("size"), py::kw_only(), py::arg("faces") = py::none(),
          "A box with hard walls. `size` is the edge [L], or one length for each axis; `faces` as in Box.")
      .def_static(
          "periodic",
          [](const ArrayLike& size, double shear_rate, double shear_offset) {
            return sheared(box_of(Boundary::periodic, size, false), shear_rate, shear_offset);
          },
          py::arg("size"), py::kw_only(), py::arg("shear_rate") = 0.0, py::arg("shear_offset") = 0.0,
          "A box in which spheres that leave at one end enter at the other. `size` is the edge [L], or one "
          "length "
          "for each axis; `shear_rate` and `shear_offset` as in Box.")
      .def_static("open", &Box::open, "Unbounded space.")
      .def_static(
          "flat_walls",
          [](const ArrayLike& size, const Faces& faces) {
            return with_faces(box_of(Boundary::wall, size, true), faces);
          },
          py::arg("size"), py::kw_only(), py::arg("faces") = py::none(),
          "A box with hard walls in two dimensions: spheres are discs.")
      .def_static(
          "flat_periodic",
          [](const ArrayLike& size, double shear_rate, double shear_offset) {
            return sheared(box_of(Boundary::periodic, size, true), shear_rate, shear_offset);
          },
          py::arg("size"), py::kw_only(), py::arg("shear_rate") = 0.0, py::arg("shear_offset") = 0.0,
          "A periodic box in two dimensions: spheres are discs.")
      .def_static("flat_open", &Box::flat_open, "The whole plane: spheres are discs.")
      .def_property_readonly(
          "boundary",
          [](const Box& self) {
            return std::tuple(name_of(self.boundary(0)), name_of(self.boundary(1)),
                              name_of(self.boundary(2)));
          },
          doc::Boundary)
      .def_property_readonly(
          "size", [](const Box& self) { return read_only(array_of(self.size())); }, doc::Box_size)
      .def_property_readonly(
          "shear_rate", [](const Box& self) { return self.shear().rate; }, doc::Shear_rate)
      .def_property_readonly(
          "shear_offset", [](const Box& self) { return self.shear().offset; }, doc::Shear_offset)
      .def_property_readonly("faces", &faces_of, "The properties of faces that have their own.")
      .def_property_readonly("dimensions", &Box::dimensions, "3, or 2 if the box is flat.")
      .def_property_readonly("volume", &Box::volume, doc::Box_volume)
      .def(
          "__eq__", [](const Box& self, const Box& other) { return self == other; }, py::is_operator())
      .def(pickled<Box>())
      .def("__repr__", [](const Box& self) { return text_of(self); });
  bind_surface(module);
}

}  // namespace hardball::python
