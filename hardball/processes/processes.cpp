// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/processes/processes.hpp"

#include <cstring>
#include <utility>

namespace hardball {
namespace {

class OneProcess final : public Processes {
 public:
  std::size_t rank() const override { return 0; }
  std::size_t size() const override { return 1; }
  std::vector<std::string> exchange(std::span<const std::size_t>, std::span<const std::string>) override {
    return {};
  }

 private:
  void gather_bytes(const void* own, std::size_t bytes, void* all) override { std::memcpy(all, own, bytes); }
};

}  // namespace

Processes& one_process() {
  static OneProcess alone;
  return alone;
}

std::vector<std::string> Processes::gather(const std::string& own) {
  std::vector<std::string> texts = exchange(others(), std::vector<std::string>(size() - 1, own));
  texts.insert(texts.begin() + static_cast<std::ptrdiff_t>(rank()), own);
  return texts;
}

std::vector<std::string> Processes::exchange_with_all(std::vector<std::string> outgoing) {
  const auto place = static_cast<std::ptrdiff_t>(rank());
  std::string own = std::move(outgoing[rank()]);
  outgoing.erase(outgoing.begin() + place);
  std::vector<std::string> texts = exchange(others(), outgoing);
  texts.insert(texts.begin() + place, std::move(own));
  return texts;
}

std::vector<std::size_t> Processes::others() const {
  std::vector<std::size_t> others;
  for (std::size_t other = 0; other < size(); ++other) {
    if (other != rank()) others.push_back(other);
  }
  return others;
}

}  // namespace hardball
