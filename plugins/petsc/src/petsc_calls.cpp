// SPDX-License-Identifier: BSD-3-Clause
#include "petsc_calls.h"

#include <cctype>
#include <cstdlib>
#include <new>
#include <sstream>
#include <string_view>

#include "boxplus/base/error.h"

namespace boxplus::petsc {
namespace {

std::mutex& petsc_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool mpi_is_finalized() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  return finalized != 0;
}

void end() {
  if (is_running()) (void)PetscFinalize();
}

PetscErrorCode keep_silent(MPI_Comm, int, const char*, const char*, PetscErrorCode code, PetscErrorType,
                           const char*, void*) {
  return code;
}

/// While an object of this class exists, MPI starts no daemon if mpirun has not started the program. The
/// daemon would only be needed for MPI_Comm_spawn(), and takes a tenth of a second.
class WithoutDaemon {
 public:
  WithoutDaemon() : sets_(std::getenv(kName) == nullptr) {
    if (sets_) setenv(kName, "1", 0);
  }
  ~WithoutDaemon() {
    if (sets_) unsetenv(kName);
  }
  WithoutDaemon(const WithoutDaemon&) = delete;
  WithoutDaemon& operator=(const WithoutDaemon&) = delete;

 private:
  static constexpr const char* kName = "OMPI_MCA_ess_singleton_isolated";
  bool sets_;
};

/// Initializes PETSc. It keeps pointers to the arguments.
void initialize() {
  static char program[] = "boxplus", no_file[] = "-skip_petscrc", no_signals[] = "-no_signal_handler";
  static char* arguments[] = {program, no_file, no_signals, nullptr};
  static char** argv = arguments;
  static int argc = 3;
  if (mpi_is_finalized()) throw Error("PETSc cannot start, because the program has already ended MPI");
  PETSC_MPI_THREAD_REQUIRED = MPI_THREAD_SERIALIZED;  // a mutex lets one thread at a time call PETSc
  const WithoutDaemon isolated;
  (void)PetscPushErrorHandler(keep_silent, nullptr);
  int mpi_runs = 0;
  (void)MPI_Initialized(&mpi_runs);
  MPI_Errhandler handler = MPI_ERRHANDLER_NULL;  // of the program, which PETSc replaces
  if (mpi_runs != 0) (void)MPI_Comm_get_errhandler(MPI_COMM_WORLD, &handler);
  const PetscErrorCode code = PetscInitialize(&argc, &argv, "", nullptr);
  if (mpi_runs != 0) (void)MPI_Comm_set_errhandler(MPI_COMM_WORLD, handler);
  (void)PetscPopErrorHandler();
  if (code != 0) throw Error("PETSc cannot start: PetscInitialize() returns " + std::to_string(code));
  std::atexit(end);
}

/// Whether an option of the user may have caused the error.
bool blames_options(PetscErrorCode code) {
  switch (code) {
    case PETSC_ERR_SUP:
    case PETSC_ERR_ARG_WRONG:
    case PETSC_ERR_ARG_OUTOFRANGE:
    case PETSC_ERR_ARG_INCOMP:
    case PETSC_ERR_ARG_UNKNOWN_TYPE:
    case PETSC_ERR_ARG_WRONGSTATE:
    case PETSC_ERR_USER:
    case PETSC_ERR_USER_INPUT:
    case PETSC_ERR_MISSING_FACTOR:
    case PETSC_ERR_FILE_OPEN:
    case PETSC_ERR_FILE_UNEXPECTED:
      return true;
    default:
      return false;
  }
}

/// "-1" and "-.5" are values, not names.
bool is_name(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

}  // namespace

void start() {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  PetscBool initialized = PETSC_FALSE, finalized = PETSC_FALSE;
  (void)PetscInitialized(&initialized);
  (void)PetscFinalized(&finalized);
  if (finalized) throw Error("PETSc cannot start, because the program has already ended it");
  if (!initialized) initialize();
}

bool is_running() {
  PetscBool initialized = PETSC_FALSE, finalized = PETSC_FALSE;
  (void)PetscInitialized(&initialized);
  (void)PetscFinalized(&finalized);
  return initialized && !finalized && !mpi_is_finalized();
}

Calls::Calls(PetscOptions options) : alone_(petsc_mutex()), options_(options) {
  if (!is_running()) throw Error("PETSc cannot be called, because the program has already ended it, or MPI");
  (void)PetscPushErrorHandler(take_message, this);
  if (options_ != nullptr) (void)PetscOptionsPush(options_);
}

Calls::~Calls() {
  if (options_ != nullptr) (void)PetscOptionsPop();
  (void)PetscPopErrorHandler();
}

PetscErrorCode Calls::take_message(MPI_Comm, int, const char* function, const char*, PetscErrorCode code,
                                   PetscErrorType type, const char* message, void* calls) {
  // PETSc 3.18 has another code than PETSC_ERR_MEM if malloc() fails.
  const bool allocates = function != nullptr && std::string_view(function).starts_with("PetscMalloc");
  if (code == PETSC_ERR_MEM || allocates) static_cast<Calls*>(calls)->has_no_memory_ = true;
  if (type == PETSC_ERROR_INITIAL && message != nullptr) static_cast<Calls*>(calls)->message_ = message;
  return code;
}

void Calls::fail(PetscErrorCode code) const {
  if (has_no_memory_) throw std::bad_alloc();
  const char* general = nullptr;
  (void)PetscErrorMessage(code, &general, nullptr);
  const std::string first_line = message_.substr(0, message_.find('\n'));
  const std::string text = "PETSc: " + (!first_line.empty()  ? first_line
                                        : general != nullptr ? general
                                                             : std::to_string(code));
  if (blames_options(code)) throw InvalidArgument(text);
  throw Error(text);
}

std::map<std::string, std::string> parse_options(const std::string& text) {
  std::map<std::string, std::string> options;
  std::istringstream words(text);
  std::string* value = nullptr;  // of the last name, if it has none yet
  for (std::string word; words >> word;) {
    if (is_name(word)) {
      value = &options[word];
      value->clear();
    } else if (value != nullptr) {
      *std::exchange(value, nullptr) = word;
    } else {
      throw InvalidArgument("options of PETSc: expected a name such as -ksp_type, got '" + word + "'");
    }
  }
  return options;
}

Options make_options(const std::string& text) {
  start();
  const Calls calls(nullptr);
  Options options;
  calls(PetscOptionsCreate(options.out()));
  calls(PetscOptionsInsertString(options, text.c_str()));
  return options;
}

}  // namespace boxplus::petsc
