#include "bondstatic/version.hpp"

namespace bondstatic {

std::string version() {
  return BONDSTATIC_VERSION;
}

}  // namespace bondstatic
