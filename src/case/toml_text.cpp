#include "case/toml_text.hpp"

// Its assertions fail on malformed text that the parser goes on to reject properly.
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_MAX_NESTED_VALUES 64
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "case/toml_guard.hpp"

namespace bondstatic {
namespace {

Place place_of(const toml::source_region& region, const std::string& file) {
  return {file, int(region.begin.line), int(region.begin.column)};
}

Node tree(const toml::node& value, const std::string& file);

void add_members(const toml::table& table, const std::string& file, Node& node) {
  struct Member {
    const toml::key* key;
    const toml::node* value;
  };
  std::vector<Member> members;
  for (auto&& [key, value] : table) members.push_back({&key, &value});
  // toml++ sorts by name; people read, and expect back, the order of the file.
  std::stable_sort(members.begin(), members.end(), [](const Member& left, const Member& right) {
    const auto &l = left.key->source().begin, &r = right.key->source().begin;
    return l.line != r.line ? l.line < r.line : l.column < r.column;
  });
  for (const Member& member : members) {
    Node& item = node.items.emplace_back(tree(*member.value, file));
    item.key = std::string(member.key->str());
    item.key_place = place_of(member.key->source(), file);
  }
}

Node tree(const toml::node& value, const std::string& file) {
  Node node;
  node.place = place_of(value.source(), file);
  if (const toml::table* table = value.as_table()) {
    add_members(*table, file, node);
  } else if (const toml::array* array = value.as_array()) {
    node.kind = Node::Kind::array;
    for (const toml::node& item : *array) node.items.push_back(tree(item, file));
  } else if (const auto* text = value.as_string()) {
    node.kind = Node::Kind::text;
    node.text = text->get();
  } else if (const auto* whole = value.as_integer()) {
    node.kind = Node::Kind::whole;
    node.whole = whole->get();
  } else if (const auto* real = value.as_floating_point()) {
    node.kind = Node::Kind::real;
    node.real = real->get();
  } else if (const auto* truth = value.as_boolean()) {
    node.kind = Node::Kind::truth;
    node.truth = truth->get();
  } else {
    node.kind = Node::Kind::other;
    std::ostringstream written;
    value.visit([&](auto&& other) {
      if constexpr (toml::is_value<decltype(other)>) written << other.get();
    });
    node.text = written.str();
  }
  return node;
}

}  // namespace

std::optional<Node> parse_toml(const std::string& text, const std::string& file, std::vector<Fault>& faults) {
  if (auto fault = unfit_for_parsing(text, file)) {
    faults.push_back(std::move(*fault));
    return std::nullopt;
  }
  try {
    return tree(toml::parse(text, file), file);
  } catch (const toml::parse_error& error) {
    faults.push_back({place_of(error.source(), file), std::string(error.description()),
                      "the case file must be TOML (https://toml.io): key = value, texts in \"quotes\", "
                      "lists in [brackets], blocks under [[names]]"});
    return std::nullopt;
  }
}

std::optional<Node> parse_toml_value(const std::string& text) {
  if (text.find_first_of("\r\n") != std::string::npos) return std::nullopt;
  std::vector<Fault> ignored;
  std::optional<Node> root = parse_toml("value = " + text, "", ignored);
  if (!root || root->items.size() != 1) return std::nullopt;
  return std::move(root->items.front());
}

}  // namespace bondstatic
