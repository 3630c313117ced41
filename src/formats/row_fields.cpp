#include "formats/row_fields.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/number_field.hpp"

namespace bondstatic {

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  return text.size() <= longest ? std::string(text) : std::string(text.substr(0, longest)) + "...";
}

void RowFields::take(std::string_view line) {
  line_ = line;
  split_at_blanks(line, fields_);
}

void RowFields::fault(std::size_t field, const std::string& message, const std::string& cure) {
  const int column = field < fields_.size() ? int(fields_[field].data() - line_.data()) + 1 : 1;
  if (!faults_.add(reader_.place(column), message, cure)) gave_up_ = true;
}

std::optional<double> RowFields::number(std::size_t field, std::string_view name) {
  const double value = number_field(fields_[field]);
  if (std::isfinite(value)) [[likely]]
    return value;
  if (std::isnan(value))
    fault(field, fmt::format("{} = \"{}\" is not a number", name, shown(fields_[field])),
          "write a plain number such as 1.5e-3; a run that wrote nan has blown up");
  else
    fault(field, fmt::format("{} = {} is not a finite double", name, shown(fields_[field])),
          "write a number that a double can hold");
  return std::nullopt;
}

std::optional<double> RowFields::positive_number(std::size_t field, std::string_view name,
                                                 const std::string& cure) {
  const auto value = number(field, name);
  if (!value || *value > 0) return value;
  fault(field, fmt::format("{} = {} must be positive", name, shown(fields_[field])), cure);
  return std::nullopt;
}

std::optional<Index> RowFields::whole_number(std::size_t field, std::string_view name, Index lowest,
                                             Index highest) {
  const auto value = whole_number_field(fields_[field]);
  if (value && *value >= lowest && *value <= highest) [[likely]]
    return value;
  const std::string limits = highest < above_every_whole_number - 1
                                 ? fmt::format("from {} to {}", lowest, highest)
                                 : fmt::format("from {} on, below 9e15", lowest);
  fault(field, fmt::format("{} = \"{}\" must be a whole number {}", name, shown(fields_[field]), limits),
        "correct it, or the counts in the header that limit it");
  return std::nullopt;
}

}  // namespace bondstatic
