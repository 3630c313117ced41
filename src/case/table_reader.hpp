// Reading one table of a case: every key asked for is a known key, what nobody asked for is a fault, and
// defaults are written back, so that the tree becomes the resolved case.
#pragma once

#include <functional>
#include <span>

#include "case/reading.hpp"

namespace bondstatic {

class TableReader {
 public:
  /// `name` for messages: "[[bonds]]". A node that is no table is a fault; all keys then read as absent.
  TableReader(Reading& reading, Node& table, std::string name);

  Reading& reading() { return reading_; }
  const Place& place() const { return table_.place; }
  const std::string& name() const { return name_; }

  /// Value of a key, null where absent. Makes the key a known one.
  Node* find(const std::string& key);
  bool has(const std::string& key) { return find(key) != nullptr; }
  /// Where the key's value stands, or the table.
  const Place& place_of(const std::string& key);

  /// Nothing where absent or at fault.
  std::optional<double> number(const std::string& key, Dimension dimension, Allowed allowed = Allowed::any);
  std::optional<Vector3> vector(const std::string& key, Dimension dimension);
  std::optional<Vector3> axis(const std::string& key);
  std::optional<Index> whole(const std::string& key, Index lowest);
  std::optional<std::string> text(const std::string& key);
  std::optional<std::vector<std::string>> texts(const std::string& key);

  /// The default where absent or at fault, written back where absent.
  double number_or(const std::string& key, double fallback, Dimension dimension,
                   Allowed allowed = Allowed::any);
  Vector3 vector_or(const std::string& key, const Vector3& fallback, Dimension dimension);
  Vector3 axis_or(const std::string& key, const std::string& fallback);
  Index whole_or(const std::string& key, Index fallback, Index lowest);
  bool truth_or(const std::string& key, bool fallback);
  std::string choice_or(const std::string& key, const std::string& fallback,
                        std::span<const std::string> choices);
  void set_default(const std::string& key, Node value);

  /// A fault where the key is absent; `cure` says what to write.
  bool require(const std::string& key, const std::string& cure);

  /// The one of the keys that is given, "" where none is; several are a fault.
  std::string at_most_one_of(std::span<const std::string> keys);
  /// The same, and none is a fault too.
  std::string one_of(std::span<const std::string> keys);

  /// The path that a key names, relative paths taken from the case's folder, nothing where absent or at
  /// fault. Rewritten in the tree for where the resolved case will lie.
  std::optional<std::string> path(const std::string& key);

  /// Keys that nobody asked for become faults; not after accept_any(), where what is allowed cannot be told.
  void finish();
  void accept_any() { any_key_ = true; }

 private:
  Reading& reading_;
  Node& table_;
  std::string name_;
  std::vector<std::string> known_;
  bool valid_;
  bool any_key_ = false;
};

/// Reads every table of a list such as [[bonds]] and finishes it; absent is an empty list, a plain [bonds] a
/// fault.
void for_each_table(Reading& reading, Node* list, const std::string& key,
                    const std::function<void(TableReader&)>& read);

}  // namespace bondstatic
