// SPDX-License-Identifier: MIT
#include "microslip/io/written_recordings.hpp"

#include <algorithm>

#include "microslip/io/write_error.hpp"

namespace microslip {
namespace {

bool is_same(const Recording& a, const Recording& b) {
  return a.source == b.source && a.axis == b.axis && a.channels == b.channels &&
         a.attributes == b.attributes;
}

}  // namespace

bool are_same(std::span<const Recording> read, std::span<const Recording> written) {
  return std::ranges::equal(read, written, is_same);
}

void fail_as_not_written(const std::string& path) {
  throw WriteError(path, "cannot be written: it does not read back as it was",
                   "Make room, or choose another folder.");
}

}  // namespace microslip
