#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "app/ranked.hpp"

int main(int argc, char** argv) {
  using namespace bondstatic;
  handle_interrupts();
  const Launched launch = launched();
  if (launch.ranks > 1)
    return int(run_ranked(launch, [&](Ranks* ranks) { return run_command_line(argc, argv, ranks); }));
  const RankStatus ended = status_of([&] { return run_command_line(argc, argv, nullptr); });
  say(ended);
  return int(ended.code);
}
