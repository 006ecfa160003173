// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/packing/jamming.hpp"
#include "hardball/packing/protocol.hpp"
#include "hardball/packing/random_start.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

using Densest = PackingRequest::Densest;
using Pressure = PackingRequest::Pressure;

// Contacts between two looks at what the caller wants.
constexpr std::uint64_t kStretch = 1 << 17;
// Beyond these nothing becomes denser: the resolution of coordinates has been reached.
constexpr int kMostSteps = 400;

double thermal_speed(const World& world, const Time& now) {
  const double degrees = static_cast<double>(world.box().dimensions() * world.size());
  return std::sqrt(2 * kinetic_energy(world, now) / degrees);
}

std::vector<Vec3> thermal_velocities(std::size_t count, const Container& container, Random& random) {
  return thermal_velocities(count, container.dimensions, container.wall_area() > 0, random);
}

World start_of(const PackingPlan& plan, const OnProgress& on_progress) {
  const Container& container = plan.container;
  World world(container.box(), {}, container.surfaces());
  const std::size_t dimensions = plan.container.dimensions;
  std::vector<double> radii = plan.radii;
  std::vector<Vec3> centers = plan.start;
  Random random(plan.seed);
  if (centers.empty()) {
    double volume = 0;
    for (const double radius : radii) volume += world.box().sphere_volume(radius);
    const double shrink = plan.start_fraction / (volume / plan.container.volume());
    for (double& radius : radii) radius *= root(shrink, dimensions);
    centers = place_shrunken(world, {container.low, container.low + container.size}, radii, random, "packing",
                             Progress(on_progress));
  }
  const std::vector<Vec3> velocities = thermal_velocities(centers.size(), plan.container, random);
  world.reserve(centers.size());
  for (std::size_t i = 0; i < centers.size(); ++i)
    world.add({.position = centers[i], .velocity = velocities[i], .radius = radii[i]});
  return world;
}

// The median, but where most spheres bear nothing that of those that do: small ones rattle among large ones.
double typical(std::vector<double> pressures, double mean, const Container& container) {
  const auto median_of = [](auto begin, auto end) {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    return *middle;
  };
  const double median = median_of(pressures.begin(), pressures.end());
  constexpr double kApart = 100;
  if (!(mean > kApart * median)) return median;
  const double border = std::sqrt(mean * median);
  const auto bearing =
      std::partition(pressures.begin(), pressures.end(), [&](double p) { return p < border; });
  const auto count = static_cast<std::size_t>(pressures.end() - bearing);
  // Fewer are a pair that has become very fast; but walls may hold a single sphere.
  constexpr std::size_t kShare = 1000;
  const std::size_t least = container.wall_area() > 0 ? 1 : container.dimensions + 2;
  if (count < std::max(least, pressures.size() / kShare)) return median;
  return median_of(bearing, pressures.end());
}

}  // namespace

Packer::Packer(PackingPlan plan, const EngineOptions& options, const OnProgress& on_progress)
    : plan_(std::move(plan)), simulation_(start_of(plan_, on_progress), options) {
  begin();
}

void Packer::begin() {
  rate_ = plan_.rate;
  state_ = State::filling;
  pressure_ = std::numeric_limits<double>::quiet_NaN();
  steps_ = 0;
  step_ = 1;
  has_locked_ = false;
  forget_bracket();
  speed_ = thermal_speed(simulation_.world(), simulation_.now());
  virial_.assign(simulation_.size(), 0.0);
  open_window();
  if (rate_ < protocol::kFillingRate) {
    filled_ = simulation_.save();
    grow(protocol::kFillingRate, end_fraction());
  } else {
    begin_growing();
  }
}

double Packer::mean_diameter() const {
  const World& world = simulation_.world();
  ExactSum sum;
  for (Slot slot = 0; slot < world.size(); ++slot) sum += 2 * world.radius(slot, simulation_.now());
  return sum.value() / static_cast<double>(world.size());
}

