// The fields of one line of a file, and what is wrong with them.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/types.hpp"
#include "io/line_reader.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {

inline constexpr Index above_every_whole_number = 9'000'000'000'000'000;  ///< exact as doubles below it

class RowFields {
 public:
  RowFields(const LineReader& reader, std::vector<Fault>& faults) : reader_(reader), faults_(faults) {}

  /// The fields of the line that `reader` has just read, which must stand meanwhile.
  void take(std::string_view line);

  std::size_t size() const { return fields_.size(); }
  std::string_view text(std::size_t field) const { return fields_[field]; }

  // Nothing, and a fault that calls the field `name`, where it is not what is asked for.
  std::optional<double> number(std::size_t field, std::string_view name);
  std::optional<double> positive_number(std::size_t field, std::string_view name, const std::string& cure);
  std::optional<Index> whole_number(std::size_t field, std::string_view name, Index lowest = 0,
                                    Index highest = above_every_whole_number - 1);

  /// At a field, or at the line where there is no such field.
  void fault(std::size_t field, const std::string& message, const std::string& cure);

  /// No more faults are told: what follows is of no use.
  bool gave_up() const { return gave_up_; }

 private:
  const LineReader& reader_;
  LimitedFaults faults_;
  std::string_view line_;
  std::vector<std::string_view> fields_;
  bool gave_up_ = false;
};

/// As messages show it: at most forty characters.
std::string shown(std::string_view text);

}  // namespace bondstatic
