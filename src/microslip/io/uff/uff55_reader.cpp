// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff55_reader.hpp"

#include <fmt/format.h>

#include "microslip/io/uff/uff_fields.hpp"
#include "microslip/io/uff/uff_nodal_values.hpp"

namespace microslip {
namespace {

/// Records 6 to 8.
struct Form {
  std::int64_t analysis = 0;
  bool is_complex = false;
  std::vector<std::int64_t> integers;
  std::vector<double> reals;

  [[nodiscard]] std::int64_t integer(std::size_t i) const {
    return i < integers.size() ? integers[i] : 0;
  }
  [[nodiscard]] double real(std::size_t i) const { return i < reals.size() ? reals[i] : 0.0; }
  [[nodiscard]] std::optional<double> stated(std::size_t i) const {
    return i < reals.size() ? std::optional(reals[i]) : std::nullopt;
  }
};

Form read_form(UffEnvelope& envelope, UffModeShape& shape) {
  constexpr std::int64_t kMost = 1000;
  Form form;
  UffFields type = envelope.fields("record 6 (the form)");
  TextPlace place = envelope.input().place();
  type.skip(10);
  form.analysis = type.integer(10, "the analysis type");
  type.skip(10);
  shape.specific_type = type.integer(10, "the specific data type");
  const std::int64_t data_type = type.integer(10, "the data type");
  if (data_type != 2 && data_type != 5) {
    throw FormatError(place, "the data type 2 (real) or 5 (complex)", fmt::format("{}", data_type));
  }
  form.is_complex = data_type == 5;
  shape.values_per_node = read_uff_count(type, kMost, "the number of values of a node", place);
  if (shape.values_per_node == 0) {
    throw FormatError(place, "a number of values of a node above 0", "0");
  }
  UffFields integers = envelope.fields("record 7 (integers)");
  place = envelope.input().place();
  const std::size_t integer_count = read_uff_count(integers, 6, "the number of integers", place);
  const std::size_t real_count = read_uff_count(integers, kMost, "the number of reals", place);
  for (std::size_t i = 0; i < integer_count; ++i) {
    form.integers.push_back(integers.integer(10, "an integer of the analysis"));
  }
  form.reals = read_uff_numbers(envelope, real_count, "record 8 (frequency and damping)");
  return form;
}

void set_modal_data(const Form& form, UffModeShape& shape) {
  shape.load_case = form.integer(0);
  shape.number = form.integer(1);
  switch (form.analysis) {
    case 2:
      shape.analysis = UffAnalysis::kNormalMode;
      shape.frequency = form.real(0);
      shape.modal_mass = form.stated(1);
      shape.damping_ratio = form.stated(2);
      shape.loss_factor = form.stated(3);
      break;
    case 3:
    case 7:
      set_uff_eigenvalue({form.real(0), form.real(1)}, shape);
      if (form.reals.size() > 3) shape.modal_a = std::complex(form.reals[2], form.reals[3]);
      break;
    case 5:
      shape.analysis = UffAnalysis::kFrequencyResponse;
      shape.frequency = form.real(0);
      break;
    default:
      break;
  }
}

}  // namespace

UffModeShape read_uff55(UffEnvelope& envelope) {
  UffModeShape shape;
  for (std::string& line : shape.id_lines) line = envelope.fields("an ID line").text(80);
  const Form form = read_form(envelope, shape);
  set_modal_data(form, shape);
  read_uff_nodes(envelope, form.is_complex, shape);
  return shape;
}

}  // namespace microslip
