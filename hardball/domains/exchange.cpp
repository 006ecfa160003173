// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/exchange.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Values as they lie in memory: processes that work together run the same program.
class Packer {
 public:
  explicit Packer(std::string& bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = values.size();
    append(&count, sizeof(count));
    append(values.data(), count * sizeof(T));
  }
  void operator()(const std::vector<Handover>& handovers) {
    std::vector<HandoverHead> heads;
    std::vector<DomainNumber> holders;
    for (const Handover& handover : handovers) {
      heads.push_back({handover.sphere, handover.idle_contacts, handover.holders.size()});
      holders.insert(holders.end(), handover.holders.begin(), handover.holders.end());
    }
    (*this)(heads);
    (*this)(holders);
  }

  struct HandoverHead {
    SphereState sphere;
    std::uint32_t idle_contacts = 0;
    std::uint64_t holders = 0;
  };

 private:
  void append(const void* data, std::size_t bytes) { bytes_.append(static_cast<const char*>(data), bytes); }

  std::string& bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void operator()(std::vector<T>& values) {
    std::uint64_t count = 0;
    take(&count, sizeof(count));
    HARDBALL_CHECK(count <= bytes_.size() / sizeof(T));
    values.resize(count);
    take(values.data(), count * sizeof(T));
  }
  void operator()(std::vector<Handover>& handovers) {
    std::vector<Packer::HandoverHead> heads;
    std::vector<DomainNumber> holders;
    (*this)(heads);
    (*this)(holders);
    handovers.clear();
    auto next = holders.begin();
    for (const Packer::HandoverHead& head : heads) {
      const auto end = next + static_cast<std::ptrdiff_t>(head.holders);
      handovers.push_back({head.sphere, {next, end}, head.idle_contacts});
      next = end;
    }
  }

 private:
  void take(void* data, std::size_t bytes) {
    HARDBALL_CHECK(bytes <= bytes_.size());
    if (bytes > 0) std::memcpy(data, bytes_.data(), bytes);
    bytes_.remove_prefix(bytes);
  }

  std::string_view bytes_;
};

// What is sent in a round.
template <class Box, class Visit>
void visit_parts(Exchange::Round round, Box& box, Visit&& visit) {
  switch (round) {
    case Exchange::Round::window:
      visit(box.records);
      visit(box.near_passes);
      return;
    case Exchange::Round::conflicts:
      visit(box.conflicts);
      return;
    case Exchange::Round::arrivals:
      visit(box.departures);
      visit(box.arrivals);
      visit(box.new_owners);
      visit(box.handovers);
  }
}

}  // namespace

Exchange::Exchange(Processes& processes, const DomainsOfProcess& domains)
    : processes_(&processes), domains_(domains) {}

void Exchange::connect(std::span<const Member> members) {
  inboxes_.assign(members.size(), {});
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Member& member = members[k];
    for (const DomainNumber neighbor : member.neighbors) {
      const auto local =
          ranges::find_if(members, [&](const Member& other) { return other.number == neighbor; });
      if (local != members.end()) {
        inboxes_[k].push_back(&local->outbox_to(member.number));
        continue;
      }
      Peer& peer = peer_with(domains_.process_of(neighbor));
      peer.outgoing.push_back({member.number, neighbor, &member.outbox_to(neighbor), nullptr});
      peer.incoming.push_back({neighbor, member.number, nullptr, std::make_unique<Outbox>()});
      inboxes_[k].push_back(peer.incoming.back().received.get());
    }
  }
  for (Peer& peer : peers_) {
    for (std::vector<Link>* links : {&peer.outgoing, &peer.incoming}) {
      ranges::sort(*links, {}, [](const Link& link) { return std::pair(link.from, link.to); });
    }
  }
  outgoing_.resize(peers_.size());
}

Exchange::Peer& Exchange::peer_with(std::size_t process) {
  const auto place = ranges::lower_bound(ranks_, process);
  const auto number = place - ranks_.begin();
  if (place == ranks_.end() || *place != process) {
    ranks_.insert(place, process);
    peers_.emplace(peers_.begin() + number);
  }
  return peers_[static_cast<std::size_t>(number)];
}

void Exchange::carry_out(Round round) {
  if (peers_.empty()) return;
  for (std::size_t k = 0; k < peers_.size(); ++k) {
    outgoing_[k].clear();
    for (const Link& link : peers_[k].outgoing) visit_parts(round, *link.sent, Packer(outgoing_[k]));
  }
  const std::vector<std::string> incoming = processes_->exchange(ranks_, outgoing_);
  for (std::size_t k = 0; k < peers_.size(); ++k) {
    Unpacker unpack(incoming[k]);
    for (const Link& link : peers_[k].incoming) visit_parts(round, *link.received, unpack);
  }
}

}  // namespace hardball
