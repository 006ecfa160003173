// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/responses.hpp"

#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"
#include "python/bindings/pickling.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

RestitutionLaw law_of(const py::handle& object) {
  if (py::isinstance<ViscoelasticRestitution>(object)) return object.cast<ViscoelasticRestitution>();
  if (py::isinstance<TabulatedRestitution>(object)) return object.cast<TabulatedRestitution>();
  const Doubles number = doubles(object, "restitution");
  if (number.ndim() != 0) {
    throw Error("it is not one number", "restitution",
                "give a number from 0 to 1, a ViscoelasticRestitution or a TabulatedRestitution");
  }
  return ConstantRestitution{*number.data()};
}

TabulatedRestitution tabulated(const ArrayLike& speeds, const ArrayLike& values) {
  const Doubles abscissae = doubles(speeds, "speeds");
  const std::vector<double> at_speeds =
      numbers_of(values, "values", static_cast<std::size_t>(abscissae.size()));
  std::vector<TabulatedRestitution::Point> points;
  for (std::size_t i = 0; i < at_speeds.size(); ++i) {
    points.push_back({abscissae.data()[i], at_speeds[i]});
  }
  return TabulatedRestitution(std::move(points));
}

bool is_bounce(const py::handle& object) {
  return py::isinstance<Bounce>(object) || py::isinstance<ViscoelasticRestitution>(object) ||
         py::isinstance<TabulatedRestitution>(object) || PyNumber_Check(object.ptr()) != 0;
}

// A restitution, whether a number or a law, is a Bounce.
Bounce bounce_of(const py::handle& object) {
  if (!is_bounce(object)) {
    throw Error("it is not a Bounce", "response", "give a Bounce or a coefficient of restitution");
  }
  return py::isinstance<Bounce>(object) ? object.cast<Bounce>() : Bounce({.restitution = law_of(object)});
}

Rule rule_of(const py::handle& object) {
  if (py::isinstance<Merging>(object)) return Merging();
  if (is_bounce(object)) return bounce_of(object);
  throw Error("it is neither a Bounce nor a Merging", "response",
              "give one of these or a coefficient of restitution");
}

std::pair<py::array_t<double>, py::array_t<double>> pair_of(const Vec3& first, const Vec3& second) {
  return {array_of(first), array_of(second)};
}

// Only in a flat box, as a rule, is nothing along z.
bool is_in_plane(const Contact& contact) {
  return contact.position.z == 0 && contact.separation.z == 0 && contact.before.first.z == 0 &&
         contact.before.second.z == 0;
}

std::pair<Vec3, Vec3> vectors_of_both(const Contact& contact, const py::handle& object, const char* name) {
  if (!py::isinstance<py::sequence>(object) || py::len(object) != 2) {
    throw Error("the response did not return two vectors", name,
                "return the velocities of both bodies, as in contact.before, or an Outcome");
  }
  const auto both = py::reinterpret_borrow<py::sequence>(object);
  return {vector_of(both[0], name, is_in_plane(contact)), vector_of(both[1], name, is_in_plane(contact))};
}

std::string text_of(const ConstantRestitution& law) {
  return to_text(law.value);
}
std::string text_of(const ViscoelasticRestitution& law) {
  // It is computed, and may differ from the number given in the last digit.
  constexpr int kDigits = 15;
  const std::string value = rounded_text(law.at(law.speed()), kDigits);
  return CallText("ViscoelasticRestitution").add(value).add("speed", law.speed()).text();
}
std::string text_of(const TabulatedRestitution& law) {
  std::vector<double> speeds;
  std::vector<double> values;
  for (const TabulatedRestitution::Point& point : law.points()) {
    speeds.push_back(point.speed);
    values.push_back(point.value);
  }
  return CallText("TabulatedRestitution").add(speeds).add(values).text();
}

std::string text_of(const Bounce& bounce) {
  const BounceRules& rules = bounce.rules();
  CallText call("Bounce");
  call.add(std::visit([](const auto& law) { return text_of(law); }, rules.restitution));
  if (rules.elastic_below != 0) call.add("elastic_below", rules.elastic_below);
  if (rules.contact_duration != 0) call.add("contact_duration", rules.contact_duration);
  if (rules.settle_under != 0) call.add("settle_under", rules.settle_under);
  if (rules.tangential_restitution) call.add("tangential_restitution", *rules.tangential_restitution);
  return call.text();
}
std::string text_of(const Merging&) {
  return CallText("Merging").text();
}
std::string text_of(const Rule& rule) {
  return std::visit([](const auto& each) { return text_of(each); }, rule);
}

// Of the species, those whose rule differs from that of all others are named.
std::string text_of(const ResponseTable& table) {
  const std::size_t named = table.species();
  const auto others = static_cast<SpeciesId>(named);
  const std::string usual = text_of(table.rule(others, others));
  const std::string usual_wall = text_of(table.wall(others));
  std::string text = "<" + CallText("ResponseTable").add(usual).add(usual_wall).text();
  for (std::size_t a = 0; a < named; ++a) {
    for (std::size_t b = a; b < named; ++b) {
      const std::string rule = text_of(table.rule(static_cast<SpeciesId>(a), static_cast<SpeciesId>(b)));
      if (rule != usual) text += "; species " + to_text(a) + " and " + to_text(b) + ": " + rule;
    }
    const std::string wall = text_of(table.wall(static_cast<SpeciesId>(a)));
    if (wall != usual_wall) text += "; species " + to_text(a) + " and walls: " + wall;
  }
  return text + ">";
}

