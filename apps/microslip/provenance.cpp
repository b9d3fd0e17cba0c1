// SPDX-License-Identifier: MIT
#include "provenance.hpp"

#include <fmt/format.h>

#include "microslip/io/input_file.hpp"
#include "microslip/io/sha256.hpp"
#include "prediction.hpp"

namespace microslip::app {

std::string provenance_of(const Call& call, const std::vector<NamedInput>& inputs) {
  std::string text = heading_of(call);
  for (const NamedInput& input : inputs) {
    text += fmt::format("\n{}: sha256 {}", input_name(input.path), sha256(input.text));
  }
  return text;
}

}  // namespace microslip::app
