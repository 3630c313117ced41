#include "bench/exchange.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "bench/in_child.hpp"
#include "bench/packings.hpp"
#include "bench/program.hpp"
#include "bondstatic/case_file.hpp"
#include "support/peak_memory.hpp"

namespace bondstatic::bench {

namespace {

namespace fs = std::filesystem;

constexpr int cores = 2;
constexpr double longest = 600;  ///< seconds, of one piece of work

constexpr const char* touching = R"([[particles]]
file = "imported/particles.csv"

[[bonds]]
law = "timoshenko"
contact_radius_factor = 1.1
young = 1e9
poisson = 0.2
radius_factor = 0.8
)";

/// A packing as LAMMPS writes it: particles and bonds in no order, coefficients of their one type.
void write_data_file(const fs::path& path, Index particles) {
  const Model model = disordered_fcc(Index(std::lround(std::cbrt(double(particles) / 4))));
  std::vector<std::size_t> order(model.particles.size());
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t j = random() % (i + 1);
    order[i] = order[j];
    order[j] = i;
  }
  auto file = fmt::output_file(path.string());
  file.print("packing\n\n{} atoms\n{} bonds\n1 atom types\n1 bond types\n\n", model.particles.size(),
             model.bonds.size());
  file.print("-10 1000 xlo xhi\n-10 1000 ylo yhi\n-10 1000 zlo zhi\n\n");
  file.print("Bond Coeffs # bpm/rotational\n\n1 1e6 4e5 0.05 0.08 1 1 1 1 0 0 0 0\n\nAtoms # bpm/sphere\n\n");
  for (const std::size_t i : order) {
    const Particle& p = model.particles[i];
    file.print("{} 1 1 {} 2650 {} {} {}\n", p.id + 1, 2 * p.radius, p.position.x(), p.position.y(),
               p.position.z());
  }
  file.print("\nBonds\n\n");
  for (const Bond& bond : model.bonds)
    file.print("{} 1 {} {}\n", bond.id + 1, model.particles[std::size_t(bond.a)].id + 1,
               model.particles[std::size_t(bond.b)].id + 1);
}

/// A case that is read in a child.
struct Formed {
  Index particles = 0, bonds = 0;
  double seconds = 0, bytes = 0;
};

Formed form_bonds(const fs::path& case_file) {
  Formed formed;
  const auto work = [&](void* buffer) {
    using Clock = std::chrono::steady_clock;
    test::PeakMemory memory;
    memory.begin();
    const auto begin = Clock::now();
    const Case given = read_case(case_file.string(), {}, "", Purpose::statics, cores);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    *static_cast<Formed*>(buffer) = {Index(given.model.particles.size()), Index(given.model.bonds.size()),
                                     seconds, memory.bytes()};
  };
  if (in_child(longest, work, &formed, sizeof formed) != ChildEnd::done)
    throw std::runtime_error("the case was not read: " + case_file.string());
  return formed;
}

void print_size(const fs::path& folder, Index particles) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  const fs::path data = folder / "packing.data", out = folder / "imported";
  char none = 0;
  // In a child: programs begin as a copy of this process, and their memory is measured.
  if (in_child(
          longest, [&](void*) { write_data_file(data, particles); }, &none, sizeof none) != ChildEnd::done)
    throw std::runtime_error("no data file was written: " + data.string());
  const ProgramRun run = run_program({"import", data, "--out", out}, {"/dev/null", cores});
  std::ofstream(folder / "touching.toml") << touching;
  const Formed formed = form_bonds(folder / "touching.toml");
  const double millions = 1e-6 * double(formed.particles);
  fmt::print(
      "| {} | {:.0f} MB | {:.2f} s | {:.2f} s | {:.2f} GB | {:.2f} GB | {} | {:.2f} s | {:.2f} s | {:.2f} GB "
      "|\n",
      formed.particles, 1e-6 * double(fs::file_size(data)), run.seconds, run.seconds / millions,
      1e-9 * run.peak_bytes, 1e-9 * run.peak_bytes / millions, formed.bonds, formed.seconds,
      formed.seconds / millions, 1e-9 * formed.bytes);
  std::fflush(stdout);
  fs::remove_all(folder);
}

}  // namespace

void print_exchange(const std::vector<Index>& sizes) {
  fmt::print(
      "| particles | LAMMPS data file | import on {} cores | a million | peak memory | a million | "
      "bonds by contact radius | time | a million | memory |\n|{}\n",
      cores, "---|---|---|---|---|---|---|---|---|---|");
  for (const Index particles : sizes) print_size(BONDSTATIC_BINARY_DIR "/exchange", particles);
}

}  // namespace bondstatic::bench
