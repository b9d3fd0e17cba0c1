// SPDX-License-Identifier: MIT
#include "microslip/documents/study/ensemble_plan_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

/// An array as a message shows it: a long one by its size.
template <typename Value>
std::string array_text(const std::vector<Value>& values) {
  constexpr std::size_t kLongest = 120;
  const std::string text = printable(fmt::format("[{}]", fmt::join(values, ", ")));
  return text.size() <= kLongest ? text : fmt::format("an array of {}", values.size());
}

constexpr std::size_t kLargestPlan = std::size_t{16} << 20U;
constexpr std::size_t kMostValues = 1'000'000;  // of a list
constexpr double kLargestForce = 1e12;          // N
constexpr double kLargestAcceleration = 1e12;   // m/s²
constexpr std::string_view kAccelerationKey = "acceleration_m_per_s2";
constexpr double kLargestLength = 1e6;           // m
constexpr double kSmallestAmount = 1e-15;        // of a force or length
constexpr double kHighestFrequencyOfCase = 1e9;  // Hz

/// A range, with the words of its messages.
struct Range {
  double least;
  double most;
};

double checked(double value, const std::string& name, Range range) {
  if (value >= range.least && value <= range.most) return value;
  throw InputError(name, value, fmt::format("must be from {:g} to {:g}", range.least, range.most));
}

double number_in(const TomlTable& table, std::string_view key, Range range) {
  return checked(table.number(key), table.name(key), range);
}

std::size_t whole_in(const TomlTable& table, std::string_view key, std::size_t least,
                     std::size_t most) {
  const std::size_t value = table.whole(key);
  if (value >= least && value <= most) return value;
  throw InputError(table.name(key), static_cast<double>(value),
                   fmt::format("must be from {} to {}", least, most));
}

std::size_t whole_or(const TomlTable& table, std::string_view key, std::size_t otherwise,
                     std::size_t least, std::size_t most) {
  return table.has(key) ? whole_in(table, key, least, most) : otherwise;
}

/// One of some words.
std::string one_of(const TomlTable& table, std::string_view key,
                   const std::vector<std::string_view>& words) {
  const std::string found = table.text(key);
  if (std::ranges::find(words, found) != words.end()) return found;
  throw InputError(table.name(key), in_quotes(found),
                   fmt::format("must be one of {}", fmt::join(words, ", ")));
}

std::string path_of(const TomlTable& table, std::string_view key, std::string_view plan) {
  const std::string file = table.text(key);
  if (file.empty() || file == "-") {
    throw InputError(table.name(key), in_quotes(file), "must be the path of a file");
  }
  return file_beside(std::string(plan), file);
}

/// A boolean of a plan, given once.
bool flag(const toml::table& table, const TomlTable& named, std::string_view key, bool otherwise) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return otherwise;
  if (const auto value = node->value_exact<bool>()) return *value;
  throw wrong_type(named.name(key), described(*node), "true or false");
}

// ---- Lists of values. ----

std::vector<double> spaced(double from, double to, std::size_t count, bool ratios) {
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
    if (i + 1 == count && count > 1) {
      values.push_back(to);
    } else {
      values.push_back(ratios ? from * std::pow(to / from, share) : from + share * (to - from));
    }
  }
  return values;
}

std::vector<double> read_spaced(const TomlTable& range, Range allowed) {
  range.allow_only({"from", "to", "count", "spacing"});
  const double from = number_in(range, "from", allowed);
  const double to = number_in(range, "to", allowed);
  const std::size_t count = whole_in(range, "count", 1, kMostValues);
  const bool ratios = range.has("spacing") && one_of(range, "spacing", {"linear", "log"}) == "log";
  if (ratios && !(from > 0.0 && to > 0.0)) {
    throw InputError(range.name("spacing"), in_quotes("log"),
                     "needs values from and to above 0, as its steps are equal ratios");
  }
  return spaced(from, to, count, ratios);
}

/// An array of numbers, or { from, to, count, spacing }.
std::vector<double> read_list(const toml::table& raw, const TomlTable& table, std::string_view key,
                              Range allowed) {
  const toml::node* node = raw.get(key);
  if (node != nullptr && node->is_table()) return read_spaced(table.table(key), allowed);
  std::vector<double> values = table.numbers(key);
  if (values.empty()) {
    throw InputError(table.name(key), "an empty array", "must have at least one value");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    (void)checked(values[i], table.name(key, i), allowed);
  }
  return values;
}

