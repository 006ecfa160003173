// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation_checkpoint.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/processes/in_all.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Sections: all of a simulation; or all but the spheres, and these in blocks.
constexpr const char* kWhole = "simulation";
constexpr const char* kDivided = "distributed";
constexpr const char* kBlockName = "spheres.";

// A section and where it stands among all.
struct NumberedEntry {
  std::uint64_t number = 0;
  SectionEntry entry;

  static void persist(auto& archive, auto& self) { archive(self.number, self.entry); }
};

std::string block_name(std::size_t block) {
  return kBlockName + to_text(block);
}

void write_in_parts(const Simulation& simulation, const std::filesystem::path& path,
                    std::span<const CheckpointSection> sections) {
  Processes& processes = simulation.processes();
  const std::string state = simulation.save_without_spheres();
  std::vector<NumberedEntry> own;
  std::vector<std::string> contents;
  const auto add = [&](std::uint64_t number, const CheckpointSection& section) {
    PackedSection packed = pack(section);
    own.push_back({number, std::move(packed.entry)});
    contents.push_back(std::move(packed.bytes));
  };
  // The sections of the first process come before the blocks.
  constexpr std::uint64_t kBlocks = std::uint64_t{1} << 32;
  if (processes.is_first()) {
    for (const CheckpointSection& section : sections) add(own.size(), section);
    add(own.size(), {kDivided, state});
  }
  std::size_t block = processes.rank();
  for (std::vector<SphereTransfer>& spheres : simulation.own_blocks()) {
    add(kBlocks + block, {block_name(block), Simulation::saved_block(spheres)});
    std::vector<SphereTransfer>().swap(spheres);
    block += processes.size();
  }
  std::vector<NumberedEntry> all;
  for (const std::string& text : processes.gather(archived(own))) {
    std::vector<NumberedEntry> entries;
    restore(text, "the table of a process", entries);
    all.insert(all.end(), entries.begin(), entries.end());
  }
  ranges::sort(all, {}, &NumberedEntry::number);
  std::vector<SectionEntry> entries;
  for (const NumberedEntry& each : all) entries.push_back(each.entry);
  const std::string head = checkpoint_head(entries);
  const std::filesystem::path unfinished = unfinished_name(path);
  in_first(processes, [&] {
    std::error_code missing;
    std::filesystem::remove(unfinished, missing);
    write_at(unfinished, 0, head);
  });
  in_all(processes, [&] {
    std::uint64_t offset = head.size();
    std::size_t next = 0;
    for (const NumberedEntry& each : all) {
      if (next < own.size() && each.number == own[next].number)
        write_at(unfinished, offset, contents[next++]);
      offset += each.entry.packed;
    }
  });
  in_first(processes, [&] { put_in_place(path); });
}

// The blocks that a process reads of a checkpoint, with a stride of the number of processes.
std::vector<std::string> read_blocks(CheckpointReader& checkpoint, const Processes& processes) {
  std::vector<std::string> blocks;
  std::size_t number = 0;
  for (const std::string& name : checkpoint.names()) {
    if (!name.starts_with(kBlockName)) continue;
    if (number++ % processes.size() == processes.rank()) blocks.push_back(checkpoint.section(name));
  }
  return blocks;
}

}  // namespace

void write_checkpoint(const Simulation& simulation, const std::filesystem::path& path,
                      std::span<const CheckpointSection> sections) {
  if (simulation.processes().size() > 1) return write_in_parts(simulation, path, sections);
  std::vector<CheckpointSection> all(sections.begin(), sections.end());
  all.push_back({kWhole, simulation.save()});
  write_checkpoint_file(path, all);
}

Simulation read_simulation(CheckpointReader& checkpoint, const std::string& where, Processes& processes,
                           std::size_t threads) {
  if (ranges::count(checkpoint.names(), kDivided) == 0) {
    std::string whole;
    in_all(processes, [&] { whole = checkpoint.section(kWhole); });
    Simulation simulation = Simulation::load(whole, where, processes);
    simulation.set_threads(threads);
    return simulation;
  }
  std::string state;
  std::vector<std::string> blocks;
  in_all(processes, [&] {
    state = checkpoint.section(kDivided);
    blocks = read_blocks(checkpoint, processes);
  });
  return Simulation::load_blocks(state, blocks, where, processes, threads);
}

}  // namespace hardball
