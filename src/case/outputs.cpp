#include "case/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/selector.hpp"
#include "io/nearest_name.hpp"
#include "model/middle_third.hpp"

namespace bondstatic {
namespace {

/// Fills in `of` and what it is a quantity of; nothing where there is no such quantity.
std::optional<Quantity::Where> read_quantity(TableReader& block, Output& output) {
  std::vector<std::string> names;
  for (const Quantity& quantity : output_quantities())
    if (std::find(names.begin(), names.end(), quantity.name) == names.end()) names.push_back(quantity.name);
  if (!block.require("of", fmt::format("add of = \"..\", one of: {}", name_list(names)))) return std::nullopt;
  output.of = block.text("of").value_or("");
  std::optional<Quantity::Where> where;
  for (const Quantity& quantity : output_quantities()) {
    if (quantity.name != output.of) continue;
    // The energy of bonds and of the model share a name: a selection tells which is meant.
    const bool global = quantity.where == Quantity::Where::model;
    if (!where || global == !block.has("at")) where = quantity.where;
  }
  if (where || output.of.empty()) return where;
  const std::string nearest = nearest_name(output.of, names);
  block.reading().fault(
      block.place_of("of"),
      fmt::format("of = \"{}\" is no quantity; there are: {}", output.of, name_list(names)),
      nearest.empty() ? "choose one of them" : fmt::format("did you mean \"{}\"?", nearest));
  return std::nullopt;
}

/// The rest of apparent_poisson's specimen: what stands in for `middle` is chosen here, where the whole model
/// is at hand.
void read_middle(Draft& draft, TableReader& block, Output& output) {
  if (block.has("middle")) {
    output.middle = select_particles(draft, block, "middle").value_or(output.middle);
    return;
  }
  if (output.at.empty() || output.base.empty()) return;  // at fault
  output.middle = middle_third(draft.model, output.base, output.at, output.axis);
  if (output.middle.empty())
    draft.reading.fault(block.place(),
                        fmt::format("output \"{}\": no centre lies in the middle third between the platens "
                                    "base and at, where the sides would be measured",
                                    output.name),
                        "add middle = { .. }, the particles whose sides are measured, or check axis");
}

void read_places(Draft& draft, TableReader& block, Quantity::Where where, Output& output) {
  if (where == Quantity::Where::particle)
    output.at = select_particles(draft, block, "at").value_or(output.at);
  if (where == Quantity::Where::bond) output.at = select_bonds(draft, block, "at").value_or(output.at);
  if (output.of == "apparent_young" || output.of == "apparent_poisson") {
    output.at = select_particles(draft, block, "at").value_or(output.at);
    output.base = select_particles(draft, block, "base").value_or(output.base);
    output.axis = block.axis_or("axis", "z");
    if (output.of == "apparent_poisson") read_middle(draft, block, output);
  } else if (where == Quantity::Where::model && block.has("at")) {
    draft.reading.fault(block.place_of("at"), fmt::format("{} is a quantity of the whole model", output.of),
                        "remove at");
  }
}

void read_reduction(TableReader& block, Quantity::Where where, Output& output) {
  if (where == Quantity::Where::model) return;
  const std::vector<std::string> names{"value", "sum", "mean", "max"};
  const std::size_t before = block.reading().faults.size();
  const std::string name = block.choice_or("reduce", "value", names);
  if (block.reading().faults.size() != before) return;
  output.reduce = Output::Reduce(std::find(names.begin(), names.end(), name) - names.begin());
  if (output.reduce == Output::Reduce::value && output.at.size() > 1)
    block.reading().fault(
        block.place_of("at"),
        fmt::format("output \"{}\" is one value, but at selects {}", output.name, output.at.size()),
        "add reduce = \"mean\", \"sum\" or \"max\", or select one");
}

void read_load_case(Draft& draft, TableReader& block, Output& output) {
  const auto& names = draft.model.load_cases;
  if (output.of.starts_with("effective_")) return;  // of all load cases together
  if (const auto name = block.text("case")) {
    output.load_case = *name;
    if (std::find(names.begin(), names.end(), *name) != names.end()) return;
    const std::string nearest = nearest_name(*name, names);
    draft.reading.fault(block.place_of("case"), fmt::format("there is no load case \"{}\"", *name),
                        !nearest.empty()        ? fmt::format("did you mean \"{}\"?", nearest)
                        : names.front().empty() ? "no load or support names a case: remove this key"
                                                : fmt::format("there are: {}", name_list(names)));
  } else if (names.size() > 1) {
    block.require("case", fmt::format("say which of the load cases is meant: {}", name_list(names)));
  } else {
    output.load_case = names.front();
    if (!names.front().empty()) block.set_default("case", Node::of(names.front()));
  }
}

}  // namespace

std::vector<Output> read_outputs(Draft& draft, Node* list) {
  std::vector<Output> outputs;
  for_each_table(draft.reading, list, "outputs", [&](TableReader& block) {
    Output output;
    block.require("name", "add name = \"..\"");
    output.name = block.text("name").value_or("");
    for (const Output& other : outputs)
      if (other.name == output.name && !output.name.empty())
        draft.reading.fault(block.place_of("name"),
                            fmt::format("there is an output \"{}\" already", output.name),
                            "give each output a name of its own");
    const auto where = read_quantity(block, output);
    read_load_case(draft, block, output);
    output.scale = block.number_or("scale", 1, dimension::none);
    output.expected = block.number("expected", dimension::none);
    output.tolerance = block.number_or("tolerance", output.tolerance, dimension::none, Allowed::positive);
    output.source = block.text("source").value_or("");
    if (where) {
      read_places(draft, block, *where, output);
      read_reduction(block, *where, output);
    } else {
      block.accept_any();
    }
    outputs.push_back(output);
  });
  return outputs;
}

}  // namespace bondstatic
