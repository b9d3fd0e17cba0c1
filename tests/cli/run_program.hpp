// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/support.hpp"

/// @file
/// Runs the program as a user does, from a folder of its own.

namespace microslip::cli_test {

using Arguments = std::vector<std::string>;

/// The call with more arguments behind it.
[[nodiscard]] Arguments with(Arguments call, const Arguments& more);

/// How a run ended.
struct Outcome {
  int status = 0;  ///< as a shell shows it: 128 + signal where one ended the program
  int signal = 0;  ///< that signal; 0 where there was none
  std::string out;
  std::string err;
};

/// The circumstances of a run.
struct Circumstances {
  std::string in{};                        ///< text on standard input
  std::optional<int> standard_output{};    ///< a file descriptor in place of one that is captured
  std::vector<int> closed{};               ///< of 0, 1, 2
  std::optional<int> ignored_signal{};     ///< as `nohup` ignores SIGHUP
  std::optional<std::size_t> file_size{};  ///< no file can become larger, bytes
  std::optional<std::size_t> memory{};     ///< addresses that it may use, bytes; not by a sanitizer
  std::vector<std::string> environment{};  ///< "NAME=VALUE", added to that of the test
  bool unprivileged = false;               ///< no more rights than any user, even where root tests
  std::optional<unsigned short>
      columns{};  ///< on a terminal of this width, see Running::terminal()
};

/// A program that runs. Ended by force where nobody waits for it.
class Running {
 public:
  Running(const Arguments& arguments, const std::string& folder, const Circumstances& how);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

  /// Waits for its end.
  Outcome wait();
  void send(int signal) const { ::kill(process_, signal); }
  [[nodiscard]] bool has_ended() const;

  /// What it has shown on its terminal until `enough` says true or it ends; both of its outputs.
  std::string read_terminal(const std::function<bool(const std::string&)>& enough);

 private:
  int process_ = -1;
  int terminal_ = -1;
  int out_ = -1;
  int err_ = -1;
  std::string shown_;
};

/// A folder with files in it, from which the program is run.
class Sandbox {
 public:
  struct File {
    std::string name;
    std::string content;
  };

  Sandbox() = default;
  Sandbox(std::initializer_list<File> files);

  Outcome run(const Arguments& arguments, const Circumstances& how = {}) const {
    return Running(arguments, path(), how).wait();
  }

  /// Names are relative to the folder.
  void put(const std::string& name, const std::string& content) const;
  [[nodiscard]] std::string get(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] std::string file(const std::string& name) const { return folder_.file(name); }
  [[nodiscard]] std::string path() const { return folder_.file("."); }

  /// All files below the folder with their content; folders with an empty one.
  [[nodiscard]] std::map<std::string, std::string> content() const;

 private:
  test::TemporaryFolder folder_;
};

/// Expects that the call is refused: status 2, one line on standard error with all of the parts,
/// nothing on standard output and nothing written.
void expect_refused(const Sandbox& box, const Arguments& arguments,
                    const std::vector<std::string>& parts, const Circumstances& how = {});

/// Expects that what was to be written could not be: status 1, one line on standard error that says
/// so with all of the parts, and all files as they were.
void expect_unwritten(const Sandbox& box, const Arguments& arguments,
                      const std::vector<std::string>& parts, const Circumstances& how);

/// Expects that the call is done, with nothing on standard error.
Outcome expect_done(const Sandbox& box, const Arguments& arguments, const Circumstances& how = {});

/// Expects that the call, stopped by a signal while its progress bar tells the time left, ends by
/// that signal and leaves everything as it was.
/// @param bar  what the bar must be of; a call may have several, one after the other.
void expect_interruptible(const Sandbox& box, const Arguments& arguments, int signal = SIGINT,
                          const std::string& bar = "");

/// Expects that a table begins with the program, its version and the call; gives what follows.
std::string behind_heading(const std::string& table);

/// For messages: what was typed.
std::string typed(const Arguments& arguments);

}  // namespace microslip::cli_test
