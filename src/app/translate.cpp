#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/codes.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "app/translate_report.hpp"
#include "bondstatic/network.hpp"
#include "check/differences.hpp"
#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

/// Written last: a folder that has the summary has a translation, whose files may be replaced.
const std::vector<std::string> files{"bonds.csv", "translation.json"};

std::vector<std::string> replaceable(const std::filesystem::path& folder) {
  std::error_code none;
  return std::filesystem::exists(folder / files.back(), none) ? files : std::vector<std::string>{};
}

bool something_acts(const Model& model) {
  return !model.loads.empty() || !model.strains.empty() ||
         std::any_of(model.supports.begin(), model.supports.end(),
                     [](const Support& support) { return !support.value.isZero(0); });
}

TranslationEffects effects_of(const Case& given, const Translation& translation,
                              const std::function<void(const std::string&)>& progress) {
  const auto solved = [&](const Model& model, const std::string& what) {
    StaticOptions options = given.solve;
    options.progress = [&](const std::string& phase) { progress(what + ": " + phase); };
    return solve_statics(model, options);
  };
  TranslationEffects effects;
  const StaticSolution here = solved(given.model, "as it is");
  effects.outputs = evaluate_outputs(given.model, here, given.outputs);
  for (const State& state : here.cases) effects.load_cases.push_back(state.name);
  const double length = bond_network(given.model, translation.wanted).rotation_length;
  const auto effect = [&](Convention convention, const std::string& what) {
    const Model model = as_realised(given.model, translation, convention);
    const StaticSolution there = solved(model, what);
    ConventionEffect out;
    out.outputs = evaluate_outputs(model, there, given.outputs);
    for (std::size_t c = 0; c < here.cases.size(); ++c)
      out.fields.push_back(differences(here.cases[c], {{&there.cases[c], 1}}, length));
    return out;
  };
  effects.contact_point = effect(Convention::contact_point, "contact point");
  effects.stiffness = effect(Convention::stiffness, "stiffness");
  effects.both = effect(Convention::both, "both");
  return effects;
}

void write(const std::string& folder, const Case& given, const Translation& translation,
           const std::string& json, int threads) {
  const Model& model = given.model;
  const Index bonds = Index(model.bonds.size());
  const auto of_bond = [&](const char* name, auto number) {
    return Column(name, bonds, Column::Numbers<Index>([&model, number](Index k) {
                    return number(model.bonds[std::size_t(k)]);
                  }));
  };
  const auto id_of = [&model](Index particle) { return model.particles[std::size_t(particle)].id; };
  std::vector<Column> columns{of_bond("id", [](const Bond& bond) { return bond.id; }),
                              of_bond("a", [id_of](const Bond& bond) { return id_of(bond.a); }),
                              of_bond("b", [id_of](const Bond& bond) { return id_of(bond.b); })};
  for (std::size_t p = 0; p < translation.stored.size(); ++p)
    columns.emplace_back(translation.code->stored[p].name, bonds,
                         Column::Numbers<double>([&numbers = translation.stored[p]](Index k) {
                           return numbers[std::size_t(k)];
                         }));
  const DeferredInterrupts guard;
  FileSet set(folder, DeferredInterrupts::check, threads);
  set.supersede(replaceable(folder));
  write_csv(set.create(files.front()), columns);
  set.create(files.back()).append(json);
  set.commit();
}

}  // namespace

ExitCode translate(const TranslateArguments& arguments) {
  const BondCode& code = bond_code(arguments.to);
  const std::string& folder = arguments.solve.folder;
  StatusLine status;
  status.show("read");
  const Case given = read_case(arguments.solve, arguments.solve.overrides);
  if (!folder.empty()) {
    sweep_stale_staging(folder);
    check_writable(folder, files, replaceable(folder));
  }
  const int threads = given.solve.threads > 0 ? given.solve.threads : cores_at_hand();
  const Translation translation = translate(given.model, code, threads);
  const std::vector<BlockFit> fits = block_fits(given.model, translation);
  std::optional<TranslationEffects> effects;
  if (something_acts(given.model))
    effects = effects_of(given, translation, [&](const std::string& phase) { status.show(phase); });

  const std::string json = translation_json(given, translation, fits, effects);
  std::vector<std::string> written;
  if (!folder.empty()) {
    status.show("write");
    write(folder, given, translation, json, threads);
    for (const std::string& name : files) written.push_back((std::filesystem::path(folder) / name).string());
  }
  status.clear();
  fmt::print("{}",
             arguments.solve.json ? json : translation_report(given, translation, fits, effects, written));
  return ExitCode::done;
}

}  // namespace bondstatic
