// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The viewer as started by a user: what it prints, serves and leaves behind.
#include <gtest/gtest.h>
#include <httplib.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "cli/program.hpp"
#include "cli/written.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"

namespace hardball::view_test {
namespace {

using nlohmann::json;
using namespace support;

class View : public ProgramTest {
 protected:
  View() {
    write_text(folder_ / "gas.toml", kSmallGas);
    std::filesystem::create_directory(folder_ / "temporary");
  }
  ~View() override {
    if (program_) stop(SIGTERM);
  }

  // Starts the viewer and waits until it has printed its address.
  void start(const Arguments& more) {
    Arguments arguments{"TMPDIR=" + (folder_ / "temporary").string(), HARDBALL_PROGRAM, "view", "--no-open"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    program_.emplace(folder_, arguments, "/usr/bin/env");
    std::string address;
    for (int k = 0; k < 12000 && !address.ends_with('\n'); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      address = read_text(folder_ / "program.stdout");
    }
    ASSERT_TRUE(address.starts_with("http://127.0.0.1:")) << address;
    const std::size_t query = address.find("/?token=");
    ASSERT_EQ(address.size(), query + 8 + 32 + 1) << address;
    server_ = address.substr(0, query);
    token_ = address.substr(query + 2, 6 + 32);
  }

  ProgramOutcome stop(int signal) {
    kill(program_->process(), signal);
    const ProgramOutcome outcome = program_->wait();
    program_.reset();
    return outcome;
  }

  std::string get(const std::string& path) const {
    httplib::Client client(server_);
    const auto answer = client.Get(path + (path.find('?') == std::string::npos ? "?" : "&") + token_);
    if (!answer || answer->status != 200) {
      ADD_FAILURE() << path;
      return "null";
    }
    return answer->body;
  }

  // The status after the end of the run.
  json final_status() const {
    for (;;) {
      const json status = json::parse(get("/api/status"));
      if (status.is_null() || status["finished"]) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  json run_json(const Arguments& more) const {
    return json_of({"run", "gas.toml", "--json", "--overwrite"}, more);
  }
  std::optional<Program> program_;
  std::string server_;
  std::string token_;
};

TEST_F(View, ShowsTheSameHistoryAsRun) {
  const json summary = run_json({"--seed", "3", "--until", "40"});
  start({"gas.toml", "--seed", "3", "--until", "40"});
  const json status = final_status();
  EXPECT_EQ(status["event_log_hash"], summary["event_log_hash"]);
  EXPECT_EQ(status["collisions"], summary["events"]["collision"]);
  EXPECT_EQ(status["walls"], summary["events"]["wall"]);
  EXPECT_EQ(status["reached"], 40);
  EXPECT_TRUE(status["failed"].is_null());
  EXPECT_EQ(json::parse(get("/api/header"))["name"], "gas");
  EXPECT_NE(get("/").find(token_), std::string::npos);
  EXPECT_GT(get("/page.js").size(), 100'000U);
  EXPECT_GT(get("/page.css").size(), 1000U);
}

TEST_F(View, HasDomainsWithSeveralThreads) {
  const json summary = run_json({"--until", "40"});
  start({"gas.toml", "--until", "40", "--threads", "2"});
  const json status = final_status();
  EXPECT_EQ(status["event_log_hash"], summary["event_log_hash"]);
  ASSERT_FALSE(status["divisions"].empty());
  EXPECT_EQ(status["divisions"][0]["blocks"].size(), 2U);
  EXPECT_GT(status["windows"]["committed"], 0);
}

class StoppedView : public View, public testing::WithParamInterface<int> {};

TEST_P(StoppedView, EndsWellAndLeavesNothing) {
  start({"gas.toml", "--until", "1e6", "--set", "spheres.0.count=300"});
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "temporary")) << "the recording has no name";
  const ProgramOutcome outcome = stop(GetParam());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "temporary"));
}

INSTANTIATE_TEST_SUITE_P(Signals, StoppedView, testing::Values(SIGINT, SIGTERM));

TEST_F(View, ShowsARecordedRun) {
  const json summary = run_json({"--out", "out", "--set", "output.recording=true", "--until", "40"});
  start({"out"});
  const json status = final_status();
  EXPECT_EQ(status["event_log_hash"], summary["event_log_hash"]);
  EXPECT_EQ(status["collisions"], summary["events"]["collision"]);
  EXPECT_EQ(status["walls"], summary["events"]["wall"]);
  EXPECT_EQ(status["reached"], 40);
  EXPECT_TRUE(status["divisions"].empty());
  const RecordingReader reader(folder_ / "out/recording.hbr");
  const FileExtent& last = reader.chunks().back().bytes;
  EXPECT_TRUE(get("/api/chunk?number=" + std::to_string(reader.chunks().size() - 1)) ==
              read_text(folder_ / "out/recording.hbr").substr(last.offset, last.length));
}

TEST_F(View, PassesGravityAndSurfacesToThePage) {
  std::filesystem::create_directory(folder_ / "out");
  World world(Box::open());
  world.add({.position = {0, 0, 1}, .radius = 0.5});
  const RecordingHeader header{.name = "floor",
                               .gravity = {0, 0, -9.81},
                               .surfaces = {{Plane({0, 0, 1}), {}, {}, {.temperature = 2}}}};
  RecordingWriter(folder_ / "out/recording.hbr", header, world).close(1);
  start({"out"});
  const json shown = json::parse(get("/api/header"));
  EXPECT_EQ(shown["gravity"], json::parse("[0, 0, -9.81]"));
  ASSERT_EQ(shown["surfaces"].size(), 1U);
  EXPECT_EQ(shown["surfaces"][0]["shape"], "plane");
  EXPECT_EQ(shown["surfaces"][0]["temperature"], 2);
}

TEST_F(View, StopsTheRunAtTheLimitOfTheRecordingAndShowsIt) {
  start({"gas.toml", "--until", "1e6", "--recording-limit", "6e6"});
  const json status = final_status();
  EXPECT_NE(status["failed"].get<std::string>().find("limit of 6000000 bytes"), std::string::npos);
  EXPECT_GT(status["chunks"], 0);
  EXPECT_GT(status["reached"], 0);
  EXPECT_LT(status["reached"], 1e6);
  std::string messages;
  for (int k = 0; k < 4000 && messages.find("limit of 6000000 bytes") == std::string::npos; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    messages = read_text(folder_ / "program.stderr");
  }
  EXPECT_NE(messages.find("limit of 6000000 bytes"), std::string::npos) << messages;
  EXPECT_EQ(stop(SIGINT).exit_code, 0);
}

TEST_F(View, NeedsARecordingInADirectory) {
  run_json({"--out", "out"});
  const ProgramOutcome outcome = run_program(folder_, {"view", "out", "--no-open"});
  expect_refusal(outcome, {"recording = true"});
}

TEST_F(View, RefusesWhatItCannotDo) {
  run_json({"--out", "out", "--set", "output.recording=true"});
  for (const Arguments& arguments :
       {Arguments{"view", "gas.toml", "--port", "0"}, Arguments{"view", "gas.toml", "--port", "65536"},
        Arguments{"view", "gas.toml", "--port", "http"},
        Arguments{"view", "gas.toml", "--recording-limit", "-1"},
        Arguments{"view", "gas.toml", "--recording-limit", "much"}, Arguments{"view", "out", "--until", "3"},
        Arguments{"view", "out", "--seed", "3"}, Arguments{"view", "out", "--set", "run.seed=3"},
        Arguments{"view", "out", "--threads", "2"}, Arguments{"view", "gas.toml", "--threads", "0"},
        Arguments{"view", "missing.toml"}, Arguments{"view", "gas.toml", "--no-opne"},
        Arguments{"replay", "gas.toml"}, Arguments{"replay", "gas.toml", "--out", "no/where.html"}}) {
    const ProgramOutcome outcome = run_program(folder_, arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments.back() << outcome.messages;
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(outcome.messages.starts_with("hardball: ")) << outcome.messages;
  }
}

TEST_F(View, RefusesAnInvalidRecording) {
  std::filesystem::create_directory(folder_ / "out");
  write_text(folder_ / "out/recording.hbr", "HBREC003 and then nonsense");
  expect_refusal(run_program(folder_, {"view", "out", "--no-open"}), {"recording.hbr"});
}

TEST_F(View, ReplayIsOneFileWithTheWholeRecording) {
  run_json({"--out", "out", "--set", "output.recording=true"});
  ASSERT_EQ(run_program(folder_, {"replay", "out", "--out", "recorded.html"}).exit_code, 0);
  ASSERT_EQ(run_program(folder_, {"replay", "gas.toml", "--out", "live.html"}).exit_code, 0);
  const std::string recorded = read_text(folder_ / "recorded.html");
  EXPECT_NE(recorded.find("id=\"recording\">SEJSRUMwMD"), std::string::npos) << "the start in base 64";
  EXPECT_GT(recorded.size(), std::filesystem::file_size(folder_ / "out/recording.hbr") * 4 / 3);
  EXPECT_EQ(recorded.find("src=\"page.js\""), std::string::npos);
  EXPECT_EQ(recorded.find("href=\"page.css\""), std::string::npos);
  EXPECT_EQ(read_text(folder_ / "live.html").size(), recorded.size());
}

TEST_F(View, ReplaySaysWhatItHasWritten) {
  const json summary = run_json({"--out", "out", "--set", "output.recording=true"});
  const std::string contents = to_string(summary["spheres"]) + " spheres, " +
                               to_string(summary["events"]["collision"]) + " collisions";
  for (const std::string what : {"out", "gas.toml"}) {
    const ProgramOutcome outcome = run_program(folder_, {"replay", what, "--out", what + ".html"});
    expect_written(outcome.output, folder_, what + ".html", contents);
  }
}

TEST_F(View, ReplayIsQuietIfItIsTold) {
  write_text(folder_ / "dense.toml",
             "[box]\npacking_fraction = 0.4\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
             "[[spheres]]\ncount = 50\nradius = 0.5\nplacement = \"random\"\nspeed = 1\n"
             "[run]\nuntil = 0.1\n");
  EXPECT_NE(run_program(folder_, {"replay", "dense.toml", "--out", "loud.html"}).messages, "");
  const ProgramOutcome quiet =
      run_program(folder_, {"replay", "dense.toml", "--out", "quiet.html", "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.output + quiet.messages, "");
}

TEST_F(View, ReplayReplacesAFileOnlyIfItIsTold) {
  write_text(folder_ / "mine.html", "mine");
  expect_refusal(run_program(folder_, {"replay", "gas.toml", "--out", "mine.html"}),
                 {"mine.html: the file exists already"});
  EXPECT_EQ(read_text(folder_ / "mine.html"), "mine");
  EXPECT_EQ(run_program(folder_, {"replay", "gas.toml", "--out", "mine.html", "--overwrite"}).exit_code, 0);
  EXPECT_TRUE(read_text(folder_ / "mine.html") != "mine");
}

TEST_F(View, ReplayOfADamagedRecordingShowsWhatComesBefore) {
  run_json({"--out", "out", "--set", "output.recording=true"});
  std::string recording = read_text(folder_ / "out/recording.hbr");
  recording[recording.size() - 50] ^= 1;
  write_text(folder_ / "out/recording.hbr", recording);
  const ProgramOutcome outcome = run_program(folder_, {"replay", "out", "--out", "damaged.html"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("the recording is damaged after time 0: chunk 0, at byte "),
            std::string::npos)
      << outcome.messages;
  EXPECT_NE(outcome.messages.find("the part before is shown"), std::string::npos) << outcome.messages;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "damaged.html"));
}

TEST_F(View, ReplayOfAFailedRunShowsItUpToTheFailure) {
  write_text(folder_ / "collapse.toml",
             "[box]\nsize = [20, 20, 20]\nboundary = ['wall', 'wall', 'wall']\n"
             "[[spheres]]\nradius = 0.5\nspeed = 0\npositions = [[2, 10, 10]]\n"
             "[[spheres]]\nradius = 0.5\npositions = [[5, 10, 10], [8, 10, 10]]\n"
             "velocities = [[-1, 0, 0], [-2, 0, 0]]\n"
             "[response]\nrestitution = 0.01\n[run]\nuntil = 1e9\n");
  const ProgramOutcome outcome = run_program(folder_, {"replay", "collapse.toml", "--out", "collapse.html"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.messages.find("collapse.html shows it up to there"), std::string::npos)
      << outcome.messages;
  EXPECT_NE(read_text(folder_ / "collapse.html").find("id=\"recording\">SEJSRUMwMD"), std::string::npos);
}

}  // namespace
}  // namespace hardball::view_test
