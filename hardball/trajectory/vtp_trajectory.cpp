// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/vtp_trajectory.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/checksum.hpp"
#include "hardball/io/output_file.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/io/xml_text.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/sphere_types.hpp"
#include "hardball/trajectory/vtp_arrays.hpp"

namespace hardball {
namespace {

constexpr std::string_view kEntry = "    <DataSet ";
constexpr const char* kExtension = ".vtp";
constexpr std::size_t kDigits = 8;
constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

std::string frame_name(std::uint64_t frame) {
  const std::string number = to_text(frame);
  return std::string(kDigits - std::min(kDigits, number.size()), '0') + number + kExtension;
}

bool is_frame_name(const std::filesystem::path& name) {
  const std::string stem = name.stem().string();
  return name.extension() == kExtension && stem.size() >= kDigits &&
         ranges::all_of(stem, [](unsigned char c) { return std::isdigit(c) != 0; });
}

// Removes the files of the frame of this name and of those that follow.
void remove_frames(const std::filesystem::path& folder, const std::string& first) {
  std::error_code ignored;
  std::vector<std::filesystem::path> frames;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::filesystem::path name = entry.path().filename();
    if (is_frame_name(name) && name.string() >= first) frames.push_back(entry.path());
  }
  for (const std::filesystem::path& frame : frames) std::filesystem::remove(frame, ignored);
}

std::string vtp_text(const Snapshot& snapshot) {
  const std::vector<Sphere>& spheres = snapshot.spheres;
  VtpArrays arrays;
  const auto add = [&](const char* name, const auto& value) {
    return arrays.add(name, spheres.size(), value);
  };
  const auto of_spheres = [&](const char* name, auto member) {
    return add(name, [&](std::size_t i) { return spheres[i].*member; });
  };
  const std::string count = to_text(spheres.size());
  std::string text;
  if (snapshot.time) {
    text +=
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" +
        to_text(*snapshot.time) + "</DataArray>\n</FieldData>\n";
  }
  text += "<Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" + count +
          "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
          "<PointData Scalars=\"radius\" Vectors=\"velocity\">\n";
  text += of_spheres("radius", &Sphere::radius);
  text += of_spheres("velocity", &Sphere::velocity);
  text += of_spheres("mass", &Sphere::mass);
  text += add("id", [&](std::size_t i) { return snapshot.id(i); });
  const SphereTypes types(spheres);
  text +=
      add("type", [&](std::size_t i) { return static_cast<std::int64_t>(types.type_of(spheres[i])) + 1; });
  if (types.are_finer_than_species())
    text += add("species_id", [&](std::size_t i) { return std::int64_t{spheres[i].species} + 1; });
  text += add("image", [&](std::size_t i) {
    const Image image = snapshot.image(i);
    return VectorOf<std::int64_t>{image[0], image[1], image[2]};
  });
  if (snapshot.has_spins) {
    text += of_spheres("angular_velocity", &Sphere::spin);
    text += of_spheres("moment", &Sphere::inertia_factor);
  }
  text += "</PointData>\n<Points>\n";
  text += of_spheres("points", &Sphere::position);
  text += "</Points>\n<Verts>\n";
  text += add("connectivity", [](std::size_t i) { return static_cast<std::int64_t>(i); });
  text += add("offsets", [](std::size_t i) { return static_cast<std::int64_t>(i + 1); });
  return vtp_file(text + "</Verts>\n</Piece>\n", arrays);
}

}  // namespace

VtpTrajectory::VtpTrajectory(std::filesystem::path path, const std::optional<TrajectoryPosition>& position)
    : path_(std::move(path)) {
  if (position) {
    find_first(*position);
    return;
  }
  remove(path_);
  std::error_code failure;
  std::filesystem::create_directories(folder_of(path_), failure);
  if (failure) {
    throw Error("cannot be created as a directory: " + failure.message(), folder_of(path_).string(),
                "name a file in a directory that you may write to");
  }
  listed_ = kUnknown;
  flush();
}

