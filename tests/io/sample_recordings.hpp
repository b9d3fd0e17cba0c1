// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/signal/recording/recording.hpp"

namespace microslip::test {

inline Channel channel_of(const std::string& name, std::optional<Dimension> dimension) {
  Channel channel;
  channel.name = name;
  channel.dimension = dimension;
  return channel;
}

/// Two channels over even times, one without unit, with attributes whose names clash with those of
/// the file formats or come twice.
inline Recording time_recording(std::size_t points = 40) {
  Recording recording;
  recording.source = "level 1, größe.csv";
  recording.axis.start = -0.1;
  recording.axis.step = 1.0 / 3.0;
  recording.attributes = {{"description", "Prüfstand, left\nsecond line"},
                          {"source", "clash"},
                          {"attribute_1:x", "y"},
                          {"", "no name"},
                          {"description", "there twice"},
                          {"a/b c.", ""}};
  Channel force = channel_of("force / N", kForce);
  Channel raw = channel_of("raw", std::nullopt);
  for (std::size_t i = 0; i < points; ++i) {
    force.values.push_back(std::sin(0.1 * static_cast<double>(i)));
    raw.values.push_back(0.1 * static_cast<double>(i * i) - 1e-310);
  }
  force.attributes = {{"unit_str", "clash"}, {"fs", "12"}, {"serial_number", "0042 "}};
  recording.channels = {force, raw};
  return recording;
}

/// A complex channel and a real one of an odd unit over uneven frequencies.
inline Recording frequency_recording() {
  Recording recording;
  recording.axis.dimension = kFrequency;
  recording.axis.values = {0.1, 0.2, 0.30000000000000004, 7.5};
  Channel frf = channel_of("frf", kLength / kForce);
  frf.values = {1.0, 2.0, -0.0, 4.0};
  frf.imaginary = {-1.0, 1e-300, 3.0, 1.0 / 3.0};
  Channel odd = channel_of("odd", kMass.power(2) / kAngularFrequency);
  odd.values = {1.0, 2.0, 3.0, 4.0};
  recording.channels = {frf, odd};
  return recording;
}

/// More recordings than one digit numbers, to see that their order survives.
inline std::vector<Recording> twelve_recordings() {
  std::vector<Recording> recordings;
  for (int i = 0; i < 11; ++i) {
    recordings.push_back(time_recording());
    recordings.back().source += std::to_string(i);
  }
  recordings.push_back(frequency_recording());
  return recordings;
}

inline void expect_same(const std::vector<Recording>& a, const std::vector<Recording>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].source, b[i].source);
    EXPECT_TRUE(a[i].axis == b[i].axis) << "axis of recording " << i + 1;
    EXPECT_EQ(a[i].attributes, b[i].attributes);
    ASSERT_EQ(a[i].channels.size(), b[i].channels.size());
    for (std::size_t j = 0; j < a[i].channels.size(); ++j) {
      EXPECT_EQ(a[i].channels[j].name, b[i].channels[j].name);
      EXPECT_EQ(a[i].channels[j].attributes, b[i].channels[j].attributes);
      EXPECT_TRUE(a[i].channels[j] == b[i].channels[j]) << a[i].channels[j].name;
    }
  }
}

}  // namespace microslip::test
