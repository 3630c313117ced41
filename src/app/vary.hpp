// The grid that --vary spans.
#pragma once

#include <string>
#include <vector>

namespace bondstatic {

/// Keys that change together and the values they take: values[i] has one entry a key.
struct Variation {
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> values;
};

/// "KEY=v1,v2" or "KEY1:KEY2=a1:b1,a2:b2". Commas and colons within brackets, braces or quotes belong to the
/// value. Throws Error (invalid_input).
Variation parse_variation(const std::string& text);

/// Every combination, the last variation changing fastest; a point is one value for each key, in the order of
/// the variations.
std::vector<std::vector<std::string>> grid_points(const std::vector<Variation>& variations);

}  // namespace bondstatic
