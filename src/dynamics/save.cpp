// A run's bits, out and in again.
#include "bondstatic/error.hpp"
#include "dynamics/run_data.hpp"
#include "io/archive.hpp"

namespace bondstatic {

namespace {

const ArchiveFormat format{"explicit run", 2};

void describe(Archive& archive, Lanes& lanes) {
  for (double& value : lanes.at) archive(value);
}

/// What changes of a pack; the rest comes from the model.
void describe(Archive& archive, BondPack& pack) {
  for (auto* vector : {&pack.axis, &pack.side, &pack.force, &pack.moment})
    for (Lanes& lanes : *vector) describe(archive, lanes);
  describe(archive, pack.length);
}

void describe(Archive& archive, DashpotPack& pack) {
  for (auto* vector : {&pack.force, &pack.moment})
    for (Lanes& lanes : *vector) describe(archive, lanes);
}

}  // namespace

void describe(Archive& archive, CompensatedSum& sum) {
  archive(sum.sum_, sum.lost_);
}

void ExplicitRun::Data::carry(Archive& archive) {
  archive(step, initial_energy, work, dissipated);
  for (auto* array : {&bodies.motion, &bodies.velocity, &bodies.force}) archive(*array);
  archive(bodies.turn);
  for (BondPack& pack : packs) describe(archive, pack);
  for (DashpotPack& pack : dashpots) describe(archive, pack);
}

std::string ExplicitRun::save() const {
  Archive archive(format);
  data_->carry(archive);
  return archive.finish();
}

void ExplicitRun::load(std::string_view saved) {
  const auto misfit = [] {
    throw Error(ExitCode::invalid_input, "the saved run belongs to another model\n    cure: start it anew");
  };
  const Bodies shape = data_->bodies;
  Archive archive(format, saved, "saved run");
  data_->carry(archive);
  archive.expect_end();
  const Bodies& now = data_->bodies;
  if (now.motion.size() != shape.motion.size() || now.velocity.size() != shape.velocity.size() ||
      now.force.size() != shape.force.size() || now.turn[0].size() != shape.turn[0].size())
    misfit();
}

}  // namespace bondstatic
