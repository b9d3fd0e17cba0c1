// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"

namespace microslip {
namespace {

[[noreturn]] void fail_to_start(std::string_view program, int code) {
  throw Error(fmt::format("{}: cannot be run: {}", program, std::strerror(code)));
}

/// A descriptor that no program inherits, where it is one.
FileDescriptor opened(int number, std::string_view program) {
  FileDescriptor file(number);
  if (!file.is_open()) fail_to_start(program, errno);
  return file;
}

/// The child ends with its parent, also where a signal ends that: SIGTERM, upon which a compiler
/// removes its temporary files. Where the system has no such link it ends by itself.
void end_with(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);  // it has ended already
#else
  (void)parent;
#endif
}

/// What the child does until it is another program: calls alone that a process of several threads
/// may make behind fork(). @param report  takes the error where it cannot become one.
[[noreturn]] void become(char* const* arguments, const std::array<int, 3>& files, int report,
                         pid_t parent) {
  end_with(parent);
  bool connected = true;
  int stream = 0;
  for (const int file : files) connected = connected && dup2(file, stream++) >= 0;
  if (connected) execvp(arguments[0], arguments);
  const int code = errno;
  (void)!write(report, &code, sizeof code);
  _exit(127);
}

/// The error that become() reported; 0 where there was none.
int error_from(const FileDescriptor& pipe) {
  int code = 0;
  ssize_t count = -1;
  do {
    count = read(pipe.number(), &code, sizeof code);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof code) ? code : 0;
}

}  // namespace

std::optional<Child> Child::start(std::vector<std::string> command,
                                  const std::array<int, 3>& streams) {
  const std::string program = command.at(0);
  // Via copies with numbers above 2: where this program runs with a standard stream closed, a file
  // that has its number would be overwritten while the others are put in place.
  std::array<int, 3> files{};
  std::vector<FileDescriptor> copies;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    copies.push_back(opened(fcntl(streams.at(i), F_DUPFD_CLOEXEC, 3), program));
    files.at(i) = copies.back().number();
  }
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(program, errno);
  const FileDescriptor report(ends[0]);
  FileDescriptor end(ends[1]);
  FileDescriptor copy = opened(fcntl(end.number(), F_DUPFD_CLOEXEC, 3), program);
  end.close();
  const pid_t parent = getpid();
  const pid_t id = fork();
  if (id < 0) fail_to_start(program, errno);
  if (id == 0) become(arguments.data(), files, copy.number(), parent);
  copy.close();
  Child child(id);
  const int code = error_from(report);
  if (code == 0) return child;
  if (code == ENOENT) return std::nullopt;
  fail_to_start(program, code);
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
