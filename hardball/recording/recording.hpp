// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The layout of the file, see docs/recording.md.
namespace recording_format {
/// The version of recordings with surfaces that go on otherwise, of spheres that may grow, and of all others.
inline constexpr int kVersionWithMotions = 5;
inline constexpr int kVersionWithGrowth = 4;
inline constexpr int kVersionWithoutGrowth = 3;
/// How a file begins, by its version.
inline constexpr std::string_view kMagicWithMotions = "HBREC005";
inline constexpr std::string_view kMagicWithGrowth = "HBREC004";
inline constexpr std::string_view kMagicWithoutGrowth = "HBREC003";
inline constexpr std::uint64_t kMagicBytes = 8;
inline constexpr std::uint32_t kChunkMagic = 0x4b4e4843;
inline constexpr std::uint64_t kLengthBytes = 4;  // of the length of the header's text
inline constexpr std::uint64_t kSphereBytes = 2 * 8;

/// What the parts of a file contain.
struct Layout {
  static constexpr std::uint64_t kHeadBytes = 4 + 4 + 8 + 2 * 8;
  static constexpr std::uint64_t kPathBytes = 7 * 8;
  static constexpr std::uint64_t kBodyBytes = 10 * 8;
  static constexpr std::uint64_t kGrowthBytes = 3 * 8;
  static constexpr std::uint64_t kChecksumBytes = 8;
  /// Length of the head of a chunk with its checksum.
  static constexpr std::uint64_t kSummedHeadBytes = kHeadBytes + kChecksumBytes;

  bool has_bodies = false;
  bool has_growth = false;
  bool has_motions = false;  ///< Excludes growth.

  int version() const {
    if (has_motions) return kVersionWithMotions;
    return has_growth ? kVersionWithGrowth : kVersionWithoutGrowth;
  }
  std::string_view magic() const {
    if (has_motions) return kMagicWithMotions;
    return has_growth ? kMagicWithGrowth : kMagicWithoutGrowth;
  }
  /// Length of what a chunk says of the growth at its begin.
  std::uint64_t growth_bytes() const { return has_growth ? kGrowthBytes : 0; }
  /// Length of what a keyframe says of a sphere.
  std::uint64_t keyframe_bytes() const { return kPathBytes + (has_bodies ? kBodyBytes : 0); }
  /// Length of a contact.
  std::uint64_t contact_bytes() const { return has_bodies ? 8 + 4 * 4 + 18 * 8 : 8 + 2 * 4 + 12 * 8; }
  /// Length of a chunk. Precondition: both counts are below 2^32.
  std::uint64_t chunk_bytes(std::uint64_t spheres, std::uint64_t contacts) const {
    return kSummedHeadBytes + growth_bytes() + keyframe_bytes() * spheres + contact_bytes() * contacts +
           kChecksumBytes;
  }
};
}  // namespace recording_format

/// A force between two bodies at rest.
struct RecordedForce {
  std::uint32_t first = 0;  ///< A sphere.
  std::int32_t second = 0;  ///< Another, or -(k + 1) for wall k, as in RecordedContact.
  Vec3 separation = {};     ///< From the center of the first to that of the second, or to the wall [L].
  double force = 0;         ///< Over the mean of all [1]; NaN if it is not known.
};

