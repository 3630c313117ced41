#include "results/result_set.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/csv_writer.hpp"
#include "io/side_file.hpp"
#include "results/columns.hpp"
#include "results/grid.hpp"
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

}  // namespace

std::string prefix_of(const std::vector<std::string>& load_cases, const std::string& load_case) {
  const std::string folder = load_case_folder(load_cases, load_case);
  return folder.empty() ? "" : folder + "/";
}

std::vector<std::string> earlier_files(const std::string& folder, const char* listed_in) {
  std::ifstream stream(fs::path(folder) / listed_in);
  if (!stream) return {};
  const nlohmann::json summary = nlohmann::json::parse(stream, nullptr, false);
  if (!summary.is_object() || !summary.contains("bondstatic") || !summary.contains("files")) return {};
  std::vector<std::string> names;
  for (const auto& name : summary["files"])
    if (name.is_string() && stays_inside(name.get<std::string>())) names.push_back(name.get<std::string>());
  return names;
}

std::string grid_piece_file(int rank) {
  return "model_" + std::to_string(rank) + ".vtu";
}

std::vector<std::string> state_files(const std::vector<std::string>& load_cases, const std::string& load_case,
                                     int ranks) {
  const std::string prefix = prefix_of(load_cases, load_case);
  std::vector<std::string> names{prefix + particle_table, prefix + bond_table};
  if (ranks == 1) {
    names.push_back(prefix + grid_file);
    return names;
  }
  for (int rank = 0; rank < ranks; ++rank) names.push_back(prefix + grid_piece_file(rank));
  names.push_back(prefix + grid_of_pieces_file);
  return names;
}

void write_state(FileSet& files, const Model& model, const State& state) {
  const std::string prefix = prefix_of(model.load_cases, state.name);
  // Tables are much to compute, a grid is much to write.
  SideFile grid(files, prefix + grid_file, [&](OutputFile& file) { write_grid(file, model, state); });
  write_csv(files.create(prefix + particle_table), particle_columns(model, state));
  write_csv(files.create(prefix + bond_table), bond_columns(model, state));
  grid.finish();
}

// Some 18 characters a number in a table.
double typical_table_bytes(Index particles, Index bonds) {
  return 18.0 * (17 * double(particles) + 15 * double(bonds));
}

double typical_grid_bytes(Index particles, Index bonds) {
  return 8.0 * (24 * double(particles) + 20 * double(bonds));
}

}  // namespace bondstatic
