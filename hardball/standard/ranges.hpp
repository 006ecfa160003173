// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <version>

/// The algorithms on ranges: those of std::ranges, or where the standard library lacks them, or Clang refuses
/// them, the part of them that Hardball uses, with the same names, arguments and results.
#if defined(__cpp_lib_ranges) && !(defined(__clang__) && __clang_major__ < 16)

namespace hardball {
namespace ranges = std::ranges;
}

#else

namespace hardball::ranges {

struct identity {
  template <class T>
  constexpr T&& operator()(T&& value) const noexcept {
    return std::forward<T>(value);
  }
};

template <class Iterator>
class subrange {
 public:
  constexpr subrange(Iterator begin, Iterator end) : begin_(begin), end_(end) {}
  constexpr Iterator begin() const { return begin_; }
  constexpr Iterator end() const { return end_; }

 private:
  Iterator begin_;
  Iterator end_;
};

template <class T>
struct min_max_result {
  T min;
  T max;
};

// A comparison of two values after their projections.
template <class Compare, class Projection>
constexpr auto projected(Compare& compare, Projection& projection) {
  return [&](const auto& a, const auto& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Range, class Predicate, class Projection = identity>
constexpr auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), [&](auto&& value) -> bool {
    return std::invoke(predicate, std::invoke(projection, value));
  });
}

template <class Range, class Predicate, class Projection = identity>
constexpr auto find_if_not(Range&& range, Predicate predicate, Projection projection = {}) {
  return find_if(range, std::not_fn(std::ref(predicate)), std::ref(projection));
}

template <class Range, class Value, class Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return find_if(
      range, [&](const auto& other) -> bool { return other == value; }, std::ref(projection));
}

template <class Range, class Predicate, class Projection = identity>
constexpr bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return find_if(range, std::ref(predicate), std::ref(projection)) != std::end(range);
}

template <class Range, class Predicate, class Projection = identity>
constexpr bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return !any_of(range, std::ref(predicate), std::ref(projection));
}

template <class Range, class Predicate, class Projection = identity>
constexpr bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return find_if_not(range, std::ref(predicate), std::ref(projection)) == std::end(range);
}

template <class Range, class Predicate, class Projection = identity>
constexpr auto count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), [&](auto&& value) -> bool {
    return std::invoke(predicate, std::invoke(projection, value));
  });
}

template <class Range, class Value, class Projection = identity>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
  return count_if(
      range, [&](const auto& other) -> bool { return other == value; }, std::ref(projection));
}

template <class Range, class Function>
constexpr void for_each(Range&& range, Function function) {
  for (auto&& value : range) std::invoke(function, value);
}

template <class First, class Second, class Equal = std::equal_to<>, class FirstProjection = identity,
          class SecondProjection = identity>
constexpr bool equal(First&& first, Second&& second, Equal equal = {}, FirstProjection of_first = {},
                     SecondProjection of_second = {}) {
  return std::equal(std::begin(first), std::end(first), std::begin(second), std::end(second),
                    [&](const auto& a, const auto& b) -> bool {
                      return std::invoke(equal, std::invoke(of_first, a), std::invoke(of_second, b));
                    });
}

template <class Range, class Compare = std::equal_to<>, class Projection = identity>
constexpr auto adjacent_find(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::adjacent_find(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Iterator, class Compare = std::less<>, class Projection = identity>
constexpr void nth_element(Range&& range, Iterator nth, Compare compare = {}, Projection projection = {}) {
  std::nth_element(std::begin(range), nth, std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr bool is_sorted(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::is_sorted(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr bool is_heap(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::is_heap(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), projected(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto min(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *min_element(range, std::ref(compare), std::ref(projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto max(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *max_element(range, std::ref(compare), std::ref(projection));
}

template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto minmax(Range&& range, Compare compare = {}, Projection projection = {}) {
  const auto [least, most] =
      std::minmax_element(std::begin(range), std::end(range), projected(compare, projection));
  return min_max_result<std::decay_t<decltype(*least)>>{*least, *most};
}

template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](const auto& element, const auto& sought) -> bool {
                            return std::invoke(compare, std::invoke(projection, element), sought);
                          });
}

template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
constexpr auto upper_bound(Range&& range, const Value& value, Compare compare = {},
                           Projection projection = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value,
                          [&](const auto& sought, const auto& element) -> bool {
                            return std::invoke(compare, sought, std::invoke(projection, element));
                          });
}

template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
constexpr bool binary_search(Range&& range, const Value& value, Compare compare = {},
                             Projection projection = {}) {
  const auto found = lower_bound(range, value, std::ref(compare), std::ref(projection));
  return found != std::end(range) && !std::invoke(compare, value, std::invoke(projection, *found));
}

template <class Range, class Compare = std::equal_to<>, class Projection = identity>
constexpr auto unique(Range&& range, Compare compare = {}, Projection projection = {}) {
  const auto end = std::unique(std::begin(range), std::end(range), projected(compare, projection));
  return subrange(end, std::end(range));
}

template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}

template <class Range, class Value>
constexpr void replace(Range&& range, const Value& old, const Value& value) {
  std::replace(std::begin(range), std::end(range), old, value);
}

template <class Range, class Predicate, class Value>
constexpr void replace_if(Range&& range, Predicate predicate, const Value& value) {
  std::replace_if(std::begin(range), std::end(range), predicate, value);
}

template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Range, class Output>
constexpr void copy(Range&& range, Output output) {
  std::copy(std::begin(range), std::end(range), output);
}

template <class Range, class Output, class Function>
constexpr void transform(Range&& range, Output output, Function function) {
  std::transform(std::begin(range), std::end(range), output, function);
}

template <class First, class Second, class Output>
constexpr void set_difference(First&& first, Second&& second, Output output) {
  std::set_difference(std::begin(first), std::end(first), std::begin(second), std::end(second), output);
}

}  // namespace hardball::ranges

#endif
