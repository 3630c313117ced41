#include "formats/lammps/formula.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace bondstatic {
namespace {

class Formula {
 public:
  Formula(std::string_view text, const ScriptVariables& variables) : left_(text), variables_(variables) {}

  std::optional<double> value() {
    const double found = sum();
    skip_blanks();
    if (!sound_ || !left_.empty() || !std::isfinite(found)) return std::nullopt;
    return found;
  }

 private:
  static constexpr int deepest = 64;  ///< parentheses inside each other

  double refuse() {
    sound_ = false;
    left_ = {};
    return 0;
  }

  void skip_blanks() {
    while (!left_.empty() && (left_.front() == ' ' || left_.front() == '\t')) left_.remove_prefix(1);
  }

  bool take(char symbol) {
    skip_blanks();
    if (left_.empty() || left_.front() != symbol) return false;
    left_.remove_prefix(1);
    return true;
  }

  double sum() {
    double total = product();
    while (sound_) {
      if (take('+'))
        total += product();
      else if (take('-'))
        total -= product();
      else
        break;
    }
    return total;
  }

  double product() {
    double total = power();
    while (sound_) {
      if (take('*'))
        total *= power();
      else if (take('/'))
        total /= power();
      else
        break;
    }
    return total;
  }

  double power() {
    if (take('-')) {
      const double value = -factor();
      return take('^') ? refuse() : value;
    }
    const double base = factor();
    if (!take('^')) return base;
    const double exponent = take('-') ? -factor() : factor();
    return take('^') ? refuse() : std::pow(base, exponent);
  }

  double factor() {
    if (take('(')) return parenthesis();
    skip_blanks();
    double number = 0;
    const auto read = std::from_chars(left_.data(), left_.data() + left_.size(), number);
    const bool digit =
        !left_.empty() && (left_.front() == '.' || (left_.front() >= '0' && left_.front() <= '9'));
    if (digit && read.ec == std::errc{}) {
      left_.remove_prefix(std::size_t(read.ptr - left_.data()));
      return number;
    }
    return named();
  }

  double parenthesis() {
    if (++depth_ > deepest) return refuse();
    const double inside = sum();
    if (!take(')')) return refuse();
    --depth_;
    return inside;
  }

  double named() {
    double number = 0;
    std::size_t length = 0;
    while (length < left_.size() &&
           (std::isalnum(static_cast<unsigned char>(left_[length])) || left_[length] == '_'))
      ++length;
    const std::string_view name = left_.substr(0, length);
    left_.remove_prefix(length);
    if (name.starts_with("v_")) {
      const auto found = variables_.find(name.substr(2));
      if (found == variables_.end()) return refuse();
      const std::string& value = found->second;
      const auto known = std::from_chars(value.data(), value.data() + value.size(), number);
      return known.ec == std::errc{} && known.ptr == value.data() + value.size() ? number : refuse();
    }
    if (name == "PI") return std::numbers::pi;
    using Function = double (*)(double);
    static const std::map<std::string, Function, std::less<>> functions{
        {"sqrt", std::sqrt}, {"exp", std::exp},   {"ln", std::log},    {"log", std::log10},
        {"abs", std::fabs},  {"sin", std::sin},   {"cos", std::cos},   {"tan", std::tan},
        {"asin", std::asin}, {"acos", std::acos}, {"atan", std::atan},
    };
    const auto function = functions.find(name);
    if (function == functions.end() || !take('(')) return refuse();
    return function->second(parenthesis());
  }

  std::string_view left_;
  const ScriptVariables& variables_;
  int depth_ = 0;
  bool sound_ = true;
};

}  // namespace

std::optional<double> constant_formula(std::string_view text, const ScriptVariables& variables) {
  return Formula(text, variables).value();
}

}  // namespace bondstatic
