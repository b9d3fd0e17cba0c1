// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff55.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58.hpp"
#include "microslip/io/uff/uff_envelope.hpp"
#include "microslip/io/uff/uff_mode_shapes.hpp"

namespace microslip {

UffModeShapes read_mode_shapes_uff(const std::string& path) {
  UffInput input(path);
  UffEnvelope envelope(input);
  UffModeShapes result;
  std::optional<Uff164> units;
  while (const auto dataset = envelope.next()) {
    const bool joined = dataset->number == 151 && !result.shapes.empty();
    if (joined) units.reset();  // files are joined by putting one behind the other
    if (dataset->number == 164) units = read_uff164(envelope);
    if (has_uff_mode_shape(*dataset)) {
      auto shape = read_uff_mode_shape(envelope, *dataset, units, result.warnings);
      if (shape) result.shapes.push_back(std::move(*shape));
    }
    if (dataset->number == 58 && dataset->binary) {  // its end is found by its number of points
      std::vector<Warning> unused;
      (void)read_uff58(envelope, *dataset, true, unused);
      continue;
    }
    if (!envelope.close().closed) {
      result.warnings.push_back({"uff_not_closed", fmt::format("{}: the file ends without the line "
                                                               "'    -1' that closes it",
                                                               envelope.dataset_name())});
    }
  }
  return result;
}

}  // namespace microslip
