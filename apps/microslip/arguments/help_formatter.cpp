// SPDX-License-Identifier: MIT
#include "arguments/help_formatter.hpp"
#include <CLI/CLI.hpp>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "microslip/workflow/text/summary_text.hpp"

namespace microslip::app {
namespace {

constexpr std::size_t kUsualTerminal = 80;
constexpr std::size_t kLeastTerminal = 40;
constexpr std::size_t kBeside = 36;      // where descriptions begin beside the options
constexpr std::size_t kBelow = 6;        // and below them
constexpr std::size_t kRoomBeside = 30;  // that a description beside an option needs

class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::size_t width) : width_(width) {
    column_width(width < kBeside + kRoomBeside ? kBelow : kBeside);
  }

  std::string make_description(const CLI::App* app) const override {
    return broken(CLI::Formatter::make_description(app), width_) + "\n";
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return broken(CLI::Formatter::make_option_desc(option), width_ - get_column_width());
  }

  std::string make_subcommand(const CLI::App* command) const override {
    std::stringstream out;
    CLI::detail::format_help(out, command->get_display_name(true),
                             broken(command->get_description(), width_ - get_column_width()),
                             get_column_width());
    return out.str();
  }

 private:
  /// A column stays beside its unit: "amplitude [m]".
  static std::string broken(std::string text, std::size_t width) {
    constexpr char kKept = '\1';
    text.erase(text.find_last_not_of(" \n") + 1);
    std::ranges::replace(text, '\n', ' ');
    for (std::size_t at = text.find(" ["); at != std::string::npos; at = text.find(" [", at)) {
      text[at] = kKept;
    }
    text = wrapped("", text, 0, width - 1);
    text.pop_back();  // the end of its last line
    std::ranges::replace(text, kKept, ' ');
    return text;
  }

  std::size_t width_;
};

}  // namespace

std::size_t help_width() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsualTerminal;
  return std::max<std::size_t>(size.ws_col, kLeastTerminal);
}

std::shared_ptr<CLI::FormatterBase> make_help_formatter(std::size_t width) {
  return std::make_shared<HelpFormatter>(width);
}

}  // namespace microslip::app
