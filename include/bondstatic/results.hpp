// The answer as files: summary.json, particles.csv, bonds.csv, model.vtu and case.resolved.toml; with several
// load cases the tables lie in a folder a load case, under one summary.json.
//
// particles.csv  id, x, y, z, radius, ux, uy, uz, rx, ry, rz, reaction_fx ... reaction_mz
//                (reaction: what the support does to the particle)
// bonds.csv      id, a, b, fx, fy, fz, mx, my, mz, normal_force, shear_force, twisting_moment,
// bending_moment, sigma,
//                tau, energy (fx ... mz: what the bond does to particle b, at the contact point, global axes)
// model.vtu      points are particles, lines are bonds; the columns above, vectors where they are vectors;
//                of the load case: fixed (1 x, 2 y, 4 z, 8 rx, 16 ry, 32 rz, summed), applied_force,
//                applied_moment; radius of the bonds' sections (NaN: none)
//
// Where outputs have sensitivities: sensitivities.csv, and bond_sensitivities.csv where they have them bond
// by bond.
//
// A run of several ranks writes the rows of rank 0, then of rank 1, ...; its grid is model.pvtu with a piece
// a rank beside it (model_0.vtu, ...). Particles that a piece borrows from another one for its bonds are
// marked in vtkGhostType as copies; their reactions, which only their own rank knows, are NaN.
//
// Particles and bonds that were left out keep their rows, with empty fields (NaN in model.vtu).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bondstatic/check.hpp"
#include "bondstatic/fracture.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/relaxation.hpp"
#include "bondstatic/resolution.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// What the files tell of the case besides its model.
struct RunInfo {
  std::string title;
  std::string file;      ///< the case file
  std::string resolved;  ///< content of case.resolved.toml
  bool si = false;
  std::vector<std::string> warnings;
  std::vector<BlockResolution> resolution = {};
};

/// What reports and summary.json tell of a model: plain data that stays when the model goes.
struct ModelFacts {
  Index particles = 0;
  Index bonds = 0;
  Index supported_particles = 0;
  std::vector<std::pair<std::string, Index>> bonds_by_law;  ///< in the order of the blocks
  std::vector<std::string> load_cases{""};
};
ModelFacts facts_of(const Model& model);

/// Where a model moves most.
struct LargestDisplacement {
  std::optional<Index> particle;  ///< its id; nothing where all particles are left out
  Vector3 displacement = Vector3::Zero();
};
LargestDisplacement largest_displacement(const Model& model, const State& state);
/// In each load case.
std::vector<LargestDisplacement> largest_displacements(const Model& model, const StaticSolution& solution);

/// Names of the files that are written, by so many ranks, relative to the folder; summary.json is the last.
std::vector<std::string> result_files(const ModelFacts& model, int ranks = 1);

/// summary.json as text; `files` is what it lists. Of the states, only names, energies and work are told: the
/// particles of `largest`, one a load case, may be those of other ranks.
std::string summary_json(const ModelFacts& model, const RunInfo& run, const StaticSolution& solution,
                         const std::vector<LargestDisplacement>& largest,
                         const std::vector<OutputValue>& outputs, const std::vector<std::string>& files);

/// Throws Error (invalid_input) where the results of so many ranks could not be written: no such place, not
/// allowed, or files there that are not results. Touches nothing; worth calling before a long solve.
void check_result_folder(const ModelFacts& model, const std::string& folder, int ranks = 1);

// The same where one process has the whole model.
std::vector<std::string> result_files(const Model& model, const std::vector<OutputValue>& outputs = {});
std::string summary_json(const Model& model, const RunInfo& run, const StaticSolution& solution,
                         const std::vector<OutputValue>& outputs, const std::vector<std::string>& files);
void check_result_folder(const Model& model, const std::string& folder);

/// Writes all files, whole or not at all: after any error the folder is as it was. Replaces the results of an
/// earlier run, never another file. `checkpoint` is called between pieces of work and may throw to give up;
/// `progress` hears there which part of the whole is written, about. Both may be called by other threads than
/// the caller's, one at a time. Files are formatted on solution.report.threads threads, and do not depend on
/// their number. Throws Error that names the path.
void write_results(const Model& model, const RunInfo& run, const StaticSolution& solution,
                   const std::vector<OutputValue>& outputs, const std::string& folder,
                   const std::function<void()>& checkpoint = {},
                   const std::function<void(double)>& progress = {});

