#include "bondstatic/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "case/bonds.hpp"
#include "case/calibration.hpp"
#include "case/cell.hpp"
#include "case/dynamic_options.hpp"
#include "case/fracture_options.hpp"
#include "case/load_cases.hpp"
#include "case/loads.hpp"
#include "case/outputs.hpp"
#include "case/overrides.hpp"
#include "case/particles.hpp"
#include "case/selector.hpp"
#include "case/solve_options.hpp"
#include "case/supports.hpp"
#include "case/toml_text.hpp"
#include "io/text_file.hpp"

namespace bondstatic {
namespace {

/// The case file first, then the files it names; each from top to bottom.
[[noreturn]] void throw_sorted(std::vector<Fault> faults, const std::string& case_file) {
  const auto order = [&](const Fault& fault) {
    return std::tuple(fault.place.file != case_file, fault.place.file, fault.place.line, fault.place.column);
  };
  std::stable_sort(faults.begin(), faults.end(),
                   [&](const Fault& left, const Fault& right) { return order(left) < order(right); });
  throw InputError(std::move(faults));
}

Node read_tree(const std::string& file, const std::vector<std::string>& overrides) {
  std::vector<Fault> faults;
  std::optional<Node> root;
  if (const auto text = read_text_file(file, {file, 0, 0}, faults)) root = parse_toml(*text, file, faults);
  if (root) {
    root->place = {file, 1, 1};
    apply_overrides(*root, overrides, faults);
  }
  if (!faults.empty()) throw_sorted(std::move(faults), file);
  return std::move(*root);
}

/// Absent tables are made where the run rests on them, so that the resolved case shows their defaults.
void add_table(Node& root, TableReader& top, const std::string& name) {
  if (top.has(name)) return;
  Node table;
  table.place = root.place;
  root.set(name, std::move(table));
}

RelaxOptions read_relax_options(Reading& reading, Node& root, TableReader& top) {
  for (const char* name : {"dynamics", "check"})
    if (reading.purpose == Purpose::dynamics) add_table(root, top, name);
  RelaxOptions options;
  if (Node* dynamics = top.find("dynamics")) options = read_dynamic_options(reading, *dynamics);
  if (Node* check = top.find("check")) options.check_tolerance = read_check_tolerance(reading, *check);
  return options;
}

}  // namespace

Case read_case(const std::string& file, const std::vector<std::string>& overrides,
               const std::string& resolved_folder, Purpose purpose, int threads) {
  Node root = read_tree(file, overrides);
  Draft draft;
  draft.reading.file = file;
  draft.reading.folder = std::filesystem::path(file).parent_path();
  draft.reading.resolved_folder = resolved_folder;
  draft.reading.purpose = purpose;

  TableReader top(draft.reading, root, "the case");
  Case out;
  out.file = file;
  out.title = top.text("title").value_or("");
  add_table(root, top, "solve");
  out.solve = read_solve_options(draft.reading, *top.find("solve"));
  draft.reading.threads = out.solve.threads > 0 ? std::min(threads, out.solve.threads) : threads;
  out.relax = read_relax_options(draft.reading, root, top);
  read_cell(draft, top.find("cell"));
  read_particles(draft, top.find("particles"));
  read_groups(draft, top.find("groups"));
  read_bonds(draft, top.find("bonds"));
  collect_load_cases(draft, top.find("loads"), top.find("supports"));
  read_supports(draft, top.find("supports"));
  read_loads(draft, top.find("loads"));
  complete_cell(draft, top.has("loads"), top.has("supports"));
  out.outputs = read_outputs(draft, top.find("outputs"));
  if (top.has("calibration")) out.calibration = read_calibration_plan(draft, root, out.outputs);
  if (purpose == Purpose::fracture) add_table(root, top, "fracture");
  out.fracture = read_fracture_options(draft, top.find("fracture"), top.find("bonds"));
  top.finish();

  if (!draft.reading.faults.empty()) throw_sorted(std::move(draft.reading.faults), file);
  out.model = std::move(draft.model);
  out.warnings = std::move(draft.reading.warnings);
  out.si = draft.reading.si;
  out.resolved = to_toml(root);
  return out;
}

}  // namespace bondstatic
