// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"

namespace hardball::exact_sum_test {
namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

// A finite number in units of the least double.
Integer in_least_units(double number) {
  int exponent = 0;
  const double fraction = std::frexp(number, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Integer(mantissa) * (Integer(1) << shift)
                    : Integer(mantissa / (std::int64_t{1} << -shift));
}

// The slow twin: an integer, rounded by dividing.
double rounded_sum(const std::vector<double>& numbers) {
  Integer sum = 0;
  for (const double number : numbers) sum += in_least_units(number);
  if (sum == 0) return 0;
  const Integer magnitude = abs(sum);
  const int dropped = std::max(0, static_cast<int>(msb(magnitude)) - 52);
  const Integer unit = Integer(1) << dropped;
  Integer mantissa = magnitude / unit;
  const Integer twice_rest = 2 * (magnitude % unit);
  if (twice_rest > unit || (twice_rest == unit && mantissa % 2 == 1)) ++mantissa;
  const double rounded = std::ldexp(mantissa.convert_to<double>(), dropped - 1074);
  return sum < 0 ? -rounded : rounded;
}

ExactSum sum_of(const std::vector<double>& numbers) {
  ExactSum sum;
  for (const double number : numbers) sum += number;
  return sum;
}

void expect_same(double actual, double expected) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(actual), std::bit_cast<std::uint64_t>(expected))
      << actual << " instead of " << expected;
}

using Make = std::function<double(Random&)>;

double with_exponent(Random& random, int lowest, int highest) {
  const int exponent = lowest + static_cast<int>(random.uniform() * (highest - lowest + 1));
  return std::ldexp(random.uniform() < 0.5 ? -1 - random.uniform() : 1 + random.uniform(), exponent);
}

// Numbers as runs have them, and as they do not.
const std::vector<std::pair<const char*, Make>>& kinds() {
  static const std::vector<std::pair<const char*, Make>> all = {
      {"of one sign", [](Random& random) { return random.uniform(); }},
      {"of both signs", [](Random& random) { return random.normal(); }},
      {"of any magnitude", [](Random& random) { return with_exponent(random, -1074, 1000); }},
      {"large", [](Random& random) { return with_exponent(random, 1010, 1023); }},
      {"subnormal and little more", [](Random& random) { return with_exponent(random, -1074, -1000); }},
      {"with few bits",
       [](Random& random) { return std::ldexp(1, static_cast<int>(300 * random.uniform())); }},
      {"at the edge of the window",
       [](Random& random) {
         return std::ldexp(1 + random.uniform(), static_cast<int>(36 * random.uniform()));
       }},
      {"with zeros", [](Random& random) { return random.uniform() < 0.5 ? -0.0 : random.normal(); }},
  };
  return all;
}

std::vector<double> numbers_of(const Make& make, std::size_t count, Random& random) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < count; ++k) numbers.push_back(make(random));
  return numbers;
}

void shuffle(std::vector<double>& numbers, Random& random) {
  for (std::size_t k = numbers.size(); k > 1; --k) {
    std::swap(numbers[k - 1], numbers[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  }
}

TEST(ExactSum, IsTheRoundedSumOfIntegers) {
  Random random(1);
  for (const auto& [name, make] : kinds()) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {0U, 1U, 2U, 3U, 10U, 100U, 1000U, 5000U}) {
      const std::vector<double> numbers = numbers_of(make, count, random);
      expect_same(sum_of(numbers).value(), rounded_sum(numbers));
    }
    for (std::size_t k = support::cases(2000); k > 0; --k) {
      const std::vector<double> numbers =
          numbers_of(make, static_cast<std::size_t>(5 * random.uniform()), random);
      expect_same(sum_of(numbers).value(), rounded_sum(numbers));
    }
  }
}

// The middle between two doubles, and a little to each side of it.
TEST(ExactSum, RoundsToEven) {
  for (const double start : {1.0, std::nextafter(1.0, 2.0), -1.0, std::ldexp(1.0, 1000)}) {
    const double half = std::ldexp(std::fabs(start), -53);
    for (const double rest : {0.0, kLeast, -kLeast, half * 0x1p-40, -half * 0x1p-80}) {
      for (const double middle : {half, -half, half / 2, 3 * half}) {
        expect_same(sum_of({start, middle, rest}).value(), rounded_sum({start, middle, rest}));
      }
    }
  }
  expect_same(sum_of({kMost, std::ldexp(1.0, 970)}).value(), kInfinity);
  expect_same(sum_of({kMost, std::ldexp(1.0, 970), -kLeast}).value(), kMost);
}

