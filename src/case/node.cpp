#include "case/node.hpp"

#include <fmt/format.h>

namespace bondstatic {

Node* Node::find(std::string_view member) {
  if (!is_table()) return nullptr;
  for (Node& item : items)
    if (item.key == member) return &item;
  return nullptr;
}

Node& Node::set(const std::string& member, Node value) {
  value.key = member;
  if (Node* found = find(member)) return *found = std::move(value);
  return items.emplace_back(std::move(value));
}

Node Node::of(double value) {
  Node node;
  node.kind = Kind::real;
  node.real = value;
  return node;
}

Node Node::of(Index value) {
  Node node;
  node.kind = Kind::whole;
  node.whole = value;
  return node;
}

Node Node::of(bool value) {
  Node node;
  node.kind = Kind::truth;
  node.truth = value;
  return node;
}

Node Node::of(const std::string& value) {
  Node node;
  node.kind = Kind::text;
  node.text = value;
  return node;
}

Node Node::of(const Vector3& value) {
  Node node;
  node.kind = Kind::array;
  for (int i = 0; i < 3; ++i) node.items.push_back(of(value[i]));
  return node;
}

std::string shown(const Node& node) {
  switch (node.kind) {
    case Node::Kind::table:
      return "a table";
    case Node::Kind::array:
      return fmt::format("a list of {}", node.items.size());
    case Node::Kind::text:
      return node.text.size() > 60 ? "a long text" : '"' + node.text + '"';
    case Node::Kind::whole:
      return fmt::format("{}", node.whole);
    case Node::Kind::real:
      return fmt::format("{}", node.real);
    case Node::Kind::truth:
      return node.truth ? "true" : "false";
    case Node::Kind::other:
      return node.text;
  }
  return {};
}

}  // namespace bondstatic
