// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/arrays.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "hardball/errors/error.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t axis = 0; axis < array.ndim(); ++axis) {
    text += (axis > 0 ? ", " : "") + std::to_string(array.shape(axis));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

[[noreturn]] void refuse_shape(const py::array& array, const std::string& name, const std::string& remedy) {
  throw Error("the array has the shape " + shape_of(array), name, remedy);
}

Vec3 row_of(const double* numbers, py::ssize_t columns) {
  return {numbers[0], numbers[1], columns == 3 ? numbers[2] : 0};
}

// Whether these are the components of a vector. Error: they are those of a plane, and there are three
// dimensions.
bool is_vector(const py::array& array, const std::string& name, bool is_flat) {
  const py::ssize_t columns = array.shape(array.ndim() - 1);
  if (columns == 2 && !is_flat) {
    throw Error("the array has the shape " + shape_of(array) +
                    ": vectors of two coordinates, and the box has three dimensions",
                name, "give three coordinates, or use a flat box");
  }
  return columns == 2 || columns == 3;
}

std::vector<std::uint32_t> whole(const std::vector<double>& numbers, const std::string& name,
                                 std::uint32_t most) {
  std::vector<std::uint32_t> counts;
  counts.reserve(numbers.size());
  for (const double number : numbers) {
    if (!(number >= 0 && number <= most && std::floor(number) == number)) {
      throw Error("there is the number " + to_text(number), name,
                  "give whole numbers from 0 to " + std::to_string(most));
    }
    counts.push_back(static_cast<std::uint32_t>(number));
  }
  return counts;
}

// A mask would be taken for the numbers 0 and 1.
void refuse_truths(const py::handle& object, const std::string& name) {
  const py::array array = py::array::ensure(object);
  if (!array) PyErr_Clear();
  if (!array || array.dtype().kind() != 'b') return;
  throw Error("it is an array of booleans", name, "give numbers, such as ids[mask]");
}

}  // namespace

Doubles doubles(const py::handle& object, const std::string& name) {
  // The usual ones need no conversion. Masked arrays are of another class.
  if (Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_ && Doubles::check_(object))
    return py::reinterpret_borrow<Doubles>(object);
  constexpr std::string_view kRealNumbers = "fiub";  // as NumPy calls them
  if (py::module_::import("numpy.ma").attr("is_masked")(object).cast<bool>()) {
    throw Error("it has masked entries", name, "fill them, as array.filled(...) does");
  }
  const py::array array = py::array::ensure(object);
  if (!array || kRealNumbers.find(array.dtype().kind()) == std::string_view::npos) {
    PyErr_Clear();
    throw Error("it is not an array of numbers", name, "give real numbers, as numpy.asarray takes them");
  }
  return Doubles::ensure(array.attr("astype")("float64"));
}

std::optional<Vec3> plain_vector(const py::handle& object, bool is_flat) {
  const bool is_list = PyList_CheckExact(object.ptr()) != 0;
  if (!is_list && PyTuple_CheckExact(object.ptr()) == 0) {
    if (Py_TYPE(object.ptr()) != py::detail::npy_api::get().PyArray_Type_ || !Doubles::check_(object))
      return std::nullopt;
    const auto array = py::reinterpret_borrow<Doubles>(object);
    const bool is_vector = array.ndim() == 1 && (array.shape(0) == 3 || (is_flat && array.shape(0) == 2));
    return is_vector ? std::optional(row_of(array.data(), array.shape(0))) : std::nullopt;
  }
  const py::ssize_t size = Py_SIZE(object.ptr());
  if (size != 3 && !(is_flat && size == 2)) return std::nullopt;
  std::array<double, 3> numbers{};
  for (py::ssize_t axis = 0; axis < size; ++axis) {
    PyObject* const number =
        is_list ? PyList_GET_ITEM(object.ptr(), axis) : PyTuple_GET_ITEM(object.ptr(), axis);
    if (PyFloat_CheckExact(number) == 0) return std::nullopt;
    numbers[static_cast<std::size_t>(axis)] = PyFloat_AS_DOUBLE(number);
  }
  return Vec3{numbers[0], numbers[1], numbers[2]};
}

