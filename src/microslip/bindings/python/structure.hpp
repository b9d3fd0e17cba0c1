// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "microslip/documents/structure/model_file.hpp"

namespace microslip::python {

/// A structure with the further contents of a model.toml, so that the same checks apply: levels
/// that joints were identified from, modes left out. Shared with the objects made of it.
using SharedModel = std::shared_ptr<const ModelFile>;

}  // namespace microslip::python
