// The static solve beside other processes: how much longer than alone, and how much longer than a fair share
// of the processors would make it. Solves of a second and more, alone and beside the others by turns, so that
// whatever else happens on the machine is the same for both. What a share is worth the scheduler decides: a
// loop without memory or waiting, cut into small pieces for as many threads, goes through the same turns.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "bench/busy.hpp"
#include "bench/packings.hpp"
#include "bench/tables.hpp"
#include "bench/threads.hpp"
#include "bench/timing.hpp"

namespace bondstatic::bench {

namespace {

constexpr int others = 4;
constexpr int turns = 5;

// Where as many threads as there are compete for the cores, each gets its part of them.
double fair_share(int threads) {
  return std::max(1.0, double(threads + others) / machine_cores());
}

// About a second on each of the threads.
void plain_loop(int threads) {
  constexpr int pieces_each = 1000, steps = 250000;
  std::atomic<int> left{pieces_each * threads};
  const auto work = [&left] {
    volatile double x = 1;
    while (left-- > 0)
      for (int i = 0; i < steps; ++i) x = x * 1.0000001 + 1e-9;
  };
  std::vector<std::jthread> team;
  for (int i = 1; i < threads; ++i) team.emplace_back(work);
  work();
}

struct Turns {
  std::vector<double> alone, beside;
  double longer() const { return median(beside) / median(alone); }
};

void print_solver(BusyProcesses& busy, const std::string& solver, Index edge) {
  const Model model = cubic_packing(edge, edge, edge);
  for (const int threads : thread_counts()) {
    const StaticOptions options = on_threads(solver, threads);
    Turns solves, work, loops;
    int used = 0;
    const auto take_turn = [&](std::vector<double> Turns::*side) {
      (work.*side).push_back(processor_seconds_of<CLOCK_PROCESS_CPUTIME_ID>([&] {
        (solves.*side).push_back(seconds_of([&] { used = solve_statics(model, options).report.threads; }));
      }));
      (loops.*side).push_back(seconds_of([&] { plain_loop(threads); }));
    };
    for (int turn = 0; turn < turns; ++turn) {
      busy.pause();
      take_turn(&Turns::alone);
      busy.resume();
      take_turn(&Turns::beside);
    }
    const double longer = solves.longer(), fair = fair_share(threads);
    fmt::print(
        "| {0}x{0}x{0} lattice, {1}, {2}: alone, beside {3} busy processes | {4:.2f} s, {5:.2f} s on {6}: "
        "{7:.2f} "
        "times as long, {8:.2f} of the fair share ({9:.2f}), {10:.2f} of what a plain loop gets ({11:.2f}); "
        "{12:.2f} times the processor time |\n",
        edge, solver, plural(threads), others, median(solves.alone), median(solves.beside), plural(used),
        longer, longer / fair, fair, longer / loops.longer(), loops.longer(), work.longer());
    std::fflush(stdout);
  }
}

}  // namespace

void print_crowded() {
  BusyProcesses busy(others);
  busy.pause();
  print_solver(busy, "cholmod", 21);
  print_solver(busy, "multigrid", 36);
}

}  // namespace bondstatic::bench
