// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "apps/viewer/shared_recording.hpp"

namespace hardball::viewer {

/// The progress of a run whose files, a recording and perhaps a summary, are in a directory: contacts from
/// the recording, rate and hash from the summary. Cost: that of reading, and so checking, the whole
/// recording. Error: see RecordingReader.
RunProgress recorded_progress(const std::filesystem::path& recording, const std::filesystem::path& summary);

}  // namespace hardball::viewer
