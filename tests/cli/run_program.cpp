// SPDX-License-Identifier: MIT
#include "cli/run_program.hpp"

#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "microslip/base/version.hpp"
#include "support/built_file.hpp"

namespace microslip::cli_test {
namespace {

namespace fs = std::filesystem;

const std::string kProgram = test::built_file("MICROSLIP_PROGRAM", MICROSLIP_PROGRAM);
constexpr int kCannotRun = 127;
constexpr unsigned kNobody = 65534;

/// A file without a name, for what flows into and out of the program: unlike a pipe it is never
/// full.
int nameless_file(const std::string& content = {}) {
  std::string name = (fs::temp_directory_path() / "microslip-test-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) throw std::runtime_error("no temporary file");
  ::unlink(name.c_str());
  if (::write(file, content.data(), content.size()) != static_cast<ssize_t>(content.size())) {
    throw std::runtime_error("temporary file cannot be written");
  }
  ::lseek(file, 0, SEEK_SET);
  return file;
}

std::string content_of(int file) {
  std::string text;
  std::array<char, 65536> buffer;
  ::lseek(file, 0, SEEK_SET);
  for (;;) {
    const ssize_t count = ::read(file, buffer.data(), buffer.size());
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool drop_rights() {
  return ::geteuid() != 0 ||
         (::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

/// In the child. Does not return.
[[noreturn]] void become_program(const Arguments& arguments, const std::string& folder,
                                 const Circumstances& how) {
  for (const int file : how.closed) ::close(file);
  const rlimit no_core{0, 0};  // a program that a signal ends must leave nothing
  if (::setrlimit(RLIMIT_CORE, &no_core) != 0) ::_exit(kCannotRun);
  for (const std::string& variable : how.environment) ::putenv(const_cast<char*>(variable.c_str()));
  if (how.file_size) {
    const rlimit limit{*how.file_size, *how.file_size};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(kCannotRun);
  }
  if (how.memory) {
    const rlimit limit{*how.memory, *how.memory};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(kCannotRun);
  }
  if (how.ignored_signal) ::signal(*how.ignored_signal, SIG_IGN);
  if (::chdir(folder.c_str()) != 0) ::_exit(kCannotRun);
  if (how.unprivileged && !drop_rights()) ::_exit(kCannotRun);
  std::vector<char*> words{const_cast<char*>(kProgram.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(kProgram.c_str(), words.data());
  ::_exit(kCannotRun);
}

}  // namespace

Running::Running(const Arguments& arguments, const std::string& folder, const Circumstances& how) {
  if (how.columns) {
    const winsize size{.ws_row = 24, .ws_col = *how.columns, .ws_xpixel = 0, .ws_ypixel = 0};
    process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ == 0) {
      if (how.standard_output) ::dup2(*how.standard_output, STDOUT_FILENO);
      become_program(arguments, folder, how);
    }
  } else {
    const int in = nameless_file(how.in);
    out_ = nameless_file();
    err_ = nameless_file();
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(in, STDIN_FILENO);
      ::dup2(how.standard_output.value_or(out_), STDOUT_FILENO);
      ::dup2(err_, STDERR_FILENO);
      become_program(arguments, folder, how);
    }
    ::close(in);
  }
  if (process_ < 0) throw std::runtime_error("no process");
}

Running::~Running() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  for (const int file : {terminal_, out_, err_}) {
    if (file >= 0) ::close(file);
  }
}

bool Running::has_ended() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == process_;
}

std::string Running::read_terminal(const std::function<bool(const std::string&)>& enough) {
  std::array<char, 4096> buffer;
  while (!enough(shown_)) {
    const ssize_t count = ::read(terminal_, buffer.data(), buffer.size());
    if (count <= 0) break;  // the system reports an error where the other side has gone
    shown_.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return shown_;
}

Outcome Running::wait() {
  Outcome outcome;
  if (terminal_ >= 0) outcome.out = read_terminal([](const std::string&) { return false; });
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  outcome.status = outcome.signal > 0 ? 128 + outcome.signal : WEXITSTATUS(status);
  if (out_ >= 0) outcome.out = content_of(out_);
  if (err_ >= 0) outcome.err = content_of(err_);
  return outcome;
}

Sandbox::Sandbox(std::initializer_list<File> files) {
  for (const auto& [name, text] : files) put(name, text);
}

void Sandbox::put(const std::string& name, const std::string& content) const {
  test::put(file(name), content);
}

std::string Sandbox::get(const std::string& name) const {
  EXPECT_TRUE(has(name)) << name << " is not there";
  return test::get(file(name));
}

bool Sandbox::has(const std::string& name) const { return fs::exists(file(name)); }

std::map<std::string, std::string> Sandbox::content() const {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(path())) {
    const bool is_file = entry.is_regular_file() && !entry.is_symlink();
    result[entry.path().string()] = is_file ? test::get(entry.path().string()) : "";
  }
  return result;
}

Arguments with(Arguments call, const Arguments& more) {
  call.insert(call.end(), more.begin(), more.end());
  return call;
}

void expect_interruptible(const Sandbox& box, const Arguments& arguments, int signal,
                          const std::string& bar) {
  const auto before = box.content();
  Running program(arguments, box.path(), {.columns = 80});
  program.read_terminal([&](const std::string& shown) {
    const std::size_t begin = shown.rfind(bar + " [");
    return begin != std::string::npos && shown.find("s left", begin) != std::string::npos;
  });
  program.send(signal);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, signal) << typed(arguments);
  EXPECT_EQ(outcome.status, 128 + signal) << typed(arguments);
  EXPECT_TRUE(box.content() == before) << typed(arguments);
}

std::string behind_heading(const std::string& table) {
  EXPECT_TRUE(table.starts_with("# microslip " + std::string(kVersion) + ": microslip ")) << table;
  return table.substr(table.find('\n') + 1);
}

std::string typed(const Arguments& arguments) {
  std::string text = "microslip";
  for (const std::string& word : arguments) text += " '" + word + "'";
  return text;
}

namespace {

/// One line on standard error with all of the parts, and all files as they were.
Outcome expect_complaint(const Sandbox& box, const Arguments& arguments,
                         const std::vector<std::string>& parts, const Circumstances& how,
                         int status) {
  constexpr std::size_t kLongest = 600;  // bytes, whatever the size of what was refused
  const auto before = box.content();
  Outcome outcome = box.run(arguments, how);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("microslip: ")) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_LT(outcome.err.size(), kLongest) << outcome.err;
  for (const std::string& part : parts) {
    EXPECT_NE(outcome.err.find(part), std::string::npos)
        << "no '" << part << "' in " << outcome.err;
  }
  EXPECT_TRUE(box.content() == before) << "something was written";
  return outcome;
}

}  // namespace

void expect_refused(const Sandbox& box, const Arguments& arguments,
                    const std::vector<std::string>& parts, const Circumstances& how) {
  SCOPED_TRACE(typed(arguments));
  EXPECT_EQ(expect_complaint(box, arguments, parts, how, 2).out, "");
}

void expect_unwritten(const Sandbox& box, const Arguments& arguments,
                      const std::vector<std::string>& parts, const Circumstances& how) {
  SCOPED_TRACE(typed(arguments));
  (void)expect_complaint(box, arguments, parts, how, 1);
}

Outcome expect_done(const Sandbox& box, const Arguments& arguments, const Circumstances& how) {
  SCOPED_TRACE(typed(arguments));
  Outcome outcome = box.run(arguments, how);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome;
}

}  // namespace microslip::cli_test
