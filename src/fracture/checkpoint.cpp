// A run's checkpoint. It is taken only where the model is factorised anew anyway, so that a run that goes on
// from it and one that was never stopped do the same from there on, bit for bit.
#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "fracture/fracture_run.hpp"

namespace bondstatic {

namespace {

const ArchiveFormat format{"fracture checkpoint", 1};

}  // namespace

void describe(Archive& archive, FailureMode& m) {
  archive(m.name, m.normal, m.shear, m.twisting, m.bending, m.at);
}

void describe(Archive& archive, BrokenBond& b) {
  archive(b.bond, b.mode, b.utilisation);
}

void describe(Archive& archive, FractureEvent& e) {
  archive(e.factor, e.load, e.displacement, e.factor_after, e.load_after, e.displacement_after, e.runner_up,
          e.released, e.strain_energy, e.work, e.dissipated, e.avalanche, e.bonds);
}

void describe(Archive& archive, SeparatedBody& s) {
  archive(s.particles, s.event);
}

// Of all that the run depends on but where it is to stop.
std::uint64_t FractureRun::fingerprint() const {
  Archive f;
  for (const Particle& p : model_.particles) f(p.id, p.position);
  for (std::size_t k = 0; k < model_.bonds.size(); ++k) {
    const Bond& bond = model_.bonds[k];
    const BondProperties& of = damaged_.properties()[k];
    const SectionStiffness& c = of.stiffness;
    f(bond.id, bond.a, bond.b, bond.branch, c.kn, c.ks, c.kt, c.kb, c.coupling, of.fraction, of.radius,
      of.moments_fed_back);
  }
  for (const Support& s : model_.supports) f(s.particle, s.fixed, s.value, s.load_case);
  for (const Load& l : model_.loads) f(l.particle, l.force, l.load_case);
  for (const Strain& s : model_.strains) f(s.value, s.load_case);
  f(failures_.first, failures_.modes, options_.pattern, options_.preload, options_.control, options_.tie,
    options_.save_every);
  return f.checksum();
}

void FractureRun::carry(Archive& archive) {
  damaged_.carry(archive);
  archive(result_.events, result_.break_event, result_.separated, result_.warnings);
  FractureReport& report = result_.report;
  archive(report.factorisations, report.analyses, report.backward_error, report.forward_error,
          report.energy_balance, report.seconds);
  archive(factor_, largest_factor_, largest_load_, rest_displacement_, rest_energy_, whole_stiffness_,
          at_.load, at_.displacement, at_.held_work, work_, dissipated_, breaks_, shown_);
}

void FractureRun::take_snapshot() {
  if (!hooks_.keep) return;
  Archive archive(format);
  archive(fingerprint_);
  carry(archive);
  snapshot_ = archive.finish();
  const auto now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - kept_).count() < hooks_.keep_every) return;
  kept_ = now;
  hooks_.keep(snapshot_);
}

void FractureRun::resume() {
  Archive archive(format, hooks_.resume, hooks_.resume_name);
  std::uint64_t saved = 0;
  archive(saved);
  if (saved != fingerprint_)
    throw Error(
        ExitCode::invalid_input,
        fmt::format("{}: belongs to another model or other options\n    cure: go on with the case as it "
                    "was, or remove the file to start anew",
                    hooks_.resume_name));
  carry(archive);
  archive.expect_end();
  damaged_.refresh();
  damaged_.recover_parts();
  measure();
}

}  // namespace bondstatic
