#include "bench/fracture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "bench/after_break.hpp"
#include "bench/packings.hpp"
#include "bench/threads.hpp"
#include "bench/timing.hpp"
#include "bondstatic/case_file.hpp"
#include "bondstatic/fracture.hpp"
#include "statics/held.hpp"
#include "statics/refine.hpp"
#include "statics/residual.hpp"
#include "support/models.hpp"
#include "system/unknowns.hpp"

namespace bondstatic::bench {

namespace {

using std::chrono::steady_clock;

StaticOptions on_cholmod(int threads) {
  StaticOptions solve = on_threads("cholmod", threads);
  solve.unsupported = Unsupported::drop;
  return solve;
}

/// What is left after breaks, as the solver sees it.
struct Broken {
  BondNetwork whole, network;
  Boundary boundary;
  FreeDofs dofs;
  std::vector<Link> links;  // broken ones, in their order
};

Broken broken(const Model& model, const Fracture& found) {
  Broken b;
  b.whole = b.network = bond_network(model, bond_properties(model));
  b.boundary = boundary_of(model, 0);
  std::vector<std::uint8_t> free = held_by(model, b.whole, b.boundary.free, Unsupported::drop).dofs.free;
  for (const SeparatedBody& body : found.separated)
    for (const Index id : body.particles)
      for (std::size_t p = 0; p < free.size(); ++p)
        if (model.particles[p].id == id) free[p] = 0;
  b.dofs = number_free_dofs(std::move(free));
  for (const FractureEvent& event : found.events)
    for (const BrokenBond& bond : event.bonds) {
      Link& link = b.network.links[std::size_t(bond.bond)];
      b.links.push_back(link);
      link.stiffness = {};
    }
  return b;
}

struct Run {
  Fracture found;
  double seconds = 0;  // a break, the first one apart
};

Run run(const Model& model, const FractureOptions& options, int threads) {
  Run run;
  steady_clock::time_point first;
  Index breaks_at_first = 0, breaks = 0;
  FractureHooks hooks;
  hooks.progress = [&](const FractureProgress& progress) {
    const auto now = steady_clock::now();
    if (progress.events == 1) {
      first = now;
      breaks_at_first = progress.breaks;
    }
    breaks = progress.breaks;
    run.seconds = std::chrono::duration<double>(now - first).count() / double(breaks - breaks_at_first);
    return true;
  };
  run.found = fracture(model, options, on_cholmod(threads), hooks);
  return run;
}

/// Of factorisation and refinement, as a plain solve does them after the analysis.
struct Anew {
  double factorisation = 0, refinement = 0;
};

Anew solve_anew(const Broken& b, int threads, int repeats) {
  const auto solver = make_solver("cholmod", threads);
  solver->analyse(b.network, b.dofs);
  const Incidence incidence = link_incidence(b.network);
  std::vector<double> factorisation, refinement;
  for (int i = 0; i < repeats; ++i) {
    FactorReport factor;
    factorisation.push_back(seconds_of([&] { factor = solver->factorise(b.network, b.dofs); }));
    Effort effort;
    refinement.push_back(seconds_of([&] {
      solve_refined(b.network, incidence, b.dofs, {&b.boundary}, solver.get(), factor.pivot_ratio, threads,
                    effort, nullptr);
    }));
  }
  return {*std::min_element(factorisation.begin(), factorisation.end()),
          *std::min_element(refinement.begin(), refinement.end())};
}

/// Of the whole model, for all stages.
Eigen::VectorXd right_hand_side(const Broken& b) {
  return to_unknowns(residual(b.whole, b.boundary, converted<Extended>(b.boundary.prescribed), 1), b.dofs,
                     b.whole.rotation_length);
}

/// Of one way after so many breaks: seconds of a change, the median since the stage before, and of a solve,
/// best of a few; what a solve is wrong by, 2-norm. A break takes a change and two solves of a state.
struct Stage {
  double change = 0, solve = 0, error = 0;
  int iterations = 0;
};

constexpr std::size_t stages[] = {1, 10, 40};

std::vector<Stage> measure(AfterBreak& way, const Broken& b, const std::vector<Eigen::VectorXd>& exact) {
  constexpr int repeats = 3;
  const Eigen::VectorXd load = right_hand_side(b);
  std::vector<Stage> measured;
  std::size_t done = 0;
  for (const std::size_t stage : stages) {
    if (stage > b.links.size()) break;
    Stage now{.solve = 1e9};
    std::vector<double> changes;
    for (; done < stage; ++done) changes.push_back(seconds_of([&] { way.take_out(b.links[done]); }));
    now.change = median(changes);
    Eigen::VectorXd x;
    for (int i = 0; i < repeats; ++i)
      now.solve = std::min(now.solve, seconds_of([&] { x = way.solve(load); }));
    now.iterations = way.iterations();
    now.error = (x - exact[measured.size()]).norm() / exact[measured.size()].norm();
    measured.push_back(now);
  }
  return measured;
}

/// After each stage, of a fresh factor.
std::vector<Eigen::VectorXd> solved_anew(const Broken& b) {
  BondNetwork network = b.whole;
  const auto solver = make_solver("cholmod", 1);
  solver->analyse(network, b.dofs);
  const Eigen::VectorXd load = right_hand_side(b);
  std::vector<Eigen::VectorXd> solved;
  for (const std::size_t stage : stages) {
    if (stage > b.links.size()) break;
    for (Link& link : network.links)
      for (std::size_t i = 0; i < stage; ++i)
        if (link.a == b.links[i].a && link.b == b.links[i].b) link.stiffness = {};
    solver->factorise(network, b.dofs);
    solved.push_back(solver->solve(load));
  }
  return solved;
}

struct Size {
  Index particles;
  Index breaks;  // where a factor is done again after fewer, that is among them
  int repeats;
};
constexpr Size sizes[] = {{2000, 201, 5}, {8000, 151, 3}, {27000, 41, 1}};

/// Between two rough platens, the upper one pressed down; strengths as in cases/fracture.
Model breakable(const Family& family, Index particles) {
  Model model = family.make(particles);
  for (const Load& load : std::exchange(model.loads, {}))
    test::fix_all(model, load.particle, test::vector6(0, 0, -1e-5));
  model.blocks.front().strength = BondStrength{.criterion = "edem-v2",
                                               .parameters = {1e7, 3e7},
                                               .scatter = BondStrength::Scatter::weibull,
                                               .spread = {8, 8},
                                               .seed = 1};
  return model;
}

struct Way {
  const char* name;
  std::unique_ptr<AfterBreak> (*make)(const BondNetwork& network, const FreeDofs& dofs);
};
constexpr Way ways[] = {{"downdates of L D L^T", by_downdates},
                        {"low-rank correction", by_low_rank},
                        {"conjugate gradients", by_iteration}};

void print_ways(const std::string& packing, const Model& model, const Broken& b) {
  const auto exact = solved_anew(b);
  for (const Way& way : ways) {
    const auto after = way.make(b.whole, b.dofs);
    const auto measured = measure(*after, b, exact);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const Stage& stage = measured[i];
      fmt::print("| {}, {} | {} | {} | {:.1f} | {:.1f} | {} | {:.1f} | {:.0e} | {:.0f} | {:.2f} |\n", packing,
                 model.particles.size(), way.name, stages[i], 1e3 * stage.change, 1e3 * stage.solve,
                 stage.iterations > 0 ? std::to_string(stage.iterations) : "",
                 1e3 * (stage.change + 2 * stage.solve), stage.error, 1e-6 * after->factor_bytes,
                 after->ready_seconds);
      std::fflush(stdout);
    }
  }
}

void print_packing_of_cases() {
  const Case yade =
      read_case(BONDSTATIC_SOURCE_DIR "/cases/fracture/packing.toml", {}, "", Purpose::fracture);
  FractureOptions options = yade.fracture;
  options.save_every = 0;
  StaticOptions solve = yade.solve;
  solve.threads = 1;
  Fracture found;
  const double seconds = seconds_of([&] { found = fracture(yade.model, options, solve); });
  Index breaks = 0;
  for (const FractureEvent& event : found.events) breaks += Index(event.bonds.size());
  fmt::print(
      "\ncases/fracture/packing.toml, {} particles, {} bonds, 1 thread: {} breaks in {:.1f} s, {:.1f} ms "
      "each, {} factorisations\n",
      yade.model.particles.size(), yade.model.bonds.size(), breaks, seconds, 1e3 * seconds / double(breaks),
      found.report.factorisations);
}

}  // namespace

