#include "python/node_of.hpp"

namespace bondstatic {

namespace {

bool is_instance_of(const py::handle& value, const char* module, const char* type) {
  return py::isinstance(value, py::module_::import(module).attr(type));
}

Node plain_node_of(const py::handle& value, const std::string& caller) {
  Node node;
  if (py::isinstance<py::dict>(value)) {
    for (const auto& [key, member] : py::reinterpret_borrow<py::dict>(value))
      if (!member.is_none()) node.set(py::str(key), node_of(member, caller));
    return node;
  }
  if (py::isinstance<py::str>(value)) return Node::of(value.cast<std::string>());
  if (py::isinstance<py::bool_>(value) || is_instance_of(value, "numpy", "bool_"))
    return Node::of(bool(py::bool_(py::reinterpret_borrow<py::object>(value))));
  if (is_instance_of(value, "numbers", "Integral")) return Node::of(value.cast<Index>());
  if (is_instance_of(value, "numbers", "Real")) return Node::of(value.cast<double>());
  if (is_instance_of(value, "collections.abc", "Iterable")) {
    node.kind = Node::Kind::array;
    for (const py::handle item : value) node.items.push_back(node_of(item, caller));
    return node;
  }
  throw py::type_error(caller + ": " + std::string(py::repr(value)) + " is no number, text, list or dict");
}

}  // namespace

Node node_of(const py::handle& value, const std::string& caller) {
  Node node = plain_node_of(value, caller);
  node.place = {caller, 0, 0};
  for (Node& item : node.items) item.key_place = node.place;
  return node;
}

}  // namespace bondstatic
