// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/output_paths.hpp"
#include "apps/cli/parse_number.hpp"
#include "apps/cli/shown_run.hpp"
#include "apps/cli/status_line.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "apps/viewer/built_page.hpp"
#include "apps/viewer/film.hpp"
#include "apps/viewer/server.hpp"
#include "apps/viewer/token.hpp"
#include "hardball/error.hpp"
#include "hardball/platform/program.hpp"

namespace hardball::cli {
namespace {

constexpr const char* kBrowserVariable = "HARDBALL_BROWSER";
constexpr std::uint64_t kMostRecordedBytes = 4'000'000'000;
constexpr double kMostFrames = 1e6;

// Error: there is none.
std::filesystem::path find_browser() {
  const char* const named = std::getenv(kBrowserVariable);
  if (named && *named) {
    const std::filesystem::path program(named);
    std::error_code unknown;
    if (std::filesystem::is_regular_file(program, unknown)) return program;
    throw Error("there is no such program: " + shortened(named), kBrowserVariable,
                "let it name the program of Chromium or Chrome");
  }
  const std::filesystem::path found = platform::find_program(
      {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge"});
  if (!found.empty()) return found;
  throw Error("a film needs Chromium, which was not found", "film",
              std::string("install the package chromium, or let ") + kBrowserVariable + " name its program");
}

double read_number(const std::string& text, const std::string& option, const std::string& remedy) {
  const auto number = parse_number<double>(text, option, remedy);
  if (!std::isfinite(number)) throw Error("the number is " + to_text(number), option, remedy);
  return number;
}

std::optional<double> read_number(const std::optional<std::string>& text, const std::string& option,
                                  const std::string& remedy) {
  if (!text) return std::nullopt;
  return read_number(*text, option, remedy);
}

double read_positive(const std::string& text, const std::string& option, const std::string& remedy) {
  const double number = read_number(text, option, remedy);
  if (!(number > 0)) throw Error("the number is " + to_text(number), option, remedy);
  return number;
}

// Encoders take an even number of pixels along each side.
void read_size(const std::string& text, viewer::FilmOrder& order) {
  const std::string remedy = "give two even numbers from 16 to 8192, such as 1920x1080";
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) throw Error("'" + shortened(text) + "' is not accepted", "--size", remedy);
  order.width = parse_number<int>(text.substr(0, cross), "--size", remedy);
  order.height = parse_number<int>(text.substr(cross + 1), "--size", remedy);
  for (const int side : {order.width, order.height}) {
    if (side < 16 || side > 8192 || side % 2 != 0)
      throw Error("a side has " + to_text(side) + " pixels", "--size", remedy);
  }
}

viewer::FilmOrder read_order(const FilmOptions& options) {
  viewer::FilmOrder order;
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (extension != ".webm" && extension != ".mp4") {
    throw Error("the extension of a film is not " + (extension.empty() ? "left out" : shortened(extension)),
                options.out, "name a file such as out.webm or out.mp4");
  }
  order.format = extension.substr(1);
  const std::string time = "give a time of the run";
  order.from = read_number(options.from, "--from", time);
  order.to = read_number(options.to, "--to", time);
  if (options.speed) {
    order.speed = read_positive(*options.speed, "--speed",
                                "give the simulated time of a second of the film, more than 0");
  }
  order.fps = read_positive(options.fps, "--fps", "give the frames of a second of the film, from 1 to 240");
  if (order.fps < 1 || order.fps > 240) {
    throw Error("the number is " + to_text(order.fps), "--fps",
                "give the frames of a second of the film, from 1 to 240");
  }
  order.turn = read_number(options.spin, "--spin", "give an angle in degrees, such as 360");
  read_size(options.size, order);
  order.quality = options.quality;
  if (order.quality != "full" && order.quality != "points") {
    throw Error("there is no quality '" + shortened(order.quality) + "'", "--quality", "give full or points");
  }
  return order;
}

// Error: the run has not what the film is to show.
void check_times(const viewer::FilmOrder& order, double begin, double end) {
  for (const auto& [time, option] : {std::pair(order.from, "--from"), std::pair(order.to, "--to")}) {
    if (time && !(*time >= begin && *time <= end)) {
      throw Error("the run has no time " + to_text(*time), option,
                  "give a time from " + to_text(begin) + " to " + to_text(end));
    }
  }
  const double from = order.from.value_or(begin);
  const double to = order.to.value_or(end);
  if (from > to)
    throw Error("the film would end before it begins", "--to", "give a time from " + to_text(from) + " on");
  if (order.speed && (to - from) / *order.speed * order.fps > kMostFrames) {
    throw Error("the film would have more than a million frames", "--speed", "give a larger one");
  }
}

// A folder that is there while the browser is.
class Profile {
 public:
  Profile() : path_(std::filesystem::temp_directory_path() / ("hardball_film_" + viewer::make_token())) {
    std::error_code failure;
    std::filesystem::create_directory(path_, failure);
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, failure);
    if (failure) {
      throw Error("cannot create a temporary folder: " + failure.message(), path_.parent_path().string(),
                  "name another directory in the environment variable TMPDIR");
    }
  }
  ~Profile() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Profile(const Profile&) = delete;
  Profile& operator=(const Profile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::vector<std::string> browser_arguments(const Profile& profile, const std::string& address) {
  std::vector<std::string> arguments{
      "--headless=new",
      "--user-data-dir=" + profile.path().string(),
      "--no-first-run",
      "--no-default-browser-check",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--disable-extensions",
      "--hide-scrollbars",
      "--force-device-scale-factor=1",
      "--force-color-profile=srgb",
      // Where there is no graphics card, it is emulated, also in containers with little shared memory.
      "--enable-unsafe-swiftshader",
      "--ignore-gpu-blocklist",
      "--disable-dev-shm-usage",
      // The page has no frames that somebody waits for.
      "--disable-background-timer-throttling",
      "--disable-renderer-backgrounding",
      "--window-size=1280,720",
  };
  // It refuses to run as root with its sandbox; the only page that it opens is the program's own.
  if (platform::is_superuser()) arguments.emplace_back("--no-sandbox");
  arguments.push_back(address);
  return arguments;
}

// The part of a link after its #, or the whole text if there is none.
std::string state_in(const std::string& view) {
  const std::size_t hash = view.find('#');
  return hash == std::string::npos ? view : view.substr(hash + 1);
}

// Error (RunFailure): the film is not complete.
void await(const viewer::Film& film, platform::ChildProgram& browser, const viewer::FilmOrder& order,
           bool quiet) {
  using namespace std::chrono_literals;
  StatusLine line(!quiet);
  for (;;) {
    const viewer::FilmProgress progress = film.progress();
    if (progress.failure) throw RunFailure("the film could not be made: " + *progress.failure);
    if (progress.has_ended) return;
    if (is_interrupted()) throw RunFailure("interrupted; no film has been written");
    if (!browser.is_running())
      throw RunFailure("the browser ended before the film; no film has been written");
    if (line.is_due() && progress.of > 0) {
      line.show(static_cast<double>(progress.shown) / static_cast<double>(progress.of),
                to_text(progress.shown) + " of " + count_of(progress.of, "frame") + ", " +
                    to_text(order.width) + " by " + to_text(order.height));
    }
    std::this_thread::sleep_for(20ms);
  }
}

}  // namespace

ExitCode film(const FilmOptions& options) {
  using namespace std::chrono_literals;
  const viewer::FilmOrder order = read_order(options);
  const std::filesystem::path program = find_browser();
  refuse_to_overwrite(options.out, options.overwrite);
  const std::filesystem::path frames = options.frames.value_or("");
  if (!frames.empty()) {
    make_directory(frames);
    if (!options.overwrite && !std::filesystem::is_empty(frames)) {
      throw Error("the directory is not empty", frames.string(),
                  "name another one, or replace frames with --overwrite");
    }
  }
  catch_signals();
  const ShownRun shown(options.run, kMostRecordedBytes);
  while (!shown.recording().progress().is_finished) {
    if (is_interrupted()) throw RunFailure("interrupted; no film has been written");
    std::this_thread::sleep_for(20ms);
  }
  check_times(order, shown.recording().header().begin, shown.recording().reached());
  viewer::Film film(order, options.out, frames);
  {
    const viewer::Server server(shown.recording(), viewer::built_page(), 0, {}, &film);
    const Profile profile;
    platform::ChildProgram browser(
        program, browser_arguments(profile, server.url() + "&film=1#" + state_in(options.view)));
    if (!browser.has_started()) throw RunFailure("cannot start " + program.string());
    await(film, browser, order, options.run.quiet);
  }
  film.close();
  const std::uint64_t count = film.progress().of;
  if (!options.run.quiet) {
    write_output(written_line(options.out, count_of(count, "frame") + " of " + to_text(order.width) + " by " +
                                               to_text(order.height)));
    if (!frames.empty())
      write_output("wrote " + count_of(count, "picture") + " in " + frames.string() + "\n");
  }
  const viewer::RunProgress progress = shown.recording().progress();
  if (progress.failure) write_message(*progress.failure + "; " + options.out + " shows it up to there");
  if (progress.damage) write_message(*progress.damage);
  return progress.failure || progress.damage ? ExitCode::failed : ExitCode::done;
}

}  // namespace hardball::cli
