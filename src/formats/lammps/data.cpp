#include "formats/lammps/data.hpp"

#include <fmt/format.h>

#include "formats/lammps/atoms.hpp"
#include "formats/lammps/bond_coeffs.hpp"
#include "formats/lammps/data_header.hpp"
#include "formats/lammps/data_periodic.hpp"
#include "formats/lammps/type_groups.hpp"
#include "formats/particle_ids.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

class DataFile {
 public:
  DataFile(LineReader& reader, DataHeaderEnd header, const ReadOptions& options, LammpsAtoms& atoms,
           std::vector<Fault>& faults)
      : reader_(reader),
        options_(options),
        faults_(faults),
        section_faults_(faults),
        header_(std::move(header.header)),
        sections_(reader, std::move(header.section), options, faults),
        atoms_(atoms),
        atom_types_("atom type", highest_of("atom types")),
        bond_types_("bond type", highest_of("bond types")) {}

  bool read(ForeignModel& model) {
    const std::size_t before = faults_.size();
    model_ = &model;
    model.title = header_.title;
    while (!gave_up_ && sections_.next_section()) section();
    if (reader_.failed()) return false;
    for (const char* name : {"Atoms", "Bonds"}) require(name);
    if (faults_.size() == before) check_bonds();
    if (faults_.size() != before) return false;
    finish();
    return faults_.size() == before;
  }

 private:
  void section() {
    const std::string& name = sections_.name();
    if (!seen_.emplace(name, sections_.line()).second) {
      wrong_section(fmt::format("section \"{}\" is there twice, first in line {}", shown(name), seen_[name]),
                    "remove one of them");
      return;
    }
    if (name == "Atoms") {
      options_.particles ? read_atoms() : check_count("atoms", sections_.skip_rows());
    } else if (name == "Bonds") {
      options_.bonds ? read_bonds() : check_count("bonds", sections_.skip_rows());
    } else if (name == "Bond Coeffs" && options_.bonds) {
      RowFields fields(reader_, faults_);
      coefficients_ = read_bond_coefficients(sections_, fields, bond_types_, model_->notes);
    } else if (name == "Atom Type Labels" || name == "Bond Type Labels") {
      (name == "Atom Type Labels" ? atom_types_ : bond_types_).read_labels(sections_, reader_, faults_);
    } else if (const std::string near = nearest_lammps_section(name); !near.empty()) {
      wrong_section(fmt::format("section \"{}\" is not known", shown(name)),
                    fmt::format("did you mean \"{}\"?", near));
    } else {
      model_->notes.left_out.push_back(
          fmt::format("Section {}, {} lines.", shown(name), sections_.skip_rows()));
    }
  }

  void wrong_section(const std::string& message, const std::string& cure) {
    gave_up_ = !section_faults_.add({reader_.file(), sections_.line(), 1}, message, cure);
  }

  void require(const std::string& section) {
    const bool atoms = section == "Atoms";
    const std::string count = atoms ? "atoms" : "bonds";
    const auto announced = header_.counts.find(count);
    const Index number = header_.count(count);
    if (atoms && number == 0)
      faults_.push_back({{reader_.file(), announced == header_.counts.end() ? 1 : announced->second.line, 1},
                         "the header announces no atoms",
                         "a header needs a line such as \"1000 atoms\" before the first section"});
    else if (number > 0 && !seen_.contains(section))
      faults_.push_back(
          {{reader_.file(), announced->second.line, 1},
           fmt::format("{} {} are announced, but there is no section {}", number, count, section),
           "the file is cut short, or the section is missing"});
  }

  void check_count(const std::string& of, Index there) {
    const Index announced = header_.count(of);
    if (there == announced || reader_.failed()) return;
    faults_.push_back(
        {{reader_.file(), sections_.line(), 1},
         fmt::format("{} has {} lines, but the header announces {} {}", sections_.name(), there, announced,
                     of),
         there < announced ? "the file is cut short, or correct the header" : "correct the header"});
  }

  /// Highest number of a kind of types, where the header says it.
  Index highest_of(const std::string& count) const {
    const auto declared = header_.counts.find(count);
    return declared == header_.counts.end() ? highest_type : std::min(declared->second.value, highest_type);
  }

  void read_atoms() {
    const auto rows = read_lammps_atoms(sections_, reader_, header_.count("atoms"), options_, atom_types_,
                                        *model_, atoms_, faults_);
    if (rows) check_count("atoms", *rows);
  }

  void read_bonds() {
    RowFields fields(reader_, faults_);
    Index rows = 0, broken = 0;
    const std::size_t room = std::size_t(std::min<std::uint64_t>(header_.count("bonds"), reader_.size() / 8));
    model_->bonds.reserve(room);
    model_->bond_line.reserve(room);
    while (const auto row = sections_.next_row()) {
      ++rows;
      fields.take(*row);
      if (fields.size() != 4) {
        fields.fault(4, fmt::format("{} fields where a bond has 4 (id, type, two atoms)", fields.size()),
                     "correct the line");
      } else {
        ForeignBond bond;
        const auto id = fields.whole_number(0, "bond id"), type = bond_types_.number(fields, 1, 0);
        const auto a = fields.whole_number(2, "first atom"), b = fields.whole_number(3, "second atom");
        if (id && type && a && b) {
          bond = {*id, *a, *b, *type};
          if (*a == *b)
            fields.fault(3, fmt::format("a bond of particle {} with itself", *a), "remove the bond");
          if (*type == 0) {
            ++broken;
          } else {
            model_->bonds.push_back(bond);
            model_->bond_line.push_back(reader_.line());
          }
        }
      }
      if (fields.gave_up()) return;
    }
    check_count("bonds", rows);
    model_->notes.taken.push_back(fmt::format("{} bonds.", model_->bonds.size()));
    if (broken > 0)
      model_->notes.left_out.push_back(fmt::format("{} bonds of type 0, which are broken.", broken));
  }

