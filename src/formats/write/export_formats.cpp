#include "formats/write/export_formats.hpp"

#include "bondstatic/error.hpp"
#include "model/cell.hpp"
#include "model/turning.hpp"

namespace bondstatic {

const std::vector<ExportFormat>& export_formats() {
  static const std::vector<ExportFormat> formats{
      {"lammps", "LAMMPS: data file and a runnable input deck (bond_style bpm/rotational)", false, true,
       write_lammps},
      {"liggghts", "LIGGGHTS with bonds: data file and commands (bond_style gran)", false, false,
       write_liggghts},
      {"csv", "particles.csv, bonds.csv and a case file that reads them", true, false, write_csv_case},
      {"vtu", "model.vtu for ParaView: radii, supports, loads and stiffnesses", false, false,
       write_vtu_model},
  };
  return formats;
}

OutputFile& create(FileSet& files, ExportNotes& notes, const std::string& name) {
  notes.files.push_back(name);
  return files.create(name);
}

Index bonds_to_other_images(const Model& model) {
  if (!model.cell) return 0;
  constexpr double doubt = 1e-6;  // of the length, as where a case takes bonds from a table
  Index count = 0;
  for (const Bond& bond : model.bonds) {
    const NearestImage nearest = nearest_image(*model.cell, bond.branch);
    count += nearest.image != CellImage{} || nearest.next_length <= (1 + doubt) * nearest.length;
  }
  return count;
}

void need_bonds(const Model& model, const std::string& format) {
  if (model.bonds.empty())
    throw Error(ExitCode::invalid_input,
                "the case has no bonds, and a " + format +
                    " deck is about nothing else\n    cure: add [[bonds]], or export to csv or vtu");
}

Vector6 relaxed_motion(const ExportInput& input, std::size_t particle) {
  const Vector6& motion = input.state->displacement[particle];
  return motion.allFinite() ? motion : Vector6(Vector6::Zero());
}

Vector3 relaxed_position(const ExportInput& input, std::size_t particle) {
  return input.model.particles[particle].position + relaxed_motion(input, particle).head<3>();
}

Eigen::Quaterniond relaxed_orientation(const ExportInput& input, std::size_t particle) {
  return quaternion(relaxed_motion(input, particle).tail<3>());
}

}  // namespace bondstatic
