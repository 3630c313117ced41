#include "results.hpp"

#include <algorithm>
#include <cmath>

#include "demand.hpp"
#include "report/json_value.hpp"
#include "report/read_grid.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic {

namespace {

/// Puts questions to a file. What is refused may be asked for again: the next question is put all the same.
struct Asker {
  const std::string& path;
  std::vector<Fault>& faults;

  template <class Question>
  void operator()(Question question) const {
    try {
      question();
    } catch (const InputError& error) {
      demand(!error.faults().empty(), "an error says what is wrong");
      for (Fault fault : error.faults()) {
        demand(to_string(fault).find(path) != std::string::npos, "the file is named");
        // Grids, values of JSON and files as a whole have no lines.
        fault.place = {path, std::max(1, fault.place.line)};
        faults.push_back(fault);
      }
    }
  }
};

void visit(const JsonValue& value, const Asker& ask) {
  ask([&] { value.number(); });
  ask([&] { value.text(); });
  ask([&] { value.flag(); });
  ask([&] { value.whole(); });
  ask([&] {
    for (const JsonValue& item : value.items()) visit(item, ask);
  });
  ask([&] {
    for (const auto& [name, member] : value.members()) {
      demand(value.has(name) == member.there(), "a member is found by its name");
      visit(member, ask);
    }
  });
}

}  // namespace

void read_whole_grid(const std::string& path, std::vector<Fault>& faults) {
  const Asker ask{path, faults};
  using Of = Grid::Of;
  ask([&] {
    const Grid grid({path, path});
    const auto points = std::size_t(grid.count(Of::points)), lines = std::size_t(grid.count(Of::lines));
    for (const Of of : {Of::points, Of::lines})
      for (const GridArray& array : grid.arrays(of)) {
        const std::size_t rows = of == Of::points ? points : lines;
        ask([&] {
          demand(grid.numbers(of, array.name).size() % (rows > 0 ? rows : 1) == 0, "whole rows of numbers");
        });
        ask([&] { grid.whole_numbers(of, array.name); });
      }
    ask([&] {
      const auto x = grid.positions();
      demand(x.size() == 3 * points &&
                 std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); }),
             "positions are finite");
    });
    ask([&] {
      const auto ends = grid.ends();
      demand(ends.size() == 2 * lines, "a line has two ends");
      for (const Index end : ends) demand(end >= 0 && std::size_t(end) < points, "lines end at points");
    });
    ask([&] { demand(grid.copies().size() == points, "each point is a copy or none"); });
  });
}

void read_whole_table(const std::string& path, std::vector<Fault>& faults) {
  const Asker ask{path, faults};
  ask([&] {
    const auto table = CsvColumns::read(path);
    demand(table.has_value(), "the file is there");
    const auto rows = std::size_t(table->rows());
    for (int column = 0; column < int(table->names().size()); ++column) {
      const int first = table->find(table->names()[std::size_t(column)]);
      demand(first >= 0 && first <= column, "a column is found by its name");
      demand(table->texts(column).size() == rows, "a text each row");
      ask([&] { demand(table->numbers(column).size() == rows, "a number each row"); });
      ask([&] { demand(table->whole_numbers(column).size() == rows, "a whole number each row"); });
    }
  });
}

void read_whole_sweep(const std::string& path, std::vector<Fault>& faults) {
  const Asker ask{path, faults};
  ask([&] {
    const auto csv = CsvColumns::read(path);
    demand(csv.has_value(), "the file is there");
    const SweepTable sweep = read_sweep(path, *csv);
    demand(!sweep.keys.empty() && sweep.counts.size() == 2, "keys and counts");
    for (const SweepKey& key : sweep.keys) {
      demand(key.numbers.empty() || key.numbers.size() == sweep.rows(), "a number each row or none");
      demand(value_names(key).size() == sweep.rows(), "a name each row");
      demand(depends_on(key, key), "a key changes together with itself");
    }
    for (const auto* columns : {&sweep.counts, &sweep.outputs})
      for (const SweepColumn& one : *columns) demand(one.values.size() == sweep.rows(), "a value each row");
  });
}

void read_whole_json(const std::string& path, std::vector<Fault>& faults) {
  const Asker ask{path, faults};
  ask([&] { visit(JsonValue::read(path, "write it anew"), ask); });
}

}  // namespace bondstatic
