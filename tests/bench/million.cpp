#include "bench/million.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "bench/in_child.hpp"
#include "bench/packings.hpp"
#include "bench/program.hpp"
#include "bench/timing.hpp"

namespace bondstatic::bench {

namespace {

namespace fs = std::filesystem;

constexpr int cores = 2;

constexpr const char* case_text = R"([[particles]]
file = "particles.csv"

[[bonds]]
file = "bonds.csv"
law = "timoshenko"
young = 1e9
poisson = 0.2
radius_factor = 0.8

[[supports]]
at = { lowest = { axis = "z", within = 0.2 } }
fix = "all"

[[loads]]
at = { highest = { axis = "z", within = 0.2 } }
force = [1, 0, -1]

[solve]
unsupported = "drop"
)";

// 0 ... count-1 in an order that is the same on every machine, as std::shuffle's is not.
std::vector<std::size_t> shuffled(std::size_t count) {
  std::mt19937_64 random(1);
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = random() % (i + 1);
    order[i] = order[j];
    order[j] = i;
  }
  return order;
}

void write_case(const fs::path& folder, Index particles) {
  const Model model = disordered_fcc(Index(std::lround(std::cbrt(double(particles) / 4))));
  auto particle_file = fmt::output_file((folder / "particles.csv").string());
  particle_file.print("id,x,y,z,radius\n");
  for (const std::size_t i : shuffled(model.particles.size())) {
    const Particle& p = model.particles[i];
    particle_file.print("{},{},{},{},{}\n", p.id, p.position.x(), p.position.y(), p.position.z(), p.radius);
  }
  auto bond_file = fmt::output_file((folder / "bonds.csv").string());
  bond_file.print("id,a,b\n");
  for (const std::size_t k : shuffled(model.bonds.size())) {
    const Bond& bond = model.bonds[k];
    bond_file.print("{},{},{}\n", bond.id, model.particles[std::size_t(bond.a)].id,
                    model.particles[std::size_t(bond.b)].id);
  }
  std::ofstream(folder / "case.toml") << case_text;
}

double bytes_in(const fs::path& folder) {
  double bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) bytes += double(entry.file_size());
  return bytes;
}

void print_run(const nlohmann::json& summary, const ProgramRun& run) {
  const auto& solver = summary["solver"];
  fmt::print("| particles, bonds, unknowns | {}, {}, {} |\n", summary["counts"]["particles"].get<Index>(),
             summary["counts"]["bonds"].get<Index>(), summary["counts"]["unknowns"].get<Index>());
  fmt::print("| solver | {}, {} of {} threads, {} iterations |\n", solver["name"].get<std::string>(),
             solver["threads"].get<int>(), solver["threads_asked"].get<int>(),
             solver["iterations"].get<Index>());
  double in_phases = 0;
  for (const auto& phase : summary["phases"]) {
    const double seconds = phase["seconds"].get<double>();
    in_phases += seconds;
    fmt::print("| {} | {:.2f} s |\n", phase["name"].get<std::string>(), seconds);
  }
  fmt::print("| the rest: writing, freeing | {:.2f} s |\n", run.seconds - in_phases);
  fmt::print("| **whole process** | **{:.1f} s**, {:.1f} s of processor time |\n", run.seconds,
             run.cpu_seconds);
  fmt::print("| **peak resident memory** | **{:.2f} GB** |\n", 1e-9 * run.peak_bytes);
}

}  // namespace

void print_million(const Million& asked) {
  const fs::path folder = BONDSTATIC_BINARY_DIR "/million";
  fs::remove_all(folder);
  fs::create_directories(folder);
  // The model must not count as memory of the program, which begins as a copy of this process.
  char none = 0;
  const auto write = [&](void*) { write_case(folder, asked.particles); };
  if (in_child(600, write, &none, sizeof none) != ChildEnd::done)
    throw std::runtime_error("the case was not written to " + folder.string());
  const double case_bytes = bytes_in(folder);

  const fs::path results = folder / "results", answer = folder / "answer.json";
  const ProgramRun run =
      run_program({"solve", folder / "case.toml", "--out", results, "--json"}, {answer, cores});
  const auto summary = nlohmann::json::parse(std::ifstream(answer));

  fmt::print("| from case file to written answer on {} cores | figure |\n|---|---|\n", cores);
  print_run(summary, run);
  fmt::print("| case and results on disk | {:.0f} MB and {:.0f} MB |\n", 1e-6 * case_bytes,
             1e-6 * bytes_in(results));
  fmt::print("| relative error at most | {:.1e} (backward error {:.1e}) |\n",
             summary["accuracy"]["forward_error"].get<double>(),
             summary["accuracy"]["backward_error"].get<double>());
  if (asked.keep)
    fmt::print("\ncase, results and summary: {}\n", folder.string());
  else
    fs::remove_all(folder);
}

}  // namespace bondstatic::bench
