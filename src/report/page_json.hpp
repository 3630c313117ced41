// The data of a page as JSON that may stand inside a <script> element: no "<" in it, and no NaN.
#pragma once

#include <string>

#include "report/page_data.hpp"

namespace bondstatic {

std::string page_json(const PageData& data);

}  // namespace bondstatic