double Packer::packing_fraction() const {
  return hardball::packing_fraction(simulation_.world(), simulation_.now());
}

std::uint64_t Packer::collisions() const {
  return given_up_ + contacts();
}

double Packer::share_done() const {
  return std::min(1.0, static_cast<double>(contacts()) / contacts_for(plan_.expected_collisions()));
}

void Packer::record(const Contact& contact) {
  const Vec3 impulse = contact.impulse();
  if (contact.is_collision()) {
    const double virial = std::fabs(dot(impulse, contact.separation)) / 2;
    virial_[contact.first] += virial;
    virial_[contact.second] += virial;
  } else {
    virial_[contact.first] += std::fabs(dot(impulse, contact.wall_normal)) * contact.first_radius;
  }
  if (state_ != State::weighing || weighed_at_.empty()) return;
  ContactKey bodies{contact.first, contact.is_collision() ? contact.second : wall_of(contact),
                    !contact.is_collision()};
  if (contact.is_collision()) {
    const Box& box = simulation_.world().box();
    const Vec3 apart = weighed_at_[contact.second] - weighed_at_[contact.first];
    bodies.image = box.nearest_image(contact.separation - apart);
  }
  impulses_[bodies] += length(impulse);
}

// The number of a wall as contacts are counted: a mesh has many.
std::uint32_t Packer::wall_of(const Contact& contact) {
  if (!plan_.container.mesh) return contact.second;
  if (!mesh_walls_) mesh_walls_.emplace(simulation_.world().surfaces().front().mesh()->shared_mesh());
  return mesh_walls_->number(contact.feature);
}

// What the pressure must exceed before spheres are as dense as planned; infinite where that is a packing
// fraction.
double Packer::wanted_pressure() const {
  if (const auto* pressure = std::get_if<Pressure>(&plan_.goal)) return pressure->compressibility;
  return std::holds_alternative<Densest>(plan_.goal) ? protocol::kJammed
                                                     : std::numeric_limits<double>::infinity();
}

// Whether a pressure is wanted that is not far above the last one.
bool Packer::is_next_to_pressure() const {
  constexpr double kNear = 2;
  return std::holds_alternative<Pressure>(plan_.goal) && kNear * pressure_ > wanted_pressure();
}

// Whether the last pressure is as high as the goal says, and no higher than is meant by that.
bool Packer::has_pressure_wanted() const {
  const double wanted = wanted_pressure();
  return pressure_ >= wanted && pressure_ <= protocol::kHighest * wanted;
}

double Packer::end_fraction() const {
  const double* fraction = std::get_if<double>(&plan_.goal);
  return fraction ? *fraction : std::numeric_limits<double>::infinity();
}

// Whether the packing fraction planned has been reached, or spheres have jammed next to it.
bool Packer::is_at_end() const {
  return packing_fraction() >= (1 - protocol::kExact) * end_fraction();
}

// Whether spheres at this pressure may jam only there: free volume vanishes as one over the pressure.
bool Packer::is_near_end() const {
  const double room = 2 * static_cast<double>(plan_.container.dimensions) / pressure_;
  return packing_fraction() * (1 + room) >= end_fraction();
}

void Packer::open_window() {
  ranges::fill(virial_, 0.0);
  energy_integral_ = simulation_.tally().energy_integral(simulation_.now());
  window_begin_ = contacts();
}

void Packer::close_window(double rate) {
  const double energy = simulation_.tally().energy_integral(simulation_.now()) - energy_integral_;
  const double ideal = 2 * energy / static_cast<double>(simulation_.size());
  std::vector<double> pressures = virial_;
  double mean = 0;
  for (double& pressure : pressures) {
    pressure = 1 + pressure / ideal;
    mean += pressure / static_cast<double>(pressures.size());
  }
  pressure_ = typical(std::move(pressures), mean, plan_.container);
  mean_pressure_ = mean;
  history_.push_back({collisions(), packing_fraction(), pressure_, rate});
  open_window();
}

