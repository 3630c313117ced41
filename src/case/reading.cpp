#include "case/reading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace bondstatic {
namespace {

std::string number_cure(const std::string& name, Dimension dimension) {
  if (dimension == dimension::none) return fmt::format("write {} = NUMBER", name);
  return fmt::format("write {0} = NUMBER, or with a unit as a text: {0} = \"NUMBER {1}\"", name,
                     si_unit(dimension));
}

}  // namespace

std::optional<double> read_number(Reading& reading, const Node& node, const std::string& name,
                                  Dimension dimension, Allowed allowed) {
  double value = 0;
  if (node.kind == Node::Kind::whole) {
    value = double(node.whole);
  } else if (node.kind == Node::Kind::real) {
    value = node.real;
  } else if (node.is_text()) {
    try {
      value = parse_quantity(node.text, dimension);
      if (!(dimension == dimension::none)) reading.si = true;
    } catch (const std::invalid_argument& error) {
      reading.fault(node.place, fmt::format("{} = {}: {}", name, shown(node), error.what()),
                    number_cure(name, dimension));
      return std::nullopt;
    }
  } else {
    reading.fault(node.place, fmt::format("{} = {} must be a number", name, shown(node)),
                  number_cure(name, dimension));
    return std::nullopt;
  }
  const char* wrong = !std::isfinite(value)                               ? "must be finite"
                      : allowed == Allowed::positive && !(value > 0)      ? "must be positive"
                      : allowed == Allowed::not_negative && !(value >= 0) ? "must not be negative"
                                                                          : nullptr;
  if (!wrong) return value;
  reading.fault(node.place, fmt::format("{} = {} {}", name, shown(node), wrong),
                number_cure(name, dimension));
  return std::nullopt;
}

std::optional<Vector3> read_vector(Reading& reading, const Node& node, const std::string& name,
                                   Dimension dimension) {
  if (!node.is_array() || node.items.size() != 3) {
    reading.fault(node.place, fmt::format("{} = {} must be a list of three numbers", name, shown(node)),
                  fmt::format("write {} = [X, Y, Z]", name));
    return std::nullopt;
  }
  Vector3 vector;
  bool sound = true;
  int i = 0;
  for (const Node& item : node.items) {
    const auto value = read_number(reading, item, fmt::format("{}[{}]", name, i), dimension);
    sound = sound && value;
    vector[i++] = value.value_or(0);
  }
  return sound ? std::optional(vector) : std::nullopt;
}

std::optional<Index> read_whole(Reading& reading, const Node& node, const std::string& name, Index lowest) {
  if (node.kind == Node::Kind::whole && node.whole >= lowest) return node.whole;
  // 3.0 and 1e3 are whole numbers to whoever writes them, in a sweep above all.
  if (node.kind == Node::Kind::real && std::abs(node.real) < 9e15 && std::trunc(node.real) == node.real &&
      node.real >= double(lowest))
    return Index(node.real);
  reading.fault(node.place,
                fmt::format("{} = {} must be a whole number, at least {}", name, shown(node), lowest),
                fmt::format("write {} = {}", name, std::max<Index>(lowest, 1)));
  return std::nullopt;
}

std::optional<bool> read_truth(Reading& reading, const Node& node, const std::string& name) {
  if (node.kind == Node::Kind::truth) return node.truth;
  reading.fault(node.place, fmt::format("{} = {} must be true or false", name, shown(node)),
                fmt::format("write {0} = true or {0} = false, without quotes", name));
  return std::nullopt;
}

std::optional<std::string> read_text(Reading& reading, const Node& node, const std::string& name) {
  if (node.is_text()) return node.text;
  reading.fault(node.place, fmt::format("{} = {} must be a text", name, shown(node)),
                fmt::format("write {} = \"...\", in quotes", name));
  return std::nullopt;
}

std::optional<std::vector<std::string>> read_texts(Reading& reading, const Node& node,
                                                   const std::string& name) {
  std::vector<std::string> texts;
  if (!node.is_array()) {
    if (auto text = read_text(reading, node, name)) return texts = {*text};
    return std::nullopt;
  }
  for (const Node& item : node.items)
    if (auto text = read_text(reading, item, fmt::format("{}[{}]", name, texts.size())))
      texts.push_back(*text);
    else
      return std::nullopt;
  return texts;
}

std::string resolve_path(const Reading& reading, Node& text) {
  namespace fs = std::filesystem;
  const fs::path given = text.text;
  const fs::path found = given.is_absolute() ? given : reading.folder / given;
  std::error_code error;  // a path that cannot be followed is for the reader of the file to report
  if (!reading.resolved_folder.empty() && !given.is_absolute()) {
    const fs::path target = fs::weakly_canonical(fs::absolute(found, error), error);
    const fs::path from = fs::weakly_canonical(fs::absolute(reading.resolved_folder, error), error);
    const fs::path relative = target.lexically_relative(from);
    if (!target.empty()) text.text = (relative.empty() ? target : relative).generic_string();
  }
  return found.lexically_normal().string();
}

std::optional<Vector3> read_axis(Reading& reading, const Node& node, const std::string& name) {
  if (node.is_text()) {
    for (int i = 0; i < 3; ++i)
      if (node.text == std::string_view("xyz").substr(std::size_t(i), 1)) return Vector3::Unit(i);
    reading.fault(node.place,
                  fmt::format("{} = {} must be \"x\", \"y\", \"z\" or a vector", name, shown(node)),
                  fmt::format("write {0} = \"z\" or {0} = [0, 0, 1]", name));
    return std::nullopt;
  }
  const auto vector = read_vector(reading, node, name, dimension::none);
  if (!vector) return std::nullopt;
  const Vector3 axis = vector->stableNormalized();
  if (std::abs(axis.norm() - 1) < 1e-9) return axis;
  reading.fault(node.place, fmt::format("{} must not be the zero vector", name),
                fmt::format("write {0} = \"z\" or {0} = [0, 0, 1]", name));
  return std::nullopt;
}

}  // namespace bondstatic