const toml::table& raw_table(const toml::table& top, std::string_view key) {
  return *top.get_as<toml::table>(key);  // TomlTable::table() has checked
}

// ---- The kinds. ----

PlannedIdentification read_identification(const toml::table& raw, const TomlTable& table) {
  return {flag(raw, table, "linear_damping", false), flag(raw, table, "atom", false),
          flag(raw, table, "edges", false)};
}

constexpr std::size_t kMostDraws = 1'000'000'000;

PredictPlan read_predict(const TomlTable& table, std::string_view file) {
  table.allow_only({"model", "draws", "correlation"});
  PredictPlan plan{path_of(table, "model", file), whole_in(table, "draws", 1, kMostDraws)};
  if (table.has("correlation")) {
    plan.correlation = one_of(table, "correlation", {"auto", "together", "independent"});
  }
  return plan;
}

BootstrapPlan read_bootstrap(const toml::table& raw, const TomlTable& table,
                             std::string_view file) {
  table.allow_only({"levels", "stiffness_N_per_m", "count", "resample", "linear_damping", "atom",
                    "edges", "points"});
  BootstrapPlan plan{path_of(table, "levels", file),
                     number_in(table, "stiffness_N_per_m", {1e-6, 1e15}),
                     whole_in(table, "count", 1, kMostDraws)};
  if (table.has("resample")) {
    plan.residuals = one_of(table, "resample", {"residuals", "levels"}) == "residuals";
  }
  plan.points = whole_or(table, "points", plan.points, 2, 10'000);
  plan.identification = read_identification(raw, table);
  return plan;
}

std::vector<std::size_t> read_numbers_of_levels(const TomlTable& table) {
  constexpr double kMostLevels = 100'000;
  std::vector<std::size_t> numbers;
  const std::vector<double> values = table.numbers("levels");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = checked(values[i], table.name("levels", i), {4.0, kMostLevels});
    if (value != std::floor(value)) {
      throw InputError(table.name("levels", i), value, "must be a whole number");
    }
    numbers.push_back(static_cast<std::size_t>(value));
  }
  if (numbers.empty()) {
    throw InputError(table.name("levels"), "an empty array", "must have at least one number");
  }
  return numbers;
}

/// Texts of an array.
std::vector<std::string> texts_in(const toml::array& array, const std::string& name) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto text = array.get(i)->value_exact<std::string>();
    if (!text) throw wrong_type(fmt::format("{}[{}]", name, i), described(*array.get(i)), kText);
    texts.push_back(*text);
  }
  return texts;
}

std::vector<std::vector<std::string>> read_sensors(const toml::table& raw, const TomlTable& table) {
  constexpr std::string_view kExpected = "an array of arrays of channels";
  const toml::array* choices = raw.get_as<toml::array>("sensors");
  if (choices == nullptr) {
    throw wrong_type(table.name("sensors"), described(*raw.get("sensors")), kExpected);
  }
  std::vector<std::vector<std::string>> sensors;
  for (std::size_t i = 0; i < choices->size(); ++i) {
    const toml::array* choice = choices->get_as<toml::array>(i);
    if (choice == nullptr) {
      throw wrong_type(table.name("sensors", i), described(*choices->get(i)), kExpected);
    }
    sensors.push_back(texts_in(*choice, table.name("sensors", i)));
    if (std::ranges::find(sensors.begin(), sensors.end() - 1, sensors.back()) !=
        sensors.end() - 1) {
      throw InputError(table.name("sensors", i), array_text(sensors.back()),
                       "must differ from the others");
    }
  }
  if (sensors.empty()) {
    throw InputError(table.name("sensors"), "an empty array", "must have at least one choice");
  }
  return sensors;
}

/// A design whose tests are records of a rig.
void read_rig_design(const toml::table& raw, const TomlTable& table, std::string_view file,
                     DesignPlan& plan) {
  table.allow_only({"rig", "count", "levels", "sensor_noise", "sensors", "linear_damping", "atom",
                    "edges", "draws"});
  plan.rig = path_of(table, "rig", file);
  if (table.has("sensor_noise")) {
    plan.sensor_noise = read_list(raw, table, "sensor_noise", {0.0, 1e6});
  }
  if (table.has("sensors")) plan.sensors = read_sensors(raw, table);
}

