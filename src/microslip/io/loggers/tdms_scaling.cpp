// SPDX-License-Identifier: MIT
#include "microslip/io/loggers/tdms_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

/// The input of a scale that takes the values as they are stored.
constexpr double kStored = 4294967295.0;
/// More than any channel needs: scales that refer to each other could go round in circles.
constexpr int kMostSteps = 64;
constexpr std::size_t kMostScales = 1000;

/// Why values cannot be scaled. Ends in ScaledValues::fault.
class Unscalable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The number in "NI_Scale[…]_Scale_Type"; nothing for another property.
std::optional<std::size_t> scale_of_property(std::string_view name) {
  constexpr std::string_view kBegin = "NI_Scale[";
  constexpr std::string_view kEnd = "]_Scale_Type";
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return std::nullopt;
  name.remove_prefix(kBegin.size());
  if (name.size() <= kEnd.size()) return std::nullopt;
  name.remove_suffix(kEnd.size());
  std::size_t scale = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), scale);
  const bool is_number = error == std::errc{} && end == name.data() + name.size();
  return is_number && scale < kMostScales ? std::optional(scale) : std::nullopt;
}

/// As stated, else up to the highest one that has a type: of DAQmx those below may have none.
std::optional<std::size_t> number_of_scales(const TdmsProperties& properties) {
  if (const double* count = properties.number("NI_Number_Of_Scales")) {
    const bool fits = *count > 0.0 && *count <= static_cast<double>(kMostScales);
    return fits ? static_cast<std::size_t>(*count) : 0;
  }
  std::optional<std::size_t> count;
  for (const auto& [name, value] : properties.all) {
    const std::optional<std::size_t> scale = scale_of_property(name);
    if (scale) count = std::max(count.value_or(0), *scale + 1);
  }
  return count;
}

double polynomial(const std::vector<double>& coefficients, double x) {
  double sum = 0.0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * x + *c;
  return sum;
}

/// A line through points, beyond them the value of the last one.
class Table {
 public:
  Table(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
    if (x_.empty() || x_.size() != y_.size()) throw Unscalable("a table without points");
    if (x_.front() > x_.back()) {
      std::ranges::reverse(x_);
      std::ranges::reverse(y_);
    }
    const auto not_above = [](double a, double b) { return !(a < b); };
    if (std::ranges::adjacent_find(x_, not_above) != x_.end()) {
      throw Unscalable("a table that does not rise");
    }
  }

  [[nodiscard]] double at(double x) const {
    const auto next = std::ranges::upper_bound(x_, x);
    if (next == x_.begin()) return y_.front();
    if (next == x_.end()) return y_.back();
    const auto i = static_cast<std::size_t>(next - x_.begin());
    return y_[i - 1] + (y_[i] - y_[i - 1]) * (x - x_[i - 1]) / (x_[i] - x_[i - 1]);
  }

 private:
  std::vector<double> x_;
  std::vector<double> y_;
};

class Scaling {
 public:
  Scaling(TdmsObject& channel, const TdmsProperties& properties)
      : channel_(channel), properties_(properties) {}

  /// @param input  the number of the scale, or kStored.
  std::vector<double> values(double input) {
    if (++steps_ > kMostSteps) throw Unscalable("scales that refer to each other in a circle");
    if (input == kStored) return stored();
    const std::string scale = fmt::format("NI_Scale[{:.0f}]_", input);
    const std::string* const type = properties_.text(scale + "Scale_Type");
    if (type == nullptr) return source(input);
    if (*type == "Add" || *type == "Subtract") return combined(scale + *type);
    const std::string prefix = scale + *type + "_";
    const double* const from = properties_.number(prefix + "Input_Source");
    const double inner = from == nullptr ? kStored : *from;
    if (*type == "Linear") return linear(prefix, values(inner));
    if (*type == "Polynomial") return of_polynomial(prefix, values(inner));
    if (*type == "Table") return of_table(prefix, values(inner));
    if (*type == "AdvancedAPI") return values(inner);
    throw Unscalable(fmt::format("a scale of the type {}", in_quotes(*type)));
  }

 private:
  std::vector<double> stored() const {
    if (channel_.sources.size() != 1) throw Unscalable("a scale of several sources");
    return channel_.sources.front().values;
  }

  /// Scales of DAQmx hand on what the file has of them.
  std::vector<double> source(double id) const {
    const auto found = std::ranges::find_if(channel_.sources, [&](const TdmsSource& s) {
      return static_cast<double>(s.scale_id) == id;
    });
    if (found == channel_.sources.end()) throw Unscalable("a scale without type");
    return found->values;
  }

  double number(const std::string& name) const {
    const double* const value = properties_.number(name);
    if (value == nullptr) throw Unscalable(fmt::format("a scale without {}", in_quotes(name)));
    return *value;
  }

  std::vector<double> numbers(const std::string& name, std::optional<double> usual = {}) const {
    const double* const size = properties_.number(name + "_Size");
    const double count = size != nullptr ? *size : usual ? *usual : number(name + "_Size");
    std::vector<double> values;
    for (std::size_t i = 0; static_cast<double>(i) < count; ++i) {
      values.push_back(number(fmt::format("{}[{}]", name, i)));
    }
    return values;
  }

  std::vector<double> linear(const std::string& prefix, std::vector<double> values) const {
    const double slope = number(prefix + "Slope");
    const double intercept = number(prefix + "Y_Intercept");
    for (double& value : values) value = value * slope + intercept;
    return values;
  }

  std::vector<double> of_polynomial(const std::string& prefix, std::vector<double> values) const {
    constexpr double kUsual = 4.0;
    const std::vector<double> coefficients = numbers(prefix + "Coefficients", kUsual);
    for (double& value : values) value = polynomial(coefficients, value);
    return values;
  }

  /// The names are the wrong way round: what comes in is among the scaled values.
  std::vector<double> of_table(const std::string& prefix, std::vector<double> values) const {
    const Table table(numbers(prefix + "Scaled_Values"), numbers(prefix + "Pre_Scaled_Values"));
    for (double& value : values) value = table.at(value);
    return values;
  }

  /// LabVIEW subtracts the left operand from the right one.
  std::vector<double> combined(const std::string& prefix) {
    const bool add = prefix.ends_with("Add");
    std::vector<double> sum = values(number(prefix + "_Right_Operand_Input_Source"));
    const std::vector<double> left = values(number(prefix + "_Left_Operand_Input_Source"));
    if (left.size() != sum.size()) throw Unscalable("a scale of unlike numbers of values");
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += add ? left[i] : -left[i];
    return sum;
  }

  TdmsObject& channel_;
  const TdmsProperties& properties_;
  int steps_ = 0;
};

}  // namespace

ScaledValues scaled_values(TdmsObject& channel,
                           const std::vector<const TdmsProperties*>& properties) {
  if (channel.sources.empty()) return {};
  for (const TdmsProperties* const of : properties) {
    const std::optional<std::size_t> count = number_of_scales(*of);
    const std::string* const status = of->text("NI_Scaling_Status");
    const bool scaled = status != nullptr && *status == "scaled";
    if (!count || *count == 0 || scaled) continue;
    try {
      return {Scaling(channel, *of).values(static_cast<double>(*count - 1))};
    } catch (const Unscalable& reason) {
      return {{}, reason.what()};
    }
  }
  if (channel.sources.size() > 1) return {{}, "several sources without a scale"};
  return {std::move(channel.sources.front().values)};
}

}  // namespace microslip
