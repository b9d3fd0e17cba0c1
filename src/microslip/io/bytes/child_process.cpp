// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"

// POSIX has the program declare it.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace microslip {
namespace {

[[noreturn]] void fail_to_start(std::string_view program, int code) {
  throw Error(fmt::format("{}: cannot be run: {}", program, std::strerror(code)));
}

/// Files to put in the place of the standard streams of a child.
class SpawnActions {
 public:
  explicit SpawnActions(std::string_view program) : program_(program) {
    require(posix_spawn_file_actions_init(&actions_));
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  /// Via a copy with a number above 2: where this program runs with a standard stream closed,
  /// a file that has its number would be overwritten while the others are put in place.
  void connect(int file, int stream) {
    const FileDescriptor& copy = copies_.emplace_back(fcntl(file, F_DUPFD_CLOEXEC, 3));
    if (!copy.is_open()) fail_to_start(program_, errno);
    require(posix_spawn_file_actions_adddup2(&actions_, copy.number(), stream));
  }

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  void require(int code) const {
    if (code != 0) fail_to_start(program_, code);
  }

  std::string program_;
  std::vector<FileDescriptor> copies_;
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

std::optional<Child> Child::start(std::vector<std::string> command,
                                  const std::array<int, 3>& streams) {
  const std::string program = command.at(0);
  SpawnActions actions(program);
  for (std::size_t i = 0; i < streams.size(); ++i) {
    actions.connect(streams.at(i), static_cast<int>(i));
  }
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  pid_t id = -1;
  const int code =
      posix_spawnp(&id, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (code == ENOENT) return std::nullopt;
  if (code != 0) fail_to_start(program, code);
  return Child(id);
}

Child::~Child() {
  if (id_ < 0) return;
  kill(id_, SIGKILL);
  (void)wait();
}

int Child::wait() {
  int state = 0;
  pid_t id = -1;
  do {
    id = waitpid(id_, &state, 0);
  } while (id < 0 && errno == EINTR);
  id_ = -1;
  if (id < 0) return 0;
  return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
}

}  // namespace microslip
