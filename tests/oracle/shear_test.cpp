// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Sheared boxes: contact times against a hundred digits, and random worlds, one history for all engines,
// however the run is split.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>

#include "hardball/numbers/random.hpp"
#include "hardball/world/pair_event.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/pieces.hpp"
#include "support/sheared.hpp"

namespace hardball::shear_test {
namespace {

using Long = boost::multiprecision::cpp_bin_float_100;
using namespace support;

Long exact(const Time& time) {
  return Long(time.high) + Long(time.low);
}

// From one center to an image of another.
std::array<Long, kAxes> separation(const World& world, Slot a, Slot b, const Image& image, const Long& time) {
  std::array<Long, kAxes> apart;
  const auto position = [&](Slot slot, std::size_t axis) {
    const Path& path = world.path(slot);
    return Long(path.position[axis]) + (time - exact(path.time)) * Long(path.velocity[axis]);
  };
  const Box& box = world.box();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    apart[axis] = position(b, axis) - position(a, axis);
    if (box.is_periodic(axis)) apart[axis] += Long(image[axis]) * Long(box.size()[axis]);
  }
  apart[0] += Long(image[1]) * (Long(box.shear().offset) + Long(box.images().speed()) * time);
  return apart;
}

TEST(ShearedContactTime, AgreesWithAHundredDigits) {
  Random random(1);
  std::size_t met = 0;
  for (std::size_t i = 0; i < cases(100000); ++i) {
    Box box = Box::periodic({10 + random.uniform(), 10 + random.uniform(), 10 + random.uniform()});
    box.set_shear({.rate = std::pow(10, 4 * random.uniform() - 3), .offset = 20 * random.uniform()});
    World world(box);
    // Late, so that images have slid far.
    const double late = i % 3 == 0 ? 1e6 * random.uniform() : 0;
    const auto point = [&] { return 10 * random.uniform(); };
    for (int k = 0; k < 2; ++k) {
      world.add({.position = {point(), point(), point()}, .velocity = random.direction(), .radius = 0.5},
                Time(late + random.uniform()));
    }
    Image image{{0, random.uniform() < 0.5 ? 1 : -1, 0}};
    const Time start = later(world.path(0).time, world.path(1).time);
    // The image that is nearest when they are at the same height, or soon after.
    const double height =
        world.unfolded_position(1, start).y + image[1] * box.size().y - world.unfolded_position(0, start).y;
    const double rise = world.path(1).velocity.y - world.path(0).velocity.y;
    const double wait = std::clamp(-height / rise, 0.0, 100.0);
    const Time meeting = after(start, std::isfinite(wait) ? wait : 0);
    const Vec3 apart = world.unfolded_position(0, meeting) - world.unfolded_position(1, meeting);
    image[0] = box.nearest_image({apart.x, image[1] * box.size().y, 0}, meeting)[0];
    const Time time = sheared_contact_time(world, 0, 1, image);
    const Time reversed = sheared_contact_time(world, 1, 0, -image);
    ASSERT_EQ(time, reversed);
    if (!(time < kNever)) continue;
    ++met;
    const auto r = separation(world, 0, 1, image, exact(time));
    const Long distance = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const State relative = relative_state(world, 0, 1, image, start);
    // Where they begin is rounded to units in the last place of its coordinates; steep contacts follow.
    const Long rounding = Long(64 * 0x1p-53 * (length(relative.position) + 20));
    const Vec3 at_contact = relative.position + duration(start, time) * relative.velocity;
    const double steepness =
        std::fabs(dot(at_contact, relative.velocity)) / (length(at_contact) * length(relative.velocity));
    if (time > start) {
      ASSERT_LE(abs(distance - 1), rounding) << i << " " << steepness;
    }
  }
  EXPECT_GT(met, cases(1000));
}

constexpr std::uint64_t kWorlds = 3000;
constexpr std::uint64_t kParts = 6;

class ShearAgrees : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ShearAgrees, OnRandomWorlds) {
  std::uint64_t contacts = 0;
  std::uint64_t across = 0;
  std::uint64_t with_cells = 0;
  std::uint64_t with_lists = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = make_sheared_world(seed);
    SCOPED_TRACE(made.name);
    Random random(seed);
    const RunLimits limits{.until = Time(made.until), .contacts = 100 + 100 * (seed % 5)};
    const std::vector<EngineVariant> variants = engine_variants(made.world);
    const auto run = [&](Simulation& simulation, const EngineVariant& variant, bool is_first) {
      if (variant.options.cell_edge && simulation.engine() == EngineKind::cells) ++with_cells;
      if (simulation.engine() == EngineKind::neighbors) ++with_lists;
      if (is_first) {
        simulation.on_contact([&](const Contact& contact) {
          across += contact.image[1] != 0 ? 1U : 0U;
          EXPECT_EQ(contact.image_speed, contact.image[1] * made.world.box().images().speed());
        });
      } else if (&variant == &variants[1 + seed % (variants.size() - 1)]) {
        return run_in_pieces(simulation, limits, random);
      }
      const History history = validated_run(simulation, limits);
      const bool may_overlap =
          has_passing_pairs(made.world) || made.world.interactions().table().has_merging();
      if (history.failure.empty() && !may_overlap) {
        EXPECT_LE(audit(simulation.world(), simulation.now()).max_overlap, 1e-6);
      }
      return history;
    };
    const std::optional<History> expected = one_history(made.world, variants, run, true);
    if (!expected) return;
    contacts += expected->contacts;
  }
  EXPECT_GT(contacts, 20 * cases(kWorlds) / kParts);
  EXPECT_GT(across, 3 * cases(kWorlds) / kParts);
  EXPECT_GT(with_cells, 2 * cases(kWorlds) / kParts);
  EXPECT_GT(with_lists, cases(kWorlds) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, ShearAgrees, testing::Range(std::uint64_t{0}, kParts));

}  // namespace
}  // namespace hardball::shear_test
