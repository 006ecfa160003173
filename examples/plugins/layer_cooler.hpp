// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/simulation.hpp"

/// A thermostat of one's own: at equal intervals it slows down all spheres below a height.
class LayerCooler final : public hardball::Actor {
 public:
  /// What is below `height` [L] has its velocity multiplied by `factor` [1] after every interval [T].
  LayerCooler(double height, double factor, double interval)
      : height_(height), factor_(factor), interval_(interval) {}

  std::unique_ptr<Actor> clone() const override { return std::make_unique<LayerCooler>(*this); }
  std::string_view deed() const override { return "the cooler acts"; }
  // A product, as a sum of intervals would drift.
  hardball::Time next() const override {
    return hardball::Time(interval_ * static_cast<double>(actions_ + 1));
  }
  hardball::Action act(const hardball::World& world, const hardball::Tally&,
                       const hardball::Time& moment) override {
    ++actions_;
    changes_.clear();
    double energy = 0;
    world.for_each_by_id([&](hardball::Slot slot) {
      if (world.position(slot, moment).z > height_) return;
      const hardball::Vec3 before = world.velocity(slot, moment);
      changes_.push_back({slot, before, factor_ * before});
      energy += world.mass(slot) / 2 * (factor_ * factor_ - 1) * dot(before, before);
    });
    return {.changes = changes_, .energy = energy};
  }

 private:
  double height_;
  double factor_;
  double interval_;
  std::size_t actions_ = 0;
  std::vector<hardball::NewVelocity> changes_;
};
