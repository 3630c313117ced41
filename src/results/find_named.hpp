#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace bondstatic {

/// Null where there is none of that name.
template <class Named>
const Named* find_named(const std::vector<Named>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Named& one) { return one.name == name; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace bondstatic
