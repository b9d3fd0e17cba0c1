// SPDX-License-Identifier: MIT
#include "microslip/io/output/shared_object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/child_process.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/output/temporaries.hpp"

namespace microslip {
namespace {

/// A file in the folder for temporary ones that vanishes with this.
class ScratchFile {
 public:
  ScratchFile() : file_(::mkstemp(name_.data())), temporary_(name_) {
    if (!file_.is_open()) {
      throw Error(fmt::format("{}: no temporary file: {}", name_, std::strerror(errno)));
    }
  }

  [[nodiscard]] const std::string& path() const { return name_; }
  [[nodiscard]] int number() const { return file_.number(); }

  /// Fills it and returns to its start, for a reader.
  void fill(std::string_view bytes) {
    for (std::string_view rest = bytes; !rest.empty();) {
      const ssize_t written = ::write(number(), rest.data(), rest.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        throw Error(fmt::format("{}: cannot be written: {}", name_, std::strerror(errno)));
      }
      rest.remove_prefix(static_cast<std::size_t>(written));
    }
    ::lseek(number(), 0, SEEK_SET);
  }

 private:
  static std::string pattern() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    return ((error ? std::filesystem::path("/tmp") : folder) / "microslip-XXXXXX").string();
  }

  std::string name_ = pattern();
  FileDescriptor file_;
  Temporary temporary_;
};

/// The first line of a compiler's messages that tells of an error.
std::string first_error(std::string_view messages) {
  std::string first;
  while (!messages.empty()) {
    const std::string line(messages.substr(0, messages.find('\n')));
    messages.remove_prefix(std::min(messages.find('\n'), messages.size() - 1) + 1);
    if (line.find("error") != std::string::npos) return line;
    if (first.empty()) first = line;
  }
  return first;
}

}  // namespace

std::string shared_object_of(std::string_view source, const std::vector<std::string>& definitions) {
  ScratchFile in;
  in.fill(source);
  const ScratchFile out;
  const ScratchFile errors;
  std::vector<std::string> command{"cc",    "-std=c99", "-O2", "-ffp-contract=off",
                                   "-fPIC", "-shared",  "-s",  "-fvisibility=hidden",
                                   "-x",    "c"};
  for (const std::string& definition : definitions) command.push_back("-D" + definition);
  command.insert(command.end(), {"-o", out.path(), "-"});
  std::optional<Child> compiler =
      Child::start(command, {in.number(), errors.number(), errors.number()});
  if (!compiler) {
    throw Error(
        "cc: there is no C compiler of this name. Install one (on Debian: apt install gcc).");
  }
  const int status = compiler->wait();
  std::string object = read_file(out.path());
  if (status != 0 || object.empty()) {
    throw Error(
        fmt::format("cc: ended with status {}: {}", status, first_error(read_file(errors.path()))));
  }
  return object;
}

}  // namespace microslip
