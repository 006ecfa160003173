// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

namespace hardball::viewer {

/// What the server grants a client.
struct ClientLimits {
  /// The time for the whole head of a request, and for each part of a response to be read.
  std::chrono::milliseconds patience = std::chrono::seconds(5);
  std::size_t head_bytes = std::size_t{1} << 16;  ///< The longest head of a request.
  std::size_t strangers = 256;  ///< The connections whose client has not shown that it may view.
};

}  // namespace hardball::viewer
