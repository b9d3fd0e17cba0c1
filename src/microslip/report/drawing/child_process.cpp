// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/child_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/child_process.hpp"

namespace microslip {
namespace {

[[noreturn]] void fail(std::string_view program, int code) {
  throw Error(fmt::format("{}: cannot be run: {}", program, std::strerror(code)));
}

struct CloseStream {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};

/// Owns a socket through a stream that is never read or written.
using Socket = std::unique_ptr<std::FILE, CloseStream>;

int number_of(const Socket& socket) { return socket ? fileno(socket.get()) : -1; }

/// Two connected sockets, which no child inherits unless it is given them. Sockets rather than
/// pipes, because a send() to a child that is gone can be kept from raising SIGPIPE.
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
  for (SocketPair& channel : channels) channel = open_channel(program);
  std::optional<Child> child = Child::start(
      std::move(command), {number_of(channels[0].childs), number_of(channels[1].childs),
                           number_of(channels[2].childs)});
  if (!child) return std::nullopt;
  for (SocketPair& channel : channels) channel.childs.reset();

  ChildResult result;
  converse(std::move(channels[0].ours), std::move(channels[1].ours), std::move(channels[2].ours),
           program, input, result);
  result.status = child->wait();
  return result;
}

}  // namespace microslip
