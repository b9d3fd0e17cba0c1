// SPDX-License-Identifier: MIT
#include "microslip/report/child_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "microslip/base/error.hpp"

// POSIX has the program declare it.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace microslip {
namespace {

[[noreturn]] void fail(std::string_view program, int code) {
  throw Error(fmt::format("{}: cannot be run: {}", program, std::strerror(code)));
}

struct CloseStream {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};

/// Owns a socket by way of a stream that is never read or written.
using Socket = std::unique_ptr<std::FILE, CloseStream>;

int number_of(const Socket& socket) { return socket ? fileno(socket.get()) : -1; }

/// Two connected sockets, which no child inherits unless it is given them. Sockets rather than
/// pipes, because a send() to a child that is gone can be told not to raise SIGPIPE.
struct SocketPair {
  Socket ours;
  Socket childs;
};

SocketPair open_channel(std::string_view program) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(program, errno);
  SocketPair channel{.ours = Socket(fdopen(ends[0], "r+")),
                     .childs = Socket(fdopen(ends[1], "r+"))};
  if (!channel.ours || !channel.childs) fail(program, errno);
  return channel;
}

/// Numbers above 2: where this program runs with a standard stream closed, the socket that takes
/// its number would be overwritten while the child's streams are put in place.
SocketPair open_high_channel(std::string_view program) {
  std::vector<SocketPair> low;
  for (;;) {
    SocketPair channel = open_channel(program);
    if (std::min(number_of(channel.ours), number_of(channel.childs)) > 2) return channel;
    low.push_back(std::move(channel));
  }
}

/// The child's end of each channel as its standard input, output and error.
class SpawnActions {
 public:
  explicit SpawnActions(std::string_view program) {
    if (const int code = posix_spawn_file_actions_init(&actions_); code != 0) fail(program, code);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  void connect(const SocketPair& channel, int stream, std::string_view program) {
    const int code = posix_spawn_file_actions_adddup2(&actions_, number_of(channel.childs), stream);
    if (code != 0) fail(program, code);
  }

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// A running child. Whatever happens, it is gone and reaped when this is.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (reaped_) return;
    kill(id_, SIGKILL);
    wait();
  }

  /// The exit status as a shell states it; 0 where this program ignores SIGCHLD and cannot know it.
  int wait() {
    int state = 0;
    pid_t id = -1;
    do {
      id = waitpid(id_, &state, 0);
    } while (id < 0 && errno == EINTR);
    reaped_ = true;
    if (id < 0) return 0;
    return WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  }

 private:
  pid_t id_;
  bool reaped_ = false;
};

/// Sends what the socket takes without waiting. @return whether more is left that somebody will
/// read.
bool send_some(const Socket& socket, std::string_view& input) {
  const ssize_t sent =
      send(number_of(socket), input.data(), input.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent < 0) return errno == EINTR || errno == EAGAIN;
  input.remove_prefix(static_cast<std::size_t>(sent));
  return !input.empty();
}

/// Appends what there is to read. @return whether more can come.
bool receive_some(const Socket& socket, std::string& text) {
  std::array<char, 65536> buffer;  // NOLINT: filled by recv()
  const ssize_t received = recv(number_of(socket), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (received < 0) return errno == EINTR || errno == EAGAIN;
  text.append(buffer.data(), static_cast<std::size_t>(received));
  return received > 0;
}

/// Writes and reads whatever is ready, so that neither side waits for the other for ever.
void converse(Socket to, Socket from, Socket errors_from, std::string_view program,
              std::string_view input, ChildResult& result) {
  if (input.empty()) to.reset();
  while (from || errors_from) {
    // poll() passes over negative numbers: sockets that are closed.
    std::array<pollfd, 3> ready{{{number_of(to), POLLOUT, 0},
                                 {number_of(from), POLLIN, 0},
                                 {number_of(errors_from), POLLIN, 0}}};
    if (poll(ready.data(), ready.size(), -1) < 0) {
      if (errno != EINTR && errno != EAGAIN) fail(program, errno);
      continue;
    }
    if (ready[0].revents != 0 && !send_some(to, input)) to.reset();
    if (ready[1].revents != 0 && !receive_some(from, result.output)) from.reset();
    if (ready[2].revents != 0 && !receive_some(errors_from, result.errors)) errors_from.reset();
  }
}

}  // namespace

std::optional<ChildResult> run_child(std::vector<std::string> command, std::string_view input) {
  const std::string program = command.at(0);
  std::array<SocketPair, 3> channels;
  SpawnActions actions(program);
  for (int stream = 0; stream < 3; ++stream) {
    SocketPair& channel = channels[static_cast<std::size_t>(stream)];
    channel = open_high_channel(program);
    actions.connect(channel, stream, program);
  }
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);

  pid_t id = -1;
  const int code =
      posix_spawnp(&id, program.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (code == ENOENT) return std::nullopt;
  if (code != 0) fail(program, code);
  Child child(id);
  for (SocketPair& channel : channels) channel.childs.reset();

  ChildResult result;
  converse(std::move(channels[0].ours), std::move(channels[1].ours), std::move(channels[2].ours),
           program, input, result);
  result.status = child.wait();
  return result;
}

}  // namespace microslip
