// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

#include "microslip/dynamics/march.hpp"
#include "microslip/io/csv_writer.hpp"

/// @file
/// march.csv, a march in time, one row a recorded time:
///
///     time [s]
///     force [N]           that acts; force at POINT [N] where there are several
///     displacement [m], velocity [m/s], acceleration [m/s^2]    at the response point
///     NAME displacement [m], NAME force [N]                     of each joint
///
/// Its comments tell how the march ended, "NOT CONVERGED" where it did not, and where the energy went.

namespace microslip {

/// Recorded times up to which all is finite: what there is to write.
[[nodiscard]] std::size_t finite_records(const MarchResult& result);

/// The table of what was marched.
/// @param result   with one recorded point.
/// @param loads    that were marched.
/// @param every    the decimation of the records.
/// @param heading  the first comment; may be empty.
/// @throws InputError  where nothing finite was recorded.
[[nodiscard]] CsvWriter march_table(const MarchResult& result, const LoadHistory& loads,
                                    std::size_t every, std::string_view heading = {});

}  // namespace microslip
