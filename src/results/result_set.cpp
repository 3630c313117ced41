#include "results/result_set.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/csv_writer.hpp"
#include "io/vtu_writer.hpp"
#include "results/columns.hpp"
#include "results/load_case_folder.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

bool stays_inside(const fs::path& name) {
  if (name.empty() || name.is_absolute()) return false;
  for (const fs::path& part : name)
    if (part == "..") return false;
  return true;
}

void write_vtu(OutputFile& file, const Model& model, const State& state,
               const std::vector<Column>& line_data) {
  std::vector<double> points;
  points.reserve(3 * model.particles.size());
  for (const Particle& particle : model.particles)
    points.insert(points.end(), particle.position.begin(), particle.position.end());
  std::vector<Index> lines;
  lines.reserve(2 * model.bonds.size());
  for (const Bond& bond : model.bonds) lines.insert(lines.end(), {bond.a, bond.b});
  write_vtu(file, LineGrid{points, lines, point_data(model, state), line_data});
}

}  // namespace

std::string prefix_of(const Model& model, const std::string& load_case) {
  const std::string folder = load_case_folder(model, load_case);
  return folder.empty() ? "" : folder + "/";
}

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

std::vector<std::string> state_files(const Model& model, const std::string& load_case) {
  std::vector<std::string> names;
  for (const char* name : {"particles.csv", "bonds.csv", "model.vtu"})
    names.push_back(prefix_of(model, load_case) + name);
  return names;
}

void write_state(FileSet& files, const Model& model, const State& state) {
  const std::string prefix = prefix_of(model, state.name);
  write_csv(files.create(prefix + "particles.csv"), particle_columns(model, state));
  const std::vector<Column> bonds = bond_columns(model, state);
  write_csv(files.create(prefix + "bonds.csv"), bonds);
  write_vtu(files.create(prefix + "model.vtu"), model, state, bonds);
}

}  // namespace bondstatic
