// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "apps/viewer/shared_recording.hpp"

namespace hardball::viewer {

/// How far a run had come whose files, a recording and perhaps a summary, are in a directory: contacts as the
/// recording has them, rate and hash as the summary has them. Cost: that of reading, and so checking, all of
/// the recording. Error: see RecordingReader.
RunProgress recorded_progress(const std::filesystem::path& recording, const std::filesystem::path& summary);

}  // namespace hardball::viewer
