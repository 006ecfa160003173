// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// A surface that spheres bounce off, besides the faces of the box.
struct RecordedSurface {
  enum class Shape {
    plane,     ///< Spheres are on the side to which the normal points.
    cylinder,  ///< Unbounded along its axis; spheres are inside.
    sphere,    ///< Spheres are inside.
    obstacle,  ///< A sphere; the spheres are outside.
  };

  Shape shape = Shape::plane;
  Vec3 point = {};                         ///< Of the plane or the axis at time 0, or the centre [L].
  Vec3 direction = {0, 0, 1};              ///< Unit normal of a plane, unit vector along an axis [1].
  double radius = 0;                       ///< [L]; 0 for a plane.
  Vec3 velocity = {};                      ///< With which the point moves [L/T].
  double amplitude = 0;                    ///< Of a plane's oscillation along its normal [L].
  double frequency = 0;                    ///< Of that oscillation: cycles per time [1/T].
  std::optional<double> temperature = {};  ///< kT [M L^2 T^-2] of a thermal surface.
  double restitution = 1;                  ///< [1]

  friend bool operator==(const RecordedSurface&, const RecordedSurface&) = default;
};

/// What a recording says about the run as a whole.
///
/// A recording is the whole history of a run in a file: where the spheres were at the start, and every
/// contact with the motion after it. docs/recording.md describes the format.
struct RecordingHeader {
  std::size_t spheres = 0;  ///< How many; their ids are 0 to spheres - 1.
  Box box = {};
  double begin = 0;                  ///< [T]
  std::optional<double> until = {};  ///< When the run is to end [T], if known.
  Vec3 cell_edge = {};               ///< Edges of a cell [L]; zero if there are no cells.
  Vec3 cell_origin = {};             ///< A corner of a cell [L].
  std::string name = {};             ///< Of the scenario.
  double restitution = 1;            ///< [1]
  Vec3 gravity = {};                 ///< Acceleration of all spheres [L/T^2].
  std::vector<RecordedSurface> surfaces = {};
};

/// One JSON object.
std::string to_json(const RecordingHeader& header);

/// The header described by a JSON object; unknown keys are ignored. `where` names the recording in messages.
/// Error: it is not such an object, or describes an impossible box or surface.
RecordingHeader parse_recording_header(std::string_view json, const std::string& where);

/// The motion of a sphere from a contact, or from the start, on.
struct RecordedPath {
  Vec3 position;    ///< Centre at `time`, folded into the box [L].
  Vec3 velocity;    ///< [L/T]
  double time = 0;  ///< [T]

  /// The centre at `moment` [T] under `gravity` [L/T^2], not folded into the box [L].
  Vec3 center_at(double moment, const Vec3& gravity) const;
  /// The velocity at `moment` [T] under `gravity` [L/T^2], in L/T.
  Vec3 velocity_at(double moment, const Vec3& gravity) const;

  friend bool operator==(const RecordedPath&, const RecordedPath&) = default;
};

/// A collision, a contact with a surface, or a change of one sphere's velocity without a contact, and the
/// motion after it.
struct RecordedContact {
  double time = 0;  ///< [T]
  SphereId first = 0;
  /// The id of the other sphere; `first` where there is no contact; or -(k + 1) for surface k: 0 to 5 are the
  /// faces of the box (see Face), and 6 + i is surface i of the header.
  std::int32_t second = 0;
  Vec3 first_position;   ///< Centre, folded into the box [L].
  Vec3 first_velocity;   ///< [L/T]
  Vec3 second_position;  ///< Zero unless it is a collision.
  Vec3 second_velocity;  ///< Likewise.

  bool is_wall() const { return second < 0; }
  bool is_collision() const { return !is_wall() && static_cast<SphereId>(second) != first; }
  /// Sets the paths of the contact's spheres to those after it. `paths`: by id.
  void rewrite(std::vector<RecordedPath>& paths) const;
  friend bool operator==(const RecordedContact&, const RecordedContact&) = default;
};

/// A part of a recording that can be shown by itself.
struct RecordedChunk {
  double begin = 0;                       ///< [T]
  double end = 0;                         ///< [T]
  std::vector<RecordedPath> keyframe;     ///< By id: the paths at `begin`, before any contact of the chunk.
  std::vector<RecordedContact> contacts;  ///< In order.

  /// By id: the paths after all contacts up to `time` [T]. Precondition: begin <= time <= end.
  std::vector<RecordedPath> paths_at(double time) const;
};

/// The layout of the file, see docs/recording.md.
namespace recording_format {
inline constexpr std::string_view kMagic = "HBREC001";
inline constexpr std::uint32_t kChunkMagic = 0x4b4e4843;
inline constexpr std::uint64_t kLengthBytes = 4;  // of the length of the header's text
inline constexpr std::uint64_t kSphereBytes = 2 * 8;
inline constexpr std::uint64_t kChunkHeaderBytes = 4 + 4 + 8 + 2 * 8;
inline constexpr std::uint64_t kPathBytes = 7 * 8;
inline constexpr std::uint64_t kContactBytes = 8 + 2 * 4 + 12 * 8;

/// Length of a chunk in bytes. Precondition: both counts are below 2^32.
inline constexpr std::uint64_t chunk_bytes(std::uint64_t spheres, std::uint64_t contacts) {
  return kChunkHeaderBytes + kPathBytes * spheres + kContactBytes * contacts;
}
}  // namespace recording_format

}  // namespace hardball
