// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/value_pointer.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace hardball::value_pointer_test {
namespace {

class Shape {
 public:
  virtual ~Shape() = default;
  virtual int corners() const = 0;
  virtual std::unique_ptr<Shape> clone() const = 0;
};

class Triangle final : public Shape {
 public:
  int corners() const override { return 3; }
  std::unique_ptr<Shape> clone() const override { return std::make_unique<Triangle>(*this); }
};

TEST(ValuePointer, CopiesTheValue) {
  ValuePointer<std::string> original = ValuePointer<std::string>::make("abc");
  const ValuePointer<std::string> copy = original;
  original->push_back('d');
  EXPECT_EQ(*original, "abcd");
  EXPECT_EQ(*copy, "abc");
  original = copy;
  EXPECT_EQ(*original, "abc");
}

TEST(ValuePointer, IsNullByDefaultAndAfterAMove) {
  EXPECT_FALSE(ValuePointer<std::string>());
  EXPECT_FALSE(ValuePointer<std::string>(ValuePointer<std::string>()));
  ValuePointer<std::string> original = ValuePointer<std::string>::make("abc");
  const ValuePointer<std::string> moved = std::move(original);
  EXPECT_TRUE(moved);
  EXPECT_FALSE(original);  // NOLINT(bugprone-use-after-move)
}

TEST(ValuePointer, CopiesByClone) {
  const ValuePointer<Shape> original = std::make_unique<Triangle>();
  const ValuePointer<Shape> copy = original;
  EXPECT_NE(&*copy, &*original);
  EXPECT_EQ(copy->corners(), 3);
}

}  // namespace
}  // namespace hardball::value_pointer_test
