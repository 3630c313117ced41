#include <memory>

#include "app/parsed_commands.hpp"

namespace bondstatic {

std::vector<ParsedCommand> add_exchange_commands(CLI::App&) {
  return {};
}

}  // namespace bondstatic
