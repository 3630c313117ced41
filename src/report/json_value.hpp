// The JSON files that commands write, read back by somebody who cannot know who has edited them since: what
// is not there is nothing, what has another type than it should ends with the file, the place and a cure.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// A value in a file; it keeps the file's content alive. Missing keys and null are both "not there".
class JsonValue {
 public:
  /// Throws InputError where the file cannot be read, is no JSON, or does not hold an object. `cure` says how
  /// to get a sound one.
  static JsonValue read(const std::string& file, const std::string& cure);

  bool there() const { return value_ != nullptr; }
  bool has(const std::string& key) const { return (*this)[key].there(); }

  /// Of an object. What follows throws InputError where the value is there, but of another type.
  JsonValue operator[](const std::string& key) const;
  std::vector<std::pair<std::string, JsonValue>> members() const;  ///< none where it is not there
  std::vector<JsonValue> items() const;                            ///< likewise

  std::optional<double> number() const;
  double number_or_nan() const;
  std::optional<std::string> text() const;
  std::string text_or(const std::string& otherwise = "") const;
  std::optional<bool> flag() const;
  std::optional<Index> whole() const;  ///< ids: all digits of 64 bits

  [[noreturn]] void refuse(const std::string& must) const;

 private:
  struct File {
    std::string name, cure;
    nlohmann::json json;
  };
  JsonValue(std::shared_ptr<const File> file, const nlohmann::json* value, std::string at)
      : file_(std::move(file)), value_(value), at_(std::move(at)) {}
  JsonValue child(const nlohmann::json& value, const std::string& at) const;

  std::shared_ptr<const File> file_;
  const nlohmann::json* value_;  ///< null: not there
  std::string at_;               ///< "load_cases[0].energy"
};

}  // namespace bondstatic
