// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/cli/interruption.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

std::string readable_duration(double seconds) {
  if (!(seconds < 360000)) return "long";
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

void Progress::show(double time, std::uint64_t collisions) {
  if (!line_.is_due()) return;
  const double done = until_ > 0 ? std::clamp(time / until_, 0.0, 1.0) : 1;
  const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
  const double rate = static_cast<double>(collisions) / std::max(elapsed, 1e-9);
  line_.show(done, fmt::format("t = {:.6g}  {:.3g} collisions/s  {} left", time, rate,
                               readable_duration(elapsed * (1 - done) / done)));
}

void PackingProgress::show(const Packer& packer) {
  const double share = packer.share_done();
  if (begin_share_ < 0) begin_share_ = share;
  if (!line_.is_due()) return;
  const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
  const double left = elapsed * (1 - share) / std::max(share - begin_share_, 1e-9);
  const std::string pressure = std::isfinite(packer.pressure())
                                   ? fmt::format("pressure {:.3g}", packer.pressure())
                                   : "no pressure yet";
  line_.show(share, fmt::format("{}  phi {:.5f}  {}  {} left", name_of(packer.state()),
                                packer.packing_fraction(), pressure, readable_duration(left)));
}

OnProgress SetUpProgress::part(double begin, double end) {
  return [this, begin, end](double fraction) {
    const double done = begin + (end - begin) * fraction;
    if (is_interrupted())
      throw RunFailure(fmt::format("interrupted during the set-up, {:.0f}% done", 100 * done));
    if (line_.is_due()) line_.show(done, "setting up");
  };
}

double Budget::spent() const {
  return std::chrono::duration<double>(Clock::now() - begin_).count() / seconds_;
}

void Budget::show(const std::string& work) {
  if (is_interrupted()) throw RunFailure("interrupted");
  if (line_.is_due()) line_.show(std::min(1.0, spent()), work);
}

}  // namespace hardball::cli
