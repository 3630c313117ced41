#include "results/ranked_results.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "io/csv_writer.hpp"
#include "io/file_set.hpp"
#include "results/all_or_none.hpp"
#include "results/columns.hpp"
#include "results/grid.hpp"
#include "results/owned.hpp"
#include "results/ranked_outputs.hpp"
#include "results/result_set.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

/// A rank's rows of a table on their way into the table; rank 0 begins the table itself.
std::string part_of(const std::string& table, int rank) {
  return rank == 0 ? table : table + ".part" + std::to_string(rank);
}

/// Puts this rank's files where rank 0 finds them.
class Sender {
 public:
  /// `files`: at rank 0, null elsewhere.
  Sender(FileSet* files, fs::path staged, fs::path folder, int rank, Checkpoint checkpoint, int threads)
      : files_(files),
        staged_(std::move(staged)),
        folder_(std::move(folder)),
        checkpoint_(std::move(checkpoint)),
        threads_(threads) {
    if (!fs::is_directory(staged_))
      throw Error(ExitCode::invalid_input,
                  fmt::format("{}: process {} does not see what process 0 writes here\n"
                              "    cure: name a folder on a file system that all machines of the run share",
                              folder_.string(), rank));
  }

  void put(const std::string& name, const std::function<void(OutputFile&)>& write) const {
    if (files_) return write(files_->create(name));
    const fs::path path = staged_ / name;
    fs::create_directories(path.parent_path());
    OutputFile file(path, (folder_ / name).string(), checkpoint_, threads_);
    write(file);
    file.close();
  }

 private:
  FileSet* files_;
  fs::path staged_, folder_;
  Checkpoint checkpoint_;
  int threads_;
};

void put_state(const Sender& sender, const Piece& piece, const State& state, int rank) {
  const std::string prefix = prefix_of(piece.model.load_cases, state.name);
  const auto write_rows = rank == 0 ? write_csv : write_csv_rows;
  sender.put(prefix + part_of(particle_table, rank), [&](OutputFile& file) {
    std::vector<Column> columns = particle_columns(piece.model, state);
    for (Column& column : columns) column.count = piece.own;
    write_rows(file, columns);
  });
  sender.put(prefix + part_of(bond_table, rank), [&](OutputFile& file) {
    const std::vector<Index> owned = owned_bonds(piece);
    const std::vector<Column> all = bond_columns(piece.model, state);
    std::vector<Column> columns;
    for (const Column& column : all) columns.push_back(rows_of(column, owned));
    write_rows(file, columns);
  });
  sender.put(prefix + grid_piece_file(rank), [&](OutputFile& file) { write_grid_piece(file, piece, state); });
}

/// Makes whole what the ranks have left in the staging folder.
void put_together(FileSet& files, const fs::path& staged, const std::string& prefix, int ranks) {
  for (const char* name : {particle_table, bond_table}) {
    OutputFile& table = files.extend(prefix + name);
    for (int rank = 1; rank < ranks; ++rank) {
      const fs::path part = staged / (prefix + part_of(name, rank));
      table.append_file(part);
      fs::remove(part);
    }
  }
  std::vector<std::string> pieces;
  for (int rank = 0; rank < ranks; ++rank) {
    pieces.push_back(grid_piece_file(rank));
    if (rank > 0) files.adopt(prefix + pieces.back());
  }
  write_grid_of_pieces(files.create(prefix + grid_of_pieces_file), pieces);
}

}  // namespace

void write_results_on_ranks(const Piece& piece, const ModelFacts& facts, const RunInfo& run,
                            const StaticSolution& solution, const std::vector<OutputValue>& outputs,
                            const std::string& folder, Ranks& ranks, const std::function<void()>& checkpoint,
                            const std::function<void(double)>& progress) {
  if (ranks.size() == 1)
    return write_results(piece.model, run, solution, outputs, folder, checkpoint, progress);
  const bool first = ranks.rank() == 0;
  // All tables, and the pieces of the grid that this rank writes.
  const double bytes =
      1 + double(facts.load_cases.size()) * (typical_table_bytes(facts.particles, facts.bonds) +
                                             typical_grid_bytes(piece.own, Index(piece.model.bonds.size())));
  std::unique_ptr<FileSet> files;
  const Checkpoint look = [&] {
    if (checkpoint) checkpoint();
    if (progress && files) progress(std::min(1.0, files->bytes() / bytes));
  };
  fs::path staged;
  all_or_none(ranks, [&] {
    if (!first) return;
    files = std::make_unique<FileSet>(folder, look, solution.report.threads);
    files->supersede(earlier_files(folder));
    staged = fs::absolute(files->shared_folder());
  });
  staged = ranks.broadcast(staged.string());

  all_or_none(ranks, [&] {
    const Sender sender(files.get(), staged, folder, ranks.rank(), look, solution.report.threads);
    for (const State& state : solution.cases) put_state(sender, piece, state, ranks.rank());
  });

  const auto largest = largest_displacements_on_ranks(piece, solution, ranks);
  all_or_none(ranks, [&] {
    if (!first) return;
    for (const State& state : solution.cases)
      put_together(*files, staged, prefix_of(facts.load_cases, state.name), ranks.size());
    files->create("case.resolved.toml").append(run.resolved);
    files->create("summary.json")
        .append(summary_json(facts, run, solution, largest, outputs, result_files(facts, ranks.size())));
    files->commit();
  });
}

}  // namespace bondstatic
