// Case files and files of other codes, read off the interpreter's thread.
#include "bondstatic/case_file.hpp"
#include "case/imported_case.hpp"
#include "formats/import_files.hpp"
#include "python/background.hpp"
#include "python/fracture_options.hpp"
#include "python/parts.hpp"
#include "python/python_model.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

template <class Result>
Result read_watched(std::function<Result()> read) {
  const auto result = std::make_shared<std::optional<Result>>();
  run_watched([result, read = std::move(read)](Watch&) { result->emplace(read()); });
  return std::move(**result);
}

std::unique_ptr<PythonModel> model_of(Model model) {
  auto made = std::make_unique<PythonModel>();
  made->edited = EditedModel(std::move(model));
  return made;
}

py::tuple read_case_file(const std::string& file, const std::vector<std::string>& overrides,
                         bool for_fracture) {
  const Purpose purpose = for_fracture ? Purpose::fracture : Purpose::statics;
  Case given = read_watched<Case>(
      [file, overrides, purpose] { return read_case(file, overrides, "", purpose, cores_at_hand()); });
  auto model = model_of(std::move(given.model));
  given.model = {};
  return py::make_tuple(std::move(model), std::move(given));
}

/// What an input script holds and loads becomes groups, supports and loads.
void apply_setup(Draft& draft, const ForeignSetup& setup) {
  std::vector<Index> all(draft.model.particles.size());
  for (std::size_t p = 0; p < all.size(); ++p) all[p] = Index(p);
  for (const ForeignGroup& group : setup.groups) draft.groups[group.name] = group.members;
  const auto members = [&](const std::string& group) -> const std::vector<Index>& {
    return group == "all" && !draft.groups.contains(group) ? all : draft.groups.at(group);
  };
  for (const ForeignSupport& support : setup.supports)
    for (const Index particle : members(support.group))
      draft.model.supports.push_back({particle, support.fixed, Vector6::Zero(), every_case});
  for (const ForeignLoad& load : setup.loads)
    for (const Index particle : members(load.group)) {
      Load made{particle, Vector6::Zero(), every_case};
      made.force.head<3>() =
          load.value * (load.gravity ? mass(draft.model.particles[std::size_t(particle)]) : 1.0);
      draft.model.loads.push_back(made);
    }
}

py::tuple import_model(const std::vector<std::string>& files, const std::string& atom_style,
                       const std::vector<std::string>& bond_columns, std::optional<Index> step,
                       std::optional<double> radius) {
  ImportOptions options;
  options.read.atom_style = atom_style;
  options.read.bond_columns = bond_columns;
  options.read.step = step;
  Imported imported = read_watched<Imported>([files, options] { return import_files(files, options); });
  Model model;
  model.particles = std::move(imported.model.particles);
  model.cell = imported.model.cell;
  for (Particle& particle : model.particles) {
    if (std::isnan(particle.radius) && radius) particle.radius = *radius;
    if (std::isnan(particle.radius))
      throw InputError(
          {{{files.front(), 0, 0}, "no file gives radii", "give radius = R to read(), of each particle"}});
  }
  auto made = model_of(std::move(model));
  made->edited.edit("read", [&](Draft& draft) {
    const ForeignModel& from = imported.model;
    for (std::size_t p = 0; p < from.group.size(); ++p)
      if (const std::string& name = from.group_names[std::size_t(from.group[p])]; !name.empty())
        draft.groups[name].push_back(Index(p));
    apply_setup(draft, imported.setup);
  });
  imported.model.particles.clear();
  if (!imported.model.bonds.empty())
    made->listed = std::make_shared<const ForeignModel>(std::move(imported.model));
  const ImportNotes& notes = made->listed ? made->listed->notes : imported.model.notes;
  return py::make_tuple(std::move(made), notes.taken, notes.assumed, notes.left_out);
}

}  // namespace

void add_read(py::module_& module) {
  py::class_<Case>(module, "CaseFacts", "What a case file says besides its model.")
      .def_readonly("title", &Case::title)
      .def_readonly("file", &Case::file)
      .def_readonly("outputs", &Case::outputs)
      .def_readonly("warnings", &Case::warnings)
      .def_readonly("resolved", &Case::resolved, "The case as TOML with defaults and overrides filled in.")
      .def_readonly("solve", &Case::solve)
      .def_readonly("relax", &Case::relax)
      .def_property_readonly("fracture", &fracture_options_of);
  module.def("read_case", &read_case_file, py::arg("file"), py::arg("overrides"), py::arg("for_fracture"));
  module.def("import_files", &import_model, py::arg("files"), py::arg("atom_style"), py::arg("bond_columns"),
             py::arg("step"), py::arg("radius"));
}

}  // namespace bondstatic
