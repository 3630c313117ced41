#include "bench/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace bondstatic::bench {

namespace {

constexpr double left = 80, top = 50, width = 560, height = 420, legend = 260;

// Whole decades that hold the values, and where a value lies between 0 and 1.
struct Decades {
  int low = 100, high = -100;
  void hold(double value) {
    low = std::min(low, int(std::floor(std::log10(value))));
    high = std::max(high, int(std::ceil(std::log10(value))));
  }
  double place(double value) const { return (std::log10(value) - low) / std::max(1, high - low); }
};

std::string text(double x, double y, const std::string& anchor, const std::string& content,
                 const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     content);
}

}  // namespace

std::string svg(const Plot& plot) {
  static const char* const colours[] = {"#1b6ca8", "#c8502d", "#2e8b57", "#8e44ad",
                                        "#b8860b", "#555555", "#d1478c", "#17a2a2"};
  static const char* const dashes[] = {"", "8 4", "2 3", "10 3 2 3", "5 5"};
  Decades xs, ys;
  for (const Line& line : plot.lines)
    for (const auto& [x, y] : line.points) xs.hold(x), ys.hold(y);
  const auto at_x = [&](double x) { return left + width * xs.place(x); };
  const auto at_y = [&](double y) { return top + height * (1 - ys.place(y)); };
  const double full = std::max(height, 16.0 * double(plot.lines.size()));

  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      left + width + legend, top + full + 60);
  out += text(left, top - 20, "start", plot.title, " font-size=\"16\"");
  for (int d = xs.low; d <= xs.high; ++d) {
    const double x = at_x(std::pow(10, d));
    out += fmt::format("<path d=\"M{0:.1f} {1} V{2}\" stroke=\"#ddd\"/>\n", x, top, top + height);
    out += text(x, top + height + 18, "middle", fmt::format("{:g}", std::pow(10, d)));
  }
  for (int d = ys.low; d <= ys.high; ++d) {
    const double y = at_y(std::pow(10, d));
    out += fmt::format("<path d=\"M{0} {1:.1f} H{2}\" stroke=\"#ddd\"/>\n", left, y, left + width);
    out += text(left - 8, y + 4, "end", fmt::format("{:g}", std::pow(10, d)));
  }
  out += text(left + width / 2, top + height + 40, "middle", plot.x);
  out += text(0, 0, "middle", plot.y,
              fmt::format(" transform=\"translate(20 {}) rotate(-90)\"", top + height / 2));

  std::map<std::string, std::size_t> colour, dash;
  double row = top + 8;
  for (const Line& line : plot.lines) {
    if (line.points.empty()) continue;
    const std::size_t c = colour.emplace(line.colour_of, colour.size()).first->second;
    const std::string style =
        fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\"",
                    colours[c % std::size(colours)], dashes[dash[line.colour_of]++ % std::size(dashes)]);
    std::string path;
    for (const auto& [x, y] : line.points) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", at_x(x), at_y(y));
      out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", at_x(x), at_y(y),
                         colours[c % std::size(colours)]);
    }
    out += fmt::format("<path d=\"{}\" {}/>\n", path, style);
    out += fmt::format("<path d=\"M{:.1f} {:.1f} h30\" {}/>\n", left + width + 12, row, style);
    out += text(left + width + 48, row + 4, "start", line.label);
    row += 16;
  }
  return out + "</svg>\n";
}

}  // namespace bondstatic::bench
