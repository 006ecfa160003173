// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Successful runs: what they print and write, and what must not change it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "hardball/io/npy_header.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"

namespace hardball::run_test {
namespace {

using nlohmann::json;
using namespace support;

const std::string kPeriodicGas = gas_in_cube(300, 10) + "[run]\nuntil = 5.0\n";

const std::string kOpenGas = R"([box]
boundary = ["open", "open", "open"]
[[spheres]]
count = 100
radius = 0.5
placement = "random"
temperature = 1.0
[run]
until = 5.0
)";

class Run : public ProgramTest {
 protected:
  Run() { use(kSmallGas); }

  void use(const std::string& scenario) { write_text(folder_ / "gas.toml", scenario); }

  ProgramOutcome run(const Arguments& more = {}) {
    const ProgramOutcome outcome = succeed({"run", "gas.toml", "--overwrite"}, more);
    EXPECT_EQ(outcome.messages, "");
    return outcome;
  }

  json run_json(Arguments more = {}) {
    more.push_back("--json");
    return json::parse(run(more).output);
  }

  std::string hash(const Arguments& more = {}) { return run_json(more)["event_log_hash"]; }
};

TEST_F(Run, SaysFromWhatItsResultsFollow) {
  const json printed = run_json({"--out", "out", "--seed", "18446744073709551615", "--set", "run.until=2"});
  const json written = json::parse(read_text(folder_ / "out/summary.json"));
  const std::string version = run_program(folder_, {"--version"}).output;
  for (const json& summary : {printed, written}) {
    EXPECT_EQ(summary["seed"], 18446744073709551615U);
    EXPECT_TRUE(version.starts_with("hardball " + summary["version"].get<std::string>() + "\n"));
    EXPECT_NE(version.find(" " + summary["commit"].get<std::string>() + "\n"), std::string::npos);
    EXPECT_EQ(summary["scenario"]["file"], "gas.toml");
    EXPECT_EQ(summary["scenario"]["set"], json({"run.until=2"}));
    EXPECT_EQ(summary["scenario"]["text"], kSmallGas);
  }
  const Arguments resume{"resume", "out", "--until", "3", "--json", "--quiet"};
  const json resumed = json::parse(run_program(folder_, resume).output);
  for (const char* key : {"seed", "version", "commit", "scenario"}) EXPECT_EQ(resumed[key], printed[key]);
}

TEST_F(Run, PrintsOneObjectWithAllKeys) {
  const json summary = run_json();
  std::set<std::string> keys;
  for (const auto& [key, value] : summary.items()) keys.insert(key);
  EXPECT_EQ(keys, (std::set<std::string>{"spheres",          "time",           "events",
                                         "predictions",      "event_log_hash", "energy",
                                         "momentum",         "max_overlap",    "packing_fraction",
                                         "compressibility",  "wall_pressure",  "engine",
                                         "cell_edge",        "seconds",        "collisions_per_second",
                                         "bytes_per_sphere", "peak_rss_bytes", "seed",
                                         "version",          "commit",         "scenario"}));
  EXPECT_EQ(summary["spheres"], 20);
  EXPECT_EQ(summary["time"], 5.0);
  for (const char* kind : {"collision", "wall", "enter", "leave", "stale"}) {
    EXPECT_TRUE(summary["events"][kind].is_number_unsigned()) << kind;
  }
  EXPECT_GT(summary["events"]["wall"], 0);
  const std::string hash = summary["event_log_hash"];
  EXPECT_EQ(hash.size(), 16U);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
  const double energy = summary["energy"]["initial"];
  EXPECT_GT(energy, 0);
  EXPECT_NEAR(summary["energy"]["final"], energy, 1e-12 * energy);
  EXPECT_EQ(summary["momentum"].size(), 3U);
  EXPECT_LT(summary["max_overlap"], 1e-12);
  EXPECT_NEAR(summary["packing_fraction"], 20 * std::acos(-1) / 6 / 1000, 1e-12);
  EXPECT_TRUE(summary["compressibility"].is_null());
  EXPECT_GT(summary["wall_pressure"], 0);
  EXPECT_EQ(summary["engine"], "cells");
  EXPECT_GT(summary["cell_edge"], 0);
  EXPECT_GE(summary["seconds"]["setup"], 0);
  EXPECT_GE(summary["seconds"]["run"], 0);
  EXPECT_GT(summary["bytes_per_sphere"], 0);
  EXPECT_GT(summary["peak_rss_bytes"], 1'000'000);
}

TEST_F(Run, LeavesOutWhatDoesNotApply) {
  use(kPeriodicGas);
  const json periodic = run_json();
  EXPECT_GT(periodic["compressibility"], 1);
  EXPECT_TRUE(periodic["wall_pressure"].is_null());
  use(kOpenGas);
  const json open = run_json();
  EXPECT_TRUE(open["compressibility"].is_null());
  EXPECT_TRUE(open["wall_pressure"].is_null());
  EXPECT_TRUE(open["packing_fraction"].is_null());
  EXPECT_TRUE(run_json({"--engine", "all-pairs"})["cell_edge"].is_null());
  EXPECT_TRUE(run_json({"--until", "0"})["compressibility"].is_null());
}

TEST_F(Run, PrintsATable) {
  const std::string output = run().output;
  EXPECT_NE(output.find("collisions "), std::string::npos) << output;
  EXPECT_NE(output.find(hash()), std::string::npos) << output;
}

// Files are the same for any number of threads, and hold what --json prints.
TEST_F(Run, NamesItsWindowsInTheTableAlone) {
  use(kPeriodicGas);
  EXPECT_EQ(run().output.find("windows"), std::string::npos);
  const std::string output = run({"--threads", "2"}).output;
  EXPECT_NE(output.find("domains                 2\n"), std::string::npos) << output;
  EXPECT_NE(output.find(" single steps\n"), std::string::npos) << output;
  EXPECT_FALSE(run_json({"--threads", "2"}).contains("windows"));
}

TEST_F(Run, ShowsNoProgressAwayFromATerminal) {
  use(kPeriodicGas);
  EXPECT_EQ(run({"--until", "20"}).messages, "");
}

TEST_F(Run, WritesNoFilesUnlessRequested) {
  run();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "trajectory.xyz"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "summary.json"));
}

