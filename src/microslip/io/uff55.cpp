// SPDX-License-Identifier: MIT
#include "microslip/io/uff55.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "microslip/io/text.hpp"
#include "microslip/io/uff55_reader.hpp"
#include "microslip/io/uff58.hpp"
#include "microslip/io/uff_envelope.hpp"
#include "microslip/io/uff_fields.hpp"

namespace microslip {
namespace {

constexpr std::array<std::size_t, 1> kWidth{13};

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

/// Numbers over as many lines as they need.
std::vector<double> read_numbers(UffEnvelope& envelope, std::size_t count, std::string_view what) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const std::string_view line = envelope.line(what);
    append_uff_numbers(line, kWidth, envelope.input().line_was_whole(), envelope.input().place(),
                       numbers);
  }
  const auto bad = std::find_if_not(numbers.begin(), numbers.end(),
                                    [](double value) { return std::isfinite(value); });
  if (bad != numbers.end()) {
    throw FormatError(envelope.input().place(), fmt::format("finite numbers as {}", what),
                      fmt::format("{}", *bad));
  }
  numbers.resize(count);
  return numbers;
}

std::size_t read_count(UffFields& fields, std::int64_t largest, std::string_view what,
                       const TextPlace& place) {
  const std::int64_t count = fields.integer(10, what);
  if (count >= 0 && count <= largest) return static_cast<std::size_t>(count);
  throw FormatError(place, fmt::format("{} from 0 to {}", what, largest), fmt::format("{}", count));
}

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
  shape.values_per_node = read_count(type, kMost, "the number of values of a node", place);
  if (shape.values_per_node == 0) {
    throw FormatError(place, "a number of values of a node above 0", "0");
  }
  UffFields integers = envelope.fields("record 7 (integers)");
  place = envelope.input().place();
  const std::size_t integer_count = read_count(integers, 6, "the number of integers", place);
  const std::size_t real_count = read_count(integers, kMost, "the number of reals", place);
  for (std::size_t i = 0; i < integer_count; ++i) {
    form.integers.push_back(integers.integer(10, "an integer of the analysis"));
  }
  form.reals = read_numbers(envelope, real_count, "record 8 (frequency and damping)");
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
    case 7: {
      shape.analysis = UffAnalysis::kComplexMode;
      const double size = std::hypot(form.real(0), form.real(1));
      shape.frequency = size / (2.0 * std::numbers::pi);
      shape.eigenvalue = std::complex(form.real(0), form.real(1));
      if (size > 0.0) shape.damping_ratio = -form.real(0) / size;
      if (form.reals.size() > 3) shape.modal_a = std::complex(form.reals[2], form.reals[3]);
      break;
    }
    case 5:
      shape.analysis = UffAnalysis::kFrequencyResponse;
      shape.frequency = form.real(0);
      break;
    default:
      break;
  }
}

void read_nodes(UffEnvelope& envelope, bool is_complex, UffModeShape& shape) {
  const std::size_t count = shape.values_per_node * (is_complex ? 2 : 1);
  while (const auto line = envelope.value_line()) {
    if (trimmed(*line).empty()) continue;
    shape.nodes.push_back(UffFields(*line, envelope.input().place()).integer(10, "a node number"));
    const std::vector<double> numbers = read_numbers(envelope, count, "values of a node");
    for (std::size_t i = 0; i < count; ++i) {
      (is_complex && i % 2 == 1 ? shape.imaginary : shape.values).push_back(numbers[i]);
    }
  }
}

}  // namespace

UffModeShape read_uff55(UffEnvelope& envelope) {
  UffModeShape shape;
  for (std::string& line : shape.id_lines) line = envelope.fields("an ID line").text(80);
  const Form form = read_form(envelope, shape);
  set_modal_data(form, shape);
  read_nodes(envelope, form.is_complex, shape);
  return shape;
}

void set_uff_units(const std::optional<Uff164>& units, UffModeShape& shape) {
  if (!units) return;
  shape.length_unit = 1.0 / units->length;
  shape.force_unit = 1.0 / units->force;
}

UffModeShapes read_mode_shapes_uff(const std::string& path) {
  UffInput input(path);
  UffEnvelope envelope(input);
  UffModeShapes result;
  std::optional<Uff164> units;
  while (const auto dataset = envelope.next()) {
    const bool joined = dataset->number == 151 && !result.shapes.empty();
    if (joined) units.reset();  // files are joined by putting one behind the other
    if (dataset->number == 164) units = read_uff164(envelope);
    if (dataset->number == 55) {
      result.shapes.push_back(read_uff55(envelope));
      set_uff_units(units, result.shapes.back());
    }
    if (dataset->number == 58 && dataset->binary) {  // its end is found by its number of points
      std::vector<Warning> unused;
      (void)read_uff58(envelope, *dataset, true, unused);
      continue;
    }
    if (!envelope.close().closed) {
      result.warnings.push_back({"uff_not_closed", fmt::format("{}: the file ends without the line "
                                                               "'    -1' that closes it",
                                                               envelope.dataset_name())});
    }
  }
  return result;
}

}  // namespace microslip
