// `export`, told as numbered steps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands.hpp"
#include "app/export_report.hpp"
#include "app/export_run.hpp"
#include "app/interrupt.hpp"
#include "app/report.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "io/csv_writer.hpp"
#include "io/nearest_name.hpp"
#include "io/stale_staging.hpp"
#include "results/columns.hpp"
#include "results/result_set.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

constexpr const char* list_file = "export.json";

const ExportFormat& export_format(const std::string& name) {
  std::vector<std::string> names;
  std::string listing;
  for (const ExportFormat& format : export_formats()) {
    if (format.name == name) return format;
    names.push_back(format.name);
    listing += fmt::format("\n      {:<10}{}", format.name, format.description);
  }
  const std::string nearest = nearest_name(name, names);
  throw Error(ExitCode::invalid_input,
              fmt::format("--to {}: there is no such format\n    cure: {}take one of{}", name,
                          nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest), listing));
}

/// -1 where the format takes all of them.
Index chosen_load_case(const Model& model, const ExportArguments& arguments, const ExportFormat& format) {
  const std::vector<std::string>& names = model.load_cases;
  if (arguments.has_load_case) {
    const auto found = std::find(names.begin(), names.end(), arguments.load_case);
    if (found != names.end()) return found - names.begin();
    throw Error(ExitCode::invalid_input,
                fmt::format("--load-case {}: there is no such load case\n    cure: take one of: {}",
                            arguments.load_case, name_list(names)));
  }
  if (names.size() == 1) return 0;
  if (format.all_load_cases && !arguments.relaxed) return -1;
  throw Error(ExitCode::invalid_input,
              fmt::format("the case has {} load cases, an export of this kind holds one\n    cure: add "
                          "--load-case NAME, one of: {}",
                          names.size(), name_list(names)));
}

template <class Item>
void keep_one_load_case(std::vector<Item>& items, Index load_case) {
  std::erase_if(
      items, [&](const Item& item) { return item.load_case != every_case && item.load_case != load_case; });
  for (Item& item : items) item.load_case = every_case;
}

void keep_one_load_case(Model& model, Index load_case) {
  keep_one_load_case(model.supports, load_case);
  keep_one_load_case(model.loads, load_case);
  keep_one_load_case(model.strains, load_case);
  model.load_cases = {model.load_cases[std::size_t(load_case)]};
}

/// So that a shell takes it as one word.
std::string shell_word(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

/// What makes the case the exported model.
std::string options_of(const ExportArguments& arguments) {
  std::string text;
  for (const std::string& change : arguments.solve.overrides) text += " --set " + shell_word(change);
  if (arguments.has_load_case) text += " --load-case " + shell_word(arguments.load_case);
  return text;
}

/// A run needs masses; the state at rest does not depend on them.
void complete_densities(Model& model, std::vector<std::string>& remarks) {
  Index without = 0;
  for (Particle& particle : model.particles)
    if (std::isnan(particle.density)) {
      particle.density = 1;
      ++without;
    }
  if (without > 0)
    remarks.push_back(fmt::format(
        "{} of {} particles have no density in the case: written with 1, which the state at rest does "
        "not depend on.",
        without, model.particles.size()));
}

/// The relaxed state as tables of this project, whatever the format: positions, orientations and what
/// particles and bonds carry. Displacements are called disp_x, not ux: x has them already
/// (formats/table/foreign_table.hpp).
void write_relaxed_tables(const ExportInput& input, FileSet& files, ExportNotes& notes) {
  const Model& model = input.model;
  std::vector<Column> columns = particle_columns(model, *input.state);
  std::erase_if(columns, [](const Column& column) {
    return column.name == "x" || column.name == "y" || column.name == "z";
  });
  for (Column& column : columns)
    if (column.name == "ux" || column.name == "uy" || column.name == "uz")
      column.name = std::string("disp_") + column.name[1];
  const auto count = Index(model.particles.size());
  const auto add = [&](const std::string& name, const std::function<double(std::size_t)>& value) {
    columns.push_back(
        {name, count, Column::Numbers<double>([value](Index p) { return value(std::size_t(p)); })});
  };
  for (const int i : {0, 1, 2})
    add({"xyz"[i]}, [&input, i](std::size_t p) { return relaxed_position(input, p)[i]; });
  add("qw", [&](std::size_t p) { return relaxed_orientation(input, p).w(); });
  for (const int i : {0, 1, 2})
    add({'q', "xyz"[i]}, [&input, i](std::size_t p) { return relaxed_orientation(input, p).vec()[i]; });
  write_csv(create(files, notes, "relaxed_particles.csv"), columns);
  write_csv(create(files, notes, "relaxed_bonds.csv"), bond_columns(model, *input.state));
}

}  // namespace

