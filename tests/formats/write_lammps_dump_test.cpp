#include <gtest/gtest.h>

#include "formats/export_models.hpp"
#include "formats/readers.hpp"
#include "formats/write/lammps_dump.hpp"
#include "model/turning.hpp"

namespace bondstatic::test {
namespace {

ParticleState some_state() {
  ParticleState state;
  state.step = 1234;
  for (int p = 0; p < 3; ++p) {
    state.id.push_back(7 * p + 1);
    state.type.push_back(p % 2 + 1);
    state.position.push_back(Vector3(1.0 / 3 * p, -2.0 / 7, 1e-9 / 3));
    state.orientation.push_back(quaternion(Vector3(1e-7 * p, 0.2, -1.0 / 3)));
    state.velocity.push_back(Vector3(1e-17, p, 0));
    state.angular_velocity.push_back(Vector3(0, 0.1, p));
    state.force.push_back(Vector3(p, 1e300, -1e-300));
    state.torque.push_back(Vector3(0.3, p, 0));
    state.radius.push_back(0.1 / (p + 1));
  }
  return state;
}

ParticleState there_and_back(const ParticleState& state, const LammpsBox& box) {
  ScratchFolder folder;
  {
    OutputFile file(folder / "dump", "dump");
    write_lammps_dump(file, state, box);
    file.close();
  }
  std::vector<Fault> faults;
  const auto back = read_particle_state((folder / "dump").string(), {}, {}, faults);
  for (const Fault& fault : faults) ADD_FAILURE() << to_string(fault);
  return back.value_or(ParticleState{});
}

TEST(LammpsDumpRoundTrip, ReadsBackToTheLastBit) {
  const ParticleState state = some_state();
  LammpsBox box;
  box.high = Vector3(1, 1, 1);
  const ParticleState back = there_and_back(state, box);
  EXPECT_EQ(back.step, state.step);
  EXPECT_EQ(back.id, state.id);
  EXPECT_EQ(back.type, state.type);
  EXPECT_EQ(back.position, state.position);
  EXPECT_EQ(back.velocity, state.velocity);
  EXPECT_EQ(back.angular_velocity, state.angular_velocity);
  EXPECT_EQ(back.force, state.force);
  EXPECT_EQ(back.torque, state.torque);
  EXPECT_EQ(back.radius, state.radius);
  ASSERT_EQ(back.orientation.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p)
    EXPECT_LT((back.orientation[p].coeffs() - state.orientation[p].coeffs()).norm(), 3e-16);
}

TEST(LammpsDumpRoundTrip, KeepsAnObliquePeriodicBox) {
  LammpsBox box;
  box.low = Vector3(-1, -1, -1);
  box.high = Vector3(3, 3, 3);
  box.tilt = Vector3(1, -0.5, 0.25);
  box.periodic = {true, true, true};
  ParticleState state = some_state();
  state.unwrapped = true;
  const ParticleState back = there_and_back(state, box);
  EXPECT_TRUE(back.unwrapped);
  EXPECT_EQ(back.position, state.position);
  ASSERT_TRUE(back.cell.has_value());
  Matrix3 edges;
  edges << 4, 1, -0.5, 0, 4, 0.25, 0, 0, 4;
  EXPECT_EQ(back.cell->edges, edges);
  EXPECT_EQ(back.cell->origin, box.low);
}

}  // namespace
}  // namespace bondstatic::test
