// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_mode_shapes.hpp"

#include "microslip/io/uff/uff2414_reader.hpp"
#include "microslip/io/uff/uff55_reader.hpp"

namespace microslip {

bool has_uff_mode_shape(const UffDataset& dataset) {
  return dataset.number == 55 || dataset.number == 2414;
}

std::optional<UffModeShape> read_uff_mode_shape(UffEnvelope& envelope, const UffDataset& dataset,
                                                const std::optional<Uff164>& units,
                                                std::vector<Warning>& warnings) {
  std::optional<UffModeShape> shape =
      dataset.number == 55 ? std::optional(read_uff55(envelope)) : read_uff2414(envelope, warnings);
  if (!shape || !units) return shape;
  shape->length_unit = 1.0 / units->length;
  shape->force_unit = 1.0 / units->force;
  return shape;
}

}  // namespace microslip
