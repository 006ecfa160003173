// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/shown_run.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/viewer/built_page.hpp"
#include "apps/viewer/server.hpp"
#include "hardball/error.hpp"
#include "hardball/platform/program.hpp"

namespace hardball::cli {
namespace {

int read_port(const ViewOptions& options) {
  if (!options.port) return 0;
  const std::string remedy = "give a number from 1 to 65535";
  const int port = parse_number<int>(*options.port, "--port", remedy);
  if (port < 1 || port > 65535) throw Error("there is no port " + to_text(port), "--port", remedy);
  return port;
}

std::uint64_t read_recording_limit(const ViewOptions& options) {
  constexpr double kMax = 1e18;
  if (!options.recording_limit) return 4'000'000'000;
  const std::string remedy = "give a number of bytes such as 4e9";
  const double limit = parse_number<double>(*options.recording_limit, "--recording-limit", remedy);
  if (!(limit > 0 && limit <= kMax))
    throw Error("the limit is " + to_text(limit), "--recording-limit", remedy);
  return static_cast<std::uint64_t>(limit);
}

}  // namespace

ExitCode view(const ViewOptions& options) {
  using namespace std::chrono_literals;
  const int port = read_port(options);
  const std::uint64_t most_bytes = read_recording_limit(options);
  catch_signals();
  const ShownRun shown(options.run, most_bytes);
  const viewer::Server server(shown.recording(), viewer::built_page(), port);
  write_output(server.url() + "\n");
  if (const auto damage = shown.recording().progress().damage) write_message(*damage);
  write_notes({"open this address in a browser; Ctrl-C ends the viewer"}, options.run.quiet);
  if (!options.no_open && platform::has_display()) platform::open_browser(server.url());
  bool is_told = false;
  while (!is_interrupted()) {
    std::this_thread::sleep_for(50ms);
    const std::optional<std::string> failure = shown.recording().progress().failure;
    if (failure && !is_told) write_message(*failure);
    is_told = failure.has_value();
  }
  return ExitCode::done;
}

}  // namespace hardball::cli
