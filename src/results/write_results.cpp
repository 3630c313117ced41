#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bondstatic/results.hpp"
#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "io/vtu_writer.hpp"
#include "results/columns.hpp"
#include "results/load_case_folder.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

std::string prefix_of(const Model& model, const std::string& load_case) {
  const std::string folder = load_case_folder(model, load_case);
  return folder.empty() ? "" : folder + "/";
}

bool stays_inside(const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  for (const fs::path& part : name)
    if (part == "..") return false;
  return true;
}

/// What the summary.json of an earlier run lists; nothing where there is none, or none of ours.
std::vector<std::string> earlier_files(const std::string& folder) {
  std::ifstream stream(fs::path(folder) / "summary.json");
  if (!stream) return {};
  const nlohmann::json summary = nlohmann::json::parse(stream, nullptr, false);
  if (!summary.is_object() || !summary.contains("bondstatic") || !summary.contains("files")) return {};
  std::vector<std::string> names;
  for (const auto& name : summary["files"])
    if (name.is_string() && stays_inside(name.get<std::string>())) names.push_back(name.get<std::string>());
  return names;
}

void write_vtu(OutputFile& file, const Model& model, const State& result,
               const std::vector<Column>& line_data) {
  std::vector<double> points;
  points.reserve(3 * model.particles.size());
  for (const Particle& particle : model.particles)
    points.insert(points.end(), particle.position.begin(), particle.position.end());
  std::vector<Index> lines;
  lines.reserve(2 * model.bonds.size());
  for (const Bond& bond : model.bonds) lines.insert(lines.end(), {bond.a, bond.b});
  write_vtu(file, LineGrid{points, lines, point_data(model, result), line_data});
}

void write_load_case(FileSet& files, const Model& model, const State& result) {
  const std::string prefix = prefix_of(model, result.name);
  write_csv(files.create(prefix + "particles.csv"), particle_columns(model, result));
  const std::vector<Column> bonds = bond_columns(model, result);
  write_csv(files.create(prefix + "bonds.csv"), bonds);
  write_vtu(files.create(prefix + "model.vtu"), model, result, bonds);
}

}  // namespace

std::vector<std::string> result_files(const Model& model) {
  std::vector<std::string> names;
  for (const std::string& load_case : model.load_cases)
    for (const char* name : {"particles.csv", "bonds.csv", "model.vtu"})
      names.push_back(prefix_of(model, load_case) + name);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

void check_result_folder(const Model& model, const std::string& folder) {
  check_writable(folder, result_files(model), earlier_files(folder));
}

void write_results(const Model& model, const RunInfo& run, const StaticSolution& solution,
                   const std::vector<OutputValue>& outputs, const std::string& folder,
                   const std::function<void()>& checkpoint) {
  FileSet files(folder, checkpoint);
  files.supersede(earlier_files(folder));
  for (const State& result : solution.cases) write_load_case(files, model, result);
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json").append(summary_json(model, run, solution, outputs, result_files(model)));
  files.commit();
}

}  // namespace bondstatic