/// A design whose levels are those of a joint with noise.
void read_joint_design(const toml::table& raw, const TomlTable& table, std::string_view file,
                       DesignPlan& plan) {
  table.allow_only({"joint", "count", "levels", "noise", "amplitude_noise", "secant_noise",
                    "amplitude_m", "spacing", "linear_damping", "atom", "edges", "draws"});
  plan.joint = path_of(table, "joint", file);
  plan.noise = read_list(raw, table, "noise", {1e-9, 1.0});
  if (table.has("amplitude_noise")) {
    plan.amplitude_noise = read_list(raw, table, "amplitude_noise", {0.0, 1.0});
  }
  if (table.has("secant_noise")) {
    plan.secant_noise = read_list(raw, table, "secant_noise", {1e-9, 1.0});
  }
  const std::vector<double> ends = table.numbers("amplitude_m");
  if (ends.size() != 2 || !(ends[0] >= kSmallestAmount && ends[1] > ends[0]) ||
      ends[1] > kLargestLength) {
    throw InputError(table.name("amplitude_m"), array_text(ends),
                     "must be the lowest and the highest amplitude, in m, rising from above 0");
  }
  plan.lowest = ends[0];
  plan.highest = ends[1];
  plan.equal_ratios = table.has("spacing") && one_of(table, "spacing", {"linear", "log"}) == "log";
}

DesignPlan read_design(const toml::table& raw, const TomlTable& table, std::string_view file) {
  if (table.has("rig") && table.has("joint")) {
    throw FormatError(table.place("rig"), "one of the keys joint and rig", "both");
  }
  DesignPlan plan;
  if (table.has("rig")) {
    read_rig_design(raw, table, file, plan);
  } else {
    read_joint_design(raw, table, file, plan);
  }
  plan.count = whole_in(table, "count", 1, kMostDraws);
  plan.levels = read_numbers_of_levels(table);
  plan.draws = whole_or(table, "draws", 0, 40, 1'000'000);
  plan.identification = read_identification(raw, table);
  return plan;
}

SweepAxis read_axis(const toml::table& raw, const TomlTable& table) {
  table.allow_only({"number", "values"});
  SweepAxis axis;
  axis.number = table.text("number");
  const std::size_t colon = axis.number.find(": ");
  if (colon != std::string::npos) axis.joint = axis.number.substr(0, colon);
  axis.path = colon == std::string::npos ? axis.number : axis.number.substr(colon + 2);
  if (axis.path.empty()) {
    throw InputError(table.name("number"), in_quotes(axis.number),
                     "must be the path of a number in the model, or 'JOINT: PATH' of one in the "
                     "file of a joint");
  }
  axis.values = read_list(raw, table, "values", {-1e300, 1e300});
  return axis;
}

SweepPlan read_sweep(const toml::table& raw, const TomlTable& table, std::string_view file) {
  table.allow_only({"model", "axis"});
  SweepPlan plan{path_of(table, "model", file), {}};
  const std::vector<TomlTable> axes = table.tables("axis");
  const toml::array& arrays = *raw.get_as<toml::array>("axis");
  for (std::size_t i = 0; i < axes.size(); ++i) {
    plan.axes.push_back(read_axis(*arrays.get_as<toml::table>(i), axes[i]));
  }
  if (plan.axes.empty()) {
    throw InputError(table.name("axis"), "an empty array", "must have at least one axis");
  }
  double points = 1.0;
  for (const SweepAxis& axis : plan.axes) points *= static_cast<double>(axis.values.size());
  if (points > EnsemblePlan::kMostJobs) {
    throw InputError(table.name("axis"), fmt::format("a grid of {:g} points", points),
                     fmt::format("must have {:g} or less", EnsemblePlan::kMostJobs));
  }
  return plan;
}

// ---- Cases. ----

