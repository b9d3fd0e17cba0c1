// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_reader.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/sandbox/reading_process.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "microslip-hdf5-reader";
constexpr const char* kVariable = "MICROSLIP_HDF5_READER";

/// The folder of the running program.
fs::path program_folder() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).parent_path();
}

/// The folder of the file that this code is in: a shared library or, again, the program.
fs::path library_folder() {
  Dl_info info{};
  const auto* here = reinterpret_cast<const void*>(&find_hdf5_reader);
  if (dladdr(here, &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code unknown;
  return fs::canonical(info.dli_fname, unknown).parent_path();
}

std::vector<fs::path> candidates() {
  const fs::path program = program_folder();
  const fs::path library = library_folder();
  std::vector<fs::path> folders{program, program.parent_path(), library};
  for (const fs::path& prefix :
       {program.parent_path(), library.parent_path(), library.parent_path().parent_path()}) {
    folders.push_back(prefix / "libexec/microslip");
  }
  folders.emplace_back(MICROSLIP_LIBEXEC_DIR);
  for (fs::path& folder : folders) folder /= kProgram;
  return folders;
}

std::vector<std::string> call(const char* content, const std::string& path) {
  return {find_hdf5_reader(), std::string(kVersion), content, path};
}

}  // namespace

std::string find_hdf5_reader() {
  if (const char* given = std::getenv(kVariable)) return given;
  const std::vector<fs::path> paths = candidates();
  const auto found = std::ranges::find_if(
      paths, [](const fs::path& path) { return access(path.c_str(), X_OK) == 0; });
  if (found != paths.end()) return found->string();
  throw FileError(kProgram, "is missing; it reads HDF5 files",
                  fmt::format("It is installed with microslip, in {}; {} can name another place.",
                              MICROSLIP_LIBEXEC_DIR, kVariable));
}

Hdf5Recordings read_hdf5_recordings(const std::string& path, const RecordingReadOptions& options) {
  std::vector<std::string> command =
      call(options.allow_untimed ? "untimed_recordings" : "recordings", path);
  if (options.rate) append_number(command.emplace_back(), *options.rate);
  return read_in_process<Hdf5Recordings>(command, path, options.progress);
}

RawSamples read_hdf5_joint_samples(const std::string& path) {
  return read_in_process<RawSamples>(call("joint_samples", path), path, {});
}

MatTree read_mat73_tree(const std::string& path, const MatReadOptions& options) {
  std::vector<std::string> command = call("matlab", path);
  if (options.only) command.emplace_back(*options.only);
  return read_in_process<MatTree>(command, path, options.progress);
}

}  // namespace microslip
