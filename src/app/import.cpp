#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/import_report.hpp"
#include "app/interrupt.hpp"
#include "app/status_line.hpp"
#include "case/imported_case.hpp"
#include "formats/write/packing.hpp"
#include "io/checksum.hpp"
#include "io/file_set.hpp"
#include "io/replace_file.hpp"
#include "solver/machine.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_name = "case.toml";
constexpr const char* particles_name = "particles.csv";
constexpr const char* bonds_name = "bonds.csv";
constexpr std::string_view mark = "# Made by bondstatic import ";

/// The first line of an imported case tells later imports that they may replace it: nobody has changed it.
std::string marked(const std::string& text) {
  return fmt::format("{}({:016x}).\n{}", mark, checksum(text), text);
}

/// What an earlier import left in the folder, all of it or nothing. Throws Error where its case was edited.
std::vector<std::string> earlier_import(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_regular_file(folder / case_name, ignored)) return {};
  const std::string text = read_whole_file(folder / case_name).value_or("");
  const std::size_t line_end = text.find('\n');
  if (!text.starts_with(mark) || line_end == std::string::npos) return {};
  if (text != marked(text.substr(line_end + 1)))
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: was changed after its import, so it is not overwritten\n"
                            "    cure: name another folder, or move the file away",
                            (folder / case_name).string()));
  return {particles_name, bonds_name, case_name};
}

std::string origin_of(const std::vector<std::string>& files) {
  std::string names;
  for (const std::string& file : files)
    names += (names.empty() ? "" : ", ") + fs::path(file).filename().string();
  return names;
}

std::vector<std::string> write(const Imported& imported, const fs::path& folder,
                               const std::vector<std::string>& earlier, StatusLine& status) {
  const DeferredInterrupts guard;
  FileSet files(folder, DeferredInterrupts::check, cores_at_hand());
  files.supersede(earlier);
  std::vector<std::string> written;
  const auto create = [&](const char* name) -> OutputFile& {
    status.show(fmt::format("write {}", name));
    written.push_back((folder / name).string());
    return files.create(name);
  };
  write_particle_table(create(particles_name), imported.model);
  if (!imported.model.bonds.empty()) write_bond_table(create(bonds_name), imported.model);
  create(case_name).append(marked(imported_case(imported.model, imported.setup,
                                                {origin_of(imported.files), imported.parallel_bonds > 0})));
  files.commit();
  return written;
}

}  // namespace

ExitCode import_packing(const ImportArguments& arguments) {
  const fs::path folder = arguments.folder;
  const std::vector<std::string> earlier = earlier_import(folder);
  check_writable(folder, {particles_name, bonds_name, case_name}, earlier);

  StatusLine status;
  ImportOptions options;
  options.read.atom_style = arguments.atom_style;
  options.read.bond_columns = arguments.bond_columns;
  options.read.step = arguments.step;
  options.progress = [&](const std::string& file, double part) {
    status.show(fmt::format("read {}", fs::path(file).filename().string()), part);
  };
  const Imported imported = import_files(arguments.files, options);
  status.show("connect");
  ImportReport report{
      imported, packing_facts(imported.model), to_be_filled_in(imported.model, imported.setup), {}};
  report.written = write(imported, folder, earlier, status);
  status.clear();
  fmt::print("{}", arguments.json ? import_json(report) : import_report(report));
  return ExitCode::done;
}

}  // namespace bondstatic
