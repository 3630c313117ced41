#include "petsc/session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <petscviewer.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "petsc/mpi_lifetime.hpp"

namespace bondstatic {

namespace {

struct Told {
  std::string message;  // of the error that is under way, from where it was first noticed
};

PetscErrorCode keep_message(MPI_Comm, int, const char* function, const char*, PetscErrorCode code,
                            PetscErrorType type, const char* message, void* context) {
  if (type == PETSC_ERROR_INITIAL)
    static_cast<Told*>(context)->message =
        fmt::format("{} ({})", message && *message ? message : "no further word", function ? function : "?");
  return code;
}

// argv as PETSc wants it: the name of a program first.
struct Arguments {
  std::vector<std::string> texts;
  std::vector<char*> pointers;
  explicit Arguments(const std::vector<std::string>& options) : texts(options) {
    texts.insert(texts.begin(), {"bondstatic", "-no_signal_handler"});
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
  }
  int count() const { return int(texts.size()); }
};

class Session {
 public:
  explicit Session(const std::vector<std::string>& options) : options_(options) {
    start_mpi();
    Arguments arguments(options);
    int count = arguments.count();
    char** values = arguments.pointers.data();
    if (PetscInitialize(&count, &values, nullptr, nullptr) != 0)
      throw Error(ExitCode::internal, "PETSc does not start");
    PETSC_STDOUT = stderr;  // the answer alone goes to standard output
    PetscPushErrorHandler(keep_message, &told_);
  }
  ~Session() {
    PetscPopErrorHandler();
    PetscFinalize();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void use(const std::vector<std::string>& options) {
    if (options == options_) return;
    Arguments arguments(options);
    check_petsc(PetscOptionsClear(nullptr));
    check_petsc(PetscOptionsInsertArgs(nullptr, arguments.count(), arguments.pointers.data()));
    options_ = options;
  }

  const std::vector<std::string>& options() const { return options_; }
  const std::string& message() const { return told_.message; }

 private:
  std::vector<std::string> options_;
  Told told_;
};

Session& session(const std::vector<std::string>& options = {}) {
  static Session only(options);
  return only;
}

// "-1" and "-1e-3" are values; "-ksp_rtol" and "--help" are options.
bool is_option(const std::string& text) {
  return text.size() > 1 && text[0] == '-' &&
         std::string_view("0123456789.").find(text[1]) == std::string::npos;
}

bool misunderstood(PetscErrorCode code) {
  constexpr PetscErrorCode codes[] = {PETSC_ERR_ARG_UNKNOWN_TYPE,
                                      PETSC_ERR_ARG_OUTOFRANGE,
                                      PETSC_ERR_ARG_WRONG,
                                      PETSC_ERR_USER,
                                      PETSC_ERR_SUP,
                                      PETSC_ERR_USER_INPUT,
                                      PETSC_ERR_MISSING_FACTOR,
                                      PETSC_ERR_FILE_OPEN,
                                      PETSC_ERR_ARG_INCOMP};
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

}  // namespace

void start_petsc(const std::vector<std::string>& options) {
  for (std::size_t i = 0; i < options.size(); ++i)
    if (!is_option(options[i]) && (i == 0 || !is_option(options[i - 1])))
      throw Error(
          ExitCode::invalid_input,
          fmt::format("\"{}\" is no option of PETSc, nor the value of one\n    cure: options behind -- "
                      "look like -ksp_rtol 1e-6",
                      options[i]));
  session(options).use(options);
}

void check_petsc(PetscErrorCode code) {
  if (code == 0) return;
  const std::string message = "PETSc: " + session().message();
  if (code == PETSC_ERR_MEM) throw MemoryError(message);
  if (!session().options().empty() && misunderstood(code))
    throw Error(ExitCode::invalid_input,
                message + "\n    cure: look at the options given to PETSc behind --");
  throw Error(ExitCode::internal, message);
}

void refuse_unused(const std::vector<std::string>& options) {
  std::vector<std::string> unused;
  for (const std::string& option : options) {
    if (!is_option(option)) continue;
    PetscBool used = PETSC_TRUE;
    check_petsc(PetscOptionsUsed(nullptr, option.c_str() + 1, &used));
    if (!used) unused.push_back(option);
  }
  if (!unused.empty())
    throw Error(ExitCode::invalid_input,
                fmt::format("PETSc had no use for {}\n    cure: look for a misspelt name, or an option of a "
                            "method that does not run (-help lists those that do)",
                            fmt::join(unused, ", ")));
}

}  // namespace bondstatic
