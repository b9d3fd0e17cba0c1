// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "microslip/io/loggers/tdms_contents.hpp"

namespace microslip {

/// The values of a channel in its unit.
struct ScaledValues {
  std::vector<double> values;
  std::string fault = {};  ///< in words, why they cannot be had; empty where they are there
};

/// Scales the values of a channel as its properties state, else those of its group, else those of
/// the file: the last of `NI_Number_Of_Scales` scales, each of which takes the values of another
/// one (`…_Input_Source`) or those that are stored. Unless `NI_Scaling_Status` is "scaled".
/// Scales that are known: Linear, Polynomial, Table (from its `Scaled_Values` to its
/// `Pre_Scaled_Values`, between two points linearly, beyond them the last one), Add, Subtract and
/// AdvancedAPI; those of DAQmx have no type. Takes the stored values.
/// @param properties  of the channel, its group and the file, in this order.
[[nodiscard]] ScaledValues scaled_values(TdmsObject& channel,
                                         const std::vector<const TdmsProperties*>& properties);

}  // namespace microslip
