// SPDX-License-Identifier: MIT
#include "microslip/io/responses/uff_responses.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "support/replaced.hpp"
#include "support/tested_chain.hpp"

namespace microslip::uff_responses_test {
namespace {

using test::UffResponse;

const std::vector<double> kFrequencies = {0.0, 1.0, 2.0, 3.0};

std::string dataset(const UffResponse& of) {
  Eigen::VectorXcd values(4);
  values << 0.0, std::complex(1.0, -1.0), std::complex(2.0, 0.5), 3.0;
  return test::response_dataset(of, kFrequencies, values);
}

FrequencyResponses read(const std::string& content,
                        const std::optional<UnitSystem>& otherwise = {}) {
  const test::TemporaryFolder folder;
  test::put(folder.file("t.uff"), content);
  return read_responses_uff(folder.file("t.uff"), otherwise);
}

TEST(UffResponses, HaveTheirPlacesKindAndValues) {
  const FrequencyResponses all = read(dataset({.response = 5, .reference = 7}) +
                                      dataset({.response = 6, .reference = 7, .derivatives = 0}) +
                                      dataset({.response = 6, .reference = 7, .derivatives = 1}));
  ASSERT_EQ(all.responses.size(), 3U);
  const FrequencyResponse& first = all.responses[0];
  EXPECT_EQ(first.response, (DegreeOfFreedom{5, NodalDirection::kZ}));
  EXPECT_EQ(first.reference, (DegreeOfFreedom{7, NodalDirection::kZ}));
  EXPECT_EQ(first.name, "dataset 1 (node 5 z by a force at node 7 z)");
  EXPECT_EQ(first.frequency, (std::vector<double>{1.0, 2.0, 3.0}));  // not 0 Hz
  EXPECT_EQ(first.values[1], std::complex(2.0, 0.5));
  EXPECT_EQ(first.derivatives, 2);
  EXPECT_EQ(all.responses[1].derivatives, 0);
  EXPECT_EQ(all.responses[2].derivatives, 1);
}

TEST(UffResponses, AreAlongPositiveDirections) {
  EXPECT_EQ(read(dataset({.response_direction = -3})).responses[0].values[2], -3.0);
  EXPECT_EQ(
      read(dataset({.response_direction = -3, .reference_direction = -1})).responses[0].values[2],
      3.0);
}

// Without labels a unit is that of the data type in dataset 164, of mm and N, or as given.
TEST(UffResponses, TakeUnitsOfLabelsOrOfTheSystem) {
  const std::string bare = dataset({.units = {"", "", ""}, .force_unit = ""});
  EXPECT_DOUBLE_EQ(read(test::units_dataset(1000.0, 1.0) + bare).responses[0].values[2].real(),
                   3e-3);
  EXPECT_DOUBLE_EQ(
      read(bare, UnitSystem{.length = 1e-2, .force = 10.0}).responses[0].values[2].real(), 3e-3);
  EXPECT_DOUBLE_EQ(read(dataset({.units = {"", "", "g"}})).responses[0].values[2].real(),
                   3.0 * 9.80665);
  // Of rotations: rad/s² a newton.
  EXPECT_EQ(read(dataset({.response_direction = 5, .units = {"", "", "rad/s^2"}}))
                .responses[0]
                .derivatives,
            2);
}

TEST(UffResponses, RefuseByName) {
  const auto refused = [](const std::string& content, const std::string& part) {
    const std::string message = test::message_of<Error>([&] { (void)read(content); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  refused(dataset({.units = {"", "", ""}}),
          "dataset 1 (node 1 z by a force at node 1 z) = without unit");
  refused(dataset({.force_unit = ""}), "without unit");
  refused(dataset({.units = {"", "", "m"}, .force_unit = "m"}), "over a force");
  refused(dataset({.function_type = 6}), "1 functions of other types");
  refused(test::replaced(dataset({}), "        18    0    0    0 Frequency            Hz",
                         "        17    0    0    0 Time                 s "),
          "must be over frequency");
  refused(dataset({.reference = 0}), "reference of dataset 1 = node 0, direction 3");
  refused(test::replaced(dataset({}), "3.000000000000E+00", "               NAN"),
          "at 3 Hz = not a number, or infinite");
}

}  // namespace
}  // namespace microslip::uff_responses_test