  void check_bonds() {
    if (!options_.particles) return;
    std::vector<Index> ids(model_->particles.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = model_->particles[i].id;
    const IdTable known = table_of_ids("particle", ids, model_->particle_line, reader_.file(), faults_);
    LimitedFaults limited(faults_);
    for (std::size_t k = 0; k < model_->bonds.size(); ++k)
      for (const Index id : {model_->bonds[k].a, model_->bonds[k].b})
        if (!known.position_of(id) &&
            !limited.add({reader_.file(), model_->bond_line[k], 1},
                         fmt::format("a bond of particle {}, which is not in the section Atoms", id),
                         "remove the bond, or give the particle"))
          return;
  }

  void finish() {
    ForeignModel& model = *model_;
    if (options_.particles) {
      group_by_type(atoms_.types, model);
      find_periodic_directions(header_, atoms_.images, model);
    }
    drop_repeated_bond_ids();
    spread_bond_coefficients(coefficients_, {reader_.file(), seen_["Bond Coeffs"], 1}, model, faults_);
    if (!model.bonds.empty())
      model.notes.assumed.push_back(
          "Bonds carry nothing where their particles are now: a data file does not hold their reference "
          "state.");
    if (!reader_.line_ended())
      model.notes.assumed.push_back("The file is whole, although its last line has no end.");
    model.si = header_.units == "si";
    note_units();
  }

  /// LAMMPS does not look at the numbers of bonds, so files have any.
  void drop_repeated_bond_ids() {
    IdTable ids;
    ids.expect(Index(model_->bonds.size()));
    bool repeated = false;
    for (const ForeignBond& bond : model_->bonds) repeated = !ids.add(bond.id, 0) || repeated;
    if (!repeated) return;
    for (ForeignBond& bond : model_->bonds) bond.id = -1;
    model_->notes.assumed.push_back(
        "Bonds are numbered in their order: some numbers of the file are there twice.");
  }

  void note_units() {
    auto& assumed = model_->notes.assumed;
    const std::string& units = header_.units;
    if (units.empty())
      assumed.push_back("The file does not say its units: numbers are taken as they are.");
    else if (units == "real" || units == "metal" || units == "electron")
      assumed.push_back(
          fmt::format("LAMMPS's units {} are no consistent system: forces are not mass times length "
                      "over time squared. Numbers are taken as they are.",
                      units));
    else if (units != "si")
      assumed.push_back(fmt::format("LAMMPS's units {}: numbers are taken as they are.", units));
  }

  LineReader& reader_;
  const ReadOptions& options_;
  std::vector<Fault>& faults_;
  LimitedFaults section_faults_;
  bool gave_up_ = false;
  DataHeader header_;
  DataSections sections_;
  ForeignModel* model_ = nullptr;
  LammpsAtoms& atoms_;
  TypeNumbers atom_types_, bond_types_;
  BondCoefficients coefficients_;
  std::map<std::string, int> seen_;  // sections and their lines
};

struct ReadData {
  ForeignModel model;
  LammpsAtoms atoms;
  std::optional<Index> step;
  Cell box;
};

std::optional<ReadData> read_data(const std::string& path, const ReadOptions& options, const Place& named_at,
                                  std::vector<Fault>& faults) {
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  ReadData data;
  data.model.format = format_name(FileFormat::lammps_data);
  auto header = read_data_header(*reader, data.model.notes, faults);
  if (!header) return std::nullopt;
  data.step = header->header.step;
  data.box = header->header.box;
  if (!DataFile(*reader, std::move(*header), options, data.atoms, faults).read(data.model))
    return std::nullopt;
  if (options.progress) options.progress(1);
  return data;
}

}  // namespace

std::optional<ForeignModel> read_lammps_data(const std::string& path, const ReadOptions& options,
                                             const Place& named_at, std::vector<Fault>& faults) {
  auto data = read_data(path, options, named_at, faults);
  if (!data) return std::nullopt;
  return std::move(data->model);
}

std::optional<ParticleState> read_lammps_data_state(const std::string& path, const ReadOptions& options,
                                                    const Place& named_at, std::vector<Fault>& faults) {
  ReadOptions wanted = options;
  wanted.particles = true;
  auto data = read_data(path, wanted, named_at, faults);
  if (!data) return std::nullopt;
  ParticleState state;
  state.step = data->step.value_or(0);
  state.unwrapped = !data->atoms.images.empty();
  data->atoms.images.resize(data->model.particles.size());
  for (std::size_t i = 0; i < data->model.particles.size(); ++i) {
    const Particle& particle = data->model.particles[i];
    const auto& image = data->atoms.images[i];
    state.id.push_back(particle.id);
    state.position.push_back(particle.position + data->box.edges * Vector3(image[0], image[1], image[2]));
    if (particle.radius > 0) state.radius.push_back(particle.radius);
  }
  state.cell = data->model.cell;
  state.notes = {"Positions and radii of a data file, which has neither orientations nor forces."};
  return state;
}

}  // namespace bondstatic
