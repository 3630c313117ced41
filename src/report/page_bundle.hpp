// The page that reports are made of: src/report/page, bundled by src/report/page/bundle.mjs when the library
// is built.
#pragma once

#include <string_view>

namespace bondstatic {

struct PageBundle {
  std::string_view script, style;  ///< licences of what is bundled stand at the head of the script
  std::string_view script_hash;    ///< "sha256-...", as a content security policy names it
};

/// Null where the library was built without.
const PageBundle* page_bundle();

}  // namespace bondstatic
