// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "apps/viewer/shared_recording.hpp"

namespace hardball::viewer {

/// The progress of a run that has left a recording and perhaps a summary: contacts from the recording, rate
/// and hash from the summary. Cost: that of RecordingReader::verify. Error: as for RecordingReader::verify.
RunProgress recorded_progress(SharedRecording& recording, const std::filesystem::path& summary);

}  // namespace hardball::viewer
