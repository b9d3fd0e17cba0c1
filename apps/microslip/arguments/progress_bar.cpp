// SPDX-License-Identifier: MIT
#include "arguments/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

namespace microslip::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kBarWidth = 28;
constexpr std::size_t kLeastBarWidth = 4;  // a shorter one says nothing
constexpr std::chrono::milliseconds kInterval{100};

/// So that a line does not break, which \r could not take back. Nothing known: a usual terminal.
std::size_t terminal_width() {
  constexpr std::size_t kUsual = 80;
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

class Bar {
 public:
  explicit Bar(std::string what) : what_(std::move(what)) {}

  void show(std::size_t done, std::size_t total) {
    const Clock::time_point now = Clock::now();
    const bool finished = done >= total;
    if (!finished && now - shown_ < kInterval) return;
    shown_ = now;
    const double share = static_cast<double>(done) / static_cast<double>(total);
    const std::chrono::duration<double> elapsed = now - begin_;
    const std::string figures = done == 0 ? "  0 %"
                                          : fmt::format("{:3.0f} %, {:.0f} s left", 100.0 * share,
                                                        elapsed.count() * (1.0 - share) / share);
    print("\r" + line(share, figures) + "\033[K");
    if (finished) print("\r\033[K");
  }

 private:
  /// Line that fits in the width of the terminal, less the last column, where some break the line.
  [[nodiscard]] std::string line(double share, const std::string& figures) const {
    const std::size_t room = terminal_width() - 1;
    const std::size_t text = what_.size() + figures.size() + 4;  // blanks and brackets
    if (text + kLeastBarWidth > room) return figures.substr(0, room);
    const std::size_t width = std::min(kBarWidth, room - text);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
    return fmt::format("{} [{}{}] {}", what_, std::string(filled, '#'),
                       std::string(width - filled, ' '), figures);
  }

  /// Unlike fmt::print, no exception where the terminal has gone.
  static void print(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
  }

  std::string what_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_;
};

}  // namespace

Progress progress_bar(std::string what, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return {};
  auto bar = std::make_shared<Bar>(std::move(what));
  return [bar](std::size_t done, std::size_t total) {
    bar->show(done, total);
    return true;
  };
}

}  // namespace microslip::app
