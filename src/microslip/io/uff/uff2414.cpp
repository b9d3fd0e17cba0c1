// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff2414_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <string>
#include <string_view>

#include "microslip/io/uff/uff_fields.hpp"
#include "microslip/io/uff/uff_nodal_values.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kAtNodes = 1;
constexpr std::int64_t kMostOfANode = 1000;
constexpr std::string_view kNoMotion = "uff_no_motion";

std::string_view location_name(std::int64_t location) {
  switch (location) {
    case kAtNodes:
      return "at nodes";
    case 2:
      return "on elements";
    case 3:
      return "at nodes on elements";
    case 5:
      return "at points";
    default:
      return "at no known location";
  }
}

/// Whether the result type is of displacements, velocities, accelerations, or not given.
bool is_motion(std::int64_t result) {
  return result == 0 || result == 1 || result == 8 || result == 11 || result == 12;
}

/// Records 1 to 9.
struct Uff2414Form {
  std::int64_t location = 0;
  std::int64_t analysis = 0;
  std::int64_t characteristic = 0;
  std::int64_t data_type = 0;
  TextPlace place;  // of record 9

  [[nodiscard]] bool is_complex() const { return data_type == 5 || data_type == 6; }
};

/// An integer that stands alone in a record.
std::int64_t read_alone(UffEnvelope& envelope, std::string_view what) {
  return envelope.fields(what).integer(10, what);
}

Uff2414Form read_uff2414_form(UffEnvelope& envelope, UffModeShape& shape) {
  Uff2414Form form;
  (void)read_alone(envelope, "record 1 (the label)");
  (void)envelope.line("record 2 (the name)");
  form.location = read_alone(envelope, "record 3 (the location)");
  for (std::string& line : shape.id_lines) line = envelope.fields("an ID line").text(80);
  UffFields type = envelope.fields("record 9 (the form)");
  form.place = envelope.input().place();
  type.skip(10);
  form.analysis = type.integer(10, "the analysis type");
  form.characteristic = type.integer(10, "the data characteristic");
  shape.specific_type = type.integer(10, "the result type");
  form.data_type = type.integer(10, "the data type");
  shape.values_per_node =
      read_uff_count(type, kMostOfANode, "the number of values of a node", form.place);
  return form;
}

/// Of motions of nodes.
void check_uff2414_form(const Uff2414Form& form, const UffModeShape& shape) {
  if (form.data_type != 2 && form.data_type != 4 && !form.is_complex()) {
    throw FormatError(form.place, "the data type 2 or 4 (real), 5 or 6 (complex)",
                      fmt::format("{}", form.data_type));
  }
  const std::int64_t characteristic = form.characteristic;
  if (characteristic != 0 && characteristic != 2 && characteristic != 3) {
    throw FormatError(form.place,
                      "motions of nodes with the data characteristic 2 or 3 (x, y, z, "
                      "and rotations)",
                      fmt::format("{}", characteristic));
  }
  if (shape.values_per_node == 0) {
    throw FormatError(form.place, "a number of values of a node above 0", "0");
  }
}

/// Records 10 to 13.
void read_uff2414_mode(UffEnvelope& envelope, const Uff2414Form& form, UffModeShape& shape) {
  UffFields integers = envelope.fields("record 10 (integers)");
  integers.skip(40);
  shape.load_case = integers.integer(10, "the load set");
  const std::int64_t mode = integers.integer(10, "the mode number");
  (void)integers.integer(10, "the number of the time step");
  const std::int64_t frequency_number = integers.integer(10, "the number of the frequency");
  (void)envelope.line("record 11 (integers)");
  const std::vector<double> real =
      read_uff_numbers(envelope, 12, "records 12 and 13 (frequency, damping, modal mass)");
  shape.number = form.analysis == 5 ? frequency_number : mode;
  switch (form.analysis) {
    case 2:
      shape.analysis = UffAnalysis::kNormalMode;
      shape.frequency = real[1];
      shape.modal_mass = real[3];
      shape.damping_ratio = real[4];
      shape.loss_factor = real[5];
      break;
    case 3:
    case 7:
      set_uff_eigenvalue({real[6], real[7]}, shape);
      shape.modal_a = std::complex(real[8], real[9]);
      break;
    case 5:
      shape.analysis = UffAnalysis::kFrequencyResponse;
      shape.frequency = real[1];
      break;
    default:
      break;
  }
}

}  // namespace

std::optional<UffModeShape> read_uff2414(UffEnvelope& envelope, std::vector<Warning>& warnings) {
  UffModeShape shape;
  shape.dataset = 2414;
  const Uff2414Form form = read_uff2414_form(envelope, shape);
  if (form.location != kAtNodes || !is_motion(shape.specific_type)) {
    if (std::ranges::find(warnings, kNoMotion, &Warning::code) == warnings.end()) {
      warnings.push_back(
          {std::string(kNoMotion), fmt::format("{} (2414) has result type {} {}, no motion of "
                                               "nodes: it is left out, as are others without",
                                               envelope.dataset_name(), shape.specific_type,
                                               location_name(form.location))});
    }
    return std::nullopt;
  }
  check_uff2414_form(form, shape);
  read_uff2414_mode(envelope, form, shape);
  read_uff_nodes(envelope, form.is_complex(), shape);
  return shape;
}

}  // namespace microslip
