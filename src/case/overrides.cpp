#include "case/overrides.hpp"

#include <fmt/format.h>

#include <charconv>

#include "case/toml_text.hpp"

namespace bondstatic {
namespace {

constexpr std::size_t longest_key = 16;  // parts

std::vector<std::string> split(const std::string& key) {
  std::vector<std::string> parts(1);
  for (const char c : key)
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

void set_place(Node& node, const Place& place) {
  node.place = node.key_place = place;
  for (Node& item : node.items) set_place(item, place);
}

Node value_of(const std::string& text) {
  if (auto value = parse_toml_value(text)) return *value;
  // ".5", "+.5" and "5." are numbers to everybody but TOML.
  double number = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) return Node::of(number);
  return Node::of(text);
}

/// The item of a list, null where `part` is no position in it.
Node* item_at(Node& list, const std::string& part) {
  std::size_t position = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), position);
  if (error != std::errc() || end != part.data() + part.size() || position >= list.items.size())
    return nullptr;
  return &*std::next(list.items.begin(), std::ptrdiff_t(position));
}

void apply(Node& root, const std::string& setting, std::vector<Fault>& faults) {
  const Place place{"--set " + setting, 0, 0};
  const auto fail = [&](const std::string& message, const std::string& cure) {
    faults.push_back({place, message, cure});
  };
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size())
    return fail("a setting must be KEY=VALUE", "write for instance --set bonds.0.young=70e9");
  const std::vector<std::string> parts = split(setting.substr(0, equals));
  if (parts.size() > longest_key) return fail("the key has too many parts", "no key of a case is that deep");

  Node* node = &root;
  std::string so_far;
  for (const std::string& part : parts) {
    if (part.empty()) return fail("the key has an empty part", "write for instance bonds.0.young");
    if (node->is_array()) {
      Node* item = item_at(*node, part);
      if (!item && node->items.empty()) return fail(fmt::format("{} is empty", so_far), "set the whole list");
      if (!item)
        return fail(
            fmt::format("\"{}\" is no position in {}, which has {}", part, so_far, node->items.size()),
            fmt::format("positions run from 0 to {}", node->items.size() - 1));
      node = item;
    } else if (node->is_table()) {
      Node* member = node->find(part);
      if (!member) {
        Node fresh;
        set_place(fresh, place);
        member = &node->set(part, fresh);
      }
      node = member;
    } else {
      return fail(fmt::format("{} = {} has no parts: \"{}\" leads nowhere", so_far, shown(*node), part),
                  fmt::format("set {} itself", so_far));
    }
    so_far += (so_far.empty() ? "" : ".") + part;
  }
  const Node before = *node;
  *node = value_of(setting.substr(equals + 1));
  set_place(*node, place);
  node->key = before.key;
}

}  // namespace

void apply_overrides(Node& root, const std::vector<std::string>& overrides, std::vector<Fault>& faults) {
  for (const std::string& setting : overrides) apply(root, setting, faults);
}

Node* find_node(Node& root, const std::string& key) {
  Node* node = &root;
  for (const std::string& part : split(key)) {
    if (node) node = node->is_array() ? item_at(*node, part) : node->find(part);
  }
  return node;
}

}  // namespace bondstatic
