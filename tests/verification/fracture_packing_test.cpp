// 200 breaks of the YADE packing (2068 spheres, 6271 bonds) between rough platens: each state equals a plain
// solve of what was left then. Every 20th by default, every one under BONDSTATIC_FULL=1.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bondstatic/case_file.hpp"
#include "fracture/broken_model.hpp"

namespace bondstatic::test {
namespace {

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

struct Packed {
  const char* name;
  const char* contact_radius_factor;
  int breaks;
  double weight;  ///< of each sphere, N
};

void PrintTo(const Packed& packed, std::ostream* out) {
  *out << packed.name;
}

/// As a preload. The load on the platens may fall below zero then: not a reason to stop.
void add_weight(Case& given, double weight) {
  given.fracture.load_drop = std::numeric_limits<double>::infinity();
  Model& model = given.model;
  model.load_cases = {"press", "weight"};
  given.fracture.preload = 1;
  const std::vector<Support> supports = model.supports;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    if (supports[i].value.isZero(0)) continue;
    model.supports[i].load_case = 0;
    model.supports.push_back({supports[i].particle, supports[i].fixed, Vector6::Zero(), 1});
  }
  Vector6 down = Vector6::Zero();
  down[2] = -weight;
  for (std::size_t p = 0; p < model.particles.size(); ++p) model.loads.push_back({Index(p), down, 1});
}

class FracturedPacking : public ::testing::TestWithParam<Packed> {};

TEST_P(FracturedPacking, EveryStateEqualsAPlainSolveOfWhatIsLeft) {
  const std::string breaks = std::to_string(full_run() ? 200 : GetParam().breaks);
  Case given = read_case(BONDSTATIC_SOURCE_DIR "/cases/fracture/packing.toml",
                         {"fracture.max_breaks=" + breaks,
                          std::string("bonds.0.contact_radius_factor=") + GetParam().contact_radius_factor},
                         "", Purpose::fracture);
  given.solve.threads = 1;
  if (GetParam().weight > 0) add_weight(given, GetParam().weight);
  std::vector<std::pair<std::size_t, State>> states;
  FractureHooks hooks;
  hooks.probe = [&](std::size_t event, const State& state) {
    if (full_run() || event % 20 == 19) states.emplace_back(event, state);
  };
  const Fracture found = fracture(given.model, given.fracture, given.solve, hooks);
  ASSERT_EQ(found.end, FractureEnd::breaks);
  ASSERT_FALSE(states.empty());
  for (const auto& [event, state] : states) {
    const Model left = broken_model(given.model, given.fracture, found, event, found.events[event].factor);
    const StateDifference apart = difference(state, solved_with_drop(left), found, event);
    // Both are rounded from answers good to all digits: 1e-10 is what is asked, 4e-16 was seen.
    EXPECT_LT(apart.largest(), 2e-15) << event;
  }
  EXPECT_EQ(found.separated.empty(), GetParam().weight == 0);
  EXPECT_LT(found.report.energy_balance, 1e-13);
  EXPECT_LT(found.report.forward_error, 1e-14);
}

// With hardly any gap bridged, hundreds of spheres hang on nothing from the start, and chips come off.
INSTANTIATE_TEST_SUITE_P(Yade, FracturedPacking,
                         ::testing::Values(Packed{"Dense", "1.1", 200, 0}, Packed{"Loose", "1.0", 120, 0.3}),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

}  // namespace
}  // namespace bondstatic::test