TEST(ExactSum, CancelsToNothing) {
  Random random(2);
  for (const auto& [name, make] : kinds()) {
    SCOPED_TRACE(name);
    std::vector<double> numbers = numbers_of(make, 3000, random);
    for (std::size_t k = 0; k < 3000; ++k) numbers.push_back(-numbers[k]);
    shuffle(numbers, random);
    expect_same(sum_of(numbers).value(), 0);
    EXPECT_EQ(archived(sum_of(numbers)), archived(ExactSum()));
    numbers.push_back(kLeast);
    expect_same(sum_of(numbers).value(), kLeast);
  }
  expect_same(sum_of({kMost, kMost, kMost, -kMost, -kMost}).value(), kMost);
}

// Many that are alike, so that the bins are full several times.
TEST(ExactSum, HoldsManyOfTheLargestMantissas) {
  const double largest = std::nextafter(2.0, 0.0);
  for (const double number : {largest, -largest, kMost, -kMost, kLeast}) {
    ExactSum sum;
    for (int k = 0; k < 10000; ++k) sum += number;
    sum += -number;
    for (int k = 0; k < 9998; ++k) sum += -number;
    expect_same(sum.value(), number);
  }
}

TEST(ExactSum, IsTheSameInAnyOrderAndHoweverDivided) {
  Random random(3);
  for (const auto& [name, make] : kinds()) {
    SCOPED_TRACE(name);
    std::vector<double> numbers = numbers_of(make, 4000, random);
    const ExactSum expected = sum_of(numbers);
    for (int repetition = 0; repetition < 5; ++repetition) {
      shuffle(numbers, random);
      std::vector<ExactSum> parts(static_cast<std::size_t>(1 + repetition * 2));
      for (const double number : numbers) {
        parts[static_cast<std::size_t>(random.uniform() * static_cast<double>(parts.size()))] += number;
      }
      ExactSum sum;
      for (const ExactSum& part : parts) sum.add(part);
      expect_same(sum.value(), expected.value());
      EXPECT_EQ(archived(sum), archived(expected));
      ExactSum more = expected;
      more += 1;
      sum += 1;
      EXPECT_EQ(archived(sum), archived(more));
    }
  }
}

TEST(ExactSum, OfInfinitiesAndNanIsThatOfDoubles) {
  for (std::vector<double> numbers : {std::vector<double>{1, kInfinity, -2},
                                      {1, -kInfinity, kMost},
                                      {kInfinity, kInfinity},
                                      {kInfinity, -kInfinity},
                                      {1, kNan},
                                      {kInfinity, kNan},
                                      {-kInfinity, kInfinity, kNan, 1}}) {
    std::ranges::sort(numbers, std::less<std::uint64_t>(),
                      [](double x) { return std::bit_cast<std::uint64_t>(x); });
    const double expected = std::accumulate(numbers.begin(), numbers.end(), 0.0);
    do {
      const ExactSum sum = sum_of(numbers);
      ExactSum divided(numbers[0]);
      divided.add(sum_of({numbers.begin() + 1, numbers.end()}));
      for (const double value : {sum.value(), divided.value()}) {
        if (std::isnan(expected)) {
          EXPECT_TRUE(std::isnan(value));
        } else {
          EXPECT_EQ(value, expected);
        }
      }
      EXPECT_EQ(archived(divided), archived(sum));
    } while (std::next_permutation(numbers.begin(), numbers.end(), [](double a, double b) {
      return std::bit_cast<std::uint64_t>(a) < std::bit_cast<std::uint64_t>(b);
    }));
  }
}

TEST(ExactSum, ContinuesWhenRestored) {
  Random random(4);
  for (const auto& [name, make] : kinds()) {
    SCOPED_TRACE(name);
    for (const std::size_t count : {0U, 1U, 7U, 1500U}) {
      std::vector<double> numbers = numbers_of(make, count, random);
      ExactSum restored(3);
      restore(archived(sum_of(numbers)), "the test", restored);
      EXPECT_EQ(archived(restored), archived(sum_of(numbers)));
      const std::vector<double> more = numbers_of(make, 1500, random);
      numbers.insert(numbers.end(), more.begin(), more.end());
      for (const double number : more) restored += number;
      expect_same(restored.value(), rounded_sum(numbers));
      EXPECT_EQ(archived(restored), archived(sum_of(numbers)));
    }
  }
}

TEST(ExactSum, RefusesWhatIsNoSum) {
  const auto refuse = [](std::uint8_t specials, std::uint32_t first,
                         const std::vector<std::int64_t>& digits) {
    ArchiveWriter writer;
    writer(ArchiveWriter::kVersion, specials, first, digits);
    ExactSum sum;
    EXPECT_THROW(restore(writer.bytes(), "the test", sum), Error);
  };
  refuse(8, 0, {});
  refuse(0, 71, {1});
  refuse(0, 0xffffffff, {1});
  refuse(0, 60, std::vector<std::int64_t>(11, 1));
  refuse(0, 0, {std::int64_t{1} << 32, 1});
  refuse(0, 0, {-1, 1});
  refuse(0, 0, {std::int64_t{1} << 31});
  refuse(0, 0, {-(std::int64_t{1} << 31) - 1});
}

}  // namespace
}  // namespace hardball::exact_sum_test
