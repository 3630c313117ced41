#include "results/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/xml_text.hpp"

namespace bondstatic {

namespace {

// Pixels.
constexpr double width = 800, height = 500, left = 86, right = 26, top = 66, bottom = 62;

/// Where a point of the curve lies in the picture.
struct Frame {
  PlotScale x, y;

  double across(double value) const {
    return left + (value - x.low) / (x.high - x.low) * (width - left - right);
  }
  double down(double value) const {
    return height - bottom - (value - y.low) / (y.high - y.low) * (height - top - bottom);
  }
};

void add_extent(const Eigen::Vector2d& point, Eigen::Vector2d& least, Eigen::Vector2d& largest) {
  if (!point.allFinite()) return;
  least = least.cwiseMin(point);
  largest = largest.cwiseMax(point);
}

Frame frame_of(const Plot& plot) {
  Eigen::Vector2d least = Eigen::Vector2d::Zero(), largest = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : plot.curve) add_extent(point, least, largest);
  for (const PlotDot& dot : plot.dots) add_extent(dot.at, least, largest);
  for (const PlotMark& mark : plot.marks) add_extent(mark.at, least, largest);
  // Room for the words over the highest point.
  const double room = 0.08 * (largest.y() - least.y());
  return {plot_scale(plot.x, least.x(), largest.x()),
          plot_scale(plot.y, least.y(), largest.y() > 0 ? largest.y() + room : 0)};
}

class Picture {
 public:
  template <class... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<T>(values)...);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string tick_text(double value, const PlotScale& scale) {
  const double unit = std::pow(10, scale.exponent);
  const int decimals = std::max(0, int(std::ceil(-std::log10(scale.tick / unit) - 1e-9)));
  const double shown = value / unit;
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * scale.tick ? 0.0 : shown, decimals);
}

template <class Draw>
void for_each_tick(const PlotScale& scale, Draw draw) {
  const auto first = std::lround(scale.low / scale.tick), last = std::lround(scale.high / scale.tick);
  for (long i = first; i <= last; ++i) draw(double(i) * scale.tick);
}

void add_axes(Picture& picture, const Frame& frame) {
  const double end_x = width - right, end_y = height - bottom;
  for_each_tick(frame.x, [&](double value) {
    const double x = frame.across(value);
    picture.add("<line class=\"grid\" x1=\"{0:.2f}\" y1=\"{1}\" x2=\"{0:.2f}\" y2=\"{2}\"/>\n", x, top,
                end_y);
    picture.add("<text x=\"{:.2f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x, end_y + 19,
                tick_text(value, frame.x));
  });
  for_each_tick(frame.y, [&](double value) {
    const double y = frame.down(value);
    picture.add("<line class=\"grid\" x1=\"{1}\" y1=\"{0:.2f}\" x2=\"{2}\" y2=\"{0:.2f}\"/>\n", y, left,
                end_x);
    picture.add("<text x=\"{}\" y=\"{:.2f}\" text-anchor=\"end\">{}</text>\n", left - 8, y + 4.5,
                tick_text(value, frame.y));
  });
  picture.add("<path class=\"axis\" d=\"M{0} {3:.2f}H{1}M{4:.2f} {2}V{5}\"/>\n", left, end_x, top,
              frame.down(0), frame.across(0), end_y);
  picture.add("<text class=\"name\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (left + end_x) / 2,
              height - 16, xml_text(frame.x.label));
  picture.add(
      "<text class=\"name\" transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (top + end_y) / 2, xml_text(frame.y.label));
}

void add_curve(Picture& picture, const Frame& frame, const std::vector<Eigen::Vector2d>& curve) {
  picture.add("<path class=\"curve\" d=\"");
  bool begun = false;
  for (const Eigen::Vector2d& point : curve) {
    if (point.allFinite())
      picture.add("{}{:.2f} {:.2f}", begun ? 'L' : 'M', frame.across(point.x()), frame.down(point.y()));
    begun = point.allFinite();
  }
  picture.add("\"/>\n");
}

void add_mark(Picture& picture, const Frame& frame, const PlotMark& mark) {
  if (!mark.at.allFinite()) return;
  const double x = frame.across(mark.at.x()), y = frame.down(mark.at.y());
  // A curve comes from the left and below: to the left of it there is room, if the words are short enough.
  constexpr double letter = 7.2;
  const bool fits = x - 9 - letter * double(mark.text.size()) > left;
  const double lower = mark.above ? y - 9 : fits ? y + 4 : y + 18;
  picture.add("<circle class=\"mark\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\"/>\n", x, y);
  picture.add("<text class=\"words\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n",
              fits ? x - 11 : x + 11, lower, fits ? "end" : "start", xml_text(mark.text));
}

constexpr const char* style =
    "text{font:13px sans-serif;fill:#222}"
    ".title{font-size:16px;font-weight:bold}.name{font-size:14px}.note{fill:#555}"
    ".words{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}"
    ".grid{stroke:#e3e3e3}.axis{stroke:#444;fill:none}"
    ".curve{stroke:#1f5fa8;stroke-width:1.4;stroke-linejoin:round;fill:none}"
    ".dot{fill:#c0392b;fill-opacity:.45}.mark{stroke:#222;stroke-width:1.6;fill:none}";

}  // namespace

std::string plot_svg(const Plot& plot) {
  const Frame frame = frame_of(plot);
  Picture picture;
  picture.add(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      width, height);
  picture.add("<style>{}</style>\n<rect width=\"{}\" height=\"{}\" fill=\"#fff\"/>\n", style, width, height);
  picture.add("<text class=\"title\" x=\"{}\" y=\"28\">{}</text>\n", left, xml_text(plot.title));
  picture.add("<text class=\"note\" x=\"{}\" y=\"49\">{}</text>\n", left, xml_text(plot.note));
  add_axes(picture, frame);
  add_curve(picture, frame, plot.curve);
  for (const PlotDot& dot : plot.dots)
    if (dot.at.allFinite())
      picture.add("<circle class=\"dot\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n",
                  frame.across(dot.at.x()), frame.down(dot.at.y()), dot.radius);
  for (const PlotMark& mark : plot.marks) add_mark(picture, frame, mark);
  picture.add("</svg>\n");
  return picture.take();
}

}  // namespace bondstatic
