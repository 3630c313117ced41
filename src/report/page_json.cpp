#include "report/page_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace bondstatic {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json numbers(const std::vector<double>& values) {
  Json all = Json::array();
  for (const double value : values) all.push_back(number(value));
  return all;
}

template <class Item, class ToJson>
Json list(const std::vector<Item>& items, ToJson to_json) {
  Json all = Json::array();
  for (const Item& item : items) all.push_back(to_json(item));
  return all;
}

const char* name_of(BlockRef::Type type) {
  switch (type) {
    case BlockRef::Type::f32:
      return "f32";
    case BlockRef::Type::u32:
      return "u32";
    case BlockRef::Type::i64:
      return "i64";
  }
  return "";
}

const char* name_of(PageSeries::Draw draw) {
  switch (draw) {
    case PageSeries::Draw::line:
      return "line";
    case PageSeries::Draw::points:
      return "points";
    case PageSeries::Draw::line_and_points:
      return "line_and_points";
    case PageSeries::Draw::bars:
      return "bars";
    case PageSeries::Draw::steps:
      return "steps";
  }
  return "";
}

Json block(const BlockRef& ref) {
  if (ref.block < 0) return {};
  return {{"block", ref.block},
          {"type", name_of(ref.type)},
          {"count", ref.count},
          {"components", ref.components},
          {"scale", ref.scale}};
}

Json field(const PageField& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* of_number = std::get_if<double>(&value)) return number(*of_number);
  return {};
}

Json table(const PageTable& one) {
  return {{"title", one.title},
          {"columns", one.columns},
          {"rows", list(one.rows, [](const auto& row) { return list(row, field); })},
          {"note", one.note}};
}

Json axis(const PageAxis& one) {
  return {{"label", one.label}, {"unit", one.unit}, {"log", one.log}, {"categories", one.categories}};
}

Json series(const PageSeries& one) {
  return {{"name", one.name},           {"x", numbers(one.x)},
          {"y", numbers(one.y)},        {"draw", name_of(one.draw)},
          {"low", numbers(one.low)},    {"high", numbers(one.high)},
          {"reference", one.reference}, {"place", one.place < 0 ? Json() : Json(one.place)}};
}

Json mark(const PageMark& one) {
  return {{"x", number(one.x)}, {"y", number(one.y)}, {"label", one.label}};
}

Json plot(const PagePlot& one) {
  return {{"title", one.title},
          {"kind", one.kind == PagePlot::Kind::rose ? "rose" : "xy"},
          {"x", axis(one.x)},
          {"y", axis(one.y)},
          {"series", list(one.series, series)},
          {"marks", list(one.marks, mark)},
          {"note", one.note}};
}

Json sweep_column(const PageSweep::Column& one) {
  return {{"name", one.name},
          {"unit", one.unit},
          {"values", numbers(one.values)},
          {"categories", one.categories}};
}

Json curves(const PageSweep::Curves& one) {
  return {{"names", one.names}, {"of_row", one.of_row}};
}

Json abscissa(const PageSweep::Abscissa& one) {
  return {{"column", one.column}, {"curves", one.curves}, {"log", one.log}};
}

Json ordinate(const PageSweep::Ordinate& one) {
  return {{"title", one.title}, {"column", one.column}, {"log", one.log}};
}

Json sweep(const std::optional<PageSweep>& one) {
  if (!one) return {};
  return {{"columns", list(one->columns, sweep_column)},
          {"curves", list(one->curves, curves)},
          {"abscissae", list(one->abscissae, abscissa)},
          {"ordinates", list(one->ordinates, ordinate)}};
}

Json column(const PageColumn& one) {
  return {{"name", one.name},
          {"unit", one.unit},
          {"components", one.components},
          {"is_signed", one.is_signed},
          {"is_whole", one.is_whole}};
}

Json state(const PageState& one) {
  return {{"load_case", one.load_case},
          {"label", one.label},
          {"step", one.step ? number(*one.step) : Json()},
          {"particle", list(one.particle, block)},
          {"bond", list(one.bond, block)}};
}

Json scene(const std::optional<PageScene>& given) {
  if (!given) return {};
  const PageScene& one = *given;
  return {{"length_unit", one.length_unit},
          {"all_particles", one.all_particles},
          {"all_bonds", one.all_bonds},
          {"drawn_particles", one.drawn_particles},
          {"origin", numbers({one.origin[0], one.origin[1], one.origin[2]})},
          {"particle_id", block(one.particle_id)},
          {"position", block(one.position)},
          {"radius", block(one.radius)},
          {"bond_id", block(one.bond_id)},
          {"bond_a", block(one.bond_a)},
          {"bond_b", block(one.bond_b)},
          {"bond_radius", block(one.bond_radius)},
          {"particle_columns", list(one.particle_columns, column)},
          {"bond_columns", list(one.bond_columns, column)},
          {"states", list(one.states, state)}};
}

Json run(const PageRun& one) {
  return {{"folder", one.folder},
          {"kind", one.kind},
          {"title", one.title},
          {"notes", one.notes},
          {"warnings", one.warnings},
          {"tables", list(one.tables, table)},
          {"plots", list(one.plots, plot)},
          {"sweep", sweep(one.sweep)},
          {"scene", scene(one.scene)},
          {"resolved_case", one.resolved_case}};
}

/// "<" can only stand inside of strings, where JSON knows it by its number as well: then nothing in the data
/// ends the element that holds it.
std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<')
      text += "\\u003c";
    else
      text += letter;
  }
  return text;
}

}  // namespace

std::string page_json(const PageData& data) {
  const Json all{{"version", data.version}, {"runs", list(data.runs, run)}};
  // File names need not be UTF-8.
  return without_tags(all.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace bondstatic
