// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "microslip/structure/structural_matrices.hpp"

namespace microslip {

/// A response over a force, both as factors of e^{iωt}.
struct FrequencyResponse {
  std::string name;          ///< as messages call it: "dataset 3 (node 5 x by a force at node 1 x)"
  DegreeOfFreedom response;  ///< along the positive direction, whatever the file has
  DegreeOfFreedom reference;                      ///< of the force, or of the moment
  int derivatives = 0;                            ///< 0 receptance, 1 mobility, 2 accelerance
  std::vector<double> frequency = {};             ///< Hz, above 0, rising
  std::vector<std::complex<double>> values = {};  ///< SI; one per frequency
};

}  // namespace microslip
