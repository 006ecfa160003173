// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/distributed/distributed_checkpoint.hpp"

#include <algorithm>
#include <cstdint>
#include <system_error>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/distributed/in_all.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/replace_file.hpp"

namespace hardball {
namespace {

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

}  // namespace

void write_distributed_checkpoint(const DistributedSimulation& simulation, const std::filesystem::path& path,
                                  std::span<const CheckpointSection> sections) {
  Processes& processes = simulation.processes();
  const std::string state = simulation.save();
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
    add(own.size(), {kDistributedSection, state});
  }
  std::size_t block = processes.rank();
  for (std::vector<Traveler>& spheres : simulation.own_blocks()) {
    add(kBlocks + block, {block_name(block), DistributedSimulation::saved_block(spheres)});
    std::vector<Traveler>().swap(spheres);
    block += processes.size();
  }
  std::vector<NumberedEntry> all;
  for (const std::string& text : processes.gather(archived(own))) {
    std::vector<NumberedEntry> entries;
    restore(text, "the table of a process", entries);
    all.insert(all.end(), entries.begin(), entries.end());
  }
  std::ranges::sort(all, {}, &NumberedEntry::number);
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

std::vector<std::string> blocks_of(const std::map<std::string, std::string>& sections) {
  std::vector<std::string> blocks;
  for (const auto& [name, bytes] : sections) {
    if (name.starts_with(kBlockName)) blocks.push_back(bytes);
  }
  return blocks;
}

std::vector<std::string> read_blocks(CheckpointReader& checkpoint, std::size_t rank, std::size_t processes) {
  std::vector<std::string> blocks;
  std::size_t number = 0;
  for (const std::string& name : checkpoint.names()) {
    if (!name.starts_with(kBlockName)) continue;
    if (number++ % processes == rank) blocks.push_back(checkpoint.section(name));
  }
  return blocks;
}

}  // namespace hardball
