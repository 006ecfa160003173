// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/processes/processes.hpp"

#include <utility>

namespace hardball {

std::vector<std::string> Processes::gather(const std::string& own) {
  std::vector<std::string> texts = exchange(others(), std::vector<std::string>(size() - 1, own));
  texts.insert(texts.begin() + static_cast<std::ptrdiff_t>(rank()), own);
  return texts;
}

std::vector<std::string> Processes::gather_in_first(std::string own) {
  if (!is_first()) {
    const std::size_t first = 0;
    exchange({&first, 1}, {&own, 1});
    return {};
  }
  std::vector<std::string> texts = exchange(others(), std::vector<std::string>(size() - 1));
  texts.insert(texts.begin(), std::move(own));
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