/// What a recording says about the run as a whole.
///
/// A recording is the whole history of a run in a file: where the spheres were at the start, and every
/// contact with the motion after it. docs/recording.md describes the format.
struct RecordingHeader {
  bool has_bodies = false;  ///< Whether spheres may spin, merge or pass through each other.
  bool has_growth = false;  ///< Whether spheres may grow.
  /// Whether motions drive surfaces, which then go on otherwise now and then. Excludes growth.
  bool has_motions = false;
  std::size_t spheres = 0;  ///< Ids are below this; without bodies, all spheres exist at the start.
  Box box = {};
  double begin = 0;                    ///< [T]
  std::optional<double> until = {};    ///< When the run is to end [T], if known.
  Vec3 cell_edge = {};                 ///< Edges of a cell [L]; zero if there are no cells.
  Vec3 cell_origin = {};               ///< A corner of a cell [L].
  std::string name = {};               ///< Name of the scenario.
  double restitution = 1;              ///< [1]; NaN if it is not one number.
  Vec3 gravity = {};                   ///< Acceleration of all spheres [L/T^2].
  std::vector<Surface> surfaces = {};  ///< Without a restitution of its own, it is that of the response.
  std::vector<std::string> species_names = {};      ///< By species; those without a name are missing.
  std::vector<SpeciesId> species = {};              ///< By id; empty if all are zero.
  std::vector<std::array<SphereId, 2>> bonds = {};  ///< Pairs of spheres that are tied to each other.
  /// What holds spheres that are packed, for viewers; parse_recording_header leaves it out.
  std::vector<RecordedForce> forces = {};

  recording_format::Layout layout() const { return {has_bodies, has_growth, has_motions}; }
};

/// One JSON object.
HARDBALL_EXPORT std::string to_json(const RecordingHeader& header);

/// The header described by a JSON object; unknown keys are ignored. `where` names the recording in messages.
/// Error: it is not such an object, or describes an impossible box or surface.
HARDBALL_EXPORT RecordingHeader parse_recording_header(std::string_view json, const std::string& where);

/// The motion of a sphere from a contact, or from the start, on.
struct HARDBALL_EXPORT RecordedPath {
  using PlainNumber = double;  ///< To archives.

  Vec3 position;    ///< Center at `time`, folded into the box [L].
  Vec3 velocity;    ///< [L/T]
  double time = 0;  ///< [T]

  /// The center at `moment` [T] under `gravity` [L/T^2], not folded into the box [L].
  Vec3 center_at(double moment, const Vec3& gravity) const;
  /// The velocity at `moment` [T] under `gravity` [L/T^2], in L/T.
  Vec3 velocity_at(double moment, const Vec3& gravity) const;

  friend bool operator==(const RecordedPath&, const RecordedPath&) = default;
};

/// How a sphere is turned: a unit quaternion. Turned upright, a sphere is as it was at the start.
struct HARDBALL_EXPORT Orientation {
  using PlainNumber = double;  ///< To archives.

  Vec3 imaginary;   ///< [1]
  double real = 1;  ///< [1]

  /// After `duration` [T] with this spin [1/T].
  Orientation turned(const Vec3& spin, double duration) const;

  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// What a sphere is and how it turns, from a contact, or from the start, on.
struct RecordedBody {
  using PlainNumber = double;  ///< To archives.

  Vec3 spin = {};                ///< Angular velocity [1/T].
  Orientation orientation = {};  ///< When the sphere's path started.
  /// [L]; zero once the sphere has become part of another, or if it was removed before the start.
  /// Where spheres grow, the base radius.
  double radius = 0;
  double mass = 0;                               ///< [M]; infinite for a kinematic sphere.
  double inertia_factor = kSphereInertiaFactor;  ///< Moment of inertia over mass and squared radius [1].

  bool exists() const { return radius > 0; }
  friend bool operator==(const RecordedBody&, const RecordedBody&) = default;
};

/// The scale of all radii from some time on; see Growth.
struct RecordedEpoch {
  using PlainNumber = double;  ///< To archives.

  double begin = 0;  ///< [T]
  double scale = 1;  ///< At the begin [1].
  double rate = 0;   ///< [1/T]

