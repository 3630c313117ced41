#include "formats/import_files.hpp"

#include <fmt/format.h>

#include "formats/lammps/apply_script.hpp"

namespace bondstatic {
namespace {

/// Reads all of them, whatever is at fault with the first.
std::vector<ReadFile> read_all(const std::vector<std::pair<std::string, Place>>& paths, ImportOptions options,
                               std::vector<Fault>& faults) {
  std::vector<ReadFile> files;
  for (const auto& [path, named_at] : paths) {
    if (options.progress)
      options.read.progress = [&options, &file = path](double part) { options.progress(file, part); };
    if (auto model = read_foreign_model(path, options.read, named_at, faults))
      files.push_back({path, std::move(*model)});
  }
  return files;
}

/// By its name, unless it is something else by its content: data files are called x.lmp, too.
bool is_script(const std::string& path, const Place& named_at) {
  if (!is_lammps_script_name(path)) return false;
  std::vector<Fault> unread;  // which reading the script tells as well
  const auto format = detect_format(path, named_at, unread);
  return !format || *format == FileFormat::table;
}

void stop_at(const std::vector<Fault>& faults) {
  if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Imported import_files(const std::vector<std::string>& paths, const ImportOptions& options) {
  std::vector<Fault> faults;
  ImportOptions adapted = options;
  std::optional<LammpsScript> script;
  std::vector<std::pair<std::string, Place>> others;
  for (const std::string& path : paths) {
    const Place named_at{path, 0, 0};
    if (!is_script(path, named_at))
      others.emplace_back(path, named_at);
    else if (script)
      faults.push_back({named_at, fmt::format("a second input script, after {}", script->file),
                        "give the one whose model is meant"});
    else
      script = read_lammps_script(path, named_at, faults);
  }
  stop_at(faults);
  Imported imported;
  imported.files = paths;
  if (script) {
    if (adapted.read.atom_style.empty()) adapted.read.atom_style = script->atom_style;
    if (others.empty() && !script->data_file.empty()) {
      others.emplace_back(script->data_file, script->data_place);
      imported.files.push_back(script->data_file);
    }
    if (others.empty())
      faults.push_back({{script->file, 0, 0},
                        "the script reads no data file, so that it has no packing",
                        "give a data file or a dump that LAMMPS wrote beside it"});
  }
  stop_at(faults);
  auto joined = join_models(read_all(others, adapted, faults), faults);
  stop_at(faults);
  if (!joined || joined->model.particles.empty())
    throw InputError({{{paths.empty() ? "" : paths.front(), 0, 0},
                       "no particles are in what was given",
                       "give the file that has them beside that of the bonds"}});
  imported.model = std::move(joined->model);
  imported.parallel_bonds = joined->parallel_bonds;
  if (script)
    if (auto setup = apply_script(*script, imported.model, faults)) imported.setup = std::move(*setup);
  stop_at(faults);
  return imported;
}

}  // namespace bondstatic
