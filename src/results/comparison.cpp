#include "results/comparison.hpp"

#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "results/columns.hpp"
#include "results/grid.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

constexpr const char* step_table = "steps.csv";
constexpr const char* motion_names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
constexpr const char* force_names[] = {"fx", "fy", "fz", "mx", "my", "mz"};

std::vector<std::string> file_names(bool with_bonds, bool with_steps) {
  std::vector<std::string> names{particle_table};
  if (with_bonds) names.push_back(bond_table);
  names.push_back(grid_file);
  if (with_steps) names.push_back(step_table);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

/// run_NAME and difference_NAME of six components.
template <class Static>
void add_run_columns(std::vector<Column>& columns, const std::vector<Vector6>& run,
                     const char* const (&names)[6], Static static_of) {
  const auto count = Index(run.size());
  for (const bool difference : {false, true})
    for (int i = 0; i < 6; ++i)
      columns.push_back({std::string(difference ? "difference_" : "run_") + names[i], count,
                         Column::Numbers<double>([&run, static_of, difference, i](Index row) {
                           const auto at = std::size_t(row);
                           return run[at][i] - (difference ? static_of(at)[i] : 0);
                         })});
}

std::vector<Column> particles_of(const ComparisonResults& results) {
  std::vector<Column> columns;
  for (Column& column : particle_columns(results.model, results.statics))
    if (!column.name.starts_with("reaction")) columns.push_back(std::move(column));
  add_run_columns(columns, results.run.displacement, motion_names,
                  [&](std::size_t p) -> const Vector6& { return results.statics.displacement[p]; });
  return columns;
}

std::vector<Column> run_columns_of_bonds(const ComparisonResults& results) {
  std::vector<Column> columns;
  add_run_columns(columns, results.run.bond_force, force_names,
                  [&](std::size_t k) -> const Vector6& { return results.statics.bonds[k].force; });
  return columns;
}

std::vector<Column> run_vectors(const ComparisonResults& results) {
  const auto vectors = [&](const char* name, int first, bool difference) {
    return Column(name, 3 * Index(results.run.displacement.size()),
                  Column::Numbers<double>([&results, first, difference](Index i) {
                    const auto p = std::size_t(i / 3);
                    const Index component = first + i % 3;
                    return results.run.displacement[p][component] -
                           (difference ? results.statics.displacement[p][component] : 0);
                  }),
                  3);
  };
  return {vectors("run_displacement", 0, false), vectors("run_rotation", 3, false),
          vectors("displacement_difference", 0, true), vectors("rotation_difference", 3, true)};
}

double difference_of(const Comparison& c, const char* field) {
  for (const FieldComparison& one : c.fields)
    if (one.field == field) return one.difference;
  return not_given;
}

std::vector<Column> step_columns(const std::vector<Comparison>& steps) {
  std::vector<Index> step;
  for (const Comparison& c : steps) step.push_back(c.step);
  const auto column = [&](const char* name, auto value) {
    std::vector<double> values;
    for (const Comparison& c : steps) values.push_back(value(c));
    return Column(name, std::move(values));
  };
  return {Column("step", std::move(step)),
          column("displacement", [](const Comparison& c) { return difference_of(c, "displacement"); }),
          column("rotation", [](const Comparison& c) { return difference_of(c, "rotation"); }),
          column("scale", [](const Comparison& c) { return c.fields.front().scale; }),
          column("energy", [](const Comparison& c) { return difference_of(c, "energy"); }),
          column("kinetic", [](const Comparison& c) { return c.unbalance.kinetic; }),
          column("residual", [](const Comparison& c) { return c.unbalance.finite; })};
}

}  // namespace

std::vector<std::string> comparison_files(const ComparisonResults& results) {
  return file_names(!results.run.bond_force.empty(), results.steps.size() > 1);
}

void check_comparison_folder(const std::string& folder, bool with_bonds, bool with_steps) {
  sweep_stale_staging(folder);
  check_writable(folder, file_names(with_bonds, with_steps), earlier_files(folder));
}

void write_comparison(const ComparisonResults& results, const RunInfo& info, const std::string& folder,
                      const std::function<void()>& checkpoint) {
  FileSet files(folder, checkpoint, results.solved.threads);
  files.supersede(earlier_files(folder));
  write_csv(files.create(particle_table), particles_of(results));
  std::vector<Column> of_bonds;
  if (!results.run.bond_force.empty()) {
    of_bonds = run_columns_of_bonds(results);
    std::vector<Column> all = bond_columns(results.model, results.statics);
    all.insert(all.end(), of_bonds.begin(), of_bonds.end());
    write_csv(files.create(bond_table), all);
  }
  write_grid(files.create(grid_file), results.model, results.statics, run_vectors(results), of_bonds);
  if (results.steps.size() > 1) write_csv(files.create(step_table), step_columns(results.steps));
  files.create("case.resolved.toml").append(info.resolved);
  files.create("summary.json").append(comparison_json(results, info, comparison_files(results)));
  files.commit();
}

}  // namespace bondstatic
