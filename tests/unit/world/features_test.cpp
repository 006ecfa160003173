// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
// The table of features, and its page docs/features.md.
#include "hardball/world/features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string>

#include "hardball/errors/error.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::table_of_features_test {
namespace {

using namespace support;

template <class Visit>
void for_each_feature(const Visit& visit) {
  for (std::size_t number = 0; number < kFeatures; ++number) visit(static_cast<Feature>(number));
}

std::string name_of(Feature feature) {
  return std::string(description(feature).name);
}

std::string rows_of_features() {
  std::string rows = "| feature | meaning |\n|---|---|\n";
  for_each_feature([&](Feature feature) {
    rows += "| " + name_of(feature) + " | " + std::string(description(feature).meaning) + " |\n";
  });
  return rows;
}

std::string rows_of_exclusions() {
  std::string rows = "| feature | excludes | error | remedy |\n|---|---|---|---|\n";
  for (const Exclusion& pair : exclusions()) {
    rows += "| " + name_of(pair.first) + " | " + name_of(pair.second) + " | " + std::string(pair.what) +
            " | " + std::string(pair.remedy) + " |\n";
  }
  return rows;
}

TEST(PageOfFeatures, HasTheRowsOfTheTableAndNoOthers) {
  const std::string text = read_text(HARDBALL_SCENARIOS "/../docs/features.md");
  for (const std::string& rows : {rows_of_features(), rows_of_exclusions()})
    EXPECT_NE(text.find("\n\n" + rows + "\n"), std::string::npos) << "docs/features.md lacks:\n" << rows;
  std::istringstream lines(text);
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);) found += line.starts_with("| ") ? 1U : 0U;
  EXPECT_EQ(found, kFeatures + exclusions().size() + 2);
}

TEST(TableOfFeatures, NamesEachFeatureOnce) {
  std::set<std::string> names;
  for_each_feature([&](Feature feature) {
    EXPECT_TRUE(names.insert(name_of(feature)).second) << name_of(feature);
    EXPECT_FALSE(description(feature).meaning.empty()) << name_of(feature);
    EXPECT_FALSE(description(feature).meaning.ends_with('.')) << name_of(feature);
  });
}

TEST(TableOfFeatures, StatesEachPairOnceAndWithARemedy) {
  std::set<std::set<Feature>> pairs;
  for (const Exclusion& pair : exclusions()) {
    EXPECT_NE(pair.first, pair.second) << pair.what;
    EXPECT_TRUE(pairs.insert({pair.first, pair.second}).second) << pair.what;
    EXPECT_FALSE(pair.what.empty());
    EXPECT_FALSE(pair.remedy.empty()) << pair.what;
  }
}

TEST(TableOfFeatures, IsTheSameInBothDirections) {
  for (const Exclusion& pair : exclusions()) {
    EXPECT_FALSE(goes_with(pair.first, pair.second)) << pair.what;
    EXPECT_FALSE(goes_with(pair.second, pair.first)) << pair.what;
  }
  EXPECT_TRUE(goes_with(Feature::flat, excluded_by(Feature::gravity)));
  EXPECT_EQ(excluded_by({}), Features());
  EXPECT_EQ(excluded_by(Feature::curved_walls), Feature::shear);
}

TEST(TableOfFeatures, RefusesThePairsItNames) {
  for (const Exclusion& pair : exclusions()) {
    const Features both = Features(pair.first) | pair.second;
    const Error error = error_of([&] { check_exclusions(both); });
    EXPECT_EQ(error.problem(), pair.what);
    EXPECT_EQ(error.remedy(), pair.remedy);
    EXPECT_EQ(error.where(), description(pair.first).where);
    EXPECT_EQ(error_of([&] { check_exclusions(pair.first, both, "here"); }).where(), "here");
    EXPECT_NO_THROW(check_exclusions(pair.second, pair.first, "here"));
    EXPECT_NO_THROW(check_exclusions(pair.first));
  }
  EXPECT_NO_THROW(check_exclusions(Features(Feature::flat) | Feature::gravity | Feature::thermal_walls));
}

}  // namespace
}  // namespace hardball::table_of_features_test
