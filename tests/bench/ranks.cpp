#include "bench/ranks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/packing_case.hpp"
#include "bench/program.hpp"
#include "bench/rates.hpp"

namespace bondstatic::bench {

namespace {

namespace fs = std::filesystem;

constexpr int turns = 3;

const std::vector<std::string> phase_names{"read",   "bonds",      "mechanisms", "analysis",
                                           "set-up", "iterations", "recovery"};

struct Timed {
  std::map<std::string, double> phases;  // seconds
  double whole = 0;                      // seconds, launch included
  double solve_bytes = 0;                // of the largest rank until the answer stands
  double whole_bytes = 0;                // the same, writing included
  Index iterations = 0;

  double rest() const {
    double seconds = whole;
    for (const auto& [name, in_phase] : phases) seconds -= in_phase;
    return seconds;
  }

  // All that is spread over the ranks: rank 0 reads alone, and writing is the disk's.
  double solve() const { return whole - rest() - phases.at("read"); }
};

struct Line {
  std::string solver;
  int ranks;  // 0: without mpirun
  bool written;
  Timed best{};
};

Timed run_once(const Line& line, const fs::path& folder) {
  const fs::path answer = folder / "answer.json", results = folder / "results";
  fs::remove_all(results);
  std::vector<std::string> arguments{"solve", folder / "case.toml", "--solver", line.solver, "--threads", "1",
                                     "--json"};
  if (line.written) arguments.insert(arguments.end(), {"--out", results});
  Where where;
  where.output = answer;
  where.ranks = line.ranks;
  const ProgramRun run = run_program(arguments, where);
  const auto summary = nlohmann::json::parse(std::ifstream(answer));
  Timed timed;
  for (const auto& phase : summary["phases"])
    timed.phases[phase["name"].get<std::string>()] += phase["seconds"].get<double>();
  timed.whole = run.seconds;
  timed.solve_bytes = summary["memory"]["peak_bytes"].get<double>();
  timed.whole_bytes = run.peak_bytes;
  timed.iterations = summary["solver"]["iterations"].get<Index>();
  return timed;
}

std::string name_of(const Line& line) {
  return fmt::format("| {} | {} | {} |", line.solver, std::max(line.ranks, 1), line.written ? "yes" : "no");
}

void print_head(const std::vector<std::string>& more) {
  std::vector<std::string> columns{"solver", "ranks", "written"};
  columns.insert(columns.end(), phase_names.begin(), phase_names.end());
  columns.insert(columns.end(), more.begin(), more.end());
  fmt::print("| {} |\n|", fmt::join(columns, " | "));
  for (std::size_t i = 0; i < columns.size(); ++i) fmt::print("---|");
  fmt::print("\n");
}

void print_seconds(const Line& line) {
  const Timed& timed = line.best;
  fmt::print("{}", name_of(line));
  for (const std::string& name : phase_names) {
    const auto phase = timed.phases.find(name);
    fmt::print(" {} |", phase == timed.phases.end() ? "" : fmt::format("{:.3f}", phase->second));
  }
  fmt::print(" {:.3f} | {:.3f} | {:.3f} | {} | {:.0f} | {:.0f} |\n", timed.rest(), timed.solve(), timed.whole,
             timed.iterations, 1e-6 * timed.solve_bytes, 1e-6 * timed.whole_bytes);
}

void print_ratios(const Line& line, const Line& alone, double triad_ratio) {
  const Timed &one = alone.best, &many = line.best;
  fmt::print("{}", name_of(line));
  for (const std::string& name : phase_names) {
    const auto before = one.phases.find(name), now = many.phases.find(name);
    const bool both = before != one.phases.end() && now != many.phases.end();
    fmt::print(" {} |", both ? fmt::format("{:.2f}", before->second / now->second) : "");
  }
  const double solve = one.solve() / many.solve();
  fmt::print(" {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", one.rest() / many.rest(),
             solve, one.whole / many.whole, triad_ratio, solve / triad_ratio,
             many.solve_bytes / one.solve_bytes, many.whole_bytes / one.whole_bytes);
}

}  // namespace

void compare_ranks(OnRanks asked) {
  if (asked.ranks.empty()) asked.ranks = {2};
  if (asked.solvers.empty()) asked.solvers = {"multigrid", "petsc"};
  std::vector<Line> lines;
  for (const std::string& solver : asked.solvers)
    for (const bool written : {false, true}) {
      lines.push_back({solver, 0, written});
      for (const int ranks : asked.ranks) lines.push_back({solver, ranks, written});
    }

  const fs::path folder = BONDSTATIC_BINARY_DIR "/ranks";
  write_packing_case(folder, asked.particles);
  std::map<int, double> triad;
  for (int turn = 0; turn < turns; ++turn) {
    triad[0] = std::max(triad[0], triad_rate_of_processes(1));
    for (const int ranks : asked.ranks) triad[ranks] = std::max(triad[ranks], triad_rate_of_processes(ranks));
    for (Line& line : lines) {
      const Timed timed = run_once(line, folder);
      fmt::print(stderr, "turn {} of {}: {} {:.1f} s\n", turn + 1, turns, name_of(line), timed.whole);
      if (turn == 0 || timed.whole < line.best.whole) line.best = timed;
    }
  }
  fs::remove_all(folder);

  fmt::print("Seconds, fastest of {} turns, one thread a rank; `solve` is from bonds to recovery:\n\n",
             turns);
  print_head(
      {"writing, launch", "solve", "whole process", "iterations", "MB, largest rank", "MB, writing too"});
  for (const Line& line : lines) print_seconds(line);
  fmt::print("\nTriad: {:.1f} GB/s in one process", 1e-9 * triad[0]);
  for (const int ranks : asked.ranks) fmt::print(", {:.1f} GB/s in {}", 1e-9 * triad[ranks], ranks);
  fmt::print(". Times as fast as one process, memory against it:\n\n");
  print_head({"writing, launch", "solve", "whole process", "triad", "solve / triad", "memory",
              "memory, writing too"});
  for (std::size_t i = 0, alone = 0; i < lines.size(); ++i) {
    if (lines[i].ranks == 0)
      alone = i;
    else
      print_ratios(lines[i], lines[alone], triad[lines[i].ranks] / triad[0]);
  }
}

}  // namespace bondstatic::bench
