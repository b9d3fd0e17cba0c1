// SPDX-License-Identifier: MIT
#pragma once

#include "experiment.hpp"
#include "microslip/joint/joint.hpp"
#include "reproduction.hpp"

/// @file
/// The figures of [AR14], one file each. Those from 6 on are of the experiment.

namespace ahmadian_rajaei {

[[nodiscard]] Reproduction figure_02(const Grid& grid, const microslip::Joint& joint);
[[nodiscard]] Reproduction figure_03(const Grid& grid);
[[nodiscard]] Reproduction figure_04(const Grid& grid);
[[nodiscard]] Reproduction figure_06(const Experiment& experiment);
[[nodiscard]] Reproduction figure_07(const Experiment& experiment);
[[nodiscard]] Reproduction figure_08(const Experiment& experiment);
[[nodiscard]] Reproduction figure_09(const Grid& grid, const Experiment& experiment);
[[nodiscard]] Reproduction figure_10(const Grid& grid, const Experiment& experiment);
[[nodiscard]] Reproduction figure_11(const Grid& grid, const Experiment& experiment);
[[nodiscard]] Reproduction figure_b1(const Grid& grid);

}  // namespace ahmadian_rajaei
