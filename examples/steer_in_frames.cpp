// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A game: 200 ships fly through 19,800 rocks at 60 frames a second. In each frame every ship is steered; a
// few of them look ahead and turn away from what they would hit. Beside the exact hits, it counts those that
// a check for overlaps once a frame would have seen.
//
// usage: steer_in_frames [PICTURE.svg]; how long frames take is printed on the standard error output.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "hardball/hardball.hpp"

namespace {

using hardball::Contact;
using hardball::Simulation;
using hardball::SphereId;
using hardball::Vec3;

constexpr int kFrames = 240;
constexpr double kFramesPerSecond = 60;
constexpr double kEdge = 24;             // of the box [m]
constexpr int kPerAxis = 28;             // places on a lattice; the first kSpheres are taken
constexpr std::size_t kSpheres = 20000;  // every hundredth is a ship
constexpr std::size_t kRocksPerShip = 100;
constexpr double kRock = 0.05;  // radii [m]
constexpr double kShip = 0.15;
constexpr double kRockSpeed = 4;  // along each axis [m/s]
constexpr double kShipSpeed = 6;
constexpr double kLookAhead = 0.5;  // [s]
constexpr int kLooks = 20;          // frames between two looks of a ship
constexpr Vec3 kUp{0, 0, 1};

struct Field {
  hardball::World world{hardball::Box::walls({kEdge, kEdge, kEdge})};
  std::vector<SphereId> ships;
  std::vector<Vec3> goals;  // of the ships
};

Field make_field() {
  Field field;
  hardball::Random random(1997);
  const double spacing = kEdge / kPerAxis;
  for (std::size_t i = 0; i < kSpheres; ++i) {
    const auto along = [&](std::size_t place) {
      return (static_cast<double>(place % kPerAxis) + 0.5) * spacing;
    };
    const Vec3 place{along(i), along(i / kPerAxis), along(i / (kPerAxis * kPerAxis))};
    const bool is_ship = i % kRocksPerShip == 0;
    const Vec3 velocity{kRockSpeed * random.normal(), kRockSpeed * random.normal(),
                        kRockSpeed * random.normal()};
    const SphereId id = field.world.add({.position = place,
                                         .velocity = is_ship ? Vec3{} : velocity,
                                         .radius = is_ship ? kShip : kRock,
                                         .mass = is_ship ? 20.0 : 1.0});
    if (!is_ship) continue;
    field.ships.push_back(id);
    field.goals.push_back({kEdge * random.uniform(), kEdge * random.uniform(), kEdge * random.uniform()});
  }
  return field;
}

Vec3 towards(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double distance = hardball::length(way);
  return distance > 0 ? (kShipSpeed / distance) * way : Vec3{};
}

// How long a ship would fly before it hits anything at this velocity.
double time_free(const Simulation& simulation, SphereId ship, const Vec3& velocity) {
  const double until = simulation.time() + kLookAhead;
  const auto hit = simulation.first_contact(ship, velocity, until);
  return (hit ? hit->time : until) - simulation.time();
}

// The wanted velocity, or if it leads into something, the one of a few others that stays free longest.
Vec3 look_ahead(const Simulation& simulation, SphereId ship, const Vec3& wanted) {
  double longest = time_free(simulation, ship, wanted);
  if (longest >= kLookAhead) return wanted;
  Vec3 best = wanted;
  const Vec3 aside = hardball::cross(wanted, kUp);
  for (const Vec3& turn : {aside, -aside, kShipSpeed * kUp, -kShipSpeed * kUp}) {
    const Vec3 velocity = wanted + turn;
    const double free = time_free(simulation, ship, velocity);
    if (free <= longest) continue;
    longest = free;
    best = velocity;
  }
  return best;
}

// One hit, and what a check for overlaps once a frame makes of it.
struct Hit {
  Contact contact;
  double last_check;  // the frame before it, and the one after [s]
  double next_check;
  bool is_seen;
};

// A check sees an overlap that lasts until the next frame, both spheres going straight on.
Hit hit_of(const Contact& contact) {
  const double time = contact.time.value();
  const double frame = std::ceil(time * kFramesPerSecond);
  const double next_check = frame / kFramesPerSecond;
  const Vec3 relative = contact.before.second - contact.before.first;
  const double overlap = -2 * hardball::dot(contact.separation, relative) / hardball::dot(relative, relative);
  return {contact, (frame - 1) / kFramesPerSecond, next_check, time + overlap > next_check};
}

struct Flight {
  std::vector<Hit> hits;
  std::uint64_t hits_on_ships = 0;
  std::uint64_t arrivals = 0;
  std::vector<double> frame_times;  // [s]
};

Flight fly(Field field, bool with_looks) {
  Simulation simulation(field.world);
  for (const SphereId ship : field.ships) simulation.sphere(ship).set_user_data(1);

  Flight flight;
  simulation.on_contact([&](const Contact& contact) {
    if (!contact.is_collision()) return;
    flight.hits.push_back(hit_of(contact));
    // Rocks have the number zero.
    const bool is_on_ship = simulation.user_data(contact.first) + simulation.user_data(contact.second) > 0;
    if (is_on_ship) ++flight.hits_on_ships;
  });

  hardball::Random random(2);
  std::vector<hardball::VelocityEdit> changes(field.ships.size());
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < field.ships.size(); ++i) {
      const hardball::SphereHandle ship = simulation.sphere(field.ships[i]);
      const Vec3 place = ship.position();
      if (hardball::length(field.goals[i] - place) < 1) {
        ++flight.arrivals;
        field.goals[i] = kEdge * Vec3{random.uniform(), random.uniform(), random.uniform()};
      }
      // Between looks a ship keeps to its course, and recovers from hits.
      const bool looks = (frame + static_cast<int>(i)) % kLooks == 0;
      Vec3 velocity = looks ? towards(place, field.goals[i]) : towards({}, ship.velocity());
      if (looks && with_looks) velocity = look_ahead(simulation, ship.id(), velocity);
      changes[i] = {ship.id(), velocity};
    }
    simulation.change_velocities(changes);
    simulation.run_until((frame + 1) / kFramesPerSecond);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    flight.frame_times.push_back(taken.count());
  }
  return flight;
}

