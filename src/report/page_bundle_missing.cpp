// In the place of the bundle where the library is built without npm.
#include "report/page_bundle.hpp"

namespace bondstatic {

const PageBundle* page_bundle() {
  return nullptr;
}

}  // namespace bondstatic