Outcome outcome_of(const Contact& contact, const py::object& returned) {
  if (py::isinstance<Outcome>(returned)) return returned.cast<Outcome>();
  const auto [first, second] = vectors_of_both(contact, returned, "response");
  return {contact, {first, second}};
}

void bind_contact(py::module_& module) {
  const auto vector = [](auto member) {
    return [member](const Contact& self) { return array_of(self.*member); };
  };
  const auto vectors = [](auto member) {
    return [member](const Contact& self) { return pair_of((self.*member).first, (self.*member).second); };
  };
  const auto both = [](auto first, auto second) {
    return [first, second](const Contact& self) { return std::pair(self.*first, self.*second); };
  };
  py::class_<Contact>(module, "Contact", doc::Contact)
      .def_property_readonly(
          "time", [](const Contact& self) { return self.time.value(); }, "[T]")
      .def_property_readonly(
          "kind",
          [](const Contact& self) -> BodyKind { return py::str(self.is_collision() ? "collision" : "wall"); },
          "'collision' or 'wall'.")
      .def_readonly("first", &Contact::first, doc::Contact_first)
      .def_readonly("second", &Contact::second, doc::Contact_second)
      .def_readonly("feature", &Contact::feature, doc::Contact_feature)
      .def_readonly("triangle", &Contact::triangle, doc::Contact_triangle)
      .def_readonly("group", &Contact::group, doc::Contact_group)
      .def_property_readonly("position", vector(&Contact::position), doc::Contact_position)
      .def_property_readonly("second_position", vector(&Contact::second_position),
                             doc::Contact_second_position)
      .def_property_readonly("separation", vector(&Contact::separation), doc::Contact_separation)
      .def_readonly("reach", &Contact::reach, doc::Contact_reach)
      .def_property_readonly(
          "normal", [](const Contact& self) { return array_of(self.normal()); }, doc::Contact_normal)
      .def_property_readonly(
          "point", [](const Contact& self) { return array_of(self.point()); }, doc::Contact_point)
      .def_property_readonly("radii", both(&Contact::first_radius, &Contact::second_radius),
                             "The radii of both bodies, zero for a wall [L].")
      .def_property_readonly("masses", both(&Contact::first_mass, &Contact::second_mass),
                             "The masses of both bodies, infinite for a wall and a kinematic sphere [M].")
      .def_property_readonly("species", both(&Contact::first_species, &Contact::second_species),
                             "The species of both bodies, zero for a wall.")
      .def_property_readonly(
          "before", vectors(&Contact::before),
          "The velocities of both bodies before the contact [L/T]; of a wall contact the second is the "
          "wall's.")
      .def_property_readonly(
          "after", vectors(&Contact::after),
          "The velocities of both bodies after the contact [L/T]; equal to `before` while the response is "
          "called.")
      .def_property_readonly(
          "spins_before", vectors(&Contact::spins_before),
          "The angular velocities of both bodies before the contact [1/T]; zero for a wall.")
      .def_property_readonly("spins_after", vectors(&Contact::spins_after), doc::Contact_spins_after)
      .def_property_readonly(
          "outcome", [](const Contact& self) -> Typed<"Literal['bounce', 'pass', 'merge']"> {
            return py::str(name_of(self.outcome));
          },
          "'bounce', 'pass' or 'merge'.")
      .def_property_readonly(
          "step",
          [](const Contact& self) {
            return self.step.happens() ? std::optional<StepAttempt>(self.step) : std::nullopt;
          },
          "The step of a potential at which the spheres meet, a StepAttempt; None if they touch.")
      .def_property_readonly(
          "impulse", [](const Contact& self) { return array_of(self.impulse()); }, doc::Contact_impulse)
      .def_property_readonly("normal_speed", &Contact::impact_speed, doc::Contact_impact_speed)
      .def_property_readonly("flight", &Contact::flight, doc::Contact_flight)
      .def("__repr__", [](const Contact& self) {
        return "<hardball.Contact at " + to_text(self.time.value()) + ": sphere " +
               std::to_string(self.first) + (self.is_collision() ? " and sphere " : " and wall ") +
               std::to_string(self.second) + ">";
      });
  py::class_<Outcome>(module, "Outcome", doc::Outcome)
      .def(py::init([](const Contact& contact, const Typed<"Sequence[ArrayLike]">& velocities,
                       const Typed<"Sequence[ArrayLike] | None">& spins, bool merges) {
             const auto [first, second] = vectors_of_both(contact, velocities, "velocities");
             Outcome outcome(contact, {first, second});
             if (!spins.is_none()) {
               const auto [first_spin, second_spin] = vectors_of_both(contact, spins, "spins");
               outcome.spins = {first_spin, second_spin};
             }
             outcome.merges = merges;
             return outcome;
           }),
           py::arg("contact"), py::arg("velocities"), py::arg("spins") = py::none(),
           py::arg("merges") = false,
           "`velocities` [L/T] and `spins` [1/T] of both bodies; the same spins as before if not given.")
      .def("__repr__", [](const Outcome& self) {
        CallText call("Outcome");
        call.add("velocities", std::vector{self.velocities.first, self.velocities.second});
        call.add("spins", std::vector{self.spins.first, self.spins.second});
        if (self.merges) call.add("merges", std::string("True"));
        return "<" + call.text() + ">";
      });
}

}  // namespace