VtpTrajectory::~VtpTrajectory() {
  try {
    if (!is_too_long_) flush();
  } catch (const std::exception&) {
    // The collection keeps the frames listed before.
  }
}

std::filesystem::path VtpTrajectory::folder_of(const std::filesystem::path& path) {
  return std::filesystem::path(path).replace_extension();
}

void VtpTrajectory::remove(const std::filesystem::path& path) {
  std::error_code ignored;
  // Without a collection, the folder is somebody else's.
  if (!std::filesystem::exists(path, ignored)) return;
  remove_frames(folder_of(path), frame_name(0));
  std::filesystem::remove(folder_of(path), ignored);  // if it is empty
  std::filesystem::remove(path, ignored);
}

// Reads the entries of the first frames from the collection.
void VtpTrajectory::find_first(const TrajectoryPosition& position) {
  constexpr const char* kRemedy = "restore the files, or start again in another directory";
  const std::uint64_t frames = position.frames;
  std::ifstream in(path_, std::ios::binary);
  if (!in) throw Error(std::string("cannot be read: ") + std::strerror(errno), path_.string(), kRemedy);
  for (std::string line; frames_ < frames && std::getline(in, line);) {
    if (!line.starts_with(kEntry)) continue;
    if (!std::filesystem::exists(folder_of(path_) / frame_name(frames_))) break;
    entries_ += line + "\n";
    synced_ = ++frames_;
  }
  if (frames_ < frames) {
    throw Error(
        "has " + to_text(frames_) + " frames, not the " + to_text(frames) + " or more that were written",
        path_.string(), kRemedy);
  }
  if (position.file.checksum && position.file.checksum != checksum()) {
    throw Error("does not hold what was written: it differs before frame " + to_text(frames), path_.string(),
                kRemedy);
  }
  is_too_long_ = true;
}

// Positions of the collection so far and of its last frames.
std::uint64_t VtpTrajectory::checksum() const {
  std::string parts = entries_;
  std::uint64_t summed = 0;
  for (std::uint64_t frame = frames_; frame-- > 0 && summed < kSummedBytes;) {
    const std::string bytes = read_file(folder_of(path_) / frame_name(frame));
    append_little_endian(parts, checksum_of(bytes));
    summed += bytes.size();
  }
  return checksum_of(parts);
}

void VtpTrajectory::cut_back() {
  if (!is_too_long_) return;
  is_too_long_ = false;
  listed_ = kUnknown;
  flush();
  remove_frames(folder_of(path_), frame_name(frames_));
}

void VtpTrajectory::append(const Snapshot& snapshot, std::uint64_t frame) {
  constexpr std::uint64_t kShare = 8;
  cut_back();
  const std::filesystem::path folder = folder_of(path_);
  OutputFile file(folder / frame_name(frame));
  file.append(vtp_text(snapshot));
  file.close();
  entries_ += std::string(kEntry) + "timestep=\"" +
              to_text(snapshot.time.value_or(static_cast<double>(frame))) + "\" file=\"" +
              xml_escaped((folder.filename() / frame_name(frame)).generic_string()) + "\"/>\n";
  ++frames_;
  if (frames_ - listed_ > listed_ / kShare) flush();
}

TrajectoryPosition VtpTrajectory::position() {
  cut_back();
  for (; synced_ < frames_; ++synced_) {
    const std::filesystem::path path = folder_of(path_) / frame_name(synced_);
    OutputFile(path, {std::filesystem::file_size(path), {}}).sync();
  }
  flush();
  try {
    return {.file = {0, checksum()}};
  } catch (const Error& error) {
    throw RunFailure(error.what());
  }
}

void VtpTrajectory::flush() {
  cut_back();
  if (listed_ == frames_) return;
  replace_file(path_,
               "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
               "byte_order=\"LittleEndian\">\n  <Collection>\n" +
                   entries_ + "  </Collection>\n</VTKFile>\n");
  listed_ = frames_;
}

}  // namespace hardball
