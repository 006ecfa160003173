// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/system_size.hpp"

#include <gtest/gtest.h>

namespace hardball {
namespace {

// 256 contacts of the domain itself, but at most twice as many as there would be otherwise.
TEST(SystemSize, GivesSmallDomainsLongerWindows) {
  const auto contacts_in = [](std::uint64_t spheres, std::size_t domains) {
    const SystemSize size{.spheres = spheres, .speeds = 1.5 * static_cast<double>(spheres), .contact = 1};
    return size.windows({.window = 0.02}, domains);
  };
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 8).contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 8).more_contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 64).contacts, 10000);
  EXPECT_DOUBLE_EQ(contacts_in(1000000, 64).more_contacts, 256 * 64);
  EXPECT_DOUBLE_EQ(contacts_in(10000, 2).more_contacts, 200);
  // Never less than one.
  EXPECT_DOUBLE_EQ(contacts_in(10, 2).contacts, 1);
  EXPECT_DOUBLE_EQ(contacts_in(10, 2).more_contacts, 1);
}

TEST(SystemSize, KnowsHowLongSpheresFlyByADiameter) {
  const SystemSize size{.spheres = 100, .speeds = 400, .contact = 2};
  EXPECT_DOUBLE_EQ(size.windows({}, 2).flight, 0.5);
}

}  // namespace
}  // namespace hardball