ExitCode export_case(const ExportArguments& arguments) {
  // 1. What is asked for, before any work.
  const ExportFormat& format = export_format(arguments.to);
  const std::string& folder = arguments.solve.folder;
  StatusLine status;
  status.show("read");
  Case given = read_case(arguments.solve, arguments.solve.overrides);
  const Index load_case = chosen_load_case(given.model, arguments, format);
  if (load_case >= 0) keep_one_load_case(given.model, load_case);
  sweep_stale_staging(folder);
  check_writable(folder, {list_file}, earlier_files(folder, list_file));

  // 2. Bonds, the state at rest, and the numbers of a run.
  const int threads = given.solve.threads > 0 ? given.solve.threads : cores_at_hand();
  std::vector<std::string> remarks;
  if (const auto& blocks = given.model.blocks;
      std::any_of(blocks.begin(), blocks.end(), [](const BondBlock& b) { return b.strength.has_value(); }))
    remarks.push_back("Strengths of bonds are not written: the exported bonds never break.");
  if (format.needs_run) complete_densities(given.model, remarks);
  const std::vector<BondProperties> properties = bond_properties(given.model, threads);
  StaticSolution solution;
  if (format.needs_run || arguments.relaxed) {
    StaticOptions options = given.solve;
    options.progress = [&](const std::string& phase) { status.show(phase); };
    solution = solve_statics(given.model, options);
    for (const std::string& warning : solution.report.warnings) remarks.push_back(warning);
  }
  ExportInput input{.model = given.model, .properties = properties};
  input.title = given.title;
  input.case_file = std::filesystem::absolute(given.file).string();
  if (input.case_file.find_first_of(" \t'\"$&;()*?<>|\\`#!") != std::string::npos)
    input.case_file = shell_word(input.case_file);
  input.case_options = options_of(arguments);
  input.si = given.si;
  input.state = solution.cases.empty() ? nullptr : &solution.cases.front();
  input.relaxed = arguments.relaxed;
  input.drop_unsupported = given.solve.unsupported == Unsupported::drop;
  if (format.needs_run) {
    status.show("time step");
    const RunNumbers run =
        run_numbers(given.model, properties, *input.state, given.relax, threads_worth_having(threads));
    input.time_step = run.time_step;
    input.steps = run.steps;
    input.particle_damping = run.particle_damping;
    remarks.insert(remarks.end(), run.remarks.begin(), run.remarks.end());
  }

  // 3. All files, or none.
  status.show("write");
  ExportAnswer answer{given,  format.name,       load_case < 0 ? "" : given.model.load_cases.front(),
                      folder, arguments.relaxed, {}};
  {
    const DeferredInterrupts guard;
    FileSet files(folder, DeferredInterrupts::check, threads);
    files.supersede(earlier_files(folder, list_file));
    answer.notes.remarks = std::move(remarks);
    format.write(input, files, answer.notes);
    if (arguments.relaxed) write_relaxed_tables(input, files, answer.notes);
    answer.notes.files.push_back(list_file);
    files.create(list_file).append(export_json(answer));
    files.commit();
  }
  status.clear();
  fmt::print("{}", arguments.solve.json ? export_json(answer) : export_report(answer));
  return ExitCode::done;
}

}  // namespace bondstatic