void Packer::grow(double rate, double fraction) {
  const bool is_known = pressure_ >= protocol::kFilled;
  simulation_.grow({.rate = rate, .until_packing_fraction = fraction},
                   is_known ? std::optional(pressure_) : std::nullopt);
}

void Packer::begin_growing() {
  state_ = State::growing;
  filled_ = simulation_.save();
  grow(rate_, end_fraction());
}

// Growth between relaxations heats spheres; a power of two rounds nothing.
void Packer::halve_speeds() {
  double factor = 1;
  const double speed = thermal_speed(simulation_.world(), simulation_.now());
  while (factor * speed >= 2 * speed_) factor /= 2;
  if (factor == 1) return;
  change_velocities([&](SphereId id) { return factor * simulation_.velocity(id); });
}

void Packer::change_velocities(const Function<Vec3(SphereId)>& velocity_of) {
  std::vector<VelocityEdit> edits;
  edits.reserve(simulation_.size());
  for (SphereId id = 0; id < simulation_.size(); ++id) edits.push_back({id, velocity_of(id)});
  simulation_.change_velocities(edits);
}

// Runs at constant size until each sphere has had this many collisions since the window began, or for long
// enough; returns whether it is done.
bool Packer::run_at_constant_size(double collisions) {
  const auto wanted = static_cast<std::uint64_t>(contacts_for(collisions));
  const std::uint64_t seen = contacts() - window_begin_;
  if (seen < wanted) {
    simulation_.run({.until = Time(patience_), .contacts = std::min(wanted - seen, kStretch)});
  }
  return contacts() - window_begin_ >= wanted || simulation_.time() >= patience_;
}

// Draws new velocities for all spheres, at the temperature of the start.
void Packer::renew_velocities() {
  simulation_.stop_growing();
  Random random(plan_.seed + collisions());
  const std::vector<Vec3> velocities = thermal_velocities(simulation_.size(), plan_.container, random);
  change_velocities([&](SphereId id) { return speed_ * velocities[id]; });
}

void Packer::relax() {
  simulation_.stop_growing();
  // Shrinking cools those that touch, and not rattlers, with which they hardly exchange energy.
  is_next_to_pressure() ? renew_velocities() : halve_speeds();
  state_ = State::relaxing;
  be_patient();
  open_window();
}

void Packer::weigh(State end) {
  simulation_.stop_growing();
  halve_speeds();
  end_ = end;
  state_ = State::weighing;
  if (end_ != State::reached || std::holds_alternative<Pressure>(plan_.goal))
    weighed_at_ = simulation_.positions();
  be_patient();
  open_window();
}

// Spheres of a gas may hardly ever meet: a window ends after a hundred flights over the mean diameter.
void Packer::be_patient() {
  constexpr double kFlights = 100;
  const double diameter = 2 * statistics_of(plan_.radii, plan_.container.dimensions).mean;
  const double speed = thermal_speed(simulation_.world(), simulation_.now());
  patience_ = simulation_.time() + kFlights * diameter / speed;
}

void Packer::advance() {
  HARDBALL_CHECK(!is_over());
  simulation_.on_contact([this](const Contact& contact) { record(contact); });
  if (state_ == State::relaxing) {
    // Next to the pressure wanted what has just changed must not count.
    if (run_at_constant_size(is_next_to_pressure() ? protocol::kWeighing
                                                   : protocol::kRelaxation + protocol::kWindow))
      after_relaxation();
    return;
  }
  if (state_ == State::weighing) {
    if (run_at_constant_size(weighed_at_.empty() ? protocol::kWindow : protocol::kWeighing)) after_weighing();
    return;
  }
  const GrowthSchedule& growth = *simulation_.growth();
  // Where spheres are as large as they can be, or are to be, no epoch begins that could end.
  if (growth.is_over()) return after_epoch();
  const std::uint64_t epoch = growth.epochs();
  // An epoch may be ended before its time.
  const std::uint64_t left = growth.contacts_left(simulation_.tally(), simulation_.size());
  simulation_.run({.until = Time(growth.next()), .contacts = left > 0 ? std::min(left, kStretch) : kStretch});
  if (simulation_.growth()->epochs() != epoch) after_epoch();
}

