// SPDX-License-Identifier: MIT
#include "microslip/io/output/shared_object.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp() of POSIX

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/child_process.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/output/temporaries.hpp"

namespace microslip {
namespace {

/// A folder among the temporary ones for files of these names, which vanish with it: whatever
/// writes one of them later finds no folder.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::initializer_list<std::string_view> names) : folder_(made()) {
    for (const std::string_view name : names) files_.emplace_back(file(name));
  }

  [[nodiscard]] std::string file(std::string_view name) const {
    return fmt::format("{}/{}", folder_.path(), name);
  }

 private:
  static std::string made() {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    std::string name =
        ((error ? std::filesystem::path("/tmp") : folder) / "microslip-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw Error(fmt::format("{}: no temporary folder: {}", name, std::strerror(errno)));
    }
    return name;
  }

  Temporary folder_;  // is removed behind the files, which leave it empty
  std::vector<Temporary> files_;
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

/// Runs the compiler. @param what  remains of its command. @throws Error  with its message.
void compile(const ScratchFolder& scratch, std::vector<std::string> what) {
  what.insert(what.begin(), "cc");
  const std::string messages = scratch.file("messages");
  const FileDescriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const FileDescriptor out(
      ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
  if (!nothing.is_open() || !out.is_open()) {
    throw Error(fmt::format("{}: cannot be opened: {}", messages, std::strerror(errno)));
  }
  std::optional<Child> compiler =
      Child::start(std::move(what), {nothing.number(), out.number(), out.number()});
  if (!compiler) {
    throw Error(
        "cc: there is no C compiler of this name. Install one (on Debian: apt install gcc).");
  }
  const int status = compiler->wait();
  if (status == 0) return;
  throw Error(
      fmt::format("cc: ended with status {}: {}", status, first_error(read_file(messages))));
}

/// What the compiler wrote. @throws Error  where that is nothing.
std::string written(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size == 0) throw Error("cc: ended with status 0 and wrote no file");
  return read_file(path);
}

}  // namespace

/// In two steps, by files of known names alone: with a single one the compiler would put an object
/// of a name of its own among the temporary files.
std::string shared_object_of(std::string_view source, const std::vector<std::string>& definitions) {
  const ScratchFolder scratch({"joint.c", "joint.o", "joint.so", "messages"});
  FileOutput file(scratch.file("joint.c"));
  file.write(source);
  file.close();
  const std::string object = scratch.file("joint.o");
  const std::string shared = scratch.file("joint.so");
  std::vector<std::string> command{"-std=c99",   "-O2",   "-ffp-contract=off",
                                   "-fno-ident", "-fPIC", "-fvisibility=hidden",
                                   "-pipe",      "-c"};
  for (const std::string& definition : definitions) command.push_back("-D" + definition);
  command.insert(command.end(), {"-o", object, scratch.file("joint.c")});
  compile(scratch, std::move(command));
  (void)written(object);
  compile(scratch, {"-shared", "-nostartfiles", "-s", "-Wl,--build-id=none", "-o", shared, object});
  return written(shared);
}

}  // namespace microslip