TEST_F(Run, HasOneHistoryWhateverTheEngine) {
  use(kPeriodicGas);
  const std::string expected = hash();
  EXPECT_EQ(hash({"--engine", "cells"}), expected);
  EXPECT_EQ(hash({"--engine", "paper"}), expected);
  EXPECT_EQ(hash({"--engine", "all-pairs"}), expected);
  EXPECT_EQ(hash({"--cell-edge", "1.1"}), expected);
  EXPECT_EQ(hash({"--cell-edge", "3.7"}), expected);
  EXPECT_EQ(hash({"--cell-edge", "paper"}), expected);
  EXPECT_EQ(hash({"--cell-edge", "paper", "--engine", "paper"}), expected);
  EXPECT_EQ(hash({"--unit-costs", "measured"}), expected);
  EXPECT_EQ(hash({"--unit-costs", "contact=1,enter=1,cell=1,prediction=30"}), expected);
}

TEST_F(Run, ChoosesCellsByTheUnitCosts) {
  use(kPeriodicGas);
  const auto edge = [this](Arguments arguments) {
    arguments.insert(arguments.end(), {"--engine", "cells"});
    return run_json(arguments)["cell_edge"].get<double>();
  };
  const double standard = edge({"--unit-costs", "standard"});
  EXPECT_EQ(edge({}), standard) << "a short run does not measure";
  EXPECT_LT(edge({"--unit-costs", "contact=1,enter=1,cell=1,prediction=30"}), standard);
  EXPECT_GT(edge({"--unit-costs", "contact=1,enter=100000,cell=1,prediction=1"}), standard);
  // The paper's equation lacks the collisions due to excluded volume.
  EXPECT_GE(edge({"--cell-edge", "paper"}), standard);
}

TEST_F(Run, HasOneHistoryWhateverIsWritten) {
  use(kPeriodicGas);
  const std::string expected = hash();
  EXPECT_EQ(hash({"--out", "out"}), expected);
  EXPECT_EQ(hash({"--out", "out", "--set", "output.snapshots_every=0.01"}), expected);
  EXPECT_EQ(hash({"--out", "out", "--set", "output.event_log=true"}), expected);
  EXPECT_EQ(hash({"--out", "out", "--set", "output.recording=true"}), expected);
}