void Packer::after_epoch() {
  const GrowthSchedule& growth = *simulation_.growth();
  has_no_room_ = growth.state() == GrowthSchedule::State::no_room;
  if (state_ == State::stepping) {
    if (growth.is_over()) after_step();
    return;
  }
  const bool is_seen =
      contacts() - window_begin_ >= static_cast<std::uint64_t>(contacts_for(protocol::kWindow / 2));
  if (is_seen) close_window(growth.rules().rate);
  const bool is_fraction = std::holds_alternative<double>(plan_.goal);
  const bool is_densest = std::holds_alternative<Densest>(plan_.goal);
  if (growth.state() == GrowthSchedule::State::reached) return weigh(State::reached);
  if (growth.state() == GrowthSchedule::State::no_room && is_densest) return weigh(State::jammed);
  if (growth.is_over()) {
    if (is_fraction) return end_attempt();
    renew_velocities();
    return relax();
  }
  if (!is_seen) return;
  constexpr double kFew = 100;  // the mean is that of a few
  if (is_fraction && (pressure_ > protocol::kLocked || growth.compressibility() > kFew * protocol::kLocked))
    return is_near_end() ? relax() : give_up_attempt();
  if (pressure_ >= wanted_pressure()) return is_densest ? weigh(State::jammed) : relax();
  if (state_ == State::filling && pressure_ > protocol::kFilled) return begin_growing();
  if (!is_fraction && pressure_ > protocol::kRelaxedFrom && !begins_with_another_count()) relax();
}

// After growth between relaxations. Where spheres lock within it, they go back, and on by shorter steps.
void Packer::after_step() {
  const GrowthSchedule::State end = simulation_.growth()->state();
  const bool is_fraction = std::holds_alternative<double>(plan_.goal);
  if (is_sized_) return weigh(end == GrowthSchedule::State::reached ? State::reached : State::locked);
  if (is_fraction && is_at_end()) return weigh(State::reached);
  if (end == GrowthSchedule::State::no_room && !std::holds_alternative<Pressure>(plan_.goal))
    return is_fraction ? end_attempt() : weigh(State::jammed);
  constexpr double kShorter = 0.5;
  constexpr double kLonger = 1.1;
  if (end == GrowthSchedule::State::reached) {
    step_ = std::min(1.0, kLonger * step_);
  } else {
    step_ *= kShorter;
    has_locked_ = true;
    too_dense_ = std::min(too_dense_, packing_fraction());
    go_back_to(before_step_);
  }
  relax();
}

void Packer::after_relaxation() {
  close_window(0);
  if (std::holds_alternative<Pressure>(plan_.goal)) {
    if (has_pressure_wanted()) return weigh(State::reached);
  } else if (bearing_pressure() >= protocol::kJammed) {
    return std::holds_alternative<Densest>(plan_.goal) ? weigh(State::jammed) : end_attempt();
  }
  step();
}

// Growth, or where the pressure is too high the reverse, by as much as the pressure allows.
void Packer::step() {
  if (++steps_ > kMostSteps) return weigh(State::locked);
  state_ = State::stepping;
  const double present = packing_fraction();
  const bool is_pressure = std::holds_alternative<Pressure>(plan_.goal);
  const double change = step_ * (is_pressure ? change_to_pressure() : protocol::kStep / bearing_pressure());
  double next = std::min(present * power(1 + change, plan_.container.dimensions), end_fraction());
  if (is_pressure) {
    // Between packing fractions of too low and of too high a pressure, until the two are so close that
    // spheres must have rearranged.
    (pressure_ < wanted_pressure() ? too_dilute_ : too_dense_) = present;
    constexpr double kResolved = 0.01;
    const double between = too_dense_ - too_dilute_;
    if (too_dilute_ > 0 && std::isfinite(too_dense_)) {
      if (between > kResolved * present / pressure_) {
        next = too_dilute_ + between / 2;
      } else {
        forget_bracket();
      }
    }
  }
  // The largest sphere fills the container, and the pressure is still too low.
  if (has_no_room_ && next > present) return weigh(State::locked);
  before_step_ = simulation_.save();
  grow(next > present ? rate_ : -rate_, next);
}

