// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "hardball/response/response_table.hpp"
#include "hardball/response/restitution.hpp"

namespace hardball {

/// The caller's own response; none if empty.
using CustomResponse = std::function<Outcome(const Contact&)>;

/// A response chosen at run time: a constant restitution, which is the fastest, a table, or the caller's own.
class AnyResponse {
 public:
  explicit AnyResponse(const Restitution& restitution) : restitution_(restitution) {}
  explicit AnyResponse(const ResponseTable& table)
      : is_plain_(false), table_(std::make_shared<const ResponseTable>(table)) {}

  /// Replaces the response by the caller's own, or restores the built-in one if that is empty.
  void replace(CustomResponse custom) {
    custom_ = std::move(custom);
    is_plain_ = !custom_ && !table_;
  }
  /// Replaces the built-in response, which is then in use.
  void replace(const ResponseTable& table) {
    table_ = std::make_shared<const ResponseTable>(table);
    replace(CustomResponse());
  }

  /// See Response.
  bool decide(Contact& contact) const {
    if (is_plain_) [[likely]]
      return hardball::decide(restitution_, contact);
    return custom_ ? hardball::decide(custom_, contact) : hardball::decide(*table_, contact);
  }

 private:
  bool is_plain_ = true;
  Restitution restitution_;
  std::shared_ptr<const ResponseTable> table_;  // never changes, so copies share it
  CustomResponse custom_;
};

static_assert(Response<AnyResponse>);

}  // namespace hardball
