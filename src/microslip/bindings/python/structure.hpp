// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "microslip/documents/structure/model_file.hpp"

namespace microslip::python {

/// A structure with what a model.toml says beside it, so that it is judged as that would be: levels
/// that joints were identified by, modes left out. Shared by what was made of it.
using SharedModel = std::shared_ptr<const ModelFile>;

}  // namespace microslip::python
