#include "app/vary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

/// Parts between separators that stand outside of brackets, braces and quotes.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == separator && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& text, const std::string& reason, const std::string& cure) {
  throw Error(ExitCode::invalid_input, fmt::format("--vary {}: {}\n    cure: {}", text, reason, cure));
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(text, "is not KEY=v1,v2,...", "write for example --vary bonds.0.young=50e9,70e9");
  Variation variation{split(text.substr(0, equals), ':'), {}};
  if (std::find(variation.keys.begin(), variation.keys.end(), "") != variation.keys.end())
    refuse(text, "has an empty key", "name a key on either side of each colon");
  for (const std::string& entry : split(text.substr(equals + 1), ',')) {
    const bool one_key = variation.keys.size() == 1;
    std::vector<std::string> values = one_key ? std::vector<std::string>{entry} : split(entry, ':');
    if (std::find(values.begin(), values.end(), "") != values.end())
      refuse(text, "has an empty value", "give a value between all commas and colons");
    if (values.size() != variation.keys.size())
      refuse(text,
             fmt::format("\"{}\" has {} values for {} keys", entry, values.size(), variation.keys.size()),
             "give one value a key, joined by colons: K1:K2=a1:b1,a2:b2");
    variation.values.push_back(std::move(values));
  }
  return variation;
}

std::vector<std::vector<std::string>> grid_points(const std::vector<Variation>& variations) {
  std::vector<std::vector<std::string>> points(1);
  for (const Variation& variation : variations) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& point : points)
      for (const auto& values : variation.values) {
        longer.push_back(point);
        longer.back().insert(longer.back().end(), values.begin(), values.end());
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace bondstatic
