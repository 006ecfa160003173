// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/mpi/mpi_processes.hpp"

#include <cstdint>
#include <cstdlib>
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
  std::vector<MpiMessage> messages(count);
  const auto exchange_messages = [&] {
    require_success(plugin_.exchange(messages.data(), count), "exchange messages");
  };
  // First how long they are.
  std::vector<std::uint64_t> own_lengths(count);
  std::vector<std::uint64_t> lengths(count);
  for (std::size_t k = 0; k < count; ++k) {
    own_lengths[k] = outgoing[k].size();
    messages[k] = {.peer = peers[k],
                   .outgoing = reinterpret_cast<const char*>(&own_lengths[k]),
                   .outgoing_size = sizeof(std::uint64_t),
                   .incoming = reinterpret_cast<char*>(&lengths[k]),
                   .incoming_size = sizeof(std::uint64_t)};
  }
  exchange_messages();
  std::vector<std::string> incoming(count);
  for (std::size_t k = 0; k < count; ++k) {
    incoming[k].resize(lengths[k]);
    messages[k] = {.peer = peers[k],
                   .outgoing = outgoing[k].data(),
                   .outgoing_size = outgoing[k].size(),
                   .incoming = incoming[k].data(),
                   .incoming_size = incoming[k].size()};
  }
  exchange_messages();
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
