#include "bench/solvers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "bench/measure.hpp"
#include "bench/plot.hpp"
#include "bondstatic/linear_solver.hpp"

namespace bondstatic::bench {

namespace {

struct Contender {
  std::string solver;
  Index largest;  ///< particles; beyond, it would only waste time
  std::vector<int> threads;
};

std::vector<Contender> contenders() {
  std::vector<Contender> list{{"naive", 9000, {1}}, {"relaxation", 1100, {1, 2}}};
  // Ranks are to PETSc what threads are to the others; here it is one process.
  for (const SolverInfo& info : available_solvers())
    list.push_back({info.name, info.name == "eigen" ? 9000 : Index(1) << 40,
                    info.name.starts_with("petsc") ? std::vector<int>{1} : std::vector<int>{1, 2}});
  return list;
}

std::string seconds(double value) {
  return value < 0.1 ? fmt::format("{:.4f}", value) : fmt::format("{:.2f}", value);
}

// What of the machine's own rate was reached: the factorisation's of dgemm; an iteration cannot be faster
// than reading every bond once.
std::string fraction(const Measurement& m) {
  if (m.iterative && m.iterations > 0 && m.triad > 0) {
    constexpr double bytes_a_bond = 8 * (3 + 1 + 5 + 2);  // branch, contact point, C, its two ends
    return fmt::format("{:.0f} % of triad {:.1f} GB/s",
                       100 * double(m.iterations) * bytes_a_bond * double(m.bonds) / m.refinement / m.triad,
                       1e-9 * m.triad);
  }
  if (!m.iterative && m.flops > 0 && m.dgemm > 0)
    return fmt::format("{:.1f} Gflop/s, {:.0f} % of dgemm {:.1f}", 1e-9 * m.flops / m.factorisation,
                       100 * m.flops / m.factorisation / m.dgemm, 1e-9 * m.dgemm);
  return "";
}

void print_head() {
  fmt::print(
      "| packing | particles | bonds | solver | threads | s | bonds, mechanisms | analysis | factorisation "
      "or "
      "set-up | solution, refinement | recovery | all but factorisation | iterations | peak MB | predicted / "
      "peak | rate |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const std::string& packing, const std::string& solver, int threads, const Measurement& m) {
  fmt::print("| {} | {} | {} | {} | {} | ", packing, m.particles, m.bonds, solver, threads);
  switch (m.ending) {
    case Ending::too_long:
      fmt::print("took too long |||||||||||\n");
      return;
    case Ending::does_not_fit:
    case Ending::failed:
      fmt::print("{} |||||||||||\n", m.note);
      return;
    case Ending::done:
      break;
  }
  fmt::print("{} | ", seconds(m.seconds));
  if (m.unknowns > 0)
    fmt::print("{} | {} | {} | {} | {} | {:.0f} % | ", seconds(m.before), seconds(m.analysis),
               seconds(m.factorisation), seconds(m.refinement), seconds(m.recovery),
               100 * (1 - m.factorisation / m.seconds));
  else
    fmt::print("|||||| ");
  fmt::print("{} | {:.0f} | {} | {} |\n", m.iterations > 0 ? fmt::format("{}", m.iterations) : "",
             1e-6 * m.peak_bytes,
             m.predicted_bytes > 0 ? fmt::format("{:.2f}", m.predicted_bytes / m.peak_bytes) : "",
             fraction(m));
  std::fflush(stdout);
}

struct Key {
  std::string packing, solver;
  int threads;
  auto operator<=>(const Key&) const = default;
};
using Curves = std::map<Key, std::vector<Measurement>>;

// Slope of log y over log particles by least squares.
double exponent(const std::vector<Measurement>& points, double Measurement::*value) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Measurement& m : points) {
    const double u = std::log(double(m.particles)), v = std::log(m.*value);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void print_growth(const Curves& curves) {
  fmt::print(
      "\n| packing | solver | threads | particles | time grows as n^ | memory grows as n^ "
      "|\n|---|---|---|---|---|---|\n");
  for (const auto& [key, all] : curves) {
    std::vector<Measurement> points;  // at a thousand particles what does not grow is still felt
    for (const Measurement& m : all)
      if (m.particles > 2000) points.push_back(m);
    if (points.size() < 2) continue;
    fmt::print("| {} | {} | {} | {} to {} | {:.2f} | {:.2f} |\n", key.packing, key.solver, key.threads,
               points.front().particles, points.back().particles, exponent(points, &Measurement::seconds),
               exponent(points, &Measurement::peak_bytes));
  }
}

// Seconds that a size larger than those measured is going to take; zero where too little is known.
double expected(const std::vector<Measurement>& points, Index particles) {
  if (points.size() < 2) return 0;
  const std::vector<Measurement> last(points.end() - 2, points.end());
  return last[1].seconds *
         std::pow(double(particles) / double(last[1].particles), exponent(last, &Measurement::seconds));
}

void draw(const Curves& curves, const std::string& file) {
  Plot plot{"Static solve, one thread", "particles", "seconds", {}};
  for (const auto& [key, points] : curves) {
    if (key.threads != 1) continue;
    Line line{key.solver + ", " + key.packing, key.solver, {}};
    for (const Measurement& m : points) line.points.emplace_back(double(m.particles), m.seconds);
    plot.lines.push_back(line);
  }
  std::ofstream(file) << svg(plot);
  fmt::print("\nplot: {}\n", file);
}

}  // namespace

namespace {

bool asked_for(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void compare_solvers(const Campaign& campaign) {
  std::vector<Index> sizes{1000, 8000};
  if (!campaign.quick) sizes.insert(sizes.end(), {27000, 64000, 125000});
  if (campaign.million) sizes.push_back(1000000);
  Curves curves;
  print_head();
  for (const Family& family : families()) {
    if ((!family.grows && campaign.quick) || !asked_for(campaign.packings, family.name)) continue;
    for (const Index particles : family.grows ? sizes : std::vector<Index>{160000}) {
      for (const Contender& contender : contenders()) {
        if (particles > contender.largest || !asked_for(campaign.solvers, contender.solver)) continue;
        for (const int threads : contender.threads) {
          auto& curve = curves[{family.name, contender.solver, threads}];
          const double guess = expected(curve, particles);
          if (guess > campaign.longest) {
            fmt::print("| {} | {} | | {} | {} | left out: about {:.0f} s |||||||||||\n", family.name,
                       particles, contender.solver, threads, guess);
            continue;
          }
          const Measurement m = measure(family, particles, contender.solver, threads, campaign.longest);
          print_row(family.name, contender.solver, threads, m);
          if (m.ending == Ending::done) curve.push_back(m);
        }
      }
    }
  }
  print_growth(curves);
  draw(curves, campaign.plot);
}

}  // namespace bondstatic::bench
