#include "case/supports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "case/load_cases.hpp"
#include "case/selector.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

const std::vector<std::string>& dof_names() {
  static const std::vector<std::string> names{"x", "y", "z", "rx", "ry", "rz"};
  return names;
}

void read_fix(TableReader& block, Support& support) {
  const auto names = block.texts("fix");
  if (!names) return;
  for (const std::string& name : *names) {
    const auto found = std::find(dof_names().begin(), dof_names().end(), name);
    if (name == "all")
      support.fixed.fill(true);
    else if (found != dof_names().end())
      support.fixed[std::size_t(found - dof_names().begin())] = true;
    else
      block.reading().fault(block.place_of("fix"),
                            fmt::format("fix: \"{}\" is no degree of freedom; there are {}, or all", name,
                                        name_list(dof_names())),
                            "write fix = \"all\" or a list such as fix = [\"x\", \"rz\"]");
  }
  if (names->empty())
    block.reading().fault(block.place_of("fix"), "fix is empty", "name what is fixed, or remove the block");
}

void read_values(TableReader& block, Support& support) {
  Node* node = block.find("values");
  if (!node) return;
  TableReader values(block.reading(), *node, "values");
  for (int dof = 0; dof < 6; ++dof) {
    const auto value =
        values.number(dof_names()[std::size_t(dof)], dof < 3 ? dimension::length : dimension::none);
    if (!value) continue;
    support.fixed[std::size_t(dof)] = true;
    support.value[dof] = *value;
  }
  values.finish();
}

/// What is prescribed so far, to find contradictions between blocks.
class Prescribed {
 public:
  /// The block and value that the support contradicts, if any.
  struct Clash {
    int dof;
    double value;
    Place place;
  };
  std::optional<Clash> add(const Support& support, const Place& place) {
    std::optional<Clash> clash;
    for (int dof = 0; dof < 6; ++dof) {
      if (!support.fixed[std::size_t(dof)]) continue;
      std::vector<Entry>& entries = entries_[support.particle * 6 + dof];
      for (const Entry& entry : entries) {
        const bool together = entry.load_case == every_case || support.load_case == every_case ||
                              entry.load_case == support.load_case;
        if (together && entry.value != support.value[dof] && !clash)
          clash = Clash{dof, entry.value, entry.place};
      }
      entries.push_back({support.load_case, support.value[dof], place});
    }
    return clash;
  }

 private:
  struct Entry {
    Index load_case;
    double value;
    Place place;
  };
  std::unordered_map<Index, std::vector<Entry>> entries_;
};

}  // namespace

void read_supports(Draft& draft, Node* list) {
  Prescribed prescribed;
  for_each_table(draft.reading, list, "supports", [&](TableReader& block) {
    const std::size_t before = draft.reading.faults.size();
    const auto at = select_particles(draft, block, "at");
    Support support;
    if (!block.has("fix") && !block.has("values"))
      block.require("fix", "add fix = \"all\" or a list such as [\"x\", \"rz\"], or values = { z = -1e-4 }");
    read_fix(block, support);
    read_values(block, support);
    support.load_case = load_case_of(draft, block);
    if (!at || draft.reading.faults.size() != before) return;

    draft.actions.push_back({support.value.isZero(0) ? Action::Kind::hold : Action::Kind::motion,
                             support.load_case, block.place()});
    bool clashed = false;
    for (const Index particle : *at) {
      support.particle = particle;
      draft.model.supports.push_back(support);
      const auto clash = prescribed.add(support, block.place());
      if (!clash || clashed) continue;
      clashed = true;  // once a block: the others tend to clash in the same way
      draft.reading.fault(
          block.place(),
          fmt::format("particle {}: {} is prescribed {} here and {} in line {}",
                      draft.model.particles[std::size_t(particle)].id, dof_names()[std::size_t(clash->dof)],
                      support.value[clash->dof], clash->value, clash->place.line),
          "prescribe each degree of freedom once in a load case: name different cases, or narrow the "
          "selectors");
    }
  });
}

}  // namespace bondstatic
