// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/prescribed_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

bool is_timetable(const PrescribedMotion& motion) {
  return std::holds_alternative<Keyframes>(motion.kind());
}

double frequency_of(const PrescribedMotion& motion) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.frequency(); }) return std::fabs(kind.frequency());
        return 0.0;
      },
      motion.kind());
}

}  // namespace

PrescribedMotion::PrescribedMotion(MotionKind kind, double tolerance)
    : kind_(std::move(kind)), tolerance_(tolerance) {
  if (is_timetable(*this) && tolerance == 0) return;
  check_positive(tolerance, "tolerance", "motion");
}

PrescribedMotion PrescribedMotion::sampled(const std::function<Vec3(double)>& position, double until,
                                           double acceleration, double tolerance, bool repeats) {
  constexpr double kMost = 0x1p31;
  check_positive(until, "until", "motion");
  check_positive(acceleration, "acceleration", "motion");
  check_positive(tolerance, "tolerance", "motion");
  const double chords = std::ceil(until / std::sqrt(8 * tolerance / acceleration));
  if (!(chords < kMost)) {
    throw Error("the motion would have " + to_text(chords) + " knots", "motion",
                "give a larger tolerance or a shorter time");
  }
  std::vector<Keyframe> rows;
  const auto count = static_cast<std::size_t>(std::max(1.0, chords));
  for (std::size_t k = 0; k <= count; ++k) {
    const double time = until * (static_cast<double>(k) / static_cast<double>(count));
    rows.push_back({time, position(time)});
  }
  return keyframes(std::move(rows), repeats, tolerance);
}

std::string_view PrescribedMotion::name() const {
  return std::visit([](const auto& kind) { return kind.kName; }, kind_);
}

Vec3 PrescribedMotion::span() const {
  return std::visit([](const auto& kind) { return kind.span(); }, kind_);
}

double PrescribedMotion::acceleration(const Vec3& from) const {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (std::is_same_v<Kind, Rotation>) return kind.acceleration(from);
        if constexpr (std::is_same_v<Kind, Oscillation>) return kind.acceleration();
        return 0.0;
      },
      kind_);
}

double PrescribedMotion::longest_chord(double acceleration) const {
  return acceleration > 0 ? std::sqrt(8 * tolerance_ / acceleration) : kForever;
}

bool PrescribedMotion::restored() {
  *this = PrescribedMotion(std::move(kind_), tolerance_);
  return true;
}

Knots::Knots(const PrescribedMotion& motion, double acceleration) {
  longest_ = motion.longest_chord(acceleration);
  if (is_timetable(motion)) {
    if (longest_ > 0) return;
    throw Error("there is gravity, and the motion has no tolerance", "motion",
                "give the distance up to which bodies may leave its straight lines");
  }
  // A multiple of four, so that an oscillation reaches its ends.
  constexpr double kLeast = 8;
  constexpr double kMost = 0x1p40;
  const double frequency = frequency_of(motion);
  const double chords = 4 * std::ceil(std::max(kLeast, 1 / (frequency * longest_)) / 4);
  if (!(chords <= kMost)) {
    throw Error("the motion would have " + to_text(chords) + " chords in a turn", "motion",
                "give a larger tolerance");
  }
  chords_ = chords * frequency;
}

Knots::Segment Knots::segment(const Keyframes& frames, std::uint64_t number) const {
  const std::vector<Keyframe>& rows = frames.rows();
  const std::size_t lines = rows.size() - 1;
  Segment segment;
  if (number == 0) {
    segment.length = rows.front().time;
  } else if (frames.repeats()) {
    const std::uint64_t turn = (number - 1) / lines;
    segment.from = (number - 1) % lines;
    segment.to = segment.from + 1;
    const double period = rows.back().time - rows.front().time;
    segment.begin =
        (product(static_cast<double>(turn), period) + DoubleDouble<>{rows[segment.from].time, 0}).high;
    segment.length = rows[segment.to].time - rows[segment.from].time;
    // The last row is where the first one is.
    if (segment.to == lines) segment.to = 0;
  } else if (number <= lines) {
    segment.from = number - 1;
    segment.to = number;
    segment.begin = rows[segment.from].time;
    segment.length = rows[segment.to].time - segment.begin;
  } else {
    segment = {rows.back().time, kForever, 0, lines, lines};
  }
  if (segment.parts > 0 && longest_ < kForever)
    segment.parts = static_cast<std::uint64_t>(std::clamp(std::ceil(segment.length / longest_), 1.0, 0x1p40));
  return segment;
}

Knots::Number Knots::first(const PrescribedMotion& motion) const {
  const auto* const frames = std::get_if<Keyframes>(&motion.kind());
  return {frames && frames->rows().front().time == 0 ? 1U : 0U, 0};
}

Knots::Number Knots::after(const PrescribedMotion& motion, const Number& knot) const {
  const auto* const frames = std::get_if<Keyframes>(&motion.kind());
  if (frames) {
    const std::uint64_t parts = segment(*frames, knot.segment).parts;
    if (parts == 0 || knot.part + 1 < parts) return {knot.segment, knot.part + 1};
  }
  return {knot.segment + 1, 0};
}

bool Knots::is_last(const PrescribedMotion& motion, const Number& knot) const {
  const auto* const frames = std::get_if<Keyframes>(&motion.kind());
  return frames && !(longest_ < kForever) && segment(*frames, knot.segment).parts == 0;
}

double Knots::time(const PrescribedMotion& motion, const Number& knot) const {
  const auto* const frames = std::get_if<Keyframes>(&motion.kind());
  if (!frames) return static_cast<double>(knot.segment) / chords_;
  const Segment line = segment(*frames, knot.segment);
  if (knot.part == 0) return line.begin;
  const auto part = static_cast<double>(knot.part);
  if (line.parts == 0) return line.begin + part * longest_;
  return line.begin + line.length * (part / static_cast<double>(line.parts));
}

Vec3 Knots::displacement(const PrescribedMotion& motion, const Number& knot, const Vec3& from,
                         const Time& elapsed) const {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (std::is_same_v<Kind, Rotation>) {
          return kind.displacement(from, elapsed);
        } else if constexpr (std::is_same_v<Kind, Oscillation>) {
          return kind.displacement(elapsed);
        } else {
          const Segment line = segment(kind, knot.segment);
          const Vec3 begin = kind.displacement(line.from);
          if (knot.part == 0 || line.parts == 0) return begin;
          const double share = static_cast<double>(knot.part) / static_cast<double>(line.parts);
          return begin + share * (kind.displacement(line.to) - begin);
        }
      },
      motion.kind());
}

}  // namespace hardball
