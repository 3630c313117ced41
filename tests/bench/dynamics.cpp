// The explicit run on the YADE packing: bond-steps a second, beside the naive version, the peer, and what
// memory gives.
#include "bondstatic/dynamics.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <numeric>

#include "bench/busy.hpp"
#include "bench/naive_dynamics.hpp"
#include "bench/packings.hpp"
#include "bench/tables.hpp"
#include "bench/timing.hpp"
#include "bondstatic/case_file.hpp"
#include "support/shuffled.hpp"

namespace bondstatic::bench {
namespace {

/// LAMMPS (29 August 2024) with bpm/rotational on these 2,068 particles, on one core of such a machine, idle.
constexpr double peer = 5e6;

constexpr double time_step = 1e-7;
constexpr int steps = 400;

double rate(const Model& model, const std::vector<BondProperties>& properties, Kinematics kinematics,
            int threads, int at_a_time = steps) {
  DynamicOptions options;
  options.kinematics = kinematics;
  options.time_step = time_step;
  options.threads = threads;
  ExplicitRun run(model, properties, 0, {}, options);
  // Warm, past the wave front, whose first numbers are denormal, and past the first choices of threads.
  for (int i = 0; i < 3; ++i) run.advance(at_a_time);
  const double seconds = median_seconds(9, [&] { run.advance(at_a_time); });
  return double(at_a_time) * double(model.bonds.size()) / seconds;
}

/// A packing too large for the cache, its tables in no order.
Model large_packing() {
  std::mt19937_64 random(1);
  Model model = test::shuffled(disordered_fcc(31), random);
  for (Particle& particle : model.particles) particle.density = 2650;
  return model;
}

/// Bytes a second of a loop that reads and writes an array of so many bytes, as the bonds' histories are.
double memory_rate(std::size_t bytes) {
  std::vector<double> array(bytes / sizeof(double), 1.0);
  const double seconds = median_seconds(9, [&] {
    for (int repeat = 0; repeat < 50; ++repeat)
      for (double& value : array) value += 1.0;
  });
  return 50 * 2 * double(bytes) / seconds;
}

double largest_difference(const State& state, const std::vector<Vector3>& naive) {
  double apart = 0, largest = 0;
  for (std::size_t p = 0; p < naive.size(); ++p) {
    apart = std::max(apart, (state.displacement[p].head<3>() - naive[p]).norm());
    largest = std::max(largest, naive[p].norm());
  }
  return apart / largest;
}

}  // namespace

void print_dynamics() {
  const Model model =
      read_case(BONDSTATIC_SOURCE_DIR "/cases/yade-packing/loads.toml", {"particles.0.density=2650"}).model;
  const auto properties = bond_properties(model);
  const int cores = int(sysconf(_SC_NPROCESSORS_ONLN));
  double finite = 0;
  for (int threads = 1; threads <= cores; threads *= 2) {
    const double found = rate(model, properties, Kinematics::finite, threads);
    if (threads == 1) finite = found;
    fmt::print(
        "| explicit run, {} bonds, finite kinematics, {} thread{} | {:.1f} million bond-steps a second{} |\n",
        model.bonds.size(), threads, threads == 1 ? "" : "s", 1e-6 * found,
        threads == 1 ? fmt::format(", {:.1f} times LAMMPS's 5 (bpm/rotational, idle core)", found / peer)
                     : "");
  }
  fmt::print("| the same, small kinematics, 1 thread | {:.1f} million bond-steps a second |\n",
             1e-6 * rate(model, properties, Kinematics::small, 1));
  {
    const BusyProcesses busy(4);
    fmt::print(
        "| the same, finite, {} threads asked for, beside 4 busy processes | {:.1f} million bond-steps a "
        "second |\n",
        cores, 1e-6 * rate(model, properties, Kinematics::finite, cores));
  }
  std::vector<Vector3> naive;
  const double naive_seconds = seconds_of([&] { naive = run_naively(model, properties, time_step, steps); });
  const double naive_rate = double(steps) * double(model.bonds.size()) / naive_seconds;
  DynamicOptions options;
  options.time_step = time_step;
  ExplicitRun same(model, properties, 0, {}, options);
  same.advance(steps);
  fmt::print(
      "| the naive version (an object a bond, Eigen's small vectors) | {:.1f} million, {:.1f} times as slow; "
      "its "
      "displacements within {:.0e} |\n",
      1e-6 * naive_rate, finite / naive_rate, largest_difference(same.state(), naive));
  // Read: geometry and stiffness, 17 numbers, two indices; read and written: axes, length, force, moment, 13.
  constexpr double bytes_a_bond = 8 * (17 + 2 + 2 * 13);
  const double memory = memory_rate(std::size_t(bytes_a_bond / 2 * double(model.bonds.size())));
  fmt::print("| bonds' share of what memory gives (loop over as many bytes) | {:.0f} % |\n",
             100 * finite * bytes_a_bond / memory);
  const Model large = large_packing();
  const auto of_large = bond_properties(large);
  for (const int threads : {1, cores})
    fmt::print("| explicit run, {} bonds in no order, {} thread{} | {:.1f} million bond-steps a second |\n",
               large.bonds.size(), threads, threads == 1 ? "" : "s",
               1e-6 * rate(large, of_large, Kinematics::finite, threads, 20));
}

}  // namespace bondstatic::bench
