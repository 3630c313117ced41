#include "app/ranked.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <new>
#include <thread>

#include "app/terminal.hpp"
#include "bondstatic/linear_solver.hpp"
#include "solver/machine.hpp"
#include "solver/petsc_module.hpp"

namespace bondstatic {

namespace {

RankStatus failed(ExitCode code, const std::string& message) {
  return {code, fmt::format("{} {}", red("bondstatic:", stderr), message)};
}

std::vector<std::string> solvers_on_ranks() {
  std::vector<std::string> names;
  for (const SolverInfo& info : available_solvers())
    if (info.on_ranks) names.push_back(info.name);
  return names;
}

std::unique_ptr<Ranks> join(const Launched& launch) {
  std::unique_ptr<Ranks> ranks = petsc_module().join_ranks();
  if (ranks->size() != launch.ranks)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("{} processes were launched, but their MPI knows of {}\n    cure: start them by the "
                    "mpirun of the MPI that the PETSc module was built with",
                    launch.ranks, ranks->size()));
  return ranks;
}

}  // namespace

void say(const RankStatus& status) {
  std::fflush(stdout);
  if (!status.message.empty()) fmt::print(stderr, "{}\n", status.message);
  std::fflush(stderr);
}

RankStatus status_of(const std::function<ExitCode()>& command) {
  try {
    const ExitCode code = command();
    // An answer that did not arrive is no answer.
    if (std::fflush(stdout) != 0 && code == ExitCode::done)
      return failed(ExitCode::internal, "cannot write to standard output");
    return {code, ""};
  } catch (const AgreedError&) {
    throw;
  } catch (const InputError& error) {
    // Each fault begins with its place, as editors expect it.
    return {error.code(), error.what()};
  } catch (const Error& error) {
    return failed(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(ExitCode::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    return failed(ExitCode::internal, fmt::format("internal error: {}", error.what()));
  }
}

ExitCode run_ranked(const Launched& launch, const std::function<ExitCode(Ranks*)>& command) {
  if (launch.rank != 0 && !std::freopen("/dev/null", "w", stdout)) return ExitCode::internal;
  std::unique_ptr<Ranks> ranks;
  const RankStatus joined = status_of([&] {
    ranks = join(launch);
    return ExitCode::done;
  });
  if (joined.code != ExitCode::done) {
    // Without MPI the ranks cannot talk: all see the same, rank 0 says it, and the others give it the time
    // before their end makes the launcher end it, too.
    if (launch.rank == 0)
      say(joined);
    else
      std::this_thread::sleep_for(std::chrono::seconds(2));
    return joined.code;
  }
  RankStatus agreed;
  try {
    agreed = ranks->agree(status_of([&] { return command(ranks.get()); }), say);
  } catch (const AgreedError& error) {
    agreed = {error.code(), error.what()};
  }
  if (launch.rank == 0) say(agreed);
  return agreed.code;
}

void agree(Ranks* ranks) {
  if (!ranks) return;
  const RankStatus agreed = ranks->agree({}, say);
  if (agreed.code != ExitCode::done) throw AgreedError(agreed);
}

void prepare_for_ranks(StaticOptions& options, const Ranks* ranks) {
  if (!ranks) return;
  const std::vector<std::string> names = solvers_on_ranks();
  if (options.solver == "auto") options.solver = names.front();
  if (std::find(names.begin(), names.end(), options.solver) == names.end())
    throw Error(ExitCode::invalid_input,
                fmt::format("the solver {} runs in one process, {} were launched\n    cure: start it without "
                            "mpirun, or choose one of {}",
                            options.solver, ranks->size(), fmt::join(names, ", ")));
  if (options.threads == 0) options.threads = std::max(1, cores_at_hand() / ranks->on_this_machine());
}

void refuse_ranks(const Ranks* ranks, const std::string& command) {
  if (ranks)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("`bondstatic {}` runs in one process, {} were launched\n    cure: start it without "
                    "mpirun; only `bondstatic solve` runs on several",
                    command, ranks->size()));
}

}  // namespace bondstatic
