// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <zlib.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "arguments/command.hpp"
#include "documents/documents.hpp"
#include "microslip/base/version.hpp"

/// @file
/// Runs when the program is built: microslip_documents FOLDER makes the texts that come from its
/// help again in FOLDER.

namespace {

using namespace microslip::app;
namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// Without a time stamp: the same page gives the same file.
void write_compressed(const fs::path& path, const std::string& text) {
  const gzFile file = gzopen(path.c_str(), "wb9");
  if (file == nullptr) throw std::runtime_error("cannot write " + path.string());
  const bool written = gzwrite(file, text.data(), static_cast<unsigned>(text.size())) > 0;
  if (gzclose(file) != Z_OK || !written) throw std::runtime_error("cannot write " + path.string());
}

/// Pages of commands that are no more go with the folder.
void write_man_pages(const fs::path& folder, const ProgramDescription& program) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_compressed(folder / "microslip.1.gz", program_man_page(program));
  for (const CommandDescription& command : program.commands) {
    write_compressed(folder / fmt::format("microslip-{}.1.gz", subcommand_name(command)),
                     command_man_page(program, command));
  }
}

void write_documents(const fs::path& folder) {
  Call call;
  const std::unique_ptr<CLI::App> app = make_program(call);
  const ProgramDescription program = describe(*app, std::string(microslip::kVersion));
  write_man_pages(folder / "man1", program);
  fs::create_directories(folder / "bash");
  write(folder / "bash" / "microslip", bash_completion(program));
  fs::create_directories(folder / "zsh");
  write(folder / "zsh" / "_microslip", zsh_completion(program));
  write(folder / "commands.md", command_reference(program));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: microslip_documents FOLDER\n", stderr);
    return 2;
  }
  try {
    write_documents(argv[1]);
  } catch (const std::exception& error) {
    std::fputs(fmt::format("microslip_documents: {}\n", error.what()).c_str(), stderr);
    return 1;
  }
  return 0;
}
