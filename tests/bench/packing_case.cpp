#include "bench/packing_case.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <fstream>
#include <random>
#include <stdexcept>
#include <vector>

#include "bench/in_child.hpp"
#include "bench/packings.hpp"

namespace bondstatic::bench {

namespace {

namespace fs = std::filesystem;

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

void write(const fs::path& folder, Index particles) {
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

}  // namespace

void write_packing_case(const fs::path& folder, Index particles) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  char none = 0;
  if (in_child(
          600, [&](void*) { write(folder, particles); }, &none, sizeof none) != ChildEnd::done)
    throw std::runtime_error("the case was not written to " + folder.string());
}

}  // namespace bondstatic::bench
