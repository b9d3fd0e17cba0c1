// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58.hpp"
#include "microslip/io/uff/uff_units.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// A dataset 58 as a channel of a recording, and the header of a channel. Internal to io.

namespace microslip {

/// A function in SI, with what its header still has to say.
struct UffChannel {
  Uff58Header header;
  Axis axis;
  std::optional<Dimension> dimension;
  std::vector<double> values;
  std::vector<double> imaginary;
  bool doubtful =
      false;  ///< labelled g, but see doubtful_unit.hpp: values are as the file has them
};

/// @param units  the system of units of the file, if it has one.
[[nodiscard]] UffChannel uff_channel(Uff58 data, const std::optional<Uff164>& units);

/// Gives the channels of one recording their names and attributes.
[[nodiscard]] std::vector<Channel> uff_channels(const Dimension& axis,
                                                std::vector<UffChannel> channels);

/// The headers by which the channels read back as they are: form, units, names and attributes.
[[nodiscard]] std::vector<Uff58Header> uff58_headers(const Recording& recording);

}  // namespace microslip
