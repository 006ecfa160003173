// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/contact_network.hpp"

#include <algorithm>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Calls visit(sphere) for the one or two spheres of a contact.
template <class Visit>
void for_each_sphere(const ContactKey& bodies, Visit&& visit) {
  visit(bodies.first);
  if (!bodies.is_wall) visit(bodies.second);
}

// Marks spheres with fewer contacts than hold them, again and again, since such spheres support no others.
void find_rattlers(ContactNetwork& network, std::size_t spheres, std::size_t least) {
  std::vector<std::vector<std::uint32_t>> contacts_of(spheres);
  for (std::uint32_t contact = 0; contact < network.contacts.size(); ++contact)
    for_each_sphere(network.contacts[contact].bodies,
                    [&](std::uint32_t sphere) { contacts_of[sphere].push_back(contact); });
  std::vector<std::size_t> held_by(spheres);
  std::vector<std::uint32_t> loose;
  network.rattles.assign(spheres, false);
  const auto check = [&](std::uint32_t sphere) {
    if (network.rattles[sphere] || held_by[sphere] >= least) return;
    network.rattles[sphere] = true;
    loose.push_back(sphere);
  };
  for (std::uint32_t sphere = 0; sphere < spheres; ++sphere) held_by[sphere] = contacts_of[sphere].size();
  for (std::uint32_t sphere = 0; sphere < spheres; ++sphere) check(sphere);
  std::vector<bool> is_lost(network.contacts.size());
  while (!loose.empty()) {
    const std::uint32_t sphere = loose.back();
    loose.pop_back();
    ++network.rattlers;
    for (const std::uint32_t contact : contacts_of[sphere]) {
      if (is_lost[contact]) continue;
      is_lost[contact] = true;
      for_each_sphere(network.contacts[contact].bodies, [&](std::uint32_t other) {
        --held_by[other];
        check(other);
      });
    }
  }
  network.backbone_contacts = static_cast<std::size_t>(ranges::count(is_lost, false));
}

}  // namespace

ContactNetwork contact_network(const PackedSpheres& spheres, double tolerance,
                               const std::unordered_map<ContactKey, double>& impulses) {
  ContactNetwork network;
  network.tolerance = tolerance;
  double mean = 0;
  spheres.for_each_near(tolerance, [&](const NearPair& pair) {
    PackingContact contact{pair.bodies, pair.gap, pair.separation};
    if (!impulses.empty()) {
      const auto found = impulses.find(contact.bodies);
      contact.force = found != impulses.end() ? found->second : 0;
      mean += contact.force;
    }
    network.contacts.push_back(contact);
  });
  mean /= static_cast<double>(network.contacts.size());
  if (mean > 0)
    for (PackingContact& contact : network.contacts) contact.force /= mean;
  const std::size_t dimensions = spheres.container.dimensions;
  find_rattlers(network, spheres.size(), dimensions + 1);
  const std::size_t held = spheres.size() - network.rattlers;
  if (held > 0) {
    const double needed =
        static_cast<double>(dimensions * held) + 1 - static_cast<double>(spheres.container.free_motions());
    network.isostaticity = static_cast<double>(network.backbone_contacts) / needed;
  }
  return network;
}

}  // namespace hardball