// That of the spheres that bear: where growth has failed, they may be fewer than half, and theirs is the
// mean.
double Packer::bearing_pressure() const {
  return has_locked_ ? std::max(pressure_, mean_pressure_) : pressure_;
}

// By which fraction sizes are to change for the pressure wanted.
double Packer::change_to_pressure() const {
  // The logarithm of the excess pressure grows by the dimensions with that of the sizes in a gas, and by
  // itself where spheres nearly touch.
  constexpr double kLeast = 1e-6;
  const double excess = std::max(kLeast, pressure_ - 1);
  const double sought = protocol::kSought * wanted_pressure() - 1;
  const double slope = std::max(static_cast<double>(plan_.container.dimensions), excess);
  const double most = protocol::kStep / bearing_pressure();
  return std::clamp(portable_log(sought / excess) / slope, -most, most);
}

void Packer::forget_bracket() {
  too_dilute_ = 0;
  too_dense_ = std::numeric_limits<double>::infinity();
}

void Packer::after_weighing() {
  close_window(0);
  if (begins_with_another_count()) return;
  const bool is_pressure = std::holds_alternative<Pressure>(plan_.goal) && end_ == State::reached;
  if (is_pressure && is_sized_) {
    state_ = pressure_ >= wanted_pressure() ? State::reached : State::locked;
    return;
  }
  if (is_pressure && (!has_pressure_wanted() || plan_.follows == PackingPlan::Follows::count)) {
    weighed_at_.clear();
    impulses_.clear();
    return has_pressure_wanted() ? take_diameter() : step();
  }
  state_ = end_;
}

// Gives spheres whose count follows from diameter and pressure this diameter: the pressure is then as near as
// a whole number of spheres allows.
void Packer::take_diameter() {
  is_sized_ = true;
  state_ = State::stepping;
  const double ratio = plan_.diameter / mean_diameter();
  grow(ratio > 1 ? rate_ : -rate_, packing_fraction() * power(ratio, plan_.container.dimensions));
}

// Spheres have jammed before they were as dense as planned, or where they are so.
void Packer::end_attempt() {
  is_at_end() ? weigh(State::reached) : give_up_attempt();
}

void Packer::go_back_to(const std::string& saved) {
  given_up_ += contacts();
  const std::size_t threads = simulation_.options().threads;
  simulation_ = Simulation::load(saved, kWhereSaved);
  simulation_.set_threads(threads);
  given_up_ -= contacts();
  has_no_room_ = false;
}

// Spheres have locked before they were dense enough: from the fluid on, once more and at half the rate.
void Packer::give_up_attempt() {
  const bool is_slow = rate_ / 2 < protocol::kSlowest;
  if (plan_.is_rate_given || is_slow || attempts_ == protocol::kAttempts) return weigh(State::locked);
  ++attempts_;
  rate_ /= 2;
  state_ = State::growing;
  go_back_to(filled_);
  pressure_ = std::numeric_limits<double>::quiet_NaN();
  step_ = 1;
  has_locked_ = false;
  open_window();
  grow(rate_, end_fraction());
}

