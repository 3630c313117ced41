#include "app/solve_on_ranks.hpp"

#include <fmt/format.h>

#include <chrono>

#include "app/interrupt.hpp"
#include "app/ranked.hpp"
#include "app/report.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "io/message.hpp"
#include "model/boundary.hpp"
#include "results/ranked_outputs.hpp"
#include "results/ranked_results.hpp"
#include "statics/partners.hpp"
#include "system/bisection.hpp"

namespace bondstatic {

void describe(Archive& archive, StaticOptions& o) {
  archive(o.solver, o.backend_options, o.threads, o.yield_cores, o.tolerance, o.unsupported, o.memory_limit);
}

namespace {

// Supports of one particle that contradict each other would show on one rank alone.
void refuse_contradictions(const Model& model) {
  for (std::size_t c = 0; c < model.load_cases.size(); ++c) boundary_of(model, Index(c));
}

// The model of rank 0 goes in pieces to all, and is no more.
Piece deal_out(Model&& model, Ranks& ranks) {
  std::vector<Vector3> positions;
  for (const Particle& particle : model.particles) positions.push_back(particle.position);
  const Cut cut(model, bisect(positions, ranks.size()), ranks.size());
  const std::string bytes = ranks.scatter([&](int rank) { return packed(cut.piece(rank)); });
  model = {};
  return unpacked<Piece>(bytes);
}

}  // namespace

ExitCode solve_on_ranks(const SolveArguments& arguments, Ranks& ranks) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const bool first = is_first(&ranks);
  StatusLine status;
  const auto show = [&](const std::string& what, double part = -1) {
    if (first) status.show(what, part);
  };
  show("read");
  Case given;
  ModelFacts facts;
  std::vector<BlockResolution> resolution;
  if (first) {
    given = read_case(arguments, arguments.overrides);
    facts = facts_of(given.model);
    if (!arguments.folder.empty()) check_result_folder(facts, arguments.folder, ranks.size());
    refuse_contradictions(given.model);
    resolution = resolution_of(given.model);
  }
  agree(&ranks);
  StaticOptions options = unpacked<StaticOptions>(ranks.broadcast(packed(given.solve)));
  prepare_for_ranks(options, &ranks);
  options.progress = [&](const std::string& phase) { show(phase); };
  agree(&ranks);
  show("deal out");
  const Piece piece = deal_out(std::move(given.model), ranks);
  const double reading = std::chrono::duration<double>(Clock::now() - begin).count();

  const auto whole = [&] { return read_case(arguments, arguments.overrides).model; };
  Answer result{solve_statics(Partners{piece, ranks, whole}, options), {}, resolution};
  StaticSolution& solution = result.solution;
  agree(&ranks);
  result.outputs = evaluate_outputs_on_ranks(given.outputs, piece, solution, ranks);
  agree(&ranks);
  const auto largest = largest_displacements_on_ranks(piece, solution, ranks);
  agree(&ranks);
  solution.report.phases.insert(solution.report.phases.begin(), {"read", reading});

  const RunInfo run{given.title, given.file, given.resolved, given.si, given.warnings, result.resolution};
  std::vector<std::string> files;
  if (!arguments.folder.empty()) {
    show("write");
    const DeferredInterrupts guard;
    write_results_on_ranks(piece, facts, run, solution, result.outputs, arguments.folder, ranks,
                           DeferredInterrupts::check, [&](double part) { show("write", part); });
    agree(&ranks);
    files = result_files(facts, ranks.size());
  }
  status.clear();
  if (!first) return ExitCode::done;
  fmt::print("{}", arguments.json ? summary_json(facts, run, solution, largest, result.outputs, files)
                                  : report(given, facts, result, largest, arguments.folder, files));
  return ExitCode::done;
}

}  // namespace bondstatic
