// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/exact_sign.hpp"

#include <cmath>
#include <vector>

#include "hardball/geometry/double_double.hpp"

namespace hardball {
namespace {

// An exact number: the sum of doubles that do not overlap, by rising magnitude.
class Exact {
 public:
  explicit Exact(const DoubleDouble<>& number) {
    add(number.low);
    add(number.high);
  }

  friend Exact operator*(const Exact& a, const Exact& b) {
    Exact result;
    for (const double one : a.parts_) {
      for (const double other : b.parts_) {
        const DoubleDouble<> part = product(one, other);
        result.add(part.low);
        result.add(part.high);
      }
    }
    return result;
  }
  friend Exact operator+(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(part);
    return a;
  }
  friend Exact operator-(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(-part);
    return a;
  }

  int sign() const {
    if (parts_.empty()) return 0;
    return parts_.back() > 0 ? 1 : -1;
  }

 private:
  Exact() = default;

  void add(double number) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const DoubleDouble<> both = hardball::sum(part, number);
      if (both.low != 0) parts_[kept++] = both.low;
      number = both.high;
    }
    parts_.resize(kept);
    if (number != 0) parts_.push_back(number);
  }

  std::vector<double> parts_;
};

Exact exact_difference(double a, double b) {
  return Exact(difference(a, b));
}

int sign_of(double number) {
  return (number > 0 ? 1 : 0) - (number < 0 ? 1 : 0);
}

// Far more than the rounding of either determinant, relative to the sum of the magnitudes of its products.
constexpr double kRounding = 0x1p-48;

}  // namespace

int orientation_along_z(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  if (std::fabs(left - right) > kRounding * (std::fabs(left) + std::fabs(right)))
    return sign_of(left - right);
  return (exact_difference(a.x, c.x) * exact_difference(b.y, c.y) -
          exact_difference(a.y, c.y) * exact_difference(b.x, c.x))
      .sign();
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 da = a - d;
  const Vec3 db = b - d;
  const Vec3 dc = c - d;
  const double determinant = dot(da, cross(db, dc));
  const double magnitude = std::fabs(da.x) * (std::fabs(db.y * dc.z) + std::fabs(db.z * dc.y)) +
                           std::fabs(da.y) * (std::fabs(db.z * dc.x) + std::fabs(db.x * dc.z)) +
                           std::fabs(da.z) * (std::fabs(db.x * dc.y) + std::fabs(db.y * dc.x));
  if (std::fabs(determinant) > kRounding * magnitude) return sign_of(determinant);
  const auto minor = [&](std::size_t i, std::size_t k) {
    return exact_difference(b[i], d[i]) * exact_difference(c[k], d[k]) -
           exact_difference(b[k], d[k]) * exact_difference(c[i], d[i]);
  };
  return (exact_difference(a.x, d.x) * minor(1, 2) + exact_difference(a.y, d.y) * minor(2, 0) +
          exact_difference(a.z, d.z) * minor(0, 1))
      .sign();
}

}  // namespace hardball
