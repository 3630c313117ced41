#include "formats/lammps/dump_steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/row_fields.hpp"

namespace bondstatic {
namespace {

constexpr int lines_between_reports = 1 << 14;

std::string list_of_steps(const std::vector<DumpStep>& steps) {
  constexpr std::size_t most = 10;
  std::string text;
  std::size_t count = 0;
  for (const DumpStep& step : steps) {
    if (!step.complete) continue;
    if (++count <= most) text += fmt::format("{}{}", count == 1 ? "" : ", ", step.step);
  }
  if (count > most) text += fmt::format(", ... ({} steps)", count);
  return text;
}

/// The last step, or the one that is asked for; where that is not whole or not there, a fault.
const DumpStep* choose_step(const std::vector<DumpStep>& steps, std::optional<Index> asked,
                            const LineReader& reader, const Place& named_at, std::vector<Fault>& faults) {
  const std::string whole = list_of_steps(steps);
  const auto is_asked = [&](const DumpStep& step) { return !asked || step.step == *asked; };
  const DumpStep* last = nullptr;
  for (const DumpStep& step : steps)
    if (is_asked(step) && (step.complete || !asked || !last)) last = &step;
  if (!last) {
    faults.push_back(
        {asked ? named_at : Place{reader.file(), 1, 1},
         asked ? fmt::format("file \"{}\" has no step {}", reader.file(), *asked) : "the dump has no step",
         whole.empty() ? "give a dump that a run has finished writing"
                       : "it has " + whole + ": ask for one of them"});
    return nullptr;
  }
  if (last->complete) return last;
  const std::string what = last->step < 0 ? "the last step" : fmt::format("step {}", last->step);
  const auto before =
      std::find_if(steps.rbegin(), steps.rend(), [](const DumpStep& s) { return s.complete; });
  faults.push_back({{reader.file(), last->line, 1},
                    last->rows > 0 ? fmt::format("{} is cut short: {} of its {} rows are there", what,
                                                 last->rows_there, last->rows)
                                   : what + " is cut short: its header is not whole",
                    before == steps.rend()
                        ? "no step of the file is whole; write the dump again, with the end of its last line"
                        : fmt::format("take a whole one, the last is --step {}", before->step)});
  return nullptr;
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

HeaderEnd read_header_of(const DumpStep& step, LineReader& reader, DumpHeader& header,
                         std::vector<Fault>& faults) {
  reader.go_to(step.offset, step.line, faults);
  const auto line = reader.next(faults);
  return line ? read_dump_header(reader, *line, header, faults) : HeaderEnd::at_fault;
}

}  // namespace

std::optional<std::vector<DumpStep>> find_dump_steps(LineReader& reader,
                                                     const std::function<void(double)>& progress,
                                                     std::vector<Fault>& faults) {
  std::vector<DumpStep> steps;
  DumpHeader header;
  auto line = reader.next(faults);
  while (line) {
    if (is_blank(*line)) {
      line = reader.next(faults);
      continue;
    }
    DumpStep step;
    step.offset = reader.offset();
    step.line = reader.line();
    const HeaderEnd end = read_dump_header(reader, *line, header, faults);
    if (end == HeaderEnd::at_fault) return std::nullopt;
    step.step = header.step;
    step.rows = header.rows;
    if (end == HeaderEnd::cut) {
      steps.push_back(step);
      break;
    }
    // A run that was killed and went on leaves a short step in the middle of the file, too.
    while ((line = reader.next(faults)) && step.rows_there < step.rows && !line->starts_with("ITEM: ") &&
           reader.line_ended()) {
      ++step.rows_there;
      if (progress && reader.line() % lines_between_reports == 0) progress(reader.part());
    }
    step.complete = step.rows_there == step.rows;
    steps.push_back(step);
    if (line && !step.complete && !reader.line_ended()) break;
  }
  if (reader.failed()) return std::nullopt;
  return steps;
}

std::string about_step(const DumpRows& rows) {
  std::string text = fmt::format("Step {} was read", rows.header.step);
  if (rows.steps > 1) text += fmt::format(", of {} in the file", rows.steps);
  if (rows.repeated) text += "; the file has it several times, and the last was taken";
  return text;
}

std::optional<DumpRows> read_dump_rows(const std::string& path, const ReadOptions& options,
                                       const ChooseColumns& choose, const Place& named_at,
                                       std::vector<Fault>& faults) {
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  const auto report = [&](double part) {
    if (options.progress) options.progress(part);
  };
  const auto steps = find_dump_steps(
      *reader, [&](double part) { report(part / 2); }, faults);
  if (!steps) return std::nullopt;
  const DumpStep* step = choose_step(*steps, options.step, *reader, named_at, faults);
  if (!step) return std::nullopt;

  const std::size_t before = faults.size();
  DumpRows rows;
  rows.steps = Index(steps->size());
  rows.repeated = std::count_if(steps->begin(), steps->end(),
                                [&](const DumpStep& other) { return other.step == step->step; }) > 1;
  if (read_header_of(steps->front(), *reader, rows.header, faults) == HeaderEnd::at_fault)
    return std::nullopt;
  const std::string units = rows.header.units;
  if (read_header_of(*step, *reader, rows.header, faults) != HeaderEnd::rows) return std::nullopt;
  if (rows.header.units.empty()) rows.header.units = units;
  const std::vector<WantedColumn> wanted = choose(rows.header, faults);
  if (faults.size() != before) return std::nullopt;

  const std::size_t columns = rows.header.columns.size();
  rows.values.resize(wanted.size());
  for (auto& column : rows.values) column.reserve(std::size_t(step->rows));  // the search has seen them all
  rows.line.reserve(std::size_t(step->rows));
  RowFields fields(*reader, faults);
  for (Index row = 0; row < step->rows && !fields.gave_up(); ++row) {
    const auto line = reader->next(faults);
    if (!line) break;
    fields.take(*line);
    if (fields.size() != columns) {
      fields.fault(columns, fmt::format("{} fields in a row of {} columns", fields.size(), columns),
                   "see that the dump is whole and was not changed by hand");
      continue;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto field = std::size_t(wanted[i].column);
      const std::string& name = rows.header.columns[field];
      if (wanted[i].whole_from)
        rows.values[i].push_back(double(fields.whole_number(field, name, *wanted[i].whole_from).value_or(0)));
      else
        rows.values[i].push_back(fields.number(field, name).value_or(0));
    }
    rows.line.push_back(reader->line());
    if (reader->line() % lines_between_reports == 0) report(0.5 + 0.5 * double(row) / double(step->rows));
  }
  if (faults.size() != before) return std::nullopt;
  report(1);
  return rows;
}

}  // namespace bondstatic
