// What the page of a report is told, as plain data: src/report/page/data.ts reads the same names. C++ decides
// what is shown, with which labels and units; the page only draws it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// Numbers of a scene, in a block of their own beside the JSON (report/blocks.hpp): its number, and what the
/// stored numbers must be multiplied by.
struct BlockRef {
  enum class Type { f32, u32, i64 };
  int block = -1;  ///< -1: not there
  Type type = Type::f32;
  Index count = 0;     ///< of numbers: rows times components
  int components = 1;  ///< row by row
  double scale = 1;
};

/// A cell of a table: text, a number, or nothing.
using PageField = std::variant<std::monostate, std::string, double>;

struct PageTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<PageField>> rows;
  std::string note = {};
};

struct PageAxis {
  std::string label;
  std::string unit = {};  ///< "" in consistent units
  bool log = false;
  std::vector<std::string> categories = {};  ///< where x counts names: 0, 1, ...
};

struct PageSeries {
  enum class Draw { line, points, line_and_points, bars, steps };
  std::string name;
  std::vector<double> x, y;  ///< NaN: a gap
  Draw draw = Draw::line;
  std::vector<double> low = {}, high = {};  ///< interval of each y; may be empty
  bool reference = false;  ///< what the others are compared with: closed form, experiment, target
  int place = -1;          ///< whose colour and marker it has, so that plots agree; -1: its own in the plot
};

/// A point of a plot that is named.
struct PageMark {
  double x = 0, y = 0;
  std::string label;
};

struct PagePlot {
  /// rose: x is an angle in degrees from the axis to the right, counterclockwise; each petal is as wide as
  /// the angles lie apart, and y its length.
  enum class Kind { xy, rose };
  std::string title;
  Kind kind = Kind::xy;
  PageAxis x, y;
  std::vector<PageSeries> series;
  std::vector<PageMark> marks = {};
  std::string note = {};
};

/// A sweep, row by row: the reader chooses what the ordinates are drawn over.
struct PageSweep {
  struct Column {
    std::string name, unit;
    std::vector<double> values;                ///< NaN: not known
    std::vector<std::string> categories = {};  ///< where values count names: 0, 1, ...
  };
  struct Curves {
    std::vector<std::string> names;  ///< "" where there is one only
    std::vector<std::size_t> of_row;
  };
  struct Abscissa {
    std::size_t column = 0, curves = 0;
    bool log = false;  ///< unless the reader says otherwise
  };
  struct Ordinate {
    std::string title;
    std::size_t column = 0;
    bool log = false;
  };
  std::vector<Column> columns;
  std::vector<Curves> curves;
  std::vector<Abscissa> abscissae;  ///< first the one that is shown first
  std::vector<Ordinate> ordinates;
};

/// A quantity that particles or bonds can be coloured by.
struct PageColumn {
  std::string name;  ///< as in the files of results
  std::string unit = {};
  int components = 1;      ///< 3: a vector, coloured by its length or a component
  bool is_signed = false;  ///< both signs mean something: tension and compression
  bool is_whole = false;   ///< steps, bit masks
};

/// One state of one load case; `particle` and `bond` follow the columns of the scene.
struct PageState {
  std::string load_case;
  std::string label;           ///< "12 broken, load 39.1"
  std::optional<double> step;  ///< events or time; absent where the load case has one state
  std::vector<BlockRef> particle, bond;
};

/// Rows are in an order that is random but always the same: the first so many of them are a fair sample.
struct PageScene {
  std::string length_unit;
  Index all_particles = 0, all_bonds = 0;  ///< of the model; fewer may be here
  /// Rows of particles: first those to be drawn, then far ends of bonds (images across a periodic face,
  /// particles that the sample left out).
  Index drawn_particles = 0;
  Vector3 origin = Vector3::Zero();  ///< positions are relative to it
  BlockRef particle_id, position, radius;
  BlockRef bond_id, bond_a, bond_b;  ///< a, b: rows of particles
  BlockRef bond_radius;              ///< of its section; block -1: not known
  std::vector<PageColumn> particle_columns, bond_columns;
  std::vector<PageState> states;  ///< of a load case one after the other
};

struct PageRun {
  std::string folder, kind, title;    ///< kind: the command that wrote it
  std::vector<std::string> notes;     ///< of the report itself: what it left out
  std::vector<std::string> warnings;  ///< of the run
  std::vector<PageTable> tables;
  std::vector<PagePlot> plots;
  std::optional<PageSweep> sweep;
  std::optional<PageScene> scene;
  std::string resolved_case;  ///< text; "" where the run wrote none
};

struct PageData {
  std::string version;
  std::vector<PageRun> runs;
};

}  // namespace bondstatic