std::optional<std::uint32_t> plain_count(const py::handle& object) {
  if (PyLong_CheckExact(object.ptr()) == 0) return std::nullopt;
  int overflow = 0;
  const long number = PyLong_AsLongAndOverflow(object.ptr(), &overflow);
  if (overflow != 0 || number < 0 || number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

Vec3 vector_of(const py::handle& object, const std::string& name, bool is_flat) {
  const Doubles array = doubles(object, name);
  if (array.ndim() != 1 || !is_vector(array, name, is_flat)) {
    refuse_shape(array, name, std::string("give three numbers") + (is_flat ? ", or two" : ""));
  }
  return row_of(array.data(), array.shape(0));
}

std::vector<Vec3> vectors_of(const py::handle& object, const std::string& name, bool is_flat) {
  const Doubles array = doubles(object, name);
  if (array.ndim() == 1 && array.shape(0) == 0) return {};
  if (array.ndim() != 2 || !is_vector(array, name, is_flat)) {
    refuse_shape(array, name, std::string("give one of the shape (n, 3)") + (is_flat ? ", or (n, 2)" : ""));
  }
  std::vector<Vec3> vectors;
  vectors.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t row = 0; row < array.shape(0); ++row) {
    vectors.push_back(row_of(array.data(row, 0), array.shape(1)));
  }
  return vectors;
}

std::vector<Vec3> vectors_of(const py::handle& object, const std::string& name, bool is_flat,
                             std::size_t count) {
  const Doubles array = doubles(object, name);
  if (array.ndim() == 1 && is_vector(array, name, is_flat)) {
    return std::vector<Vec3>(count, row_of(array.data(), array.shape(0)));
  }
  std::vector<Vec3> vectors = vectors_of(array, name, is_flat);
  if (vectors.size() != count) {
    refuse_shape(array, name, "give as many rows as there are spheres, " + std::to_string(count));
  }
  return vectors;
}

std::vector<double> numbers_of(const py::handle& object, const std::string& name, std::size_t count) {
  const Doubles array = doubles(object, name);
  if (array.ndim() == 0) return std::vector<double>(count, *array.data());
  if (array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != count) {
    refuse_shape(array, name, "give one number, or as many as there are spheres, " + std::to_string(count));
  }
  return {array.data(), array.data() + count};
}

std::vector<std::uint32_t> counts_of(const py::handle& object, const std::string& name, std::size_t count,
                                     std::uint32_t most) {
  refuse_truths(object, name);
  return whole(numbers_of(object, name, count), name, most);
}

std::vector<std::uint32_t> counts_of(const py::handle& object, const std::string& name, std::uint32_t most) {
  refuse_truths(object, name);
  const Doubles array = doubles(object, name);
  if (array.ndim() > 1) refuse_shape(array, name, "give one number, or an array of the shape (n,)");
  return whole({array.data(), array.data() + array.size()}, name, most);
}

std::vector<std::uint64_t> bits_of(const py::handle& object, const std::string& name, std::size_t count) {
  refuse_truths(object, name);
  // Of large numbers, NumPy would make floats.
  const py::array array = py::module_::import("numpy").attr("array")(object, py::arg("dtype") = "object");
  if (array.ndim() > 0 && (array.ndim() > 1 || static_cast<std::size_t>(array.size()) != count)) {
    refuse_shape(array, name, "give one number, or as many as there are spheres, " + std::to_string(count));
  }
  std::vector<std::uint64_t> numbers;
  for (const py::handle element : array.attr("ravel")()) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(element.ptr()));
    if (number) numbers.push_back(PyLong_AsUnsignedLongLong(number.ptr()));
    if (PyErr_Occurred() == nullptr) continue;
    PyErr_Clear();
    throw Error("there is " + py::repr(element).cast<std::string>(), name,
                "give whole numbers from 0 to 2^64 - 1");
  }
  if (array.ndim() == 0) return std::vector<std::uint64_t>(count, numbers.front());
  return numbers;
}

py::array_t<double> array_of(const Vec3& vector) {
  return py::array_t<double>(3, &vector.x);
}

py::array_t<double> array_around(std::vector<Vec3> vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  auto owner = std::make_unique<std::vector<Vec3>>(std::move(vectors));
  const auto* const data = reinterpret_cast<const double*>(owner->data());
  const auto rows = static_cast<py::ssize_t>(owner->size());
  const py::capsule capsule(owner.release(), [](void* all) { delete static_cast<std::vector<Vec3>*>(all); });
  return py::array_t<double>({rows, py::ssize_t{3}}, data, capsule);
}

}  // namespace hardball::python