void read_frf(const TomlTable& table, PlannedCase& planned) {
  table.allow_only({"name", "kind", "force_N", kAccelerationKey, "response_m", "frequency_Hz",
                    "harmonics", "samples"});
  const int kept = static_cast<int>(table.has("force_N")) +
                   static_cast<int>(table.has(kAccelerationKey)) +
                   static_cast<int>(table.has("response_m"));
  if (kept != 1) {
    throw FormatError(table.place("force_N"),
                      fmt::format("one of the keys force_N, {} and response_m", kAccelerationKey),
                      kept == 0 ? "none" : "several");
  }
  if (table.has("force_N")) {
    planned.force = number_in(table, "force_N", {kSmallestAmount, kLargestForce});
  } else if (table.has(kAccelerationKey)) {
    planned.acceleration =
        number_in(table, kAccelerationKey, {kSmallestAmount, kLargestAcceleration});
  } else {
    planned.response = number_in(table, "response_m", {kSmallestAmount, kLargestLength});
  }
  const std::vector<double> ends = table.numbers("frequency_Hz");
  if (ends.size() != 2 || ends[0] == ends[1]) {
    throw InputError(table.name("frequency_Hz"), array_text(ends),
                     "must be two frequencies, from and to");
  }
  planned.from = checked(ends[0], table.name("frequency_Hz", 0), {1e-9, kHighestFrequencyOfCase});
  planned.to = checked(ends[1], table.name("frequency_Hz", 1), {1e-9, kHighestFrequencyOfCase});
}

void read_backbone(const toml::table& raw, const TomlTable& table, PlannedCase& planned) {
  table.allow_only({"name", "kind", "response_m", "mode", "harmonics", "samples"});
  planned.responses = read_list(raw, table, "response_m", {kSmallestAmount, kLargestLength});
  planned.mode = whole_or(table, "mode", 1, 1, 100'000);
}

void read_march(const TomlTable& table, std::string_view file, PlannedCase& planned) {
  table.allow_only({"name", "kind", "force_file", "step_s"});
  planned.force_file = path_of(table, "force_file", file);
  if (table.has("step_s")) planned.step = number_in(table, "step_s", {1e-12, 1e6});
}

PlannedCase read_case(const toml::table& raw, const TomlTable& table, std::string_view file,
                      std::size_t number) {
  PlannedCase planned;
  planned.name = table.has("name") ? table.text("name") : fmt::format("case {}", number);
  const bool unfit = std::ranges::any_of(planned.name, [](char c) {
    return c == '/' || static_cast<unsigned char>(c) < 0x20;  // no name of a group of HDF5
  });
  if (planned.name.empty() || unfit || planned.name == ".") {
    throw InputError(table.name("name"), in_quotes(planned.name),
                     "must be a text without / and control characters");
  }
  const std::string kind = one_of(table, "kind", {"frf", "backbone", "march"});
  if (kind == "frf") {
    read_frf(table, planned);
  } else if (kind == "backbone") {
    planned.kind = PlannedCase::Kind::kBackbone;
    read_backbone(raw, table, planned);
  } else {
    planned.kind = PlannedCase::Kind::kMarch;
    read_march(table, file, planned);
    return planned;
  }
  planned.harmonics = whole_or(table, "harmonics", planned.harmonics, 1, 1000);
  planned.samples = whole_or(table, "samples", planned.samples, 4, 1'000'000);
  return planned;
}

std::vector<PlannedCase> read_cases(const toml::table& content, const TomlTable& top,
                                    std::string_view file) {
  std::vector<PlannedCase> cases;
  const std::vector<TomlTable> tables = top.tables("case");
  const toml::array& arrays = *content.get_as<toml::array>("case");
  for (std::size_t i = 0; i < tables.size(); ++i) {
    cases.push_back(read_case(*arrays.get_as<toml::table>(i), tables[i], file, i + 1));
    const auto same =
        std::ranges::find(cases.begin(), cases.end() - 1, cases.back().name, &PlannedCase::name);
    if (same == cases.end() - 1) continue;
    throw InputError(tables[i].name("name"), in_quotes(cases.back().name),
                     "must differ from those of the other cases");
  }
  if (cases.empty()) {
    throw InputError(top.name("case"), "an empty array", "must have at least one case",
                     "Write [[case]] with kind.");
  }
  return cases;
}

// ---- The plan. ----

/// Numbers by the shortest text that reads back as the same, whole ones that no double has in full.
std::string value_text(const toml::node& node) {
  if (node.is_number()) {
    const auto number = node.value<double>();
    return number ? fmt::format("{}", *number) : fmt::format("{}", *node.value<std::int64_t>());
  }
  if (const toml::array* array = node.as_array()) {
    std::vector<std::string> values;
    for (const toml::node& value : *array) values.push_back(value_text(value));
    return fmt::format("[{}]", fmt::join(values, ", "));
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

/// "key = value" of all of a table, with the paths of the keys.
void flatten(const toml::node& node, const std::string& path, std::vector<std::string>& lines) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      flatten(value, path.empty() ? std::string(key.str()) : key_path(path, key.str()), lines);
    }
    return;
  }
  const toml::array* array = node.as_array();
  if (array != nullptr && array->is_array_of_tables()) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      flatten(*array->get(i), fmt::format("{}[{}]", path, i), lines);
    }
    return;
  }
  std::string line = fmt::format("{} = {}", path, value_text(node));
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  lines.push_back(std::move(line));
}

