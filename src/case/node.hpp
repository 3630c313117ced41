// A case file as a tree of values, each with its place: what the text says, without the library that reads
// it.
#pragma once

#include <list>
#include <string>
#include <string_view>

#include "bondstatic/error.hpp"
#include "bondstatic/types.hpp"

namespace bondstatic {

struct Node {
  enum class Kind { table, array, text, whole, real, truth, other };

  Kind kind = Kind::table;
  Place place;
  std::string key;  ///< where the node is a member of a table
  Place key_place;
  std::string text;  ///< of a text; of `other` (dates, times) as written
  Index whole = 0;
  double real = 0;
  bool truth = false;
  std::list<Node> items;  ///< of an array or a table, in the order of the file; a list keeps references valid

  bool is_table() const { return kind == Kind::table; }
  bool is_array() const { return kind == Kind::array; }
  bool is_text() const { return kind == Kind::text; }
  bool is_number() const { return kind == Kind::whole || kind == Kind::real; }

  /// Member of a table, null where there is none.
  Node* find(std::string_view member);

  /// Set or replace a member of a table.
  Node& set(const std::string& member, Node value);

  static Node of(double value);
  static Node of(Index value);
  static Node of(bool value);
  static Node of(const std::string& value);
  static Node of(const Vector3& value);
};

/// For messages: the value itself where it is short ("-5", "\"steel\""), else what it is ("a table").
std::string shown(const Node& node);

}  // namespace bondstatic