void print_break_cost(const BreakCost& asked) {
  const auto is_asked = [](const auto& list, const auto& one) {
    return list.empty() || std::find(list.begin(), list.end(), one) != list.end();
  };
  for (const Index particles : asked.particles)
    if (std::none_of(std::begin(sizes), std::end(sizes),
                     [&](const Size& size) { return size.particles == particles; }))
      throw std::invalid_argument(std::to_string(particles));
  std::vector<std::string> packings = asked.packings;
  if (packings.empty()) packings = {"disordered FCC", "YADE-like"};
  std::vector<int> threads{1};
  if (machine_cores() > 1) threads.push_back(machine_cores());
  struct Case {
    std::string packing;
    Model model;
    Broken broken;
  };
  std::vector<Case> cases;
  fmt::print(
      "| packing | particles | bonds | unknowns | threads | breaks | a break, ms | factorisation, ms | "
      "refinement, ms | share |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Family& family : families())
    for (const Size& size : sizes) {
      if (!is_asked(packings, family.name) || !is_asked(asked.particles, size.particles)) continue;
      const Model model = breakable(family, size.particles);
      for (const int count : threads) {
        const Run one = run(model, {.max_breaks = size.breaks}, count);
        Broken b = broken(model, one.found);
        const Anew anew = solve_anew(b, count, size.repeats);
        fmt::print("| {} | {} | {} | {} | {} | {} | {:.1f} | {:.0f} | {:.0f} | 1/{:.1f} |\n", family.name,
                   model.particles.size(), model.bonds.size(), b.dofs.unknowns(), count, b.links.size(),
                   1e3 * one.seconds, 1e3 * anew.factorisation, 1e3 * anew.refinement,
                   (anew.factorisation + anew.refinement) / one.seconds);
        std::fflush(stdout);
        if (count == 1) cases.push_back({family.name, model, std::move(b)});
      }
    }
  fmt::print(
      "\n| packing | way | break | change, ms | solve, ms | iterations | change and two solves, ms | error "
      "of a solve | factor, MB | made ready, s |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& each : cases) print_ways(each.packing, each.model, each.broken);
  if (asked.packings.empty() && asked.particles.empty()) print_packing_of_cases();
}

}  // namespace bondstatic::bench
