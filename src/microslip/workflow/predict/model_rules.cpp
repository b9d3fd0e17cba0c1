// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/model_rules.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {

void require_driven_by_forces(const ModelFile& model, const std::string& path,
                              const std::string& who) {
  if (!model.structure.base_driven()) return;
  throw InputError(fmt::format("{}: excitation", input_name(path)),
                   fmt::format("the base {}", in_quotes(model.structure.excitations()[0].point)),
                   fmt::format("must be a force at a point: {} accepts no other", who),
                   "Let [excitation] name a point.");
}

void require_no_static_loads(const ModelFile& model, const std::string& path,
                             const std::string& who) {
  if (model.structure.static_loads().empty()) return;
  throw InputError(fmt::format("{}: static_load", input_name(path)),
                   fmt::format("one at {}", in_quotes(model.structure.static_loads()[0].place)),
                   fmt::format("must be left out: {} assumes symmetric cycles", who),
                   "The slip forces it identifies are those about the preload.");
}

}  // namespace microslip
