// Model: its memory as views, and the steps in which it is made.
#include "python/model_arrays.hpp"
#include "python/model_steps.hpp"
#include "python/parts.hpp"

namespace bondstatic {

namespace {

/// A view of a number of each item; of a vector, of its first three.
template <class Item, class T>
auto column(std::vector<Item> Model::*items, T Item::*member) {
  return [items, member](const PythonModel& self) {
    const auto kept = self.edited.kept();
    const std::vector<Item>& of = (*kept).*items;
    const Item* first = of.empty() ? nullptr : of.data();
    if constexpr (std::is_same_v<T, Vector3>)
      return view_of_items<double>(kept, of, first ? (first->*member).data() : nullptr, 3);
    else
      return view_of_items<T>(kept, of, first ? &(first->*member) : nullptr);
  };
}

py::array bond_ends(const PythonModel& self) {
  static_assert(offsetof(Bond, b) == offsetof(Bond, a) + sizeof(Index));
  const auto kept = self.edited.kept();
  const Index* first = kept->bonds.empty() ? nullptr : &kept->bonds.front().a;
  return view_of_items<Index>(kept, kept->bonds, first, 2);
}

std::vector<std::string> laws_of(const PythonModel& self) {
  std::vector<std::string> laws;
  for (const BondBlock& block : self.edited.model().blocks) laws.push_back(block.law);
  return laws;
}

py::dict groups_of(const PythonModel& self) {
  py::dict groups;
  for (const auto& [name, members] : self.edited.draft().groups)
    groups[py::str(name)] = taken(std::vector<Index>(members));
  return groups;
}

}  // namespace

void add_model(py::module_& module) {
  py::class_<Output>(module, "Output", "A number that is asked of a solution.")
      .def_readonly("name", &Output::name, "As Solution.outputs tells it.")
      .def_readonly("of", &Output::of, "The quantity, as in a case file.")
      .def_readonly("case", &Output::load_case, "Load case; \"\" where there is one without a name.")
      .def_readonly("scale", &Output::scale, "Times this.")
      .def_readonly("expected", &Output::expected, "None where nothing is expected.")
      .def("__repr__",
           [](const Output& output) { return "<Output " + output.name + ": " + output.of + ">"; });

  py::class_<PythonModel>(module, "Model")
      .def(py::init(&model_of), py::arg("x"), py::arg("radius"), py::arg("ids"), py::arg("density"),
           py::arg("bonds"), py::arg("cell"))
      .def(py::init<const PythonModel&>(), py::arg("other"),
           "A copy; memory is shared until one of both changes.")
      .def_property_readonly("x", column(&Model::particles, &Particle::position))
      .def_property_readonly("radius", column(&Model::particles, &Particle::radius))
      .def_property_readonly("density", column(&Model::particles, &Particle::density))
      .def_property_readonly("ids", column(&Model::particles, &Particle::id))
      .def_property_readonly("bonds", &bond_ends)
      .def_property_readonly("bond_ids", column(&Model::bonds, &Bond::id))
      .def_property_readonly("block_of_bond", column(&Model::bonds, &Bond::block))
      .def_property_readonly("branch", column(&Model::bonds, &Bond::branch))
      .def_property_readonly("laws", &laws_of)
      .def_property_readonly("load_cases",
                             [](const PythonModel& self) { return self.edited.model().load_cases; })
      .def_property_readonly("groups", &groups_of)
      .def_property_readonly(
          "listed_bonds",
          [](const PythonModel& self) {
            return self.listed ? std::optional(self.listed->bonds.size()) : std::nullopt;
          },
          "How many; None where there is no list.")
      .def("positions_of", &positions_of, py::arg("ids"))
      .def("complete_cell", py::overload_cast<PythonModel&>(&complete_cell))
      .def("parameters", &parameters_of, py::arg("block"))
      .def("set", &set_parameters, py::arg("given"), py::arg("columns"), py::arg("block"))
      .def("bond", &add_bonds, py::arg("given"), py::arg("columns"), py::arg("strengths"), py::arg("listed"))
      .def("fix", &add_supports, py::arg("given"), py::arg("at"))
      .def("load", &add_loads, py::arg("given"), py::arg("at"))
      .def("group", &add_group, py::arg("given"), py::arg("at"))
      .def("output", &output_of, py::arg("given"), py::arg("places"));
}

}  // namespace bondstatic
