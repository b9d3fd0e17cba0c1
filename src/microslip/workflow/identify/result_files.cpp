// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/result_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {

void require_result_folder(const std::string& out) {
  if (!out.empty() && out != "-") return;
  throw InputError("out", in_quotes(out), "must be a folder", "Name it.");
}

void check_inputs_kept(const std::string& out, const std::vector<ResultFile>& files,
                       const std::vector<std::string>& inputs) {
  for (const ResultFile& file : files) {
    for (const std::string& input : inputs) {
      std::error_code none;
      if (!std::filesystem::equivalent(file.path, input, none)) continue;
      throw InputError("out", in_quotes(out),
                       fmt::format("must not be the folder of {}, which would be replaced", input),
                       "Choose another folder.");
    }
  }
}

}  // namespace microslip
