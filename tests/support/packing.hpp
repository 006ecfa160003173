// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/packing/jamming.hpp"
#include "hardball/packing/packing.hpp"

/// Packings for tests.
namespace hardball::support {

/// A packer that has come to its end.
inline Packer packed(const PackingRequest& request) {
  Packer packer(plan(request));
  while (!packer.is_over()) packer.advance();
  return packer;
}

/// The packing that a request ends in, in numbers of this precision.
inline Packing pack(const PackingRequest& request, Precision precision = Precision::doubles) {
  const Packer packer = packed(request);
  Packing packing = packing_of(packer);
  finish(packing, packer.plan(), precision);
  return packing;
}

/// Equal spheres in a periodic cube that jam.
inline PackingRequest jammed_request(std::size_t count, std::uint64_t seed = 1) {
  PackingRequest request;
  request.count = count;
  request.seed = seed;
  request.goal = PackingRequest::Densest{};
  return request;
}

}  // namespace hardball::support
