// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "microslip/documents/structure/model_file.hpp"
#include "microslip/ensemble/case_prediction.hpp"
#include "microslip/io/config/named_values.hpp"

namespace microslip {

/// The SHA-256 of files, each once, in their order. @throws FileError  where one cannot be read.
[[nodiscard]] std::vector<InputHash> hashes_of(const std::vector<std::string>& files);

/// Hashes of a model with its joints, their draws, and the inputs of its cases.
/// @param file  of the model.
[[nodiscard]] std::vector<InputHash> hashes_of(
    const std::string& file, const ModelFile& model,
    const std::vector<std::unique_ptr<const CasePrediction>>& cases);

}  // namespace microslip
