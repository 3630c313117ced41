#include "io/csv_writer.hpp"

#include "io/number_text.hpp"
#include "io/ordered_blocks.hpp"

namespace bondstatic {

void write_csv(OutputFile& file, std::span<const Column> columns) {
  std::string header;
  for (const Column& column : columns) header += csv_field(column.name) + ',';
  if (!header.empty()) header.pop_back();
  file.append(header + '\n');
  write_csv_rows(file, columns);
}

void write_csv_rows(OutputFile& file, std::span<const Column> columns) {
  constexpr Index block = 8192;  // rows; a megabyte or two of text
  const Index rows = columns.empty() ? 0 : columns.front().rows();
  write_blocks(file, rows, block, [&](Index begin, Index end, fmt::memory_buffer& text) {
    const std::size_t longest_row = columns.size() * (longest_number + 1);
    for (Index row = begin; row < end; ++row) {
      const std::size_t before = text.size();
      text.resize(before + longest_row);
      char* out = text.data() + before;
      for (const Column& column : columns) {
        std::visit([&](const auto& number) { out = write_number(out, number(row)); }, column.at);
        *out++ = ',';
      }
      out[-1] = '\n';
      text.resize(std::size_t(out - text.data()));
    }
  });
}

std::string csv_number(double value) {
  char text[longest_number];
  return {text, write_number(text, value)};
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace bondstatic
