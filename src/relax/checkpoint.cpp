#include "relax/checkpoint.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "dynamics/bond_pack.hpp"
#include "io/archive.hpp"

namespace bondstatic {

namespace {

const ArchiveFormat format{"checkpoint", 2};

}  // namespace

void describe(Archive& archive, const BondDamping& d) {
  archive(d.paper, d.normal, d.shear, d.twisting, d.bending);
}

void describe(Archive& archive, DynamicPlan& p) {
  archive(p.critical_time_step, p.time_step, p.highest, p.lowest, p.ramp_time, p.hold_time, p.speed, p.decay,
          p.predicted_steps, p.best_particle_damping, p.best_decay, p.best_predicted_steps);
}

std::uint64_t fingerprint_of(const Model& model, std::span<const BondProperties> properties,
                             const RelaxOptions& options, Unsupported unsupported, std::uint64_t probe) {
  Archive f;
  for (const Particle& p : model.particles) f(p.id, p.position, p.radius, p.density);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const Bond& bond = model.bonds[k];
    const SectionStiffness& c = properties[k].stiffness;
    const double share = properties[k].fraction, stretch = stretch_share(model, bond, share);
    f(bond.id, bond.a, bond.b, bond.branch, c.kn, c.ks, c.kt, c.kb, c.coupling, share, stretch,
      properties[k].radius, properties[k].moments_fed_back);
  }
  for (const Support& s : model.supports) f(s.particle, s.fixed, s.value, s.load_case);
  for (const Load& l : model.loads) f(l.particle, l.force, l.load_case);
  f(model.load_cases, unsupported, options.kinematics, options.particle_damping);
  describe(f, options.bond_damping);
  f(options.time_step, options.safety, options.ramp, options.ramp_time, options.velocity_limit,
    options.force_limit, options.hold_time, options.record_interval, options.save_interval,
    options.load_factor, probe);
  return f.checksum();
}

void Progress::start(const DynamicPlan& plan) {
  runs_.push_back(make_run_(Index(runs_.size()), plan));
  plans_.push_back(plan);
}

std::string Progress::checkpoint() {
  Archive archive(format);
  archive(fingerprint_, plans_);
  for (CaseRun& run : runs_) run.carry(archive);
  return archive.finish();
}

std::vector<std::vector<SavedState>> Progress::saved() const {
  std::vector<std::vector<SavedState>> saved;
  for (const CaseRun& run : runs_) saved.push_back(run.saved().all());
  return saved;
}

void Progress::resume(const std::string& checkpoint, const std::string& name) {
  Archive archive(format, checkpoint, name);
  std::uint64_t saved = 0;
  archive(saved);
  if (saved != fingerprint_)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("{}: belongs to another model, other outputs or other options of [dynamics]\n"
                    "    cure: resume with the case it was started with, or remove the file to start anew",
                    name));
  std::vector<DynamicPlan> plans;
  archive(plans);
  for (const DynamicPlan& plan : plans) {
    start(plan);
    runs_.back().carry(archive);
  }
  archive.expect_end();
}

}  // namespace bondstatic