TEST_F(Run, FollowsItsOptions) {
  const std::string first = hash();
  EXPECT_EQ(hash({"--seed", "1"}), first);
  EXPECT_NE(hash({"--seed", "2"}), first);
  EXPECT_EQ(hash({"--seed", "2"}), hash({"--set", "run.seed=2"}));
  EXPECT_EQ(run_json({"--until", "2.5"})["time"], 2.5);
  EXPECT_EQ(run_json({"--set", "run.until=2.5"})["time"], 2.5);
  EXPECT_EQ(run_json({"--set", "spheres.0.count=7", "--set", "run.until=1"})["spheres"], 7);
  EXPECT_EQ(run_json({"--until", "0"})["events"]["collision"], 0);
}

TEST_F(Run, WritesTheSummaryItPrints) {
  const std::string output = run({"--out", "deep/out", "--json"}).output;
  EXPECT_EQ(read_text(folder_ / "deep/out/summary.json"), output);
}

TEST_F(Run, OutOptionTakesPrecedenceOverTheScenario) {
  use(kSmallGas + "[output]\ndirectory = \"other\"\n");
  run({"--out", "out"});
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/summary.json"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
  run();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "other/summary.json"));
}

TEST_F(Run, RemovesTheFilesOfAnEarlierRun) {
  run({"--out", "out", "--set", "output.event_log=true", "--set", "output.snapshots_every=1", "--set",
       "output.recording=true"});
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/events.npy"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/recording.hbr"));
  write_text(folder_ / "out/notes.txt", "mine");
  run({"--out", "out"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/events.npy"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/trajectory.xyz"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/recording.hbr"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/notes.txt"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(Run, WritesARecordingOfAllContacts) {
  use(kPeriodicGas);
  const json summary = run_json({"--out", "out", "--set", "output.recording=true"});
  RecordingReader reader(folder_ / "out/recording.hbr");
  EXPECT_EQ(reader.header().name, "gas");
  EXPECT_EQ(reader.header().until, 5);
  EXPECT_EQ(reader.header().box.size(), (Vec3{10, 10, 10}));
  EXPECT_EQ(reader.reached(), 5);
  std::uint64_t contacts = 0;
  for (const ChunkExtent& chunk : reader.chunks()) contacts += chunk.contacts;
  EXPECT_EQ(contacts, summary["events"]["collision"]);
}

TEST_F(Run, WritesSnapshotsAtMultiplesOfTheInterval) {
  run({"--out", "out", "--set", "output.snapshots_every=0.1", "--until", "0.75"});
  const std::string trajectory = read_text(folder_ / "out/trajectory.xyz");
  EXPECT_EQ(count(trajectory, " Time="), 8U);
  EXPECT_EQ(count(trajectory, " Time=0 "), 1U);
  EXPECT_EQ(count(trajectory, " Time=0.30000000000000004 "), 1U);
  EXPECT_EQ(count(trajectory, " Time=0.7000000000000001 "), 1U);
}

TEST_F(Run, WritesASnapshotAtTheEndIfItIsAMultiple) {
  run({"--out", "out", "--set", "output.snapshots_every=0.1", "--until", "0.3"});
  const std::string trajectory = read_text(folder_ / "out/trajectory.xyz");
  EXPECT_EQ(count(trajectory, " Time="), 4U);
  EXPECT_EQ(count(trajectory, " Time=0.3 "), 1U);
}

TEST_F(Run, WritesSnapshotsEvenlyInTheLogarithmOfTime) {
  run({"--out", "out", "--set", "output.snapshots_per_decade=2", "--set", "output.first_snapshot=0.05"});
  std::vector<double> times;
  const auto reader = open_snapshots(folder_ / "out/trajectory.xyz");
  for (std::size_t frame = 0; frame < reader->frames(); ++frame) times.push_back(*reader->read(frame).time);
  ASSERT_EQ(times.size(), 6U);
  EXPECT_EQ(times[0], 0);
  EXPECT_EQ(times[1], 0.05);
  EXPECT_NEAR(times[2], 0.05 * std::sqrt(10), 1e-15);
  EXPECT_EQ(times[3], 0.5);
  EXPECT_EQ(times[5], 5);
}

TEST_F(Run, WritesSnapshotsByTheNumberOfContacts) {
  const json summary = run_json(
      {"--out", "out", "--set", "output.snapshots_every_contacts=7", "--set", "output.event_log=true"});
  const std::uint64_t contacts =
      std::uint64_t{summary["events"]["collision"]} + std::uint64_t{summary["events"]["wall"]};
  ASSERT_GT(contacts, 14U);
  const auto reader = open_snapshots(folder_ / "out/trajectory.xyz");
  ASSERT_EQ(reader->frames(), contacts / 7 + 1);
  EXPECT_EQ(reader->read(0).time, 0);
  const std::string events = read_text(folder_ / "out/events.npy");
  const NpyHeader header = read_npy_header(folder_ / "out/events.npy");
  for (std::size_t frame = 1; frame < reader->frames(); ++frame) {
    const std::size_t seventh = header.offset + (7 * frame - 1) * header.item_bytes;
    EXPECT_EQ(reader->read(frame).time, read_little_endian<double>(&events[seventh]));
  }
}

TEST_F(Run, HasTheSameHashWhateverIsSampled) {
  const std::string expected = hash({});
  const std::string all = R"(output.trajectory=["xyz", "xyz.zst", "gsd", "lammps", "vtp"])";
  EXPECT_EQ(hash({"--out", "out", "--overwrite", "--set", "output.snapshots_every=0.01", "--set", all}),
            expected);
  EXPECT_EQ(hash({"--out", "out", "--overwrite", "--set", "output.snapshots_every_contacts=1", "--set", all}),
            expected);
  EXPECT_EQ(hash({"--out", "out", "--overwrite", "--set", "output.snapshots_per_decade=50", "--set",
                  "output.first_snapshot=1e-6", "--set", all}),
            expected);
}

TEST_F(Run, RemovesTheTrajectoriesOfAnEarlierRun) {
  run({"--out", "out", "--overwrite", "--set", "output.snapshots_every=1", "--set",
       R"(output.trajectory=["xyz", "xyz.zst", "gsd", "lammps", "vtp"])"});
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/trajectory/00000005.vtp"));
  run({"--out", "out", "--overwrite", "--set", "output.snapshots_every=1", "--set", "output.trajectory=gsd"});
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) {
    const std::string name = entry.path().filename();
    if (name.starts_with("trajectory")) names.insert(name);
  }
  EXPECT_EQ(names, std::set<std::string>{"trajectory.gsd"});
}

TEST_F(Run, GoesOnWithItsTrajectories) {
  const std::string all = R"(output.trajectory=["xyz", "xyz.zst", "gsd", "lammps", "vtp"])";
  for (const std::string schedule : {"output.snapshots_every=0.2", "output.snapshots_every_contacts=3",
                                     "output.snapshots_per_decade=20"}) {
    Arguments arguments{"--set", schedule, "--set", all};
    if (schedule.find("decade") != std::string::npos) {
      arguments.insert(arguments.end(), {"--set", "output.first_snapshot=0.01"});
    }
    const auto run_in = [&](const std::string& out, const std::string& until) {
      Arguments more = arguments;
      more.insert(more.end(), {"--out", out, "--overwrite", "--until", until});
      run(more);
    };
    run_in("whole", "5");
    run_in("parts", "2.3");
    const ProgramOutcome resumed = run_program(folder_, {"resume", "parts", "--until", "5"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.messages;
    for (const std::string name : {"trajectory.xyz", "trajectory.xyz.zst", "trajectory.gsd",
                                   "trajectory.lammpstrj", "trajectory.pvd", "trajectory/00000009.vtp"}) {
      EXPECT_TRUE(read_text(folder_ / ("parts/" + name)) == read_text(folder_ / ("whole/" + name)))
          << schedule << name;
    }
    const Arguments convert{"convert", "parts/trajectory.gsd", "parts.xyz", "--overwrite"};
    ASSERT_EQ(run_program(folder_, convert).exit_code, 0);
    EXPECT_TRUE(read_text(folder_ / "parts.xyz") == read_text(folder_ / "parts/trajectory.xyz")) << schedule;
  }
}

TEST_F(Run, StartsAlikeFromEveryFormat) {
  use(kPeriodicGas);
  run({"--out", "first", "--set", "output.snapshots_every=2.5", "--set",
       R"(output.trajectory=["xyz", "xyz.zst", "gsd", "lammps"])"});
  for (const std::string name : {"last.csv", "last.npy"}) {
    ASSERT_EQ(run_program(folder_, {"convert", "first/trajectory.gsd", name}).exit_code, 0);
  }
  std::set<std::string> hashes;
  for (const std::string name : {"first/trajectory.xyz", "first/trajectory.xyz.zst", "first/trajectory.gsd",
                                 "first/trajectory.lammpstrj", "last.csv", "last.npy"}) {
    use("[box]\nsize = [10, 10, 10]\nboundary = ['periodic', 'periodic', 'periodic']\n[start]\nfile = '" +
        name + "'\n[run]\nuntil = 2\n");
    hashes.insert(hash({}));
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST_F(Run, StartsFromASnapshotBitForBit) {
  use(kPeriodicGas);
  run({"--out", "first", "--set", "output.snapshots_every=2.5"});
  write_text(folder_ / "again.toml",
             "[box]\nsize = [10, 10, 10]\nboundary = ['periodic', 'periodic', 'periodic']\n"
             "[start]\nfile = 'first/trajectory.xyz'\n[run]\nuntil = 0\n[output]\nsnapshots_every = 1\n");
  ASSERT_EQ(run_program(folder_, {"run", "again.toml", "--out", "second"}).exit_code, 0);
  const Snapshot first = read_snapshot(folder_ / "first/trajectory.xyz");
  const Snapshot second = read_snapshot(folder_ / "second/trajectory.xyz");
  EXPECT_EQ(first.time, 5);
  EXPECT_EQ(second.time, 0);
  ASSERT_EQ(first.spheres.size(), second.spheres.size());
  for (std::size_t i = 0; i < first.spheres.size(); ++i) {
    EXPECT_EQ(first.spheres[i].position, second.spheres[i].position);
    EXPECT_EQ(first.spheres[i].velocity, second.spheres[i].velocity);
    EXPECT_EQ(first.spheres[i].radius, second.spheres[i].radius);
    EXPECT_EQ(first.spheres[i].mass, second.spheres[i].mass);
  }
}

TEST_F(Run, WritesFilesThatPythonReads) {
  const std::string python = HARDBALL_PYTHON;
  if (Program(folder_, {"-c", "import ase.io, numpy"}, python).wait().exit_code != 0) {
    GTEST_SKIP() << "Python has no numpy or no ase";
  }
  use(kPeriodicGas);
  const json summary = run_json({"--out", "out", "--set", "output.snapshots_every=2.5", "--set",
                                 "output.event_log=true", "--set", R"(box.boundary.1="wall")"});
  write_text(folder_ / "read.py", R"(
import json, sys
import ase.io
import numpy
events = numpy.load("out/events.npy", mmap_mode="r")
frames = ase.io.read("out/trajectory.xyz", index=":")
last = frames[-1]
walls = events["kind"] == 1
json.dump({
    "collisions": int((~walls).sum()), "walls": int(walls.sum()),
    "ordered": bool((numpy.diff(events["time"]) >= 0).all()),
    "faces": sorted(set(events["second"][walls].tolist())),
    "approaching": bool((events["normal_speed"] >= 0).all()),
    "impulse_shape": events["impulse"].shape,
    "frames": len(frames), "spheres": len(last), "pbc": last.pbc.tolist(), "time": float(last.info["Time"]),
    "cell": last.cell.lengths().tolist(),
    "momentum": (last.arrays["velo"] * last.arrays["mass"][:, None]).sum(axis=0).tolist(),
    "inside": bool(((last.positions >= 0) & (last.positions <= 10)).all()),
    "radius": float(last.arrays["radius"].max()), "ids": last.arrays["id"].tolist() == list(range(300)),
}, sys.stdout)
)");
  const ProgramOutcome reading = Program(folder_, {"read.py"}, python).wait();
  ASSERT_EQ(reading.exit_code, 0) << reading.messages;
  const json found = json::parse(reading.output);
  EXPECT_EQ(found["collisions"], summary["events"]["collision"]);
  EXPECT_EQ(found["walls"], summary["events"]["wall"]);
  EXPECT_EQ(found["ordered"], true);
  EXPECT_EQ(found["faces"], (json{2, 3}));
  EXPECT_EQ(found["approaching"], true);
  EXPECT_EQ(found["impulse_shape"][1], 3);
  EXPECT_EQ(found["frames"], 3);
  EXPECT_EQ(found["spheres"], 300);
  EXPECT_EQ(found["pbc"], (json{true, false, true}));
  EXPECT_EQ(found["time"], 5);
  EXPECT_EQ(found["cell"], (json{10.0, 10.0, 10.0}));
  EXPECT_EQ(found["inside"], true);
  EXPECT_EQ(found["radius"], 0.5);
  EXPECT_EQ(found["ids"], true);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found["momentum"][axis], summary["momentum"][axis], 1e-10);
  }
}

TEST(Program, PrintsItsVersionAndUsage) {
  const ScratchFolder folder;
  const ProgramOutcome version = run_program(folder, {"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.output.starts_with("hardball ")) << version.output;
  for (const Arguments& arguments :
       {Arguments{"--help"}, Arguments{"run", "--help"}, Arguments{"verify", "--help"}}) {
    const ProgramOutcome help = run_program(folder, arguments);
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.output.find("Usage: hardball"), std::string::npos) << help.output;
  }
}

TEST_F(Run, StartsAtOnceInABoxOfAnyShape) {
  for (const std::string size :
       {"1e15, 10, 10", "10, 1e15, 1e15", "1e60, 10, 10", "10, 1e60, 1e60", "1e60, 1e60, 1e60",
        "1e-15, 10, 10", "10, 1e-58, 1e-58", "1e-58, 10, 10", "1e-58, 1e-58, 1e-58", "1e-58, 1, 1e60"}) {
    for (const std::string boundary : {"wall", "periodic", "open"}) {
      for (const std::string placement : {"random", "fcc"}) {
        const std::string each = "\"" + boundary + "\"";
        use("[box]\nsize = [" + size + "]\nboundary = [" + each + ", " + each + ", " + each +
            "]\n[[spheres]]\ncount = 2\nradius = 1e-60\nplacement = \"" + placement +
            "\"\nspeed = 1.0\n[run]\nuntil = 1e-60\n");
        SCOPED_TRACE(size + " " + boundary + " " + placement);
        const ProgramOutcome checked = run_program(folder_, {"check", "gas.toml"});
        EXPECT_EQ(checked.exit_code, 0) << checked.messages;
        EXPECT_EQ(checked.output.find("nan"), std::string::npos) << checked.output;
        run({"--out", "out"});
      }
    }
  }
}

TEST(Verify, FindsOneHistoryOfABoxThatIsDisplacedByManyBoxes) {
  const ScratchFolder folder;
  write_text(folder / "sheared.toml",
             "[box]\nboundary = ['periodic', 'periodic', 'periodic']\nsize = [10, 10, 10]\n"
             "shear_rate = 0.1\nshear_offset = 2e10\n"
             "[[spheres]]\nradius = 0.5\npositions = [[2, 5, 5], [8, 5, 5], [5, 1, 5]]\n"
             "velocities = [[1, 0, 0], [-1, 0, 0], [0, -0.2, 0.1]]\n[run]\nuntil = 40\n");
  const ProgramOutcome outcome = run_program(folder, {"verify", "sheared.toml"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.output.find("all runs are the same"), std::string::npos) << outcome.output;
}

const std::string kDenseGas = R"([box]
packing_fraction = 0.48
boundary = ["periodic", "periodic", "wall"]
[[spheres]]
count = 200
radius = 0.5
placement = "random"
temperature = 1.0
[[spheres]]
count = 400
radius = 0.3
placement = "random"
temperature = 1.0
[run]
until = 1.0
)";

// Wherever a run is told about, so is that its spheres grew into place.
TEST_F(Run, TellsThatSpheresGrewIntoPlace) {
  use(kDenseGas);
  const std::string note = "placed by growing spheres";
  const ProgramOutcome table = run_program(folder_, {"run", "gas.toml"});
  EXPECT_EQ(table.exit_code, 0) << table.messages;
  EXPECT_NE(table.output.find(note), std::string::npos) << table.output;
  EXPECT_NE(table.messages.find(note), std::string::npos) << table.messages;
  const ProgramOutcome check = run_program(folder_, {"check", "gas.toml"});
  EXPECT_NE(check.output.find(note), std::string::npos) << check.output;
  const json whole = run_json({"--quiet"});
  ASSERT_EQ(whole["notes"].size(), 1U);
  EXPECT_NE(whole["notes"][0].get<std::string>().find(note), std::string::npos);
  EXPECT_NEAR(whole["packing_fraction"].get<double>(), 0.48, 1e-12);
  EXPECT_LT(whole["max_overlap"].get<double>(), 1e-12);
  EXPECT_EQ(hash({"--threads", "2", "--quiet"}), whole["event_log_hash"]);
  EXPECT_EQ(hash({"--engine", "all-pairs", "--quiet"}), whole["event_log_hash"]);
  run({"--until", "0.5", "--out", "out", "--quiet"});
  const ProgramOutcome resumed = run_program(folder_, {"resume", "out", "--until", "1", "--json"});
  EXPECT_EQ(json::parse(resumed.output)["notes"], whole["notes"]) << resumed.messages;
  EXPECT_EQ(json::parse(resumed.output)["event_log_hash"], whole["event_log_hash"]);
}

}  // namespace
}  // namespace hardball::run_test
