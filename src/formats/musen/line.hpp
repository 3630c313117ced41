// One line of MUSEN's text export: keys, each followed by what it names.
#pragma once

#include <array>
#include <optional>

#include "formats/row_fields.hpp"

namespace bondstatic {

inline constexpr const char* musen_cure =
    "export again with MUSEN's \"Export as text\"; the file is not meant to be edited";

/// Faults are told where something is not as asked for; nothing is returned then.
class MusenLine {
 public:
  MusenLine(const LineReader& reader, std::vector<Fault>& faults) : fields_(reader, faults) {}

  void take(std::string_view line) {
    fields_.take(line);
    at_ = 0;
  }
  bool at_end() const { return at_ >= fields_.size(); }
  std::size_t left() const { return fields_.size() - at_; }
  std::string_view next_text() { return fields_.text(at_++); }
  std::string_view text_ahead() const { return fields_.text(at_); }

  std::optional<Index> whole(std::string_view name);
  std::optional<std::array<double, 9>> numbers(int count);
  bool vector(Vector3& out);

  /// At what next...() returned last.
  void fault(const std::string& message) { fields_.fault(at_ == 0 ? 0 : at_ - 1, message, musen_cure); }
  bool gave_up() const { return fields_.gave_up(); }

 private:
  RowFields fields_;
  std::size_t at_ = 0;
};

}  // namespace bondstatic
