#include "case/fracture_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/fracture_cases.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

constexpr Index unknown = -2;

/// The load case that a key names; `unknown` and a fault where there is none of that name, every_case where
/// the key is absent.
Index read_case_name(Draft& draft, TableReader& fracture, const std::string& key) {
  if (!fracture.has(key)) return every_case;
  const auto name = fracture.text(key);
  if (!name) return unknown;
  const auto& names = draft.model.load_cases;
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found != names.end() && !name->empty()) return found - names.begin();
  const bool nameless = names == std::vector<std::string>{""};
  const std::string nearest = nearest_name(*name, names);
  draft.reading.fault(
      fracture.place_of(key),
      nameless ? fmt::format("{} = \"{}\", but the case names no load case", key, *name)
               : fmt::format("{} = \"{}\" is no load case; there are: {}", key, *name, name_list(names)),
      nameless          ? fmt::format("name it in its loads and supports: case = \"{}\"", *name)
      : nearest.empty() ? "choose one of them"
                        : fmt::format("did you mean \"{}\"?", nearest));
  return unknown;
}

/// The only case beside the preload, where none is named.
Index only_pattern(Draft& draft, TableReader& fracture, Index preload) {
  const auto& names = draft.model.load_cases;
  std::vector<std::string> others;
  Index found = unknown;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Index(i) == preload) continue;
    others.push_back(names[i]);
    found = Index(i);
  }
  if (others.size() == 1) {
    if (!others.front().empty()) fracture.set_default("pattern", Node::of(others.front()));
    return found;
  }
  if (others.empty())
    draft.reading.fault(fracture.place_of("preload"),
                        fmt::format("{} is the only load case: nothing is left to scale", names.front()),
                        "give what scales a load case of its own: case = \"pattern\"");
  else
    draft.reading.fault(
        fracture.place(),
        fmt::format("[fracture] does not say which load case scales; there are: {}", name_list(others)),
        fmt::format("add pattern = \"{}\", or another of them", others.front()));
  return unknown;
}

void read_cases(Draft& draft, TableReader& fracture, FractureOptions& options) {
  const Index preload = read_case_name(draft, fracture, "preload");
  Index pattern = read_case_name(draft, fracture, "pattern");
  if (pattern == every_case && preload != unknown) pattern = only_pattern(draft, fracture, preload);
  if (pattern >= 0 && pattern == preload)
    draft.reading.fault(
        fracture.place_of("pattern"),
        fmt::format("pattern and preload are both \"{}\"", draft.model.load_cases[std::size_t(pattern)]),
        "one load case stays, another scales; leave preload out where there is none");
  options.pattern = std::max<Index>(pattern, 0);
  options.preload = std::max<Index>(preload, -1);
}

double read_part(TableReader& fracture, const char* key, double fallback, bool with_zero, bool with_one) {
  const double value = fracture.number_or(key, fallback, dimension::none,
                                          with_zero ? Allowed::not_negative : Allowed::positive);
  if (value < 1 || (with_one && value == 1)) return value;
  fracture.reading().fault(fracture.place_of(key),
                           fmt::format("{} = {} must be {} 1", key, value, with_one ? "at most" : "below"),
                           fmt::format("it is a part: write {} = {}", key, fallback));
  return fallback;
}

FractureControl read_control(TableReader& fracture) {
  const std::string control =
      fracture.choice_or("control", "event", std::vector<std::string>{"event", "load", "displacement"});
  return control == "load"           ? FractureControl::load
         : control == "displacement" ? FractureControl::displacement
                                     : FractureControl::event;
}

}  // namespace

FractureOptions read_fracture_options(Draft& draft, Node* table, const Node* bonds) {
  FractureOptions options;
  if (!table) return options;
  const std::size_t before = draft.reading.faults.size();
  TableReader fracture(draft.reading, *table, "[fracture]");
  if (!table->is_table()) return options;
  read_cases(draft, fracture, options);
  const bool cases_known = draft.reading.faults.size() == before;
  options.control = read_control(fracture);
  options.max_breaks = fracture.whole("max_breaks", 1).value_or(options.max_breaks);
  options.max_factor =
      fracture.number("max_factor", dimension::none, Allowed::positive).value_or(options.max_factor);
  const Dimension of_displacement =
      cases_known ? dimension_of_displacement(draft.model, options.pattern) : dimension::length;
  options.max_displacement = fracture.number("max_displacement", of_displacement, Allowed::positive)
                                 .value_or(options.max_displacement);
  options.load_drop = read_part(fracture, "load_drop", options.load_drop, false, true);
  options.save_every = fracture.whole_or("save_every", options.save_every, 0);
  options.tie = read_part(fracture, "tie", options.tie, true, false);
  fracture.finish();
  if (draft.reading.purpose != Purpose::fracture) return options;
  need_strength(draft, bonds, fracture.place());
  if (cases_known) check_fracture_cases(draft, options, fracture.place_of("pattern"));
  return options;
}

}  // namespace bondstatic
