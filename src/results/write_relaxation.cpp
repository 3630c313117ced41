#include <cmath>

#include "bondstatic/results.hpp"
#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"
#include "results/relaxation_series.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

std::string history_file(const Model& model, const std::string& load_case) {
  return prefix_of(model.load_cases, load_case) + "history.csv";
}

std::vector<std::string> superseded_by_relaxation(const std::string& folder) {
  std::vector<std::string> names = earlier_files(folder);
  names.push_back(checkpoint_file);
  // What a kill may leave of replace_file(), which nobody calls once the run is at rest.
  for (const char* ending : {".new", ".part"}) names.push_back(std::string(".") + checkpoint_file + ending);
  return names;
}

}  // namespace

std::vector<std::string> relaxation_files(const Model& model, const Relaxation& relaxation) {
  std::vector<std::string> names;
  for (const std::string& load_case : model.load_cases) {
    for (const std::string& name : state_files(model.load_cases, load_case)) names.push_back(name);
    names.push_back(history_file(model, load_case));
  }
  for (const RelaxedCase& relaxed : relaxation.cases)
    for (const std::string& name :
         series_files(relaxation_series(model, relaxed.state.name, relaxed.saved, "")))
      names.push_back(name);
  names.insert(names.end(), {"case.resolved.toml", "summary.json"});
  return names;
}

void check_relaxation_folder(const Model& model, const RelaxOptions& asked, const std::string& folder) {
  sweep_stale_staging(folder);
  std::vector<std::string> names = relaxation_files(model);
  if (!std::isnan(asked.save_interval))
    for (const std::string& load_case : model.load_cases) {
      const StateSeries series = relaxation_series(model, load_case, {}, folder);
      names.push_back(series.prefix + series_file(series.kind));
      for (const std::string& name : states_in(folder, series)) names.push_back(name);
    }
  check_writable(folder, names, superseded_by_relaxation(folder));
}

void write_relaxation(const Model& model, const RunInfo& run, const Relaxation& relaxation,
                      const std::vector<OutputValue>& outputs, const std::string& folder,
                      const std::function<void()>& checkpoint) {
  FileSet files(folder, checkpoint, relaxation.threads);
  files.supersede(relaxation.at_rest() ? superseded_by_relaxation(folder) : earlier_files(folder));
  for (const RelaxedCase& relaxed : relaxation.cases) {
    write_state(files, model, relaxed.state);
    std::vector<Column> columns;
    for (const HistoryColumn& column : relaxed.history) columns.push_back({column.name, column.values});
    write_csv(files.create(history_file(model, relaxed.state.name)), columns);
    adopt_states(files, relaxation_series(model, relaxed.state.name, relaxed.saved, folder));
  }
  files.create("case.resolved.toml").append(run.resolved);
  files.create("summary.json")
      .append(relaxation_json(model, run, relaxation, outputs, relaxation_files(model, relaxation)));
  files.commit();
  if (relaxation.at_rest()) keep_shown_relaxation(model, {}, folder);
}

}  // namespace bondstatic