// Where the count follows from the diameter, it is known only from packings: each shows whether this number
// fits, and which number would. Returns whether packing starts again with another number. Free volume
// vanishes as one over the pressure.
bool Packer::begins_with_another_count() {
  const bool follows =
      plan_.follows == PackingPlan::Follows::count && !std::holds_alternative<double>(plan_.goal);
  if (!follows || is_count_final_ || is_sized_) return false;
  const std::size_t dimensions = plan_.container.dimensions;
  const double left = std::max(0.0, 1 / pressure_ - 1 / wanted_pressure());
  const double ratio = mean_diameter() * (1 + left) / plan_.diameter;
  const std::size_t count = simulation_.size();
  const bool fits = ratio >= 1;
  // What was expected of a packing on its way may turn out to be wrong in the end.
  constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
  if (fits) {
    most_that_fit_ = std::max(most_that_fit_, count);
    if (least_that_do_not_ <= count) least_that_do_not_ = kUnknown;
  } else {
    least_that_do_not_ = std::min(least_that_do_not_, count);
    if (most_that_fit_ >= count) most_that_fit_ = 0;
  }
  const auto estimate = static_cast<std::size_t>(static_cast<double>(count) * power(ratio, dimensions));
  // Packings differ from one to the next.
  constexpr double kScatter = 0.002;
  const auto scatter = static_cast<std::size_t>(kScatter * static_cast<double>(count));
  // A pressure is that of the fewest spheres that are too many for a lower one.
  const bool is_pressure = std::holds_alternative<Pressure>(plan_.goal);
  const bool is_good = is_pressure != fits;
  const bool is_close = fits ? estimate <= count + scatter : estimate + 1 + scatter >= count;
  const bool is_closest = fits ? count + 1 == least_that_do_not_ : count - 1 == most_that_fit_;
  if (is_good && (is_close || is_closest)) return false;
  const std::size_t best = is_pressure ? least_that_do_not_ : most_that_fit_;
  const bool is_known = is_pressure ? best < kUnknown : best > 0;
  const std::size_t fewest = most_that_fit_ + 1;
  const std::size_t most = least_that_do_not_ - 1;
  if (is_known && (recounts_ >= protocol::kRecounts || fewest > most)) {
    is_count_final_ = true;
    if (best == count) return false;
    begin_with(best);
    return true;
  }
  if (fewest > most) return false;
  // Between those that fit and those that do not; farther and farther from the estimate until some are good.
  const std::size_t farther = is_good ? 0 : static_cast<std::size_t>(recounts_) * (1 + scatter);
  const std::size_t next = is_pressure ? estimate + 1 + farther : estimate - std::min(estimate, farther);
  begin_with(std::clamp(next, fewest, most));
  return true;
}

void Packer::begin_with(std::size_t count) {
  ++recounts_;
  given_up_ += contacts();
  const EngineOptions options{.threads = simulation_.options().threads};
  plan_ = with_count(plan_, count);
  simulation_ = Simulation(start_of(plan_, {}), options);
  weighed_at_.clear();
  impulses_.clear();
  begin();
}

std::unordered_map<ContactKey, double> Packer::impulses() const {
  const Box& box = simulation_.world().box();
  const std::vector<Vec3> now = simulation_.positions();
  const auto crossed = [&](std::uint32_t sphere) {
    return box.nearest_image(weighed_at_[sphere] - now[sphere]);
  };
  std::unordered_map<ContactKey, double> impulses;
  for (const auto& [key, impulse] : impulses_) {
    ContactKey bodies = key;
    if (!key.is_wall) bodies.image = key.image + crossed(key.second) - crossed(key.first);
    impulses[bodies] = impulse;
  }
  return impulses;
}

std::string Packer::save() const {
  return archived(*this);
}

Packer Packer::load(std::string_view bytes, const std::string& where) {
  Packer packer;
  restore(bytes, where, packer);
  return packer;
}

bool Packer::restored() const {
  const std::size_t size = simulation_.size();
  const bool grows = state_ == State::filling || state_ == State::growing || state_ == State::stepping;
  return state_ <= State::locked && end_ >= State::reached && end_ <= State::locked &&
         plan_.radii.size() == size && virial_.size() == size &&
         (weighed_at_.empty() || weighed_at_.size() == size) && rate_ > 0 && speed_ > 0 &&
         grows == simulation_.growth().has_value();
}

}  // namespace hardball
