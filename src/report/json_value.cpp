#include "report/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bondstatic/error.hpp"
#include "io/text_file.hpp"

namespace bondstatic {

namespace {

using Json = nlohmann::json;

Place place_of_byte(const std::string& file, const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const std::size_t line_end = text.rfind('\n', end > 0 ? end - 1 : 0);
  const bool first_line = end == 0 || line_end == std::string::npos;
  const auto lines = std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n');
  return {file, int(lines) + 1, int(first_line ? end : end - line_end - 1) + 1};
}

/// Without the parser's own name and position, which stand before.
std::string reason_of(const std::string& what) {
  for (const char* begins : {": syntax error", "] "})
    if (const std::size_t at = what.find(begins); at != std::string::npos) return what.substr(at + 2);
  return what;
}

/// Lists and objects are not shown: they may be long, and as deep as whoever wrote them liked.
std::string shown(const Json& value) {
  if (value.is_array()) return "[..]";
  if (value.is_object()) return "{..}";
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  constexpr std::size_t most = 40;
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

}  // namespace

JsonValue JsonValue::read(const std::string& file, const std::string& cure) {
  std::vector<Fault> faults;
  const auto text = read_text_file(file, {}, faults);
  if (!text) throw InputError(std::move(faults));
  auto content = std::make_shared<File>(File{file, cure, {}});
  try {
    content->json = Json::parse(*text);
  } catch (const Json::parse_error& error) {
    throw InputError(
        {{place_of_byte(file, *text, error.byte), "is no JSON: " + reason_of(error.what()), cure}});
  } catch (const Json::exception& error) {
    throw InputError({{{file}, "is no JSON: " + reason_of(error.what()), cure}});
  }
  const Json* root = &content->json;
  if (!root->is_object())
    throw InputError({{{file, 1, 1}, fmt::format("holds {} where an object must be", shown(*root)), cure}});
  return JsonValue(std::move(content), root, "");
}

JsonValue JsonValue::child(const Json& value, const std::string& at) const {
  return JsonValue(file_, value.is_null() ? nullptr : &value, at);
}

void JsonValue::refuse(const std::string& must) const {
  const std::string found = there() ? at_ + " = " + shown(*value_) : at_ + " is missing and";
  throw InputError({{{file_->name}, found + " must be " + must, file_->cure}});
}

JsonValue JsonValue::operator[](const std::string& key) const {
  const std::string at = at_.empty() ? key : at_ + '.' + key;
  if (!there()) return JsonValue(file_, nullptr, at);
  if (!value_->is_object()) refuse("an object");
  const auto found = value_->find(key);
  return found == value_->end() ? JsonValue(file_, nullptr, at) : child(*found, at);
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
  std::vector<std::pair<std::string, JsonValue>> all;
  if (!there()) return all;
  if (!value_->is_object()) refuse("an object");
  for (auto it = value_->begin(); it != value_->end(); ++it)
    all.emplace_back(it.key(), child(it.value(), at_ + '.' + it.key()));
  return all;
}

std::vector<JsonValue> JsonValue::items() const {
  std::vector<JsonValue> all;
  if (!there()) return all;
  if (!value_->is_array()) refuse("a list");
  for (std::size_t i = 0; i < value_->size(); ++i)
    all.push_back(child((*value_)[i], fmt::format("{}[{}]", at_, i)));
  return all;
}

std::optional<double> JsonValue::number() const {
  if (!there()) return std::nullopt;
  if (!value_->is_number()) refuse("a number");
  return value_->get<double>();
}

double JsonValue::number_or_nan() const {
  return number().value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<std::string> JsonValue::text() const {
  if (!there()) return std::nullopt;
  if (!value_->is_string()) refuse("a text");
  return value_->get<std::string>();
}

std::string JsonValue::text_or(const std::string& otherwise) const {
  return text().value_or(otherwise);
}

std::optional<bool> JsonValue::flag() const {
  if (!there()) return std::nullopt;
  if (!value_->is_boolean()) refuse("true or false");
  return value_->get<bool>();
}

std::optional<Index> JsonValue::whole() const {
  if (!there()) return std::nullopt;
  constexpr auto most = std::uint64_t(std::numeric_limits<Index>::max());
  if (!value_->is_number_integer() || (value_->is_number_unsigned() && value_->get<std::uint64_t>() > most))
    refuse("a whole number of 64 bits");
  return value_->get<Index>();
}

}  // namespace bondstatic
