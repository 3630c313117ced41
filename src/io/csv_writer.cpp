#include "io/csv_writer.hpp"

#include <cmath>
#include <iterator>

namespace bondstatic {

namespace {

void append_number(fmt::memory_buffer& out, double value) {
  if (!std::isnan(value)) fmt::format_to(std::back_inserter(out), "{}", value);
}

void append_number(fmt::memory_buffer& out, Index value) {
  const fmt::format_int digits(value);
  out.append(digits.data(), digits.data() + digits.size());
}

}  // namespace

void write_csv(OutputFile& file, std::span<const Column> columns) {
  fmt::memory_buffer& out = file.buffer();
  for (std::size_t c = 0; c < columns.size(); ++c)
    fmt::format_to(std::back_inserter(out), "{}{}", c == 0 ? "" : ",", csv_field(columns[c].name));
  out.push_back('\n');
  const Index rows = columns.empty() ? 0 : columns.front().rows();
  for (Index row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out.push_back(',');
      std::visit([&](const auto& values) { append_number(out, values[std::size_t(row)]); },
                 columns[c].values);
    }
    out.push_back('\n');
    file.flush_if_large();
  }
}

std::string csv_number(double value) {
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace bondstatic
