#include <fmt/format.h>

#include <algorithm>

#include "case/toml_text.hpp"
#include "formats/write/toml.hpp"

namespace bondstatic {
namespace {

std::string key_text(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? key : toml_text(key);
}

std::string value_text(const Node& node) {
  std::string out;
  switch (node.kind) {
    case Node::Kind::table:
      for (const Node& item : node.items)
        out += (out.empty() ? " " : ", ") + key_text(item.key) + " = " + value_text(item);
      return '{' + out + (out.empty() ? "}" : " }");
    case Node::Kind::array:
      for (const Node& item : node.items) out += (out.empty() ? "" : ", ") + value_text(item);
      return '[' + out + ']';
    case Node::Kind::text:
      return toml_text(node.text);
    case Node::Kind::whole:
      return fmt::format("{}", node.whole);
    case Node::Kind::real:
      return toml_number(node.real);
    case Node::Kind::truth:
      return node.truth ? "true" : "false";
    case Node::Kind::other:
      return node.text;
  }
  return out;
}

bool is_list_of_tables(const Node& node) {
  return node.is_array() && !node.items.empty() &&
         std::all_of(node.items.begin(), node.items.end(), [](const Node& item) { return item.is_table(); });
}

std::string members_text(const Node& table) {
  std::string out;
  for (const Node& item : table.items) out += key_text(item.key) + " = " + value_text(item) + '\n';
  return out;
}

}  // namespace

std::string to_toml(const Node& root) {
  std::string out;
  for (const Node& item : root.items)
    if (!item.is_table() && !is_list_of_tables(item))
      out += key_text(item.key) + " = " + value_text(item) + '\n';
  for (const Node& item : root.items) {
    if (item.is_table()) {
      out += "\n[" + key_text(item.key) + "]\n" + members_text(item);
    } else if (is_list_of_tables(item)) {
      for (const Node& block : item.items) out += "\n[[" + key_text(item.key) + "]]\n" + members_text(block);
    }
  }
  return out;
}

}  // namespace bondstatic
