// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/written.hpp"

#include <fmt/format.h>

#include <system_error>

#include "hardball/trajectory/vtp_trajectory.hpp"

namespace hardball::cli {
namespace {

// The size in the largest unit of which it has at least one: 999 bytes, 1.0 kB, 12 kB, 1.2 MB.
std::string size_text(std::uintmax_t bytes) {
  constexpr double kStep = 1000;
  constexpr double kRoundedUp = 999.5;  // from here on it has four digits before the point
  constexpr double kFewDigits = 9.95;   // below, there is a digit after the point
  auto size = static_cast<double>(bytes);
  if (size < kStep) return count_of(bytes, "byte");
  std::string_view unit;
  for (const std::string_view each : {"kB", "MB", "GB", "TB"}) {
    unit = each;
    size /= kStep;
    if (size < kRoundedUp) break;
  }
  return fmt::format("{:.{}f} {}", size, size < kFewDigits ? 1 : 0, unit);
}

std::uintmax_t size_of(const std::filesystem::path& file) {
  std::error_code unknown;
  std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
  if (unknown) return 0;
  if (file.extension() != ".pvd") return bytes;
  for (const auto& frame : std::filesystem::directory_iterator(VtpTrajectory::folder_of(file), unknown)) {
    std::error_code gone;
    const std::uintmax_t more = frame.path().extension() == ".vtp" ? frame.file_size(gone) : 0;
    if (!gone) bytes += more;
  }
  return bytes;
}

}  // namespace

std::string count_of(std::uint64_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string written_line(const std::filesystem::path& file, const std::string& contents) {
  return fmt::format("wrote {}, {}{}{}\n", file.string(), size_text(size_of(file)),
                     contents.empty() ? "" : ", ", contents);
}

}  // namespace hardball::cli
