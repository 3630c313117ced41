#include "python/model_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bond/parameters.hpp"
#include "case/bond_parameters.hpp"
#include "case/bonds.hpp"
#include "case/cell.hpp"
#include "case/foreign_bonds.hpp"
#include "case/loads.hpp"
#include "case/outputs.hpp"
#include "case/selector.hpp"
#include "case/supports.hpp"
#include "python/node_of.hpp"

namespace bondstatic {

namespace {

/// Positions stand in the tables as a group that lasts for one reading.
class NamedPositions {
 public:
  explicit NamedPositions(Draft& draft) : draft_(draft) {}
  ~NamedPositions() {
    for (const std::string& name : names_) draft_.groups.erase(name);
  }
  NamedPositions(const NamedPositions&) = delete;
  NamedPositions& operator=(const NamedPositions&) = delete;

  void put(Node& table, const std::string& key, const Positions& positions) {
    if (!positions) return;
    names_.push_back("(" + key + ")");
    draft_.groups[names_.back()] = {positions->data(), positions->data() + positions->size()};
    Node selector;
    if (Node* given = table.find(key)) selector = *given;
    selector.place = table.place;
    selector.set("group", Node::of(names_.back()));
    table.set(key, std::move(selector));
  }

 private:
  Draft& draft_;
  std::vector<std::string> names_;
};

/// A list of one block, as the readers of cases want it.
Node list_of(Node block) {
  Node list;
  list.kind = Node::Kind::array;
  list.place = block.place;
  list.items.push_back(std::move(block));
  return list;
}

void expect_load_case(Draft& draft, Node& block) {
  const Node* name = block.find("case");
  if (!name || !name->is_text()) return;
  std::vector<std::string>& names = draft.model.load_cases;
  if (names == std::vector<std::string>{""}) names.clear();
  if (std::find(names.begin(), names.end(), name->text) == names.end()) names.push_back(name->text);
}

Warnings add_block(PythonModel& self, void (*read)(Draft&, Node*), const std::string& caller,
                   const py::dict& given, const Positions& at) {
  Node block = node_of(given, caller);  // beforehand: it runs Python
  return self.edited.edit(caller, [&](Draft& draft) {
    NamedPositions named(draft);
    named.put(block, "at", at);
    expect_load_case(draft, block);
    Node list = list_of(std::move(block));
    read(draft, &list);
  });
}

/// Into the columns of the list.
void add_columns(Draft& draft, const Columns& columns, std::size_t bonds,
                 std::map<std::string, std::vector<double>>& to) {
  for (const auto& [name, values] : columns) {
    if (std::size_t(values.size()) != bonds)
      draft.reading.fault({draft.reading.file, 0, 0},
                          fmt::format("{} has {} values, {} bonds are listed", name, values.size(), bonds),
                          "give one number for all, or one for each bond");
    to[name] = {values.data(), values.data() + values.size()};
  }
}

BondRows listed_rows(Draft& draft, const ForeignModel& bonds, const Columns& columns,
                     const Columns& of_strengths, const BondLaw& law, const std::vector<double>& given,
                     const GivenStrengths* strengths) {
  ForeignModel own = bonds;
  // What another code's file says of strength is its bonds' own where the block asks for it; that the rest is
  // left out has been said when it was read.
  std::erase_if(own.kept_columns, [&](const auto& column) {
    return !strengths || strengths->criterion->find(column.first) < 0;
  });
  for (const auto& column : columns)
    if (law.find(column.first) < 0 && column.first != "contact_point")
      draft.reading.fault({draft.reading.file, 0, 0},
                          fmt::format("{} is no parameter of law {}", column.first, law.name),
                          fmt::format("see bondstatic.laws()[\"{}\"]", law.name));
  add_columns(draft, columns, bonds.bonds.size(), own.bond_columns);
  add_columns(draft, of_strengths, bonds.bonds.size(), own.kept_columns);
  if (!draft.reading.faults.empty()) return {};
  BondRows rows = rows_of_foreign_bonds(draft, draft.reading.file, std::move(own), law, given, strengths)
                      .value_or(BondRows{});
  check_ends(draft, rows);
  return rows;
}

void set_parameters_of(Draft& draft, BondBlock& block, std::size_t bonds, const BondLaw& law, Node& table,
                       const Columns& columns) {
  const auto fault = [&](const std::string& what, const std::string& cure) {
    draft.reading.fault(table.place, what, cure);
  };
  TableReader reader(draft.reading, table, "law " + law.name);
  const std::vector<double> given = read_parameters(reader, law);
  reader.finish();
  const ParameterRules rules = parameter_rules(law);
  std::vector<double> values = block.parameters;
  values.resize(law.parameters.size(), not_given);
  const auto rule_out = [&](std::size_t p) {
    for (const std::size_t other : rules.ruled_out_by(p)) {
      values[other] = not_given;
      block.overrides.erase(other);
    }
  };
  for (std::size_t p = 0; p < given.size(); ++p) {
    if (std::isnan(given[p])) continue;
    rule_out(p);
    block.overrides.erase(p);
    values[p] = given[p];
  }
  for (const auto& [name, own] : columns) {
    const auto p = std::size_t(law.find(name));
    if (std::size_t(own.size()) != bonds)
      return fault(fmt::format("{} has {} values, the block has {} bonds", name, own.size(), bonds),
                   "name the block by block = N, and give one number for all or one for each of its bonds");
    if (const auto row =
            std::find_if(own.data(), own.data() + own.size(), [](double v) { return std::isnan(v); });
        row != own.data() + own.size())
      return fault(fmt::format("{}[{}] = nan must be a number", name, row - own.data()),
                   "give each bond of the block its value");
    rule_out(p);
    block.overrides[p] = {own.data(), own.data() + own.size()};
  }
  BondRows rows;
  rows.a.resize(bonds);
  rows.overrides = block.overrides;
  check_bond_parameters(draft, law, values, rows, [&](Index row, Index) {
    return Place{fmt::format("{}: bond {} of the block", table.place.file, row), 0, 0};
  });
  if (block.overrides.empty()) {
    std::vector<std::string> complaints;
    values = complete_parameters(law, values, complaints);
    for (const std::string& text : complaints) fault(explain(law, text).message, explain(law, text).cure);
  }
  block.parameters = values;
}

}  // namespace

Warnings add_supports(PythonModel& self, const py::dict& given, const Positions& at) {
  return add_block(self, read_supports, "Model.fix", given, at);
}

Warnings add_loads(PythonModel& self, const py::dict& given, const Positions& at) {
  return add_block(self, read_loads, "Model.load", given, at);
}

Warnings add_group(PythonModel& self, const py::dict& given, const Positions& at) {
  return add_block(self, read_groups, "Model.group", given, at);
}

std::pair<Index, Warnings> add_bonds(PythonModel& self, const py::dict& given, const Columns& columns,
                                     const Columns& strengths, bool listed) {
  Index added = 0;
  Node block = node_of(given, "Model.bond");
  auto warnings = self.edited.edit("Model.bond", [&](Draft& draft) {
    TableReader reader(draft.reading, block, "bond()");
    ListedBonds list;
    if (listed) {
      list.gives_stiffness = true;
      for (const std::string& name : stiffness_names)
        list.gives_stiffness &=
            self.listed->bond_columns.contains(name) || columns.contains(name) || block.find(name);
      list.rows = [&](const BondLaw& law, const std::vector<double>& parameters,
                      const GivenStrengths* given_strengths) -> std::optional<BondRows> {
        BondRows rows =
            listed_rows(draft, *self.listed, columns, strengths, law, parameters, given_strengths);
        return draft.reading.faults.empty() ? std::optional(std::move(rows)) : std::nullopt;
      };
    }
    const std::size_t before = draft.model.bonds.size();
    read_bond_block(draft, reader, listed ? &list : nullptr);
    reader.finish();
    added = Index(draft.model.bonds.size() - before);
  });
  return {added, std::move(warnings)};
}

void set_parameters(PythonModel& self, const py::dict& given, const Columns& columns, Index chosen) {
  const std::vector<BondBlock> before = self.edited.model().blocks;
  if (chosen < -1 || chosen >= Index(before.size()))
    throw py::index_error(fmt::format("there is no block {}, the model has {}", chosen, before.size()));
  Node table = node_of(given, "Model.set");
  self.edited.edit("Model.set", [&](Draft& draft) {
    std::vector<std::size_t> bonds(before.size());
    for (const Bond& bond : draft.model.bonds) ++bonds[std::size_t(bond.block)];
    bool taken = false;
    for (std::size_t b = 0; b < before.size(); ++b) {
      const BondLaw& law = *find_bond_law(before[b].law);
      bool takes = true;
      for (const Node& item : table.items) takes &= law.find(item.key) >= 0;
      for (const auto& column : columns) takes &= law.find(column.first) >= 0;
      if (!takes || (chosen >= 0 && Index(b) != chosen)) continue;
      taken = true;
      set_parameters_of(draft, draft.model.blocks[b], bonds[b], law, table, columns);
    }
    if (table.items.empty() && columns.empty())
      draft.reading.fault(table.place, "no parameter is given", "give one by its name: young = 50e9");
    else if (!taken)
      draft.reading.fault(table.place, "no such block of bonds has a law that takes these parameters",
                          "see model.parameters(0), or bondstatic.laws()");
    if (!draft.reading.faults.empty()) draft.model.blocks = before;
  });
}

py::dict parameters_of(const PythonModel& self, Index chosen) {
  const Model& model = self.edited.model();
  if (chosen < 0 || chosen >= Index(model.blocks.size()))
    throw py::index_error(fmt::format("there is no block {}, the model has {}", chosen, model.blocks.size()));
  const BondBlock& block = model.blocks[std::size_t(chosen)];
  const BondLaw& law = *find_bond_law(block.law);
  py::dict parameters;
  for (std::size_t p = 0; p < block.parameters.size(); ++p)
    if (!std::isnan(block.parameters[p])) parameters[py::str(law.parameters[p].name)] = block.parameters[p];
  for (const auto& [p, values] : block.overrides)
    parameters[py::str(law.parameters[p].name)] = taken(std::vector<double>(values));
  return parameters;
}

Output output_of(PythonModel& self, const py::dict& given, const std::map<std::string, Positions>& places) {
  std::vector<Output> outputs;
  Node block = node_of(given, "output");
  self.edited.ask("output", [&](Draft& draft) {
    NamedPositions named(draft);
    for (const auto& [key, positions] : places) named.put(block, key, positions);
    Node list = list_of(std::move(block));
    outputs = read_outputs(draft, &list);
  });
  return outputs.front();
}

void expect_outputs_of(const Model& model, const std::vector<Output>& outputs) {
  const auto where_of = [](const std::string& of) {
    for (const Quantity& quantity : output_quantities())
      if (quantity.name == of) return quantity.where;
    return Quantity::Where::model;
  };
  const auto fits = [](const std::vector<Index>& chosen, std::size_t count) {
    return std::all_of(chosen.begin(), chosen.end(), [&](Index i) { return std::size_t(i) < count; });
  };
  std::vector<Fault> faults;
  for (const Output& output : outputs) {
    const bool of_bonds = where_of(output.of) == Quantity::Where::bond;
    if (fits(output.at, of_bonds ? model.bonds.size() : model.particles.size()) &&
        fits(output.base, model.particles.size()) && fits(output.middle, model.particles.size()))
      continue;
    faults.push_back({{"output", 0, 0},
                      fmt::format("\"{}\" is of another model: this one is smaller", output.name),
                      "ask for it by this model's output()"});
  }
  if (!faults.empty()) throw InputError(faults);
}

void complete_cell(PythonModel& self) {
  if (!self.edited.model().cell) return;
  self.edited.edit("solve", [](Draft& draft) {
    const Model& model = draft.model;
    complete_cell(draft, !model.loads.empty() || !model.strains.empty(), !model.supports.empty());
  });
}

}  // namespace bondstatic
