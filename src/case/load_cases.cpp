#include "case/load_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bondstatic {
namespace {

/// Results of several cases lie in folders of these names.
bool usable_as_folder(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= 100 && name[0] != '.' && std::all_of(name.begin(), name.end(), fits);
}

}  // namespace

void collect_load_cases(Draft& draft, Node* loads, Node* supports) {
  std::vector<std::string> names;
  for (Node* list : {loads, supports}) {
    if (!list || !list->is_array()) continue;
    for (Node& block : list->items) {
      const Node* name = block.find("case");
      if (name && name->is_text() && std::find(names.begin(), names.end(), name->text) == names.end())
        names.push_back(name->text);
    }
  }
  if (!names.empty()) draft.model.load_cases = names;
}

Index load_case_of(Draft& draft, TableReader& block) {
  const auto name = block.text("case");
  if (!name) return every_case;
  if (!usable_as_folder(*name))
    draft.reading.fault(block.place_of("case"),
                        fmt::format("case = \"{}\" cannot name a folder of results", *name),
                        "use letters, digits, - _ and ., not . first");
  const auto& names = draft.model.load_cases;
  return std::find(names.begin(), names.end(), *name) - names.begin();
}

}  // namespace bondstatic
