// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/io/output_file.hpp"
#include "hardball/recording/recording.hpp"
#include "hardball/run/observer.hpp"
#include "hardball/world/velocity_change.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

class Simulation;

/// Writes a recording: an observer notified of every contact, and of every other change of a velocity.
///
/// The file always ends with a complete chunk. A chunk is closed when it holds as many contacts as there are
/// spheres, or 1000 if that is more, or 64 MB of them; at flush(); and at close(). Contacts at the same time
/// are never split between chunks. Memory: 56 bytes per sphere, and
/// 192 per contact of the open chunk; with bodies also 80 per sphere.
class HARDBALL_EXPORT RecordingWriter {
 public:
  /// Creates the file and records the spheres of `world`, whose number, box and species replace those of
  /// `header`. It must have bodies where contacts may turn spheres or merge them; where spheres spin or may
  /// pass through each other, or one has been removed, it gets them. It must have growth where spheres may
  /// grow. Precondition: no contact has happened since header.begin, nor lies between the stored paths and
  /// it. Error: the file cannot be opened for writing.
  RecordingWriter(std::filesystem::path path, RecordingHeader header, const World& world);

  /// Opens an existing file to continue from what `save` returned then; what follows in it is cut off as
  /// soon as anything is called, and not before.
  /// Error: it cannot be opened for writing, is shorter, or contains something else there; `saved` is
  /// damaged, or of a later version.
  RecordingWriter(std::filesystem::path path, std::string_view saved);

  /// Waits until all chunks are on the disk, and returns what is needed to continue from here, the open chunk
  /// included. Error (RunFailure): as for record.
  std::string save();

  /// Records a contact or a change. `world`: after it. Precondition: all contacts and changes are recorded,
  /// in order; no sphere is added or removed but by a merger, which needs bodies. Error (RunFailure): the
  /// file cannot be written.
  void record(const Contact& contact, const World& world);
  /// Records a contact in which no spheres merge. Error (RunFailure): the file cannot be written.
  void record(const Contact& contact);
  /// Records a contact of a simulation, which is asked for the world only if spheres merge: for
  /// Observer::contact. Error (RunFailure): the file cannot be written.
  void record(const Contact& contact, const Simulation& simulation);
  void record(const VelocityChange& change, const World& world);
  /// Records an epoch of growth that has begun. Precondition: the header says that spheres may grow. Error
  /// (RunFailure): the file cannot be written.
  void record(const Growth& epoch);
  /// Records that a surface goes on otherwise. Precondition: the header says that motions drive surfaces.
  /// Error (RunFailure): the file cannot be written.
  void record(std::uint32_t number, const Surface& surface);

  /// Closes the chunk and hands it to the operating system, so that readers see it. Contacts at the time of
  /// the last one are kept for the next chunk, since others may follow at the same time. Error (RunFailure):
  /// as for record.
  void flush();

  /// Ends the recording at `time` [T], or at the last contact if that is later, and closes the file; does
  /// nothing if it is closed. Error (RunFailure): as for record.
  void close(double time);

  /// Closes the file, if it is open and anything was called, at the last contact recorded, as far as
  /// possible; errors are ignored.
  ~RecordingWriter();
  RecordingWriter(RecordingWriter&&) noexcept = default;

  const std::filesystem::path& path() const { return file_.path(); }
  /// Length of the file if the chunk were closed now.
  std::uint64_t bytes() const;
  /// Length of a chunk without contacts.
  std::uint64_t keyframe_bytes() const { return state_.layout.chunk_bytes(state_.keyframe.size(), 0); }
  /// Length of a contact.
  std::uint64_t contact_bytes() const { return state_.layout.contact_bytes(); }

 private:
  // All but the file.
  struct State {
    recording_format::Layout layout;
    FilePosition file;              // without the open chunk; its checksum is of the last save
    std::size_t most_contacts = 0;  // of a chunk, unless they are at one time
    bool has_chunks = false;
    double begin = 0;                       // of the open chunk
    std::vector<RecordedPath> keyframe;     // of the open chunk
    std::vector<RecordedBody> bodies;       // of the open chunk, if the layout has them
    std::vector<RecordedContact> contacts;  // of the open chunk, so far
    RecordedEpoch epoch;                    // at the begin of the open chunk
    std::vector<RecordedContact> surfaces;  // as of the last chunk, those that have gone on otherwise

    static void persist(auto& archive, auto& self) {
      archive(self.layout.has_growth, self.file, self.layout.has_bodies, self.most_contacts, self.has_chunks,
              self.begin, self.keyframe, self.bodies, self.contacts, self.epoch);
      if (archive.version() >= kSinceVersion) archive(self.layout.has_motions, self.surfaces);
    }
    static constexpr std::uint32_t kSinceVersion = 15;  // of archives that have surfaces
    bool restored();
  };

  RecordingWriter(std::filesystem::path path, State state);
  static State restored(std::string_view saved, const std::string& where);
  RecordedContact recorded(const Contact& contact) const;
  void add(const RecordedContact& contact);
  void write_chunk(std::size_t contacts, double end);
  void repeat_surfaces();

  OutputFile file_;
  State state_;
  bool is_untouched_ = false;  // since it was opened to continue
};

/// What writes the contacts and changes of a simulation, from where it is on, to a recording. The writer and
/// the simulation outlive it.
HARDBALL_EXPORT Observer recording_observer(RecordingWriter& writer, const Simulation& simulation);

}  // namespace hardball
