#include "results/all_or_none.hpp"

#include <exception>
#include <new>

#include "io/message.hpp"

namespace bondstatic {

static void describe(Archive& archive, RankStatus& status) {
  archive(status.code, status.message);
}

namespace {

RankStatus outcome_of(const std::function<void()>& part, std::exception_ptr& failure) {
  try {
    part();
    return {};
  } catch (const Error& error) {
    failure = std::current_exception();
    return {error.code(), error.what()};
  } catch (const std::bad_alloc&) {
    failure = std::current_exception();
    return {ExitCode::out_of_memory, "out of memory"};
  } catch (const std::exception& error) {
    failure = std::current_exception();
    return {ExitCode::internal, error.what()};
  }
}

}  // namespace

void all_or_none(Ranks& ranks, const std::function<void()>& part) {
  std::exception_ptr failure;
  const RankStatus mine = outcome_of(part, failure);
  RankStatus first_failed;
  for (const std::string& bytes : ranks.gather(packed(mine))) {
    first_failed = unpacked<RankStatus>(bytes);
    if (first_failed.code != ExitCode::done) break;
  }
  first_failed = unpacked<RankStatus>(ranks.broadcast(packed(first_failed)));
  if (failure) std::rethrow_exception(failure);
  if (first_failed.code != ExitCode::done) throw Error(first_failed.code, first_failed.message);
}

}  // namespace bondstatic
