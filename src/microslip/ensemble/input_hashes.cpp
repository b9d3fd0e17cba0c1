// SPDX-License-Identifier: MIT
#include "microslip/ensemble/input_hashes.hpp"

#include <algorithm>

#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"

namespace microslip {

std::vector<InputHash> hashes_of(const std::vector<std::string>& files) {
  std::vector<InputHash> hashes;
  for (const std::string& file : files) {
    if (std::ranges::find(hashes, file, &InputHash::file) != hashes.end()) continue;
    hashes.push_back({file, sha256(read_file(file))});
  }
  return hashes;
}

std::vector<InputHash> hashes_of(const std::string& file, const ModelFile& model,
                                 const std::vector<std::unique_ptr<const CasePrediction>>& cases) {
  std::vector<std::string> files{file};
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& path : more) {
      if (!path.empty()) files.push_back(path);
    }
  };
  add(model.joint_files);
  add(model.joint_samples);
  for (const auto& one : cases) add(one->files());
  return hashes_of(files);
}

}  // namespace microslip