// A run to rest has history.csv beside the tables of each load case (RelaxedCase::history), and where it kept
// states on its way
//
// relax.pvd      the states in time, relax_NNNN.vtu; NNNN is the step. The last one is that of model.vtu
//
// In these grids particles have velocity, too; loads are those of the case, not times the ramp's factor. As
// long as such a run is under way, they lie in relax.unfinished, a folder a load case as the results, with a
// relax.pvd that ParaView can follow. They stay there where a run blows up.

/// Adds the state of a load case to those that lie there, whole or not at all; arguments as RelaxHooks::show
/// has them. Throws Error that names the path.
void show_relaxation(const Model& model, const State& state, const std::vector<Vector6>& velocity,
                     const std::vector<SavedState>& saved, const std::string& folder);
/// Throws Error (invalid_input) where one of the states is not there, which are given for each load case, or
/// for the first few of them.
void check_shown_relaxation(const Model& model, const std::vector<std::vector<SavedState>>& saved,
                            const std::string& folder);
/// Removes all states but these. Those that are dropped may only go once no checkpoint speaks of them.
void keep_shown_relaxation(const Model& model, const std::vector<std::vector<SavedState>>& saved,
                           const std::string& folder);

/// As result_files() and the following. Where the run is at rest, a checkpoint that lies in the folder has
/// served and goes. RelaxedCase::saved must have been shown to the same folder.
std::vector<std::string> relaxation_files(const Model& model, const Relaxation& relaxation = {});
std::string relaxation_json(const Model& model, const RunInfo& run, const Relaxation& relaxation,
                            const std::vector<OutputValue>& outputs, const std::vector<std::string>& files);
void check_relaxation_folder(const Model& model, const RelaxOptions& asked, const std::string& folder);
void write_relaxation(const Model& model, const RunInfo& run, const Relaxation& relaxation,
                      const std::vector<OutputValue>& outputs, const std::string& folder,
                      const std::function<void()>& checkpoint = {});

// A run of fracture leaves the tables and the grid of its last state, and beside them
//
// fracture.csv   a row a broken bond: step (its event, from 1), factor, load, displacement, bond, a, b (ids),
//                mode, utilisation, runner_up, released, strain_energy, work, dissipated, factor_after,
//                load_after, displacement_after, avalanche (from 1), and the outputs just before the event
// fracture.svg   load over displacement
// fracture.pvd   the states that were shown, fracture_NNNN.vtu; NNNN events had happened by then. That is the
//                time of the series, as displacement may fall
//
// In bonds.csv and in the grids bonds have break_step, the step in which they broke (0: whole), and
// utilisation (empty: broken, left out, or without a strength). A broken bond carries zero. Loads in the
// grids are those of the pattern as the case gives them, not times the factor.
//
// As long as such a run is under way, what it has shown lies in fracture.unfinished, with a fracture.pvd that
// ParaView can follow, and what it found in fracture.checkpoint.

/// What the hooks of a run have heard of it.
struct FractureRecord {
  std::vector<HistoryColumn> outputs;  ///< of each event, in the state just before it
  std::vector<Index> states;           ///< shown, ascending: how many events had happened by then
};

/// Adds a state to those that are shown, whole or not at all; `break_event` as in Fracture. The same state
/// may come again. Throws Error that names the path.
void show_fracture(const Model& model, const State& state, const std::vector<Index>& break_event,
                   FractureRecord& record, const std::string& folder);

std::vector<std::string> fracture_files(const FractureRecord& record);
/// `outputs`: in the last state.
std::string fracture_json(const Model& model, const RunInfo& run, const FractureOptions& asked,
                          const Fracture& fracture, const std::vector<OutputValue>& outputs,
                          const std::vector<std::string>& files);
/// Throws as check_result_folder(), and where a state of `record`, the run to go on with, is not there. The
/// states of a run that nobody can go on with are removed.
void check_fracture_folder(const std::string& folder, const FractureRecord& record = {});
/// As write_results(). Where the run was interrupted, it can be gone on with afterwards.
void write_fracture(const Model& model, const RunInfo& run, const FractureOptions& asked,
                    const Fracture& fracture, const FractureRecord& record,
                    const std::vector<OutputValue>& outputs, const std::string& folder,
                    const std::function<void()>& checkpoint = {});

/// The certificate as JSON.
std::string certificate_json(const Model& model, const RunInfo& run, const Certificate& certificate);

/// Name of the checkpoint of a run to rest, inside the folder of its results.
inline constexpr const char* checkpoint_file = "relax.checkpoint";
/// Likewise, of a run of fracture.
inline constexpr const char* fracture_checkpoint_file = "fracture.checkpoint";

/// The worst of each figure over the load cases.
Accuracy worst_accuracy(const StaticSolution& solution);

}  // namespace bondstatic
