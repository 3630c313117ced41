// The file of a report: data, numbers and the page that draws them, in one HTML document.
#pragma once

#include <string>
#include <string_view>

#include "report/blocks.hpp"
#include "report/page_bundle.hpp"
#include "report/page_data.hpp"

namespace bondstatic {

/// How a report begins, by which it is told from other files.
inline constexpr std::string_view html_head = "<!doctype html>\n<!-- bondstatic report -->\n";

/// A content security policy in it allows the page's own script and nothing else: no other script, no request
/// of any kind. Text of the data stands in the JSON only, where nothing of it is taken for a tag.
std::string html(const PageData& data, const Blocks& blocks, const PageBundle& page);

}  // namespace bondstatic
