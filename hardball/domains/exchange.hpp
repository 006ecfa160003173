// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hardball/domains/messages.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/processes/processes.hpp"

namespace hardball {

/// Maps domains to processes: each process has the same number of domains, numbered consecutively.
struct DomainsOfProcess {
  std::size_t each = 1;  ///< In each process.

  std::size_t process_of(DomainNumber domain) const { return domain / each; }
};

/// Brings the outboxes of the domains in this process to their neighbors, and those of their neighbors here.
/// Between domains of one process nothing is copied.
class Exchange {
 public:
  /// What is sent at once: the parts of outboxes that are complete then.
  enum class Round {
    window,     ///< Records and near_passes, sent when domains have run.
    conflicts,  ///< Conflicts, sent when domains have verified.
    arrivals    ///< Arrivals, departures, handovers and new owners, sent when domains have committed.
  };
  /// A domain in this process, and its outbox to a neighbor, which stays where it is.
  struct Member {
    DomainNumber number = 0;
    std::span<const DomainNumber> neighbors;
    Function<const Outbox&(DomainNumber neighbor)> outbox_to;
  };

  /// Among processes, which outlive it.
  Exchange(Processes& processes, const DomainsOfProcess& domains);

  Processes& processes() const { return *processes_; }
  const DomainsOfProcess& domains() const { return domains_; }

  /// Connects the domains in this process, in the order of their numbers.
  void connect(std::span<const Member> members);
  /// What the neighbors of the k-th domain in this process have sent it, by neighbor.
  std::span<const Outbox* const> inboxes(std::size_t k) const { return inboxes_[k]; }
  /// Sends and receives.
  void carry_out(Round round);

 private:
  // From a domain in one process to one in another.
  struct Link {
    DomainNumber from = 0;
    DomainNumber to = 0;
    const Outbox* sent = nullptr;      // of a domain in this process
    std::unique_ptr<Outbox> received;  // for one
  };
  // The links to and from another process, in the order of numbers.
  struct Peer {
    std::vector<Link> outgoing;
    std::vector<Link> incoming;
  };

  Peer& peer_with(std::size_t process);

  Processes* processes_;
  DomainsOfProcess domains_;
  std::vector<std::vector<const Outbox*>> inboxes_;
  std::vector<std::size_t> ranks_;  // of the peers, in order
  std::vector<Peer> peers_;
  std::vector<std::string> outgoing_;
};

}  // namespace hardball
