#include <algorithm>

#include "bondstatic/results.hpp"
#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "results/columns.hpp"
#include "results/fracture_plot.hpp"
#include "results/fracture_series.hpp"
#include "results/fracture_words.hpp"
#include "results/grid.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

constexpr const char* history_table = "fracture.csv";
constexpr const char* curve_file = "fracture.svg";

std::vector<std::string> superseded_by_fracture(const std::string& folder) {
  std::vector<std::string> names = earlier_files(folder);
  for (const std::string hidden : {"", "."})
    for (const char* ending : {"", ".new", ".part"})
      names.push_back(hidden + fracture_checkpoint_file + ending);
  return names;
}

void write_history(OutputFile& file, const Model& model, const Fracture& fracture,
                   const FractureRecord& record) {
  std::string text =
      "step,factor,load,displacement,bond,a,b,mode,utilisation,runner_up,released,strain_energy,work,"
      "dissipated,"
      "factor_after,load_after,displacement_after,avalanche";
  for (const HistoryColumn& column : record.outputs) text += ',' + csv_field(column.name);
  file.append(text + '\n');
  for (std::size_t e = 0; e < fracture.events.size(); ++e) {
    const FractureEvent& event = fracture.events[e];
    for (const BrokenBond& broken : event.bonds) {
      const Bond& bond = model.bonds[std::size_t(broken.bond)];
      text = std::to_string(e + 1);
      const auto number = [&](double value) { text += ',' + csv_number(value); };
      for (const double value : {event.factor, event.load, event.displacement}) number(value);
      text += ',' + std::to_string(bond.id);
      for (const Index end : {bond.a, bond.b})
        text += ',' + std::to_string(model.particles[std::size_t(end)].id);
      text += ',' + csv_field(mode_name(model, broken));
      for (const double value :
           {broken.utilisation, event.runner_up, event.released, event.strain_energy, event.work,
            event.dissipated, event.factor_after, event.load_after, event.displacement_after})
        number(value);
      text += ',' + std::to_string(event.avalanche);
      for (const HistoryColumn& column : record.outputs)
        number(e < column.values.size() ? column.values[e] : not_given);
      file.append(text + '\n');
    }
  }
}

}  // namespace

std::vector<std::string> fracture_files(const FractureRecord& record) {
  std::vector<std::string> names{particle_table, bond_table, grid_file, history_table, curve_file};
  for (const std::string& name : series_files(fracture_series(record, ""))) names.push_back(name);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

void check_fracture_folder(const std::string& folder, const FractureRecord& record) {
  sweep_stale_staging(folder);
  const StateSeries series = fracture_series(record, folder);
  std::vector<std::string> names = fracture_files(record);
  names.push_back(series_file(fracture_kind));
  for (const std::string& name : states_in(folder, series)) names.push_back(name);
  check_writable(folder, names, superseded_by_fracture(folder));
  check_states(series, fracture_checkpoint_file);
  remove_other_states(series);
}

void write_fracture(const Model& model, const RunInfo& run, const FractureOptions& asked,
                    const Fracture& fracture, const FractureRecord& record,
                    const std::vector<OutputValue>& outputs, const std::string& folder,
                    const std::function<void()>& checkpoint) {
  const bool goes_on = fracture.end == FractureEnd::interrupted;
  FileSet files(folder, checkpoint, fracture.report.first.threads);
  files.supersede(goes_on ? earlier_files(folder) : superseded_by_fracture(folder));
  const std::vector<Column> more = fracture_columns(model, fracture.last, fracture.break_event);
  write_csv(files.create(particle_table), particle_columns(model, fracture.last));
  std::vector<Column> of_bonds = bond_columns(model, fracture.last);
  of_bonds.insert(of_bonds.end(), more.begin(), more.end());
  write_csv(files.create(bond_table), of_bonds);
  write_grid(files.create(grid_file), model, fracture.last, {}, more);
  write_history(files.create(history_table), model, fracture, record);
  files.create(curve_file).append(plot_svg(fracture_plot(model, run, asked, fracture)));
  adopt_states(files, fracture_series(record, folder));
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json")
      .append(fracture_json(model, run, asked, fracture, outputs, fracture_files(record)));
  files.commit();
  if (!goes_on) remove_other_states(fracture_series({}, folder));
}

}  // namespace bondstatic