  double scale_at(double time) const { return scale + rate * (time - begin); }
  friend bool operator==(const RecordedEpoch&, const RecordedEpoch&) = default;
};

/// A collision, a contact with a surface, or a change of one sphere's velocity without a contact, and the
/// motion after it; or the begin of an epoch of growth.
struct HARDBALL_EXPORT RecordedContact {
  double time = 0;  ///< [T]
  SphereId first = 0;
  /// The id of the other sphere; `first` where there is no contact; or -(k + 1) for surface k: 0 to 5 are the
  /// faces of the box (see Face), and 6 + i is surface i of the header. kEpoch if an epoch begins: then
  /// `first` is no sphere, and the first two components of `first_position` are its scale and its rate.
  /// kSurface if a surface goes on otherwise: then `first` is its number, and `first_position` and
  /// `first_velocity` are those of its point.
  std::int32_t second = 0;
  static constexpr std::int32_t kEpoch = std::numeric_limits<std::int32_t>::min();
  static constexpr std::int32_t kSurface = kEpoch + 1;
  Vec3 first_position = {};   ///< Center, folded into the box [L].
  Vec3 first_velocity = {};   ///< [L/T]
  Vec3 second_position = {};  ///< Zero unless it is a collision.
  Vec3 second_velocity = {};  ///< [L/T]; zero unless it is a collision, and if the spheres merge.
  ContactOutcome outcome = ContactOutcome::bounce;
  Vec3 first_spin = {};   ///< [1/T]
  Vec3 second_spin = {};  ///< Zero unless it is a collision; zero if the spheres merge.
  /// The first sphere after a merger.
  struct Merged {
    using PlainNumber = double;

    double radius = 0;          ///< [L]
    double mass = 0;            ///< [M]
    double inertia_factor = 0;  ///< Moment of inertia over mass and squared radius [1].

    friend bool operator==(const Merged&, const Merged&) = default;
  };
  Merged merged = {};

  bool is_epoch() const { return second == kEpoch; }
  bool is_surface() const { return second == kSurface; }
  bool is_wall() const { return second < 0 && !is_epoch() && !is_surface(); }
  /// Whether two spheres meet, even if they pass through each other.
  bool is_collision() const { return second >= 0 && static_cast<SphereId>(second) != first; }
  /// Precondition: is_epoch().
  RecordedEpoch epoch() const { return {time, first_position.x, first_position.y}; }
  /// Sets the paths of the contact's spheres to those after it. `paths`: by id.
  void rewrite(std::vector<RecordedPath>& paths) const;
  /// Sets the bodies of the contact's spheres to those after it. `paths`: those before the contact.
  void rewrite(std::vector<RecordedBody>& bodies, const std::vector<RecordedPath>& paths) const;
  friend bool operator==(const RecordedContact&, const RecordedContact&) = default;

  static void persist(auto& archive, auto& self) {
    archive(self.time, self.first, self.second, self.first_position, self.first_velocity,
            self.second_position, self.second_velocity, self.outcome, self.first_spin, self.second_spin,
            self.merged);
    archive.require(self.outcome <= ContactOutcome::merge);
  }
};

/// A part of a recording that can be shown by itself.
struct HARDBALL_EXPORT RecordedChunk {
  double begin = 0;                       ///< [T]
  double end = 0;                         ///< [T]
  std::vector<RecordedPath> keyframe;     ///< By id: the paths at `begin`, before any contact of the chunk.
  std::vector<RecordedBody> bodies;       ///< By id: the bodies at `begin`.
  std::vector<RecordedContact> contacts;  ///< In order.
  RecordedEpoch epoch = {};               ///< The epoch of growth at `begin`.

  /// By id: the paths after all contacts up to `time` [T]. Precondition: begin <= time <= end.
  std::vector<RecordedPath> paths_at(double time) const;
  /// By id: the bodies after all contacts up to `time` [T]; a sphere that has become part of another has
  /// none. Precondition: begin <= time <= end.
  std::vector<RecordedBody> bodies_at(double time) const;
  /// The surfaces after all contacts up to `time` [T], which before the chunk were `surfaces`: those of the
  /// header will do. Precondition: begin <= time <= end.
  std::vector<Surface> surfaces_at(double time, std::vector<Surface> surfaces) const;
  /// The factor of the radii of the bodies at `time` [1]. Precondition: begin <= time <= end.
  double scale_at(double time) const;
};

}  // namespace hardball
