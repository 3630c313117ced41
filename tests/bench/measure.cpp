#include "bench/measure.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "bench/in_child.hpp"
#include "bench/naive.hpp"
#include "bench/rates.hpp"
#include "bench/timing.hpp"
#include "bondstatic/error.hpp"
#include "bondstatic/relaxation.hpp"
#include "bondstatic/statics.hpp"
#include "support/peak_memory.hpp"

namespace bondstatic::bench {

namespace {

constexpr double short_time = 2;  // seconds; what takes less is repeated
constexpr int most_repeats = 7;

double phase(const StaticReport& report, std::initializer_list<const char*> names) {
  double seconds = 0;
  for (const Phase& p : report.phases)
    for (const char* name : names) seconds += p.name == name ? p.seconds : 0;
  return seconds;
}

void solve_by_backend(const Model& model, const std::string& solver, int threads, Measurement& result) {
  test::PeakMemory peak;
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  options.yield_cores = false;
  options.unsupported = Unsupported::drop;
  options.tolerance = 1;  // the answer is judged elsewhere
  bool first = true;
  options.progress = [&](const std::string& name) {
    if (first && name == "analysis") peak.begin();
  };
  double spent = 0;
  for (int i = 0; i < most_repeats && (i == 0 || spent < short_time); ++i) {
    StaticReport report;
    const double seconds = seconds_of([&] { report = solve_statics(model, options).report; });
    spent += seconds;
    if (first) result.peak_bytes = peak.bytes();
    if (first || seconds < result.seconds) {
      result.seconds = seconds;
      result.before = phase(report, {"bonds", "mechanisms"});
      result.analysis = phase(report, {"analysis"});
      result.factorisation = phase(report, {"factorisation", "set-up"});
      result.refinement = phase(report, {"refinement", "iterations"});
      result.recovery = phase(report, {"recovery"});
      result.unknowns = report.analysis.unknowns;
      result.iterations = report.iterations;
      result.flops = report.analysis.factor_flops;
      result.predicted_bytes = report.analysis.predicted_bytes;
    }
    first = false;
  }
}

void solve_otherwise(const Model& model, const std::string& solver, int threads, Measurement& result) {
  test::PeakMemory peak;
  peak.begin();
  result.seconds = seconds_of([&] {
    if (solver == "naive") {
      solve_naively(model);
    } else {
      RelaxOptions options;
      options.kinematics = Kinematics::small;
      StaticOptions statics;
      statics.threads = threads;
      statics.unsupported = Unsupported::drop;
      relax(model, options, statics);
    }
  });
  result.peak_bytes = peak.bytes();
}

Measurement measure_here(const Family& family, Index particles, const std::string& solver, int threads) {
  Measurement result;
  try {
    result.dgemm = dgemm_rate(threads);
    result.triad = triad_rate(threads);
    Model model = family.make(particles);
    for (Particle& particle : model.particles) particle.density = 2500;
    result.particles = Index(model.particles.size());
    result.bonds = Index(model.bonds.size());
    if (solver == "naive" || solver == "relaxation") {
      solve_otherwise(model, solver, threads, result);
    } else {
      result.iterative = make_solver(solver, threads)->iterative();
      solve_by_backend(model, solver, threads, result);
    }
    result.dgemm = std::max(result.dgemm, dgemm_rate(threads));
    result.triad = std::max(result.triad, triad_rate(threads));
    result.ending = Ending::done;
  } catch (const std::exception& error) {
    const auto* ours = dynamic_cast<const Error*>(&error);
    result.ending = ours && ours->code() == ExitCode::out_of_memory ? Ending::does_not_fit : Ending::failed;
    std::strncpy(result.note, error.what(), sizeof result.note - 1);
    *std::find(result.note, result.note + sizeof result.note - 1, '\n') = '\0';
  }
  return result;
}

}  // namespace

Measurement measure(const Family& family, Index particles, const std::string& solver, int threads,
                    double longest) {
  static_assert(std::is_trivially_copyable_v<Measurement>);
  Measurement result;
  const ChildEnd end = in_child(
      longest,
      [&](void* to) { *static_cast<Measurement*>(to) = measure_here(family, particles, solver, threads); },
      &result, sizeof result);
  if (end == ChildEnd::done) return result;
  result = {};
  result.particles = particles;
  if (end == ChildEnd::out_of_time) result.ending = Ending::too_long;
  std::strcpy(result.note, "died");  // by a fault or for want of memory
  return result;
}

}  // namespace bondstatic::bench
