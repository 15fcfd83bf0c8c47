// SPDX-License-Identifier: BSD-3-Clause
#include "platform/process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <spawn.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <system_error>

namespace boxplus {

int process_id() {
  return ::getpid();
}

std::filesystem::path program_path() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none);
}

void after_fork(void (*handler)()) {
  ::pthread_atfork(nullptr, nullptr, handler);
}

bool start_browser(const std::string& url, const SignalSet& signals) {
  std::string program = "xdg-open", address = url;
  std::array<char*, 3> arguments{program.data(), address.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &signals.value);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error == 0;
}

void* load_function(const std::string& library, const char* name, std::string& error) {
  void* const handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = handle != nullptr ? ::dlsym(handle, name) : nullptr;
  if (function == nullptr) error = ::dlerror();
  return function;
}

std::optional<std::string> host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return std::nullopt;
  return name.data();
}

bool fill_randomly(std::span<unsigned char> bytes) {
  return ::getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
}

}  // namespace boxplus
