#include "results/fracture_words.hpp"

#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

template <class Items, class Test>
bool any_in_pattern(const Items& items, Index pattern, Test test) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) {
    return (item.load_case == pattern || item.load_case == every_case) && test(item);
  });
}

}  // namespace

FractureWords fracture_words(const Model& model, const FractureOptions& asked) {
  const auto strains = [](const Strain& strain) { return !strain.value.isZero(0); };
  const auto pushes = [](const Load& load) { return !load.force.head<3>().isZero(0); };
  const auto turns = [](const Load& load) { return !load.force.tail<3>().isZero(0); };
  const auto moves = [](const Support& support) { return !support.value.head<3>().isZero(0); };
  const auto twists = [](const Support& support) { return !support.value.tail<3>().isZero(0); };
  const auto linear = [&] {
    return any_in_pattern(model.loads, asked.pattern, pushes) ||
           any_in_pattern(model.supports, asked.pattern, moves);
  };
  const auto angular = [&] {
    return any_in_pattern(model.loads, asked.pattern, turns) ||
           any_in_pattern(model.supports, asked.pattern, twists);
  };
  if (any_in_pattern(model.strains, asked.pattern, strains))
    return {"stress times volume", "J", "strain", ""};
  if (!linear() && angular()) return {"moment", "N m", "rotation", "rad"};
  return {"load", "N", "displacement", "m"};
}

std::string mode_name(const Model& model, const BrokenBond& broken) {
  const Bond& bond = model.bonds[std::size_t(broken.bond)];
  const auto& strength = model.blocks[std::size_t(bond.block)].strength;
  const StrengthCriterion* criterion = strength ? find_strength_criterion(strength->criterion) : nullptr;
  const auto mode = std::size_t(broken.mode);
  return criterion && broken.mode >= 0 && mode < criterion->modes.size() ? criterion->modes[mode] : "";
}

const char* name_of(FractureControl control) {
  switch (control) {
    case FractureControl::load:
      return "load";
    case FractureControl::displacement:
      return "displacement";
    case FractureControl::event:
      break;
  }
  return "event";
}

const char* name_of(FractureEnd end) {
  switch (end) {
    case FractureEnd::breaks:
      return "breaks";
    case FractureEnd::factor:
      return "factor";
    case FractureEnd::displacement:
      return "displacement";
    case FractureEnd::load_drop:
      return "load drop";
    case FractureEnd::separated:
      return "separated";
    case FractureEnd::unbreakable:
      return "unbreakable";
    case FractureEnd::mechanism:
      return "mechanism";
    case FractureEnd::interrupted:
      break;
  }
  return "interrupted";
}

Index count_breaks(const Fracture& fracture) {
  Index breaks = 0;
  for (const FractureEvent& event : fracture.events) breaks += Index(event.bonds.size());
  return breaks;
}

std::map<std::string, Index> breaks_by_mode(const Model& model, const Fracture& fracture) {
  std::map<std::string, Index> counts;
  for (const FractureEvent& event : fracture.events)
    for (const BrokenBond& broken : event.bonds) ++counts[mode_name(model, broken)];
  return counts;
}

const FractureEvent* peak_of(const Fracture& fracture) {
  const auto less = [](const FractureEvent& a, const FractureEvent& b) { return a.load < b.load; };
  const auto found = std::max_element(fracture.events.begin(), fracture.events.end(), less);
  return found == fracture.events.end() ? nullptr : &*found;
}

const FractureEvent* last_standing(const Fracture& fracture) {
  const auto found = std::find_if(fracture.events.rbegin(), fracture.events.rend(),
                                  [](const FractureEvent& event) { return !std::isnan(event.work); });
  return found == fracture.events.rend() ? nullptr : &*found;
}

}  // namespace bondstatic
