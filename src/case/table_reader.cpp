#include "case/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/nearest_name.hpp"

namespace bondstatic {

TableReader::TableReader(Reading& reading, Node& table, std::string name)
    : reading_(reading), table_(table), name_(std::move(name)), valid_(table.is_table()) {
  if (!valid_)
    reading_.fault(table_.place, fmt::format("{} = {} must be a table", name_, shown(table_)),
                   "write { key = value, ... }");
}

Node* TableReader::find(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return valid_ ? table_.find(key) : nullptr;
}

const Place& TableReader::place_of(const std::string& key) {
  const Node* node = find(key);
  return node ? node->place : table_.place;
}

std::optional<double> TableReader::number(const std::string& key, Dimension dimension, Allowed allowed) {
  const Node* node = find(key);
  return node ? read_number(reading_, *node, key, dimension, allowed) : std::nullopt;
}

std::optional<Vector3> TableReader::vector(const std::string& key, Dimension dimension) {
  const Node* node = find(key);
  return node ? read_vector(reading_, *node, key, dimension) : std::nullopt;
}

std::optional<Vector3> TableReader::axis(const std::string& key) {
  const Node* node = find(key);
  return node ? read_axis(reading_, *node, key) : std::nullopt;
}

std::optional<Index> TableReader::whole(const std::string& key, Index lowest) {
  const Node* node = find(key);
  return node ? read_whole(reading_, *node, key, lowest) : std::nullopt;
}

std::optional<std::string> TableReader::text(const std::string& key) {
  const Node* node = find(key);
  return node ? read_text(reading_, *node, key) : std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(const std::string& key) {
  const Node* node = find(key);
  return node ? read_texts(reading_, *node, key) : std::nullopt;
}

void TableReader::set_default(const std::string& key, Node value) {
  if (valid_ && !has(key)) table_.set(key, std::move(value));
}

double TableReader::number_or(const std::string& key, double fallback, Dimension dimension, Allowed allowed) {
  const auto value = number(key, dimension, allowed);
  set_default(key, Node::of(fallback));
  return value.value_or(fallback);
}

Vector3 TableReader::vector_or(const std::string& key, const Vector3& fallback, Dimension dimension) {
  const auto value = vector(key, dimension);
  set_default(key, Node::of(fallback));
  return value.value_or(fallback);
}

Vector3 TableReader::axis_or(const std::string& key, const std::string& fallback) {
  set_default(key, Node::of(fallback));
  return axis(key).value_or(Vector3::UnitZ());
}

Index TableReader::whole_or(const std::string& key, Index fallback, Index lowest) {
  const auto value = whole(key, lowest);
  set_default(key, Node::of(fallback));
  return value.value_or(fallback);
}

bool TableReader::truth_or(const std::string& key, bool fallback) {
  const Node* node = find(key);
  if (node) return read_truth(reading_, *node, key).value_or(fallback);
  set_default(key, Node::of(fallback));
  return fallback;
}

std::string TableReader::choice_or(const std::string& key, const std::string& fallback,
                                   std::span<const std::string> choices) {
  const auto given = text(key);
  set_default(key, Node::of(fallback));
  if (!given) return fallback;
  if (std::find(choices.begin(), choices.end(), *given) != choices.end()) return *given;
  const std::string nearest = nearest_name(*given, choices);
  reading_.fault(place_of(key),
                 fmt::format("{} = \"{}\" must be one of: {}", key, *given, name_list(choices)),
                 nearest.empty() ? fmt::format("write {} = \"{}\"", key, choices.front())
                                 : fmt::format("did you mean \"{}\"?", nearest));
  return fallback;
}

bool TableReader::require(const std::string& key, const std::string& cure) {
  if (has(key)) return true;
  if (valid_) reading_.fault(table_.place, fmt::format("{} needs {}", name_, key), cure);
  return false;
}

std::string TableReader::at_most_one_of(std::span<const std::string> keys) {
  std::vector<std::string> given;
  for (const std::string& key : keys)
    if (has(key)) given.push_back(key);
  if (given.size() > 1)
    reading_.fault(place_of(given[1]),
                   fmt::format("{} has {}: they exclude each other", name_, name_list(given)),
                   "keep one of them");
  return given.empty() ? "" : given.front();
}

std::string TableReader::one_of(std::span<const std::string> keys) {
  const std::string given = at_most_one_of(keys);
  if (given.empty() && valid_)
    reading_.fault(table_.place, fmt::format("{} needs one of: {}", name_, name_list(keys)),
                   fmt::format("add {} = ...", keys.front()));
  return given;
}

std::optional<std::string> TableReader::path(const std::string& key) {
  if (!text(key)) return std::nullopt;
  return resolve_path(reading_, *find(key));
}

void TableReader::finish() {
  if (!valid_ || any_key_) return;
  for (const Node& item : table_.items) {
    if (std::find(known_.begin(), known_.end(), item.key) != known_.end()) continue;
    const std::string nearest = nearest_name(item.key, known_);
    reading_.fault(item.key_place, fmt::format("unknown key \"{}\" in {}", item.key, name_),
                   nearest.empty() ? fmt::format("known here: {}", name_list(known_))
                                   : fmt::format("did you mean \"{}\"?", nearest));
  }
}

void for_each_table(Reading& reading, Node* list, const std::string& key,
                    const std::function<void(TableReader&)>& read) {
  if (!list) return;
  const std::string name = "[[" + key + "]]";
  if (!list->is_array()) {
    reading.fault(list->place, fmt::format("{} is {}, not a list of tables", key, shown(*list)),
                  fmt::format("start each block with {} in double brackets", name));
    return;
  }
  for (Node& item : list->items) {
    TableReader reader(reading, item, name);
    if (!item.is_table()) continue;
    read(reader);
    reader.finish();
  }
}

}  // namespace bondstatic
