#include "case/fracture_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace bondstatic {
namespace {

using Kind = Action::Kind;

constexpr const char* dof_names[6] = {"x", "y", "z", "rx", "ry", "rz"};

std::string name_of(Kind kind) {
  switch (kind) {
    case Kind::hold:
      return "supports";
    case Kind::motion:
      return "prescribed motions";
    case Kind::force:
      return "loads";
    case Kind::strain:
      return "a strain";
  }
  return {};
}

bool belongs_to(Index load_case, Index asked) {
  return load_case == asked || load_case == every_case;
}

std::string shown_case(const Model& model, Index load_case) {
  const std::string& name = model.load_cases[std::size_t(load_case)];
  return name.empty() ? "the load case" : fmt::format("load case \"{}\"", name);
}

/// What names no case belongs to all: it would be there once as preload and once more with the pattern.
void check_shared(Draft& draft, const FractureOptions& options) {
  constexpr int most_faults = 20;
  int faulty = 0;
  const auto& names = draft.model.load_cases;
  for (const Action& action : draft.actions) {
    if (action.kind == Kind::hold || action.load_case != every_case || ++faulty > most_faults) continue;
    draft.reading.fault(
        action.place,
        fmt::format("{} of no named case would count twice: in the preload and in what scales",
                    name_of(action.kind)),
        fmt::format("say to which of them it belongs: case = \"{}\" or case = \"{}\"",
                    names[std::size_t(options.preload)], names[std::size_t(options.pattern)]));
  }
}

/// Which degrees of freedom a load case holds, by particle.
std::map<Index, std::array<bool, 6>> held_in(const Model& model, Index load_case) {
  std::map<Index, std::array<bool, 6>> held;
  for (const Support& support : model.supports) {
    if (!belongs_to(support.load_case, load_case)) continue;
    std::array<bool, 6>& of = held.try_emplace(support.particle).first->second;
    for (std::size_t dof = 0; dof < 6; ++dof) of[dof] = of[dof] || support.fixed[dof];
  }
  return held;
}

void check_held(Draft& draft, Index pattern, Index preload, const Place& place) {
  const Model& model = draft.model;
  const bool named = std::any_of(model.supports.begin(), model.supports.end(), [&](const Support& support) {
    return support.load_case == pattern || support.load_case == preload;
  });
  if (!named) return;  // all are held in both
  auto first = held_in(model, pattern), second = held_in(model, preload);
  for (auto* from : {&first, &second})
    for (const auto& [particle, held] : *from) {
      auto& other = from == &first ? second : first;
      const auto& there = other.try_emplace(particle).first->second;
      for (std::size_t dof = 0; dof < 6; ++dof) {
        if (!held[dof] || there[dof]) continue;
        return draft.reading.fault(
            place,
            fmt::format("particle {} is held along {} in {}, but not in {}",
                        model.particles[std::size_t(particle)].id, dof_names[dof],
                        shown_case(model, from == &first ? pattern : preload),
                        shown_case(model, from == &first ? preload : pattern)),
            fmt::format("hold it in both: values = {{ {} = 0 }} in the one that does not move it",
                        dof_names[dof]));
      }
    }
}

/// One kind of action has a load and a displacement; several together have not.
void check_pattern(Draft& draft, const FractureOptions& options, const Place& place) {
  const Model& model = draft.model;
  const std::string pattern = shown_case(model, options.pattern);
  const Action* first = nullptr;
  for (const Action& action : draft.actions) {
    if (action.kind == Kind::hold || !belongs_to(action.load_case, options.pattern)) continue;
    if (!first) first = &action;
    if (action.kind == first->kind) continue;
    return draft.reading.fault(
        action.place,
        fmt::format("{} scales {} here and {} in line {}: no one load and displacement belong to both",
                    pattern, name_of(action.kind), name_of(first->kind), first->place.line),
        options.preload >= 0
            ? fmt::format("move one of them into the preload: case = \"{}\"",
                          model.load_cases[std::size_t(options.preload)])
            : "put one of them into a load case of its own, and name that as the preload of [fracture]");
  }
  const bool strained = std::any_of(model.strains.begin(), model.strains.end(), [&](const Strain& strain) {
    return belongs_to(strain.load_case, options.pattern);  // of a cell without loads
  });
  if (!first && !strained)
    draft.reading.fault(place, pattern + " has neither loads nor prescribed motions: nothing scales",
                        "give it [[loads]], or [[supports]] with values");
}

}  // namespace

void need_strength(Draft& draft, const Node* bonds, const Place& otherwise) {
  const auto& blocks = draft.model.blocks;
  const auto has_strength = [](const BondBlock& block) { return block.strength.has_value(); };
  if (!draft.bonds_known || std::any_of(blocks.begin(), blocks.end(), has_strength)) return;
  const bool has_blocks = bonds && bonds->is_array() && !bonds->items.empty();
  draft.reading.fault(has_blocks ? bonds->items.front().place : otherwise,
                      "no bonds have a strength: none of them can break",
                      "add strength = { criterion = \"edem-v2\", critical_normal_stress = .., "
                      "critical_shear_stress = .. } to [[bonds]]");
}

void check_fracture_cases(Draft& draft, const FractureOptions& options, const Place& place) {
  const std::size_t before = draft.reading.faults.size();
  if (options.preload >= 0) check_shared(draft, options);
  // Blocks that are at fault are not in the model: of these nothing can be said.
  if (draft.reading.faults.size() != before || !draft.reading.faults.empty()) return;
  check_pattern(draft, options, place);
  if (options.preload >= 0) check_held(draft, options.pattern, options.preload, place);
}

Dimension dimension_of_displacement(const Model& model, Index pattern) {
  bool strained = false, straight = false, turned = false;
  const auto add = [&](const Vector6& acting) {
    straight = straight || !acting.head<3>().isZero(0);
    turned = turned || !acting.tail<3>().isZero(0);
  };
  for (const Strain& strain : model.strains)
    strained = strained || (belongs_to(strain.load_case, pattern) && !strain.value.isZero(0));
  for (const Load& load : model.loads)
    if (belongs_to(load.load_case, pattern)) add(load.force);
  for (const Support& support : model.supports)
    if (belongs_to(support.load_case, pattern)) add(support.value);
  return strained || (turned && !straight) ? dimension::none : dimension::length;
}

}  // namespace bondstatic
