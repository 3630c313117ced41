// The static solve: whole process for the reference cantilever, and a cubic lattice of 8,000 particles
// against the naive version. Ratios are formed within one run.
#include "bondstatic/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/naive.hpp"
#include "bench/program.hpp"
#include "bench/tables.hpp"
#include "bench/threads.hpp"
#include "bench/timing.hpp"
#include "bondstatic/sensitivity.hpp"
#include "support/models.hpp"

namespace bondstatic::bench {
namespace {

// Simple cubic, touching particles, foot held, head pushed down and aside.
Model cubic_lattice(int edge) {
  using namespace bondstatic::test;
  Model model;
  model.blocks = {block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}})};
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z) add_particle(model, 0.4 * Vector3(x, y, z), 0.2);
  const Index steps[3] = {Index(edge) * edge, edge, 1};
  for (Index p = 0; p < Index(model.particles.size()); ++p)
    for (const Index step : steps) {
      const bool last = (p / step) % edge == edge - 1;
      if (last) continue;
      const Vector3 branch =
          model.particles[std::size_t(p + step)].position - model.particles[std::size_t(p)].position;
      model.bonds.push_back(
          {Index(model.bonds.size()) + 1, p, p + step, branch, 0, Index(model.bonds.size())});
    }
  for (Index p = 0; p < Index(model.particles.size()); p += edge) {
    fix_all(model, p);
    load(model, p + edge - 1, vector6(1, 0, -1));
  }
  return model;
}

// Tip of a cantilever of 10,000 bonds against F L^3 / 3EI + 10 F L / 9GA ([Chen2022] Eq. 29).
void print_chain_errors() {
  using namespace bondstatic::test;
  constexpr Index bonds = 10000;
  constexpr double young = 1e10, poisson = 0.25, r = 0.01, length = 1, force = 10;
  Model model = chain(block("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", r}}),
                      Vector3::Zero(), Vector3(length, 0, 0), bonds, 0.5 * length / bonds);
  load(model, bonds, vector6(0, force, 0));
  const double area = std::numbers::pi * r * r, second_moment = area * r * r / 4,
               shear_modulus = young / (2 + 2 * poisson);
  const double tip = force * length * length * length / (3 * young * second_moment) +
                     10 * force * length / (9 * shear_modulus * area);
  const double naive = solve_naively(model)[6 * bonds + 1];
  const double refined = solve_statics(model, {}).cases[0].displacement.back()[1];
  fmt::print("| cantilever of {} bonds, relative error of the tip | {:.1e}; naive version {:.1e} |\n", bonds,
             std::abs(refined / tip - 1), std::abs(naive / tip - 1));
}

double phase_seconds(const StaticReport& report, const std::string& name) {
  for (const Phase& phase : report.phases)
    if (phase.name == name) return phase.seconds;
  return 0;
}

// Returns the seconds of one thread.
double print_solver(const Model& model, const std::string& solver) {
  double on_one = 0;
  for (const int threads : thread_counts()) {
    StaticReport report;
    const double seconds =
        median_seconds(5, [&] { report = solve_statics(model, on_threads(solver, threads)).report; });
    if (threads == 1) on_one = seconds;
    const std::string how =
        report.iterations > 0
            ? fmt::format("{} iterations", report.iterations)
            : fmt::format("factorisation {:.2f} s at {:.1f} Gflop/s", phase_seconds(report, "factorisation"),
                          1e-9 * report.analysis.factor_flops / phase_seconds(report, "factorisation"));
    fmt::print("| 20x20x20 lattice, {} unknowns, {}, {} | {:.2f} s, {} |\n", report.analysis.unknowns, solver,
               plural(threads), seconds, how);
  }
  return on_one;
}

// An evaluation of a calibration: the state and the derivative of one output. After the first it has the
// analysis already, and for numbers close by the factor, too.
void print_evaluations() {
  constexpr int threads = 1, repeats = 5;
  Model model = cubic_lattice(13);
  Functional settlement;
  settlement.displacement.emplace_back(12, test::vector6(0, 0, 1));
  struct Evaluation {
    const char* name;
    double poisson;
    std::vector<double> seconds = {};
  } evaluations[] = {
      {"first", 0.2}, {"Poisson's ratio from 0.2 to -0.5", -0.5}, {"by 1e-6 more", -0.5 + 1e-6}};
  for (int repeat = 0; repeat < repeats; ++repeat) {
    StaticAnalysis analysis(model, on_threads("cholmod", threads));
    for (Evaluation& each : evaluations) {
      model.blocks[0].parameters[1] = each.poisson;
      each.seconds.push_back(seconds_of([&] {
        analysis.solve();
        analysis.gradients({{settlement}});
      }));
    }
  }
  const double first = median(evaluations[0].seconds);
  for (const Evaluation& each : evaluations)
    fmt::print("| 13x13x13 lattice, evaluation with derivatives, {}, {} | {:.0f} ms, {:.2f} of the first |\n",
               each.name, plural(threads), 1e3 * median(each.seconds), median(each.seconds) / first);
}

}  // namespace

void print_statics() {
  const std::string cantilever = BONDSTATIC_SOURCE_DIR "/cases/cantilever/case.toml";
  run_program({"solve", cantilever});
  fmt::print("| reference cantilever, whole process | {:.1f} ms (median of 21) |\n",
             1e3 * median_seconds(21, [&] {
               run_program({"solve", cantilever});
             }));

  const Model lattice = cubic_lattice(20);
  const double direct = print_solver(lattice, "cholmod"), multigrid = print_solver(lattice, "multigrid");
  const double naive = seconds_of([&] { solve_naively(lattice); });
  fmt::print(
      "| the naive version (triplets, scalar ordering, SimplicialLDLT) | {:.1f} s, {:.0f} times as long as "
      "cholmod, {:.0f} as multigrid, on 1 thread |\n",
      naive, naive / direct, naive / multigrid);
  print_chain_errors();
  print_evaluations();
}

}  // namespace bondstatic::bench
