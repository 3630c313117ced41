#include "python/fracture_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/fracture_options.hpp"
#include "case/toml_text.hpp"
#include "python/node_of.hpp"

namespace bondstatic {

namespace {

constexpr const char* caller = "fracture";

/// The reader of cases knows this of the blocks of a file, which a model has no more.
void check_shared(Draft& draft, const FractureOptions& options) {
  const Model& model = draft.model;
  const auto fault = [&](bool shared, const char* what) {
    if (shared)
      draft.reading.fault(
          {caller, 0, 0},
          fmt::format("{} of no named case would count twice: in the preload and in what scales", what),
          fmt::format("say to which of them it belongs: case = \"{}\" or case = \"{}\"",
                      model.load_cases[std::size_t(options.preload)],
                      model.load_cases[std::size_t(options.pattern)]));
  };
  const auto any = [](const auto& items, auto value) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) {
      return item.load_case == every_case && !(item.*value).isZero(0);
    });
  };
  fault(any(model.loads, &Load::force), "loads");
  fault(any(model.supports, &Support::value), "prescribed motions");
  fault(any(model.strains, &Strain::value), "a strain");
}

}  // namespace

PythonFractureOptions PythonFractureOptions::with(const py::dict& given) const {
  PythonFractureOptions made = *this;
  for (Node& item : node_of(given, caller).items) {
    made.table.items.remove_if([&](const Node& old) { return old.key == item.key; });
    if (item.kind == Node::Kind::real && item.real == HUGE_VAL) continue;
    const std::string key = item.key;
    made.table.set(key, std::move(item));
  }
  return made;
}

PythonFractureOptions fracture_options_of(const Case& given) {
  PythonFractureOptions options;
  std::vector<Fault> faults;
  if (auto root = parse_toml(given.resolved, given.file, faults))
    if (Node* table = root->find("fracture")) options.table = std::move(*table);
  const Place place{caller, 0, 0};  // lines are those of the resolved case, which nobody sees
  options.table.place = place;
  for (Node& item : options.table.items) item.place = item.key_place = place;
  return options;
}

FractureOptions read_for(PythonModel& model, PythonFractureOptions options) {
  options.table.place = {caller, 0, 0};
  FractureOptions read;
  model.edited.ask(caller, [&](Draft& draft) {
    read = read_fracture_options(draft, &options.table, nullptr);
    if (draft.reading.faults.empty() && read.preload >= 0) check_shared(draft, read);
  });
  return read;
}

}  // namespace bondstatic
