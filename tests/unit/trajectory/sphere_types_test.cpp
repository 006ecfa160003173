// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/sphere_types.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/trajectory/gsd_type_names.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::sphere_types_test {
namespace {

using namespace support;

Sphere sphere(SpeciesId species, double radius, double mass = 1) {
  return {.position = {1 + 2 * radius, species + 1.0, 2 * mass},
          .radius = radius,
          .mass = mass,
          .species = species};
}

// Two sizes of the first species, the larger one with two masses, and one kind of the third.
const std::vector<Sphere> kMixture{sphere(0, 0.5), sphere(2, 0.25), sphere(0, 0.25), sphere(0, 0.5, 3),
                                   sphere(0, 0.5)};

std::vector<std::size_t> types_of(const std::vector<Sphere>& spheres) {
  const SphereTypes types(spheres);
  std::vector<std::size_t> all;
  for (const Sphere& each : spheres) all.push_back(types.type_of(each));
  return all;
}

TEST(SphereTypes, AreSpeciesWhereEachHasOneSizeAndMass) {
  const std::vector<Sphere> spheres{sphere(2, 0.5), sphere(0, 0.25), sphere(2, 0.5)};
  EXPECT_EQ(types_of(spheres), (std::vector<std::size_t>{2, 0, 2}));
  EXPECT_FALSE(SphereTypes(spheres).are_finer_than_species());
  EXPECT_EQ(SphereTypes(spheres).count(), 3U);
  EXPECT_EQ(SphereTypes().count(), 1U);
}

TEST(SphereTypes, AreKindsWhereASpeciesHasSeveralSizesOrMasses) {
  EXPECT_EQ(types_of(kMixture), (std::vector<std::size_t>{1, 3, 0, 2, 1}));
  const SphereTypes types(kMixture);
  EXPECT_TRUE(types.are_finer_than_species());
  EXPECT_EQ(types.count(), 4U);
  EXPECT_EQ(types.species_of(2), 0);
  EXPECT_EQ(types.species_of(3), 2);
}

TEST(SphereTypes, AreSpeciesWhereThereAreManySizes) {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < SphereTypes::kMostKinds; ++i)
    spheres.push_back(sphere(1, 0.1 + 0.01 * static_cast<double>(i)));
  EXPECT_TRUE(SphereTypes(spheres).are_finer_than_species());
  spheres.push_back(sphere(1, 0.05));
  EXPECT_FALSE(SphereTypes(spheres).are_finer_than_species());
  EXPECT_EQ(SphereTypes(spheres).count(), 2U);
  EXPECT_EQ(types_of(spheres).back(), 1U);
}

// Several processes write what one does.
TEST(SphereTypes, AddUpToThoseOfAll) {
  SphereTypes sum;
  for (std::size_t i = 0; i < kMixture.size(); ++i) {
    SphereTypes own;
    own.add(kMixture[i].species, kMixture[i].radius, kMixture[i].mass);
    SphereTypes received;
    restore(archived(own), "types", received);
    sum.add(received);
  }
  for (const Sphere& each : kMixture) EXPECT_EQ(sum.type_of(each), SphereTypes(kMixture).type_of(each));
  EXPECT_EQ(sum.count(), 4U);
}

TEST(SphereTypes, HaveNamesInGsdThatTellTheSpecies) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(gsd::type_names(SphereTypes(kMixture)), (Names{"A.1", "A.2", "A.3", "C.1"}));
  EXPECT_EQ(gsd::species_of_type_names({"A.1", "A.2", "A.3", "C.1", "31.1"}),
            (std::vector<SpeciesId>{0, 0, 0, 2, 31}));
  EXPECT_EQ(gsd::type_names(SphereTypes(std::vector{sphere(1, 1)})), (Names{"A", "B"}));
  for (const Names& names : {Names{"B", "A"}, Names{"A.1", "Si"}, Names{"A.x"}, Names{"a.1"}, Names{"300.1"}})
    EXPECT_FALSE(gsd::species_of_type_names(names)) << names.front();
}

Snapshot mixture() {
  Snapshot snapshot;
  snapshot.spheres = kMixture;
  snapshot.box.emplace().size = {10, 10, 10};
  return snapshot;
}

// What other programs know as types are the kinds; what is read back are the species.
TEST(SphereTypes, AreWrittenAndReadBackAsSpecies) {
  const ScratchFolder folder;
  for (const char* name : {"a.xyz", "a.lammpstrj", "a.gsd", "a.csv", "a.npy"}) {
    SCOPED_TRACE(name);
    Trajectory(folder / name).append(mixture());
    const Snapshot read = read_snapshot(folder / name);
    ASSERT_EQ(read.spheres.size(), kMixture.size());
    for (std::size_t i = 0; i < kMixture.size(); ++i) {
      EXPECT_EQ(read.spheres[i].species, kMixture[i].species);
      EXPECT_EQ(read.spheres[i].mass, kMixture[i].mass);
    }
  }
  EXPECT_NE(read_text(folder / "a.xyz").find("\n2 2 1 2 0 0 0 0.5 1 0 0 0 0 1 0"), std::string::npos);
  EXPECT_NE(read_text(folder / "a.lammpstrj").find("\n3 3 2 1 6 0 0 0 0 0 0 0.5 3 1\n"), std::string::npos);
  EXPECT_NE(read_text(folder / "a.csv").find("\n1,4,1.5,3,2,0,0,0,0.25,1,0,0,0,3\n"), std::string::npos);
  Trajectory(folder / "a.data").append(mixture());
  const std::string data = read_text(folder / "a.data");
  EXPECT_NE(data.find("\n5 atoms\n4 atom types\n"), std::string::npos) << data;
  EXPECT_NE(data.find("\n2 4 0.5 "), std::string::npos) << data;
  std::vector<int> types;
  for (const Sphere& read : read_snapshot(folder / "a.data").spheres) types.push_back(read.species);
  EXPECT_EQ(types, (std::vector<int>{1, 3, 0, 2, 1}));
}

}  // namespace
}  // namespace hardball::sphere_types_test
