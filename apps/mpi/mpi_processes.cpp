// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/mpi/mpi_processes.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <system_error>

#include "hardball/errors/error.hpp"
#include "hardball/platform/program.hpp"

namespace hardball {
namespace {

namespace fs = std::filesystem;

// Environment variables by which mpirun says that it has started several processes, and how many. Slurm's are
// not among them: a job has them, too, where it runs one program after the other.
constexpr const char* kCounts[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
// That of PMIx, which says only that there may be several.
constexpr const char* kRank = "PMIX_RANK";

// The length before a text, and how much of it comes with that: less than networks hold back until room is
// made for it.
constexpr std::size_t kHead = sizeof(std::uint64_t);
constexpr std::size_t kBegin = 32768;

// The first variable that is set.
struct Sign {
  std::string name;
  std::size_t count = 0;  // of the processes; zero if it does not say
};

std::optional<Sign> sign_of_several() {
  for (const char* const name : kCounts) {
    if (const char* const size = std::getenv(name)) {
      const int count = std::atoi(size);
      return count > 1 ? std::optional(Sign{name, static_cast<std::size_t>(count)}) : std::nullopt;
    }
  }
  return std::getenv(kRank) ? std::optional(Sign{kRank}) : std::nullopt;
}

// The processes of `sign` do not find each other, and each would run all of the system.
[[noreturn]] void refuse_copies(const Sign& sign, const std::string& reason, const std::string& remedy) {
  const std::string started =
      sign.count > 0 ? "has started " + to_text(sign.count) : std::string("may have started several");
  std::string variables = sign.name;
  if (sign.name != kRank && std::getenv(kRank)) variables += std::string(" and ") + kRank;
  throw Error(
      "mpirun " + started + " copies of the program, each of which would run all of the system, as " + reason,
      sign.name, remedy + ", or unset " + variables);
}

std::optional<fs::path> plugin_path(std::span<const fs::path> folders) {
  std::error_code error;
  for (const fs::path& folder : folders) {
    const fs::path path = (folder / HARDBALL_PLUGIN_NAME).lexically_normal();
    if (fs::exists(path, error)) return path;
  }
  return {};
}

const MpiPlugin& load_plugin(std::span<const fs::path> folders, const std::string& build_command,
                             const Sign& sign) {
  const std::optional<fs::path> path = plugin_path(folders);
  if (!path) {
    refuse_copies(sign, "there is no plug-in for MPI, " HARDBALL_PLUGIN_NAME,
                  "run " + build_command +
                      ", which installs Open MPI (libopenmpi-dev and openmpi-bin in Debian) and builds the "
                      "plug-in");
  }
  std::string problem;
  void* const symbol = platform::symbol_of_library(*path, kMpiPluginSymbol, problem);
  if (!symbol) {
    refuse_copies(sign, "the plug-in for MPI cannot be loaded (" + problem + ")",
                  "install Open MPI (openmpi-bin in Debian), or build the plug-in with " + build_command);
  }
  const MpiPlugin& plugin = *reinterpret_cast<GetMpiPlugin*>(symbol)();
  if (plugin.version != kMpiPluginVersion) {
    refuse_copies(sign,
                  path->string() + " has version " + to_text(plugin.version) +
                      ", and the program needs version " + to_text(kMpiPluginVersion),
                  "build both from the same source, as " + build_command + " does");
  }
  return plugin;
}

void require_success(const char* failure, const char* what) {
  if (failure) throw RunFailure(std::string("MPI failed to ") + what + ": " + failure);
}

}  // namespace

std::unique_ptr<MpiProcesses> MpiProcesses::join_others(std::span<const fs::path> folders,
                                                        const std::string& build_command) {
  const std::optional<Sign> sign = sign_of_several();
  if (!sign) return nullptr;
  const MpiPlugin& plugin = load_plugin(folders, build_command, *sign);
  auto processes = std::make_unique<MpiProcesses>(plugin);
  if (processes->size() > 1) return processes;
  if (sign->count > 1) {
    const std::string library = plugin.implementation;
    refuse_copies(*sign, "the plug-in for MPI is built for " + library + ", which finds one process",
                  "use the mpirun of " + library + ", or build the plug-in for the MPI of this mpirun");
  }
  return nullptr;
}

MpiProcesses::MpiProcesses(const MpiPlugin& plugin) : plugin_(plugin) {
  require_success(plugin_.join(&rank_, &size_), "start");
}

std::vector<std::string> MpiProcesses::exchange(std::span<const std::size_t> peers,
                                                std::span<const std::string> outgoing) {
  check_thread();
  const std::size_t count = peers.size();
  std::vector<MpiMessage> messages;
  const auto exchange_messages = [&] {
    require_success(plugin_.exchange(messages.data(), messages.size()), "exchange messages");
    messages.clear();
  };
  // The begin of each text, after its length: most texts are whole then, and have taken the latency of the
  // network once.
  std::vector<std::string> own(count);
  std::vector<std::string> incoming(count, std::string(kHead + kBegin, 0));
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t length = outgoing[k].size();
    own[k].assign(reinterpret_cast<const char*>(&length), kHead);
    own[k].append(outgoing[k], 0, kBegin);
    messages.push_back({peers[k], own[k].data(), own[k].size(), incoming[k].data(), incoming[k].size()});
  }
  exchange_messages();
  const auto rest_of = [](std::uint64_t length) { return length > kBegin ? length - kBegin : 0; };
  for (std::size_t k = 0; k < count; ++k) {
    std::uint64_t length = 0;
    std::memcpy(&length, incoming[k].data(), kHead);
    incoming[k].erase(0, kHead);
    incoming[k].resize(length);
    const std::size_t own_rest = rest_of(outgoing[k].size());
    const std::size_t rest = rest_of(length);
    if (own_rest + rest > 0)
      messages.push_back({peers[k], outgoing[k].data() + outgoing[k].size() - own_rest, own_rest,
                          incoming[k].data() + length - rest, rest});
  }
  if (!messages.empty()) exchange_messages();
  return incoming;
}

void MpiProcesses::abort(int code) {
  plugin_.abort(code);
  std::abort();
}

void MpiProcesses::gather_bytes(const void* own, std::size_t bytes, void* all) {
  check_thread();
  require_success(plugin_.gather(own, bytes, all), "gather");
}

void MpiProcesses::check_thread() const {
  if (thread_ == std::this_thread::get_id()) return;
  throw Error("a thread other than the one that joined the processes uses what they share",
              "several processes", "use it in the thread that joined them");
}

}  // namespace hardball
