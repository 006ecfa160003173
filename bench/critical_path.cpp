// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The program critical_path: what each domain of a divided system would do on a processor of its own. For
// each number of domains it prints a line of JSON, which parallel_model.py reads.
//
// The domains run once in turn, and what they tell each other is recorded. Then each of them is run again by
// itself, with what it was told, and timed: no other domain is in the caches then. All is deterministic, so
// that is repeated from the same state, and the time of a step is the median of the repetitions.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/parallel/cluster.hpp"
#include "hardball/parallel/division.hpp"
#include "hardball/parallel/system_size.hpp"
#include "hardball/scenario/make_world.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "hardball/simulation/contact_sums.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/world/curve_order.hpp"

namespace hardball::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRadius = 0.5;

struct Options {
  std::size_t spheres = 0;
  double packing_fraction = 0;
  double equilibration = 0;  // collisions per sphere
  std::vector<std::size_t> domains;
  std::size_t windows = 0;
  std::size_t warm_up = 0;  // windows until the first ones are as long as wanted
  std::size_t repetitions = 0;
  std::uint64_t seed = 0;
  Division division;
};

World make_start(const Options& options) {
  check_positive(options.packing_fraction, "the packing fraction", "--packing-fraction");
  SphereGroup group;
  group.count = options.spheres;
  group.radius = kRadius;
  group.placement = Placement::fcc;
  group.velocity_rule = VelocityRule::temperature;
  group.velocity_scale = 1;
  group.where = "--packing-fraction";
  const double volume = static_cast<double>(options.spheres) * std::numbers::pi / 6;
  Scenario scenario;
  scenario.seed = options.seed;
  scenario.spheres.push_back(group);
  scenario.box.fill({Boundary::periodic, std::cbrt(volume / options.packing_fraction)});
  return make_world(scenario);
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double processor_seconds_of(Work&& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

double sum_of(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

// What the domains do between two moments at which all wait for the slowest.
constexpr std::array<std::string_view, 5> kSteps{"run", "verify", "doubt", "commit", "receive"};

// What domains tell each other in a window, in bytes.
struct Traffic {
  static constexpr std::array<std::string_view, 7> kKinds{"records",  "flights",    "doubts",   "departures",
                                                          "arrivals", "new_owners", "handovers"};
  std::array<std::size_t, kKinds.size()> bytes{};

  // Before windows are committed there are records, flights and doubts in an outbox; after that, the others.
  void note(const Outbox& outbox) {
    const auto bytes_of = [](const auto& elements) { return elements.size() * sizeof(*elements.data()); };
    std::size_t holders = 0;
    for (const Handover& handover : outbox.handovers) holders += bytes_of(handover.holders);
    const std::array<std::size_t, kKinds.size()> sizes{bytes_of(outbox.records),
                                                       bytes_of(outbox.flights),
                                                       bytes_of(outbox.doubts),
                                                       bytes_of(outbox.departures),
                                                       bytes_of(outbox.arrivals),
                                                       bytes_of(outbox.new_owners),
                                                       bytes_of(outbox.handovers) + holders};
    for (std::size_t kind = 0; kind < sizes.size(); ++kind) bytes[kind] += sizes[kind];
  }
};

template <class Phase>
class CriticalPath {
 public:
  // The spheres, equilibrated, in an order that suits one engine.
  explicit CriticalPath(const Options& options) : options_(options), engine_(equilibrated(options)) {
    sums_.tally.begin(engine_.world(), engine_.now());
  }

  void print(std::size_t count) {
    Json json;
    json["spheres"] = options_.spheres;
    json["packing_fraction"] = options_.packing_fraction;
    json["domains"] = count;
    json["halo"] = options_.division.halo;
    json["window"] = options_.division.window;
    json["seed"] = options_.seed;
    json["equilibration"] = options_.equilibration;
    json["warm_up"] = options_.warm_up;
    json["engine"] = kEngineNames[static_cast<std::size_t>(kKind)];
    const ForEach in_turn = [](std::size_t domains, const Function<void(std::size_t)>& work) {
      for (std::size_t domain = 0; domain < domains; ++domain) work(domain);
    };
    Members members(make_members(count), engine_.now(), window_settings(count), in_turn);
    for (std::size_t k = 0; k < count; ++k) members.domain(k).clear_sums(sums_.part());
    for (std::size_t window = 0; window < options_.warm_up; ++window) run_window(members);
    // All frontiers are watched now, and not again: that cannot be repeated alone.
    if (options_.repetitions > 0 && static_cast<double>(windows()) >= kFewestPerWatch)
      throw Error("too many windows to be timed", "--windows", "give 50 at most");
    members.watch_anew();
    run_window(members);
    note_size(members, json);
    const Members start(members, in_turn);
    const Stretch stretch = record(members, json);
    measure(start, stretch, json);
    fmt::print("{}\n", json.dump());
    std::fflush(stdout);
  }

 private:
  using SingleEngine = Engine<CalendarQueue, Phase>;
  using Members = Cluster<SingleEngine, ContactSums>;
  static constexpr EngineKind kKind =
      std::is_same_v<Phase, CellGrid> ? EngineKind::cells : EngineKind::neighbors;

  static SingleEngine make_engine(World world, const PhaseSettings& phase, const Time& now) {
    return SingleEngine(std::move(world), Phase(phase), now, phase.instructions);
  }

  SingleEngine equilibrated(const Options& options) {
    World world = make_start(options);
    phase_.length = choose_length(world, gas_statistics(world, Time(0)), kKind, {}, Time(0));
    world.reorder(order_along_curve(world, Time(0)));
    SingleEngine engine = make_engine(std::move(world), phase_, Time(0));
    const double contacts = options.equilibration * static_cast<double>(options.spheres) / 2;
    engine.run({.contacts = static_cast<std::uint64_t>(contacts)}, [](const Contact&) {});
    const Time now = engine.now();
    World then = engine.world();
    then.reorder(order_along_curve(then, now));
    phase_.length = choose_length(then, gas_statistics(then, now), kKind, {}, now);
    return make_engine(std::move(then), phase_, now);
  }

  SystemSize system_size() const { return SystemSize::of(engine_.world(), engine_.now()); }
  Halo halo() const { return system_size().halo(options_.division); }
  WindowSettings window_settings(std::size_t domains) const {
    return system_size().windows(options_.division, domains);
  }

  std::vector<std::unique_ptr<typename Members::Member>> make_members(std::size_t count) const {
    const World& world = engine_.world();
    std::vector<Vec3> centers;
    for (Slot slot = 0; slot < world.size(); ++slot) centers.push_back(world.position(slot, engine_.now()));
    const Partition partition = Partition::bisection(world.box(), count, centers);
    std::vector<DomainNumber> owners;
    for (const Vec3& center : centers) owners.push_back(partition.domain_at(center));
    std::vector<std::unique_ptr<typename Members::Member>> members;
    const Halo around = halo();
    for (DomainNumber number = 0; number < count; ++number) {
      if (partition.neighbors(number, around.neighborhood()).size() > kMaxNeighbors) {
        throw Error("a domain has more than " + to_text(kMaxNeighbors) + " neighbors", "--domains",
                    "give fewer domains, or more spheres");
      }
      members.push_back(std::make_unique<typename Members::Member>(
          world, owners, engine_.now(), partition, number, around, phase_,
          [this](World part, const PhaseSettings& phase) {
            return make_engine(std::move(part), phase, engine_.now());
          }));
    }
    return members;
  }

  static void open_window(Members& members) {
    members.open_window(1e120, std::numeric_limits<std::uint64_t>::max(), {});
  }
  static void run_window(Members& members) {
    open_window(members);
    members.commit_window();
  }

  void note_size(const Members& members, Json& json) const {
    std::size_t ghosts = 0;
    std::size_t neighbors = 0;
    std::size_t bytes = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
      ghosts += members.domain(k).residents().ghost_count();
      neighbors += members.domain(k).neighbors().size();
      bytes += members.domain(k).memory_bytes();
    }
    const auto per_sphere = [&](std::size_t number) {
      return static_cast<double>(number) / static_cast<double>(options_.spheres);
    };
    json["ghosts_per_sphere"] = per_sphere(ghosts);
    json["neighbors"] = static_cast<double>(neighbors) / static_cast<double>(members.size());
    json["bytes_per_sphere"] = {{"one_engine", per_sphere(engine_.memory_bytes())},
                                {"domains", per_sphere(bytes)}};
  }

  // By domain, and by neighbor.
  using Outboxes = std::vector<std::vector<Outbox>>;
  struct RecordedWindow {
    double end = 0;   // [T]
    Outboxes before;  // it was committed
    Outboxes after;
  };
  struct Stretch {
    double start = 0;  // [T]
    std::vector<RecordedWindow> windows;
    std::uint64_t hash = 0;
  };

  // When the first spheres arrive in a copy, its arrays grow, and are copied.
  static constexpr std::size_t kUnmeasured = 12;
  std::size_t windows() const { return kUnmeasured + options_.windows; }
  double moment_before_measured(const Stretch& stretch) const { return stretch.windows[kUnmeasured - 1].end; }

  static Outboxes inboxes_of(const Members& members, Traffic* traffic) {
    Outboxes inboxes(members.size());
    for (DomainNumber domain = 0; domain < members.size(); ++domain) {
      for (const DomainNumber neighbor : members.domain(domain).neighbors()) {
        inboxes[domain].push_back(members.domain(neighbor).outbox_to(domain));
        if (traffic) traffic->note(inboxes[domain].back());
      }
    }
    return inboxes;
  }

  // Runs on, and keeps what the domains tell each other.
  Stretch record(Members& members, Json& json) const {
    Stretch stretch;
    stretch.start = members.committed();
    Traffic traffic;
    WindowCounters first;
    std::uint64_t contacts = 0;
    std::uint64_t handled = 0;
    double squares = 0;  // of the contacts that a domain has handled in a window, ghosts included
    for (std::size_t window = 0; window < windows(); ++window) {
      const bool is_measured = window >= kUnmeasured;
      if (window == kUnmeasured) first = members.window_counters();
      std::vector<std::uint64_t> before;
      for (std::size_t k = 0; k < members.size(); ++k)
        before.push_back(members.domain(k).engine().counters().collision);
      open_window(members);
      RecordedWindow& recorded = stretch.windows.emplace_back();
      Outboxes before_commit = inboxes_of(members, is_measured ? &traffic : nullptr);
      for (std::size_t k = 0; is_measured && k < members.size(); ++k) {
        const std::uint64_t done = members.domain(k).engine().counters().collision - before[k];
        handled += done;
        squares += static_cast<double>(done) * static_cast<double>(done);
      }
      if (is_measured) contacts += members.open_contacts();
      members.commit_window();
      Outboxes after_commit = inboxes_of(members, is_measured ? &traffic : nullptr);
      recorded.end = members.committed();
      if (options_.repetitions == 0) continue;
      recorded.before = std::move(before_commit);
      recorded.after = std::move(after_commit);
    }
    const WindowCounters& done = members.window_counters();
    const double parts = static_cast<double>(options_.windows * members.size());
    const double mean = static_cast<double>(handled) / parts;
    json["windows"] = options_.windows;
    json["failed"] = done.failed - first.failed;
    json["single_steps"] = done.steps - first.steps;
    json["contacts"] = contacts;
    json["handled_contacts"] = handled;
    json["relative_spread_of_contacts"] = std::sqrt(std::max(squares / parts - mean * mean, 0.0)) / mean;
    for (std::size_t kind = 0; kind < Traffic::kKinds.size(); ++kind) {
      json["bytes_per_window_and_domain"][std::string(Traffic::kKinds[kind])] =
          static_cast<double>(traffic.bytes[kind]) / parts;
    }
    ContactSums sums = sums_.part();
    for (std::size_t k = 0; k < members.size(); ++k) sums.add(members.domain(k).sums());
    stretch.hash = sums.hash.value();
    json["event_log_hash"] = hash_text(stretch.hash);
    return stretch;
  }

  static void lower(std::vector<double>& least, const std::vector<double>& other) {
    for (std::size_t k = 0; k < least.size(); ++k) least[k] = std::min(least[k], other[k]);
  }

  // What a domain has taken, alone on a processor.
  struct Alone {
    std::array<std::vector<double>, kSteps.size()> steps;  // by window
    std::vector<double> engine;                            // which runs with a journal
    std::uint64_t engine_contacts = 0;
    std::vector<double> undo;
    std::vector<double> watch;

    void lower(const Alone& other) {
      for (std::size_t step = 0; step < steps.size(); ++step)
        CriticalPath::lower(steps[step], other.steps[step]);
      CriticalPath::lower(engine, other.engine);
      CriticalPath::lower(undo, other.undo);
      CriticalPath::lower(watch, other.watch);
    }
  };

  void measure(const Members& start, const Stretch& stretch, Json& json) const {
    const double length = (stretch.windows.back().end - moment_before_measured(stretch)) /
                          static_cast<double>(options_.windows);
    json["window_length"] = length;
    json["windows_per_watch"] = windows_per_watch(length);
    std::vector<double> one_engine = seconds_of_one_engine(stretch, false);
    if (options_.repetitions == 0) return;
    std::vector<double> with_journal = seconds_of_one_engine(stretch, true);
    std::vector<Alone> alone;
    ContactSums sums = sums_.part();
    for (std::size_t repetition = 0; repetition < options_.repetitions; ++repetition) {
      lower(one_engine, seconds_of_one_engine(stretch, false));
      lower(with_journal, seconds_of_one_engine(stretch, true));
      for (std::size_t k = 0; k < start.size(); ++k) {
        Alone again = run_alone(start.domain(k), stretch, repetition == 0 ? &sums : nullptr);
        repetition == 0 ? alone.push_back(std::move(again)) : alone[k].lower(again);
      }
    }
    if (sums.hash.value() != stretch.hash) throw std::logic_error("a domain alone has other contacts");
    json["one_engine_seconds"] = sum_of(one_engine);
    json["one_engine_with_journal_seconds"] = sum_of(with_journal);
    note_times(alone, json);
  }

  // As Cluster has it.
  static constexpr double kFewestPerWatch = 64;
  double windows_per_watch(double length) const {
    constexpr double kMost = 1024;
    return std::clamp(window_settings(1).flight / length, kFewestPerWatch, kMost);
  }

  // The time of one engine for each window. Error: its contacts are others than the domains'.
  std::vector<double> seconds_of_one_engine(const Stretch& stretch, bool has_journal) const {
    SingleEngine engine = engine_;
    ContactSums sums = sums_.part();
    engine.run({.until = Time(stretch.start)}, [&](const Contact& contact) { sums.note(contact); });
    std::vector<double> seconds = seconds_of_windows(engine, stretch, sums, has_journal);
    if (sums.hash.value() != stretch.hash) throw std::logic_error("the domains have other contacts");
    return seconds;
  }

  // Of those that are measured.
  std::vector<double> seconds_of_windows(SingleEngine& engine, const Stretch& stretch, ContactSums& sums,
                                         bool has_journal) const {
    std::vector<double> seconds;
    for (const RecordedWindow& window : stretch.windows) {
      seconds.push_back(processor_seconds_of([&] {
        if (has_journal) engine.begin_journal(engine.now());
        engine.run({.until = Time(window.end)}, [&](const Contact& contact) { sums.note(contact); });
        if (has_journal) engine.end_journal();
      }));
    }
    seconds.erase(seconds.begin(), seconds.begin() + kUnmeasured);
    return seconds;
  }

  // Runs a domain once more, with what the others have told it.
  Alone run_alone(const typename Members::Member& start, const Stretch& stretch, ContactSums* sums) const {
    typename Members::Member domain(start);
    Alone alone;
    for (std::size_t window = 0; window < windows(); ++window) {
      const RecordedWindow& recorded = stretch.windows[window];
      const auto pointers = [&](const Outboxes& outboxes) {
        std::vector<const Outbox*> inboxes;
        for (const Outbox& inbox : outboxes[domain.number()]) inboxes.push_back(&inbox);
        return inboxes;
      };
      const std::vector<const Outbox*> before = pointers(recorded.before);
      const std::vector<const Outbox*> after = pointers(recorded.after);
      const auto run = [&] { domain.run(recorded.end, std::numeric_limits<std::uint64_t>::max()); };
      if (window + 1 == kUnmeasured) {
        run();
        alone.undo = {processor_seconds_of([&] { domain.undo(); })};
      }
      double bad = 0;
      const std::array<double, kSteps.size()> seconds{
          processor_seconds_of(run), processor_seconds_of([&] { bad = domain.verify(before, recorded.end); }),
          processor_seconds_of([&] { bad = std::min(bad, domain.doubtful_since(before)); }),
          processor_seconds_of([&] { domain.commit(Time(recorded.end)); }), processor_seconds_of([&] {
            domain.receive(after);
            domain.make_ready();
          })};
      if (bad <= recorded.end) throw std::logic_error("a domain alone is wrong");
      for (std::size_t step = 0; window >= kUnmeasured && step < kSteps.size(); ++step)
        alone.steps[step].push_back(seconds[step]);
    }
    if (sums) sums->add(domain.sums());
    const double length = stretch.windows.back().end - stretch.windows[windows() - 2].end;
    const double horizon = stretch.windows.back().end + length * windows_per_watch(length);
    alone.watch = {processor_seconds_of([&] { domain.watch(horizon); })};
    run_engine_alone(start.engine(), stretch, alone);
    return alone;
  }

  // What ghosts do is soon wrong, but no other work.
  void run_engine_alone(SingleEngine engine, const Stretch& stretch, Alone& alone) const {
    ContactSums sums = sums_.part();
    const std::uint64_t before = engine.counters().collision;
    alone.engine = seconds_of_windows(engine, stretch, sums, true);
    alone.engine_contacts = engine.counters().collision - before;
  }

  void note_times(const std::vector<Alone>& alone, Json& json) const {
    double critical = 0;
    double sum = 0;
    std::vector<std::vector<double>> of_window(options_.windows, std::vector<double>(alone.size()));
    for (std::size_t step = 0; step < kSteps.size(); ++step) {
      double critical_of_step = 0;
      double sum_of_step = 0;
      for (std::size_t window = 0; window < options_.windows; ++window) {
        double most = 0;
        for (std::size_t k = 0; k < alone.size(); ++k) {
          const double seconds = alone[k].steps[step][window];
          most = std::max(most, seconds);
          sum_of_step += seconds;
          of_window[window][k] += seconds;
        }
        critical_of_step += most;
      }
      json["steps"][std::string(kSteps[step])] = {{"critical_seconds", critical_of_step},
                                                  {"sum_seconds", sum_of_step}};
      critical += critical_of_step;
      sum += sum_of_step;
    }
    double waiting_once = 0;
    for (const std::vector<double>& seconds : of_window) waiting_once += std::ranges::max(seconds);
    json["critical_seconds"] = critical;
    json["sum_seconds"] = sum;
    json["critical_seconds_waiting_once_a_window"] = waiting_once;
    double undo = 0;
    double watch = 0;
    double engine = 0;
    double contacts = 0;
    for (const Alone& domain : alone) {
      undo += domain.undo.front();
      watch += domain.watch.front();
      engine += sum_of(domain.engine);
      contacts += static_cast<double>(domain.engine_contacts);
    }
    const auto domains = static_cast<double>(alone.size());
    json["undo_seconds_per_domain"] = undo / domains;
    json["watch_seconds_per_domain"] = watch / domains;
    // Those of windows that are not measured are as many on average.
    json["seconds_per_contact_of_a_domains_engine"] =
        engine / contacts * static_cast<double>(windows()) / static_cast<double>(options_.windows);
  }

  Options options_;
  PhaseSettings phase_;
  SingleEngine engine_;
  ContactSums sums_;
};

template <class Phase>
void print_all(const Options& options) {
  CriticalPath<Phase> path(options);
  for (const std::size_t domains : options.domains) path.print(domains);
}

int parse_and_run(int argument_count, char** arguments) {
  Options options;
  CLI::App app("Equal spheres in domains that work in turn: processor time on the critical path, as JSON.",
               "critical_path");
  app.add_option("--spheres", options.spheres, "How many")->required();
  app.add_option("--packing-fraction", options.packing_fraction, "Their volume over the box's")->required();
  app.add_option("--domains", options.domains, "How many, one number or several")
      ->required()
      ->delimiter(',')
      ->check(CLI::Range(2, 4096));
  app.add_option("--equilibration", options.equilibration, "Collisions per sphere before measuring")
      ->default_val(4);
  app.add_option("--windows", options.windows, "How many are measured")
      ->default_val(20)
      ->check(CLI::PositiveNumber);
  app.add_option("--warm-up", options.warm_up, "Windows before")->default_val(25)->check(CLI::PositiveNumber);
  app.add_option("--repetitions", options.repetitions, "How often they are timed; 0: only counted")
      ->default_val(5);
  app.add_option("--halo", options.division.halo, "Depth of halos, in diameters");
  app.add_option("--window", options.division.window, "Contacts for each sphere in a window");
  app.add_option("--seed", options.seed, "Seed of the random numbers")->default_val(1);
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    // Requests for help are "errors" with exit status 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    throw Error(error.what(), "command line", "see critical_path --help");
  }
  const World start = make_start(options);
  const EngineKind kind = choose_engine(start, gas_statistics(start, Time(0)), {}, Time(0));
  const bool has_lists = kind == EngineKind::neighbors;
  (has_lists ? print_all<NeighborList> : print_all<CellGrid>)(options);
  return 0;
}

}  // namespace
}  // namespace hardball::bench

int main(int argument_count, char** arguments) {
  constexpr int kFailed = 1;
  constexpr int kBadInput = 2;
  const auto complain = [](const std::exception& error) {
    std::fputs("critical_path: ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
  };
  try {
    return hardball::bench::parse_and_run(argument_count, arguments);
  } catch (const hardball::Error& error) {
    complain(error);
    return kBadInput;
  } catch (const std::exception& error) {
    complain(error);
    return kFailed;
  }
}