std::vector<std::string> settings_of(toml::table content) {
  for (const std::string_view key : {"raw", "confidence", "most_failed"}) content.erase(key);
  std::vector<std::string> lines;
  flatten(content, "", lines);
  return lines;
}

std::vector<std::string> read_raw(const toml::table& content, const TomlTable& top) {
  std::vector<std::string> names;
  const toml::array* array = content.get_as<toml::array>("raw");
  if (array == nullptr)
    throw wrong_type(top.name("raw"), described(*content.get("raw")), "an array");
  for (std::size_t i = 0; i < array->size(); ++i) {
    const auto name = array->get(i)->value_exact<std::string>();
    if (!name) throw wrong_type(top.name("raw", i), described(*array->get(i)), kText);
    names.push_back(*name);
  }
  return names;
}

void read_common(const toml::table& content, const TomlTable& top, EnsemblePlan& plan) {
  if (top.has("seed")) plan.seed = top.whole("seed");
  if (top.has("confidence")) {
    plan.confidence = top.number("confidence");
    if (!(plan.confidence > 0.0 && plan.confidence < 1.0)) {
      throw InputError(top.name("confidence"), plan.confidence, "must be above 0 and below 1");
    }
  }
  if (top.has("raw")) plan.raw = read_raw(content, top);
  if (top.has("most_failed")) plan.most_failed = number_in(top, "most_failed", {0.0, 1.0});
  if (top.has("block")) plan.block = whole_in(top, "block", 1, 1'000'000);
}

void read_work(const toml::table& content, const TomlTable& top, std::string_view file,
               EnsemblePlan& plan) {
  const TomlTable table = top.table(plan.kind);
  const toml::table& raw = raw_table(content, plan.kind);
  if (plan.kind == "bootstrap") {
    plan.work = read_bootstrap(raw, table, file);
  } else if (plan.kind == "design") {
    plan.work = read_design(raw, table, file);
  } else if (plan.kind == "sweep") {
    plan.work = read_sweep(raw, table, file);
  } else {
    plan.work = read_predict(table, file);
  }
}

}  // namespace

EnsemblePlan parse_ensemble_plan(std::string_view text, std::string_view file) {
  const toml::table content = parse_toml(text, file);
  const TomlTable top(content, file);
  check_schema(top.place("schema"), top.text("schema"), kEnsemblePlanKind, "a plan of an ensemble");
  EnsemblePlan plan;
  plan.file = file;
  plan.text = text;
  plan.kind = one_of(top, "kind", {"predict", "bootstrap", "design", "sweep"});
  const bool with_cases = plan.kind == "predict" || plan.kind == "sweep";
  std::vector<std::string_view> keys{"schema", "kind",        "seed",  "confidence",
                                     "raw",    "most_failed", "block", plan.kind};
  if (with_cases) keys.push_back("case");
  top.allow_only(keys);
  read_common(content, top, plan);
  read_work(content, top, file, plan);
  if (with_cases) plan.cases = read_cases(content, top, file);
  plan.settings = settings_of(content);
  const auto* design = std::get_if<DesignPlan>(&plan.work);
  if (design != nullptr && design->draws > 0) {  // bands of the jobs are of it
    plan.settings.push_back(fmt::format("confidence = {}", plan.confidence));
  }
  return plan;
}

EnsemblePlan read_ensemble_plan(const std::string& path) {
  return parse_ensemble_plan(read_text(path, kLargestPlan), input_name(path));
}

}  // namespace microslip