// Two spheres as a check sees them, in the frame and plane of the first: the frame before, the hit, the frame
// after.
void draw_hit(std::FILE* file, const Hit& hit, double x, double y, double scale) {
  const Contact& contact = hit.contact;
  const Vec3 relative = contact.before.second - contact.before.first;
  const double speed = hardball::length(relative);
  const double along = hardball::dot(contact.separation, relative) / speed;
  const double aside = std::sqrt(std::max(0.0, contact.reach * contact.reach - along * along));
  const double other = contact.reach - contact.first_radius;
  const auto circle = [&](double at, double across, double radius, const char* style) {
    std::fprintf(file, "<circle cx='%.1f' cy='%.1f' r='%.1f' %s/>\n", x + scale * at, y - scale * across,
                 scale * radius, style);
  };
  const double before = along - speed * (contact.time.value() - hit.last_check);
  const double after = along + speed * (hit.next_check - contact.time.value());
  std::fprintf(file, "<path d='M%.1f %.1fH%.1f' stroke='#999' stroke-dasharray='4 3'/>\n", x + scale * before,
               y - scale * aside, x + scale * after);
  circle(0, 0, contact.first_radius, "fill='#8aa'");
  circle(before, aside, other, "fill='none' stroke='#333'");
  circle(after, aside, other, "fill='none' stroke='#333'");
  circle(along, aside, other, "fill='#d33' fill-opacity='0.8'");
}

void write_picture(const char* path, std::span<const Hit> hits) {
  std::FILE* const file = std::fopen(path, "w");
  if (file == nullptr)
    throw hardball::Error("it cannot be written", path, "name a file in a writable folder");
  constexpr double kSide = 400;
  constexpr double kMargin = 30;
  std::fprintf(file,
               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 860 470' font-family='sans-serif' "
               "font-size='13' fill='#222'>\n<rect width='860' height='470' fill='#fff'/>\n"
               "<rect x='30' y='30' width='400' height='400' fill='none' stroke='#bbb'/>\n");
  // The hits of the first quarter of a second, seen from above.
  for (const bool is_seen : {true, false}) {
    std::fprintf(file, "<path stroke='%s' stroke-width='5' stroke-linecap='round' d='",
                 is_seen ? "#bbb" : "#d33");
    for (const Hit& hit : hits) {
      if (hit.contact.time.value() > 0.25) break;
      if (hit.is_seen != is_seen) continue;
      const Vec3 point = hit.contact.point();
      std::fprintf(file, "M%.0f %.0fh0", kMargin + kSide * point.x / kEdge,
                   kMargin + kSide - kSide * point.y / kEdge);
    }
    std::fprintf(file, "'/>\n");
  }
  std::fprintf(file,
               "<text x='30' y='20'>hits within a quarter of a second</text>\n"
               "<text x='30' y='452'><tspan fill='#d33'>missed</tspan> and <tspan fill='#888'>seen</tspan> "
               "by a check for overlaps in each frame</text>\n"
               "<text x='470' y='20'>three of those missed; outlined: the frames before and after</text>\n");
  int row = 0;
  for (const Hit& hit : hits) {
    const bool is_clear = hit.contact.impact_speed() > 8 && hit.contact.time.value() - hit.last_check > 0.006;
    if (hit.is_seen || !is_clear || row == 3) continue;
    draw_hit(file, hit, 640, 110 + 130 * row++, 560);
  }
  std::fprintf(file, "</svg>\n");
  std::fclose(file);
}

void print_times(const char* what, std::vector<double> times) {
  std::ranges::sort(times);
  std::fprintf(stderr, "frames took %.1f ms (median), %.1f ms (longest), %s\n", 1e3 * times[times.size() / 2],
               1e3 * times.back(), what);
}

}  // namespace

int main(int argc, char** argv) {
  const Field field = make_field();
  const Flight blind = fly(field, false);
  const Flight flight = fly(field, true);

  const auto seen = static_cast<std::size_t>(
      std::ranges::count_if(flight.hits, [](const Hit& hit) { return hit.is_seen; }));
  const std::size_t hits = flight.hits.size();
  std::printf("%d frames at %g a second, %zu spheres, %zu of them steered\n", kFrames, kFramesPerSecond,
              field.world.size(), field.ships.size());
  std::printf("hits: %zu; a check for overlaps in each frame sees %zu and misses %zu, %.1f%%\n", hits, seen,
              hits - seen, 100 * static_cast<double>(hits - seen) / static_cast<double>(hits));
  std::printf("hits on ships: %llu when they look ahead, %llu when they fly blind\n",
              static_cast<unsigned long long>(flight.hits_on_ships),
              static_cast<unsigned long long>(blind.hits_on_ships));
  std::printf("goals reached: %llu when they look ahead, %llu when they fly blind\n",
              static_cast<unsigned long long>(flight.arrivals),
              static_cast<unsigned long long>(blind.arrivals));
  if (argc > 1) write_picture(argv[1], flight.hits);

  print_times("looking ahead", flight.frame_times);
  print_times("flying blind", blind.frame_times);
}