std::optional<ResponseTable> response_table_of(const py::handle& object) {
  if (object.is_none()) return ResponseTable();
  if (py::isinstance<ResponseTable>(object)) return object.cast<ResponseTable>();
  if (py::isinstance<Merging>(object)) return ResponseTable(Merging());
  if (!is_bounce(object)) return std::nullopt;
  const Bounce bounce = bounce_of(object);
  return ResponseTable(bounce, bounce);
}

std::function<Outcome(const Contact&)> response_calling(const Callback& function) {
  return [function](const Contact& contact) {
    const py::gil_scoped_acquire lock;
    return outcome_of(contact, function(contact));
  };
}

void bind_responses(py::module_& module) {
  py::class_<ViscoelasticRestitution>(module, "ViscoelasticRestitution", doc::ViscoelasticRestitution)
      .def(py::init<double, double>(), py::arg("value"), py::arg("speed"),
           doc::ViscoelasticRestitution_ViscoelasticRestitution)
      .def("at", &ViscoelasticRestitution::at, py::arg("speed"), doc::ViscoelasticRestitution_at)
      .def("__repr__", [](const ViscoelasticRestitution& self) { return text_of(self); });
  py::class_<TabulatedRestitution>(module, "TabulatedRestitution", doc::TabulatedRestitution)
      .def(py::init(&tabulated), py::arg("speeds"), py::arg("values"),
           "`values` [1] at `speeds` [L/T], which increase.")
      .def("at", &TabulatedRestitution::at, py::arg("speed"),
           "The coefficient of restitution at an impact speed [L/T].")
      .def("__repr__", [](const TabulatedRestitution& self) { return text_of(self); });
  py::class_<Bounce>(module, "Bounce", doc::Bounce)
      .def(py::init([](const Typed<"float | ViscoelasticRestitution | TabulatedRestitution">& restitution,
                       double elastic_below, double contact_duration, double settle_under,
                       std::optional<double> tangential_restitution) {
             return Bounce({.restitution = law_of(restitution),
                            .elastic_below = elastic_below,
                            .contact_duration = contact_duration,
                            .settle_under = settle_under,
                            .tangential_restitution = tangential_restitution});
           }),
           py::arg("restitution") = 1.0, py::kw_only(), py::arg("elastic_below") = 0.0,
           py::arg("contact_duration") = 0.0, py::arg("settle_under") = 0.0,
           py::arg("tangential_restitution") = py::none(),
           "`restitution` is a number from 0 to 1 or one of the laws of restitution. Impacts slower than "
           "`elastic_below` [L/T] are elastic, and those within `contact_duration` [T] of another: the TC "
           "model. With `settle_under`, the acceleration of gravity [L/T^2], those within a hundredth of "
           "sqrt(d / g) are, so that heaps come to rest; d is the diameter of the smaller sphere. With "
           "`tangential_restitution`, from -1, smooth, to 1, perfectly rough, the spheres spin.")
      .def(pickled<Bounce>())
      .def("__repr__", [](const Bounce& self) { return text_of(self); });
  py::class_<Merging>(module, "Merging", doc::Merging)
      .def(py::init<>())
      .def(pickled<Merging>())
      .def("__repr__", [](const Merging& self) { return text_of(self); });
  py::class_<ResponseTable>(module, "ResponseTable", doc::ResponseTable)
      .def(py::init([](const Typed<"AnyBounce | Merging">& spheres, const AnyBounce& walls) {
             return ResponseTable(rule_of(spheres), bounce_of(walls));
           }),
           py::arg("spheres") = 1.0, py::arg("walls") = 1.0,
           "Starts with one Bounce or Merging for all spheres, and one Bounce for all walls; a coefficient "
           "of restitution is a Bounce.")
      .def(
          "set",
          [](ResponseTable& self, SpeciesId a, SpeciesId b, const Typed<"AnyBounce | Merging">& rule) {
            self.set(a, b, rule_of(rule));
          },
          py::arg("first"), py::arg("second"), py::arg("rule"), "Sets the response of two species.")
      .def(
          "set_wall",
          [](ResponseTable& self, SpeciesId species, const AnyBounce& bounce) {
            self.set_wall(species, bounce_of(bounce));
          },
          py::arg("species"), py::arg("bounce"), doc::ResponseTable_set_wall)
      .def(pickled<ResponseTable>())
      .def("__repr__", [](const ResponseTable& self) { return text_of(self); });
  bind_contact(module);
}

}  // namespace hardball::python
