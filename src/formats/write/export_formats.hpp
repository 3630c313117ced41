// Writers of models for other codes. Each puts its files into a FileSet and tells what a user must know of
// them; what a code cannot carry is told, never left out in silence.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

/// What an export tells of its files, each a full sentence.
struct ExportNotes {
  std::vector<std::string> files;          ///< relative to the folder, in the order of writing
  std::vector<std::string> remarks;        ///< what was assumed or changed on the way; the model is the same
  std::vector<std::string> not_expressed;  ///< what makes the exported model another one
  std::vector<std::string> next_steps;     ///< commands: how to run it, how to compare afterwards
};

struct ExportInput {
  const Model& model;  ///< of several load cases only for ExportFormat::all_load_cases
  std::span<const BondProperties> properties;  ///< one a bond
  std::string title = {};
  std::string case_file = {};     ///< for the commands in the notes
  std::string case_options = {};  ///< likewise, what makes the case this model: " --load-case up", or ""
  bool si = false;                ///< numbers are SI
  const State* state = nullptr;   ///< static answer of the load case; null where it was not asked for
  bool relaxed = false;           ///< the export starts at that answer
  bool drop_unsupported = false;  ///< bodies that nothing supports are left out of a solve
  // Of a run by the other code, where the format needs them:
  double time_step = 0;
  Index steps = 0;              ///< until at rest, about
  double particle_damping = 0;  ///< gamma of [Chen2022] Eq. 11-12, as in Cundall's local damping
};

struct ExportFormat {
  std::string name;
  std::string description;
  bool all_load_cases = false;  ///< can hold more than one
  bool needs_run = false;       ///< asks for the static answer and the numbers of a run
  /// Appends to `notes`; what they tell already stands in the files as well.
  void (*write)(const ExportInput& input, FileSet& files, ExportNotes& notes);
};

/// In the order of the listing.
const std::vector<ExportFormat>& export_formats();

/// Starts a file and lists it.
OutputFile& create(FileSet& files, ExportNotes& notes, const std::string& name);

/// Bonds that do not go to the nearest image of their far end, or to one of several that are as near: a code
/// that knows a bond by its particles alone takes another image.
Index bonds_to_other_images(const Model& model);
/// Throws Error (invalid_input) that says so where there is no bond.
void need_bonds(const Model& model, const std::string& format);

/// Position and orientation of a particle in the static answer: x + u, and the turn by its rotation vector.
/// Particles that were left out of it stay where they are.
Vector3 relaxed_position(const ExportInput& input, std::size_t particle);
Eigen::Quaterniond relaxed_orientation(const ExportInput& input, std::size_t particle);
/// The six components of a particle's motion; zero for particles that were left out.
Vector6 relaxed_motion(const ExportInput& input, std::size_t particle);

void write_lammps(const ExportInput& input, FileSet& files, ExportNotes& notes);
void write_liggghts(const ExportInput& input, FileSet& files, ExportNotes& notes);
void write_csv_case(const ExportInput& input, FileSet& files, ExportNotes& notes);
void write_vtu_model(const ExportInput& input, FileSet& files, ExportNotes& notes);

}  // namespace bondstatic
