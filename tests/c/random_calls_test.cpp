// SPDX-License-Identifier: MIT
// Calls in any order with any numbers, sizes and NULL: each ends with a status that its header has,
// an error is one line that names something, and what it makes is there or not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "c/handle.hpp"

namespace microslip::test::random_calls {
namespace {

/// Calls that are drawn: some by default, or as many as MICROSLIP_C_CALLS says.
int calls() {
  const char* const given = std::getenv("MICROSLIP_C_CALLS");
  return given == nullptr ? 4000 : std::atoi(given);
}

constexpr std::size_t kLongest = 6;
constexpr std::array kOddNumbers{0.0,
                                 -0.0,
                                 -1.0,
                                 1e-300,
                                 -1e-300,
                                 1e300,
                                 -1e300,
                                 5e-324,
                                 1.7976931348623157e308,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
constexpr std::array<std::size_t, 5> kOddSizes{0, 1, std::size_t{1} << 40U,
                                               std::numeric_limits<std::size_t>::max() / 8,
                                               std::numeric_limits<std::size_t>::max()};
constexpr std::array kTexts{"",
                            "mass",
                            "other",
                            "inversion",
                            "spline",
                            "gcv",
                            "lambda=1e-3",
                            "p=0.9",
                            "mm",
                            "four_parameter",
                            "{",
                            "{\"schema\":\"microslip.joint/1\"}",
                            "\xFF\xFE",
                            "/no/such/file"};

/// Most of what is drawn is sound, so that calls get past the first argument.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed) {}

  bool chance(double share) { return uniform() < share; }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(uniform() * static_cast<double>(count)));
  }
  double number(double from, double to) {
    if (chance(kOdd)) return kOddNumbers.at(below(kOddNumbers.size()));
    return from * std::pow(to / from, uniform());
  }
  std::size_t size(std::size_t from, std::size_t to) {
    if (chance(kOdd)) return kOddSizes.at(below(kOddSizes.size()));
    return from + below(to - from + 1);
  }
  int whole(int from, int to) {
    if (chance(kOdd)) return chance(0.5) ? std::numeric_limits<int>::min() : 99;
    return from + static_cast<int>(below(static_cast<std::size_t>(to - from + 1)));
  }
  template <typename Enumeration>
  Enumeration any(int count) {
    return static_cast<Enumeration>(whole(0, count - 1));
  }
  const char* text(const char* sound) {
    if (!chance(kOdd)) return sound;
    return chance(0.3) ? nullptr : kTexts.at(below(kTexts.size()));
  }
  /// Rising but for odd ones.
  std::vector<double> rising(double from, double to) {
    std::vector<double> values(kLongest);
    for (double& value : values) value = from * std::pow(to / from, uniform());
    std::ranges::sort(values);
    for (double& value : values) {
      if (chance(kOdd / kLongest)) value = number(from, to);
    }
    return values;
  }
  /// A pointer that is sometimes NULL.
  template <typename T>
  T* pointer(T* sound) {
    return chance(kOdd / 3.0) ? nullptr : sound;
  }
  /// A count of an array of kLongest values: never more than there are, unless it is beyond any.
  std::size_t count() {
    const std::size_t drawn = size(2, kLongest);
    return drawn > kLongest ? std::numeric_limits<std::size_t>::max() / 4 : drawn;
  }

 private:
  static constexpr double kOdd = 0.06;

  /// In [0, 1), the same with every library.
  double uniform() { return 0x1p-53 * static_cast<double>(random_() >> 11U); }

  std::mt19937_64 random_;
};

/// The error message is one line of text.
void check_error() {
  const std::string_view said = microslip_last_error();
  EXPECT_FALSE(said.empty());
  EXPECT_LT(said.size(), 2000U);
  EXPECT_TRUE(std::ranges::none_of(said, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  })) << said;
}

/// @return whether it is done.
bool check_status(microslip_status status) {
  EXPECT_GE(status, MICROSLIP_OK);
  EXPECT_LT(status, MICROSLIP_INTERNAL) << microslip_last_error();
  if (status != MICROSLIP_OK) check_error();
  return status == MICROSLIP_OK;
}

/// A handle that a call makes anew; it is there where the call is done, or did not converge.
template <typename Handle, typename Make>
void remake(Handle& handle, const Make& make) {
  handle.destroy();
  const microslip_status status = make(handle.out());
  check_status(status);
  if (status != MICROSLIP_OK && status != MICROSLIP_NOT_CONVERGED) {
    EXPECT_EQ(static_cast<const void*>(handle), nullptr) << status;
  }
}

/// How often handles were made: what is drawn must get past the checks.
using Made = std::map<std::string, int>;

class Caller {
 public:
  Caller(std::uint64_t seed, Made& made) : draws_(seed), made_(made) {}

  void call() {
    using Call = void (Caller::*)();
    static constexpr std::array<Call, 15> kCalls{
        &Caller::make_joint,  &Caller::parse_joint, &Caller::read_curves,  &Caller::make_memory,
        &Caller::move_memory, &Caller::make_levels, &Caller::set_levels,   &Caller::identify,
        &Caller::read_found,  &Caller::make_model,  &Caller::add_to_model, &Caller::make_structure,
        &Caller::respond,     &Caller::march,       &Caller::read_results};
    (this->*kCalls.at(draws_.below(kCalls.size())))();
  }

 private:
  template <typename T>
  T* some(T* handle) {
    return draws_.chance(0.02) ? nullptr : handle;
  }

  template <typename Handle, typename Make>
  void remake(const char* name, Handle& handle, const Make& make) {
    random_calls::remake(handle, make);
    if (handle != nullptr) ++made_[name];
  }

  void make_joint() {
    microslip_part part{};
    check_status(microslip_part_defaults(&part, draws_.chance(0.05) ? 3 : sizeof part));
    part.struct_size = draws_.chance(0.05) ? draws_.size(0, 200) : sizeof part;
    if (part.struct_size > sizeof part) part.struct_size = sizeof part;
    part.kind = draws_.any<microslip_part_kind>(5);
    part.from = draws_.chance(0.5) ? 0.0 : draws_.number(0.01, 1.0);
    part.to = draws_.number(1.0, 100.0);
    part.weight = draws_.number(0.01, 1.0);
    part.coefficient = draws_.number(1e-4, 1e-2);
    part.exponent = -draws_.number(0.05, 0.9);
    const std::vector<double> force = draws_.rising(0.1, 10.0);
    const std::vector<double> value = draws_.rising(1e-4, 0.02);
    part.count = draws_.count();
    part.slip_force = draws_.pointer(force.data());
    part.value = draws_.pointer(value.data());
    part.macroslip_force = draws_.number(1.0, 100.0);
    part.chi = -draws_.number(0.05, 0.9);
    part.beta = draws_.number(0.1, 10.0);
    remake("joint", joint_, [&](microslip_joint** made) {
      return microslip_joint_create(draws_.number(1.0, 1e7), draws_.pointer(&part),
                                    draws_.chance(0.02) ? 0 : 1, draws_.pointer(made));
    });
  }

  void parse_joint() {
    CJoint parsed;
    remake("parsed joint", parsed, [&](microslip_joint** made) {
      const char* text = nullptr;
      check_status(microslip_joint_text(some<microslip_joint>(joint_), draws_.pointer(&text)));
      return microslip_joint_parse(draws_.text(text), draws_.pointer(made));
    });
    remake("parsed joint", parsed, [&](microslip_joint** made) {
      return microslip_joint_read(draws_.text("/no/such/file"), made);
    });
  }

  void read_curves() {
    using Curve = microslip_status (*)(const microslip_joint*, std::size_t, const double*, double*);
    static constexpr std::array<Curve, 5> kCurves{
        microslip_virgin_force, microslip_tangent_stiffness, microslip_dissipation,
        microslip_secant_stiffness, microslip_density};
    const std::vector<double> at = draws_.rising(1e-9, 1e-2);
    std::vector<double> out(kLongest);
    const std::size_t count = draws_.count();
    check_status(kCurves.at(draws_.below(5))(some<microslip_joint>(joint_), count,
                                             draws_.pointer(at.data()),
                                             draws_.pointer(out.data())));
    microslip_part part{};
    part.struct_size = draws_.chance(0.1) ? 0 : sizeof part;
    check_status(microslip_joint_part(joint_, draws_.size(0, 2), draws_.pointer(&part)));
  }

  void make_memory() {
    remake("memory", memory_, [&](microslip_memory** made) {
      return microslip_memory_create(some<microslip_joint>(joint_), draws_.pointer(made));
    });
    CMemory copy;
    remake("copy", copy,
           [&](microslip_memory** made) { return microslip_memory_copy(memory_, made); });
    check_status(microslip_memory_assign(some<microslip_memory>(copy), memory_));
  }

  void move_memory() {
    std::vector<double> path = draws_.rising(1e-7, 1e-3);
    double a = 0.0;
    double b = 0.0;
    check_status(microslip_memory_trial(some<microslip_memory>(memory_), draws_.number(1e-7, 1e-3),
                                        draws_.pointer(&a), draws_.pointer(&b)));
    check_status(microslip_memory_advance(memory_, -draws_.number(1e-7, 1e-3), draws_.pointer(&a)));
    check_status(
        microslip_memory_march(memory_, draws_.count(), path.data(), draws_.pointer(path.data())));
    check_status(microslip_memory_dissipation(memory_, draws_.number(1e-7, 1e-3), &a));
    check_status(microslip_memory_stored_energy(memory_, draws_.pointer(&b)));
    check_status(microslip_memory_state(memory_, draws_.pointer(&a), draws_.pointer(&b)));
    if (draws_.chance(0.2)) check_status(microslip_memory_reset(memory_));
  }

  void make_levels() {
    const std::vector<double> amplitude = draws_.rising(1e-6, 1e-4);
    const std::vector<double> dissipation = draws_.rising(1e-9, 1e-5);
    remake("levels", levels_, [&](microslip_levels** made) {
      return microslip_levels_create(draws_.count(), draws_.pointer(amplitude.data()),
                                     draws_.pointer(dissipation.data()), draws_.pointer(made));
    });
  }

  void set_levels() {
    std::size_t count = 0;
    if (!check_status(microslip_levels_count(some<microslip_levels>(levels_), &count))) return;
    const std::vector<double> values = draws_.rising(1e-9, 1e-6);
    check_status(microslip_levels_set(levels_, draws_.any<microslip_level_column>(7),
                                      draws_.chance(0.9) ? count : draws_.count(),
                                      draws_.pointer(values.data())));
  }

  void identify() {
    auto options = defaults(microslip_identify_options_defaults);
    options.stiffness = draws_.number(1e4, 1e6);
    options.method = draws_.text("inversion");
    options.smoothing = draws_.text("gcv");
    options.smoothing_unit = draws_.chance(0.1) ? draws_.text("mm") : nullptr;
    options.fit = draws_.text("none");
    options.linear_damping = draws_.whole(0, 1);
    options.atom = draws_.whole(0, 1);
    options.edges = draws_.whole(0, 1);
    options.bands = draws_.chance(0.8) ? 0 : draws_.size(20, 30);
    options.confidence = draws_.number(0.5, 0.99);
    options.dissipation_gain_std = draws_.chance(0.8) ? 0.0 : draws_.number(1e-3, 0.1);
    options.threads = draws_.whole(0, 1);
    options.command = draws_.text("a call");
    remake("identification", found_, [&](microslip_identification** made) {
      return microslip_identify(some<microslip_levels>(levels_), draws_.pointer(&options),
                                draws_.pointer(made));
    });
  }

  void read_found() {
    const double* values = nullptr;
    std::size_t count = 0;
    double number = 0.0;
    const char* text = nullptr;
    microslip_outcome outcome{};
    outcome.struct_size = draws_.chance(0.1) ? draws_.size(0, 20) : sizeof outcome;
    if (outcome.struct_size > sizeof outcome) outcome.struct_size = sizeof outcome;
    check_status(microslip_identification_values(some<microslip_identification>(found_),
                                                 draws_.any<microslip_identified_values>(4),
                                                 draws_.pointer(&values), draws_.pointer(&count)));
    check_status(microslip_identification_number(found_, draws_.any<microslip_identified_number>(3),
                                                 draws_.pointer(&number)));
    check_status(microslip_identification_outcome(found_, draws_.pointer(&outcome)));
    check_status(microslip_identification_warning(found_, draws_.size(0, 2), draws_.pointer(&text),
                                                  draws_.pointer(&text)));
    CJoint joint;
    remake("found joint", joint, [&](microslip_joint** made) {
      return microslip_identification_joint(found_, draws_.pointer(made));
    });
  }

  void make_model() {
    const std::vector<double> frequency = draws_.rising(1.0, 100.0);
    const std::vector<double> loss = draws_.rising(1e-3, 0.05);
    modes_ = draws_.chance(0.95) ? 1 + draws_.below(2) : draws_.count();
    remake("model", model_, [&](microslip_model** made) {
      return microslip_model_create(modes_, draws_.pointer(frequency.data()),
                                    draws_.pointer(loss.data()), draws_.any<microslip_damping>(2),
                                    draws_.pointer(made));
    });
    added_ = 0;
    for (std::size_t i = draws_.below(3); i < 3; ++i) add_to_model();
  }

  void add_to_model() {
    const std::vector<double> shape = draws_.rising(0.1, 2.0);
    auto options = defaults(microslip_joint_options_defaults);
    options.spring_in_modes = draws_.chance(0.7) ? 0.0 : draws_.number(1.0, 100.0);
    options.series_compliance = draws_.chance(0.7) ? 0.0 : draws_.number(1e-9, 1e-7);
    const std::size_t modes = draws_.chance(0.95) ? modes_ : draws_.count();
    microslip_model* const model = some<microslip_model>(model_);
    const char* const name = kNames.at(added_++ % kNames.size());
    check_status(
        microslip_model_add_point(model, draws_.text(name), modes, draws_.pointer(shape.data())));
    check_status(microslip_model_add_joint(model, draws_.text(name), some<microslip_joint>(joint_),
                                           modes, draws_.pointer(shape.data()),
                                           draws_.pointer(&options)));
    check_status(microslip_model_add_excitation(
        model, draws_.text("mass"), draws_.chance(0.9) ? 1 : draws_.count(),
        draws_.chance(0.7) ? nullptr : shape.data(), nullptr));
    if (draws_.chance(0.2)) {
      check_status(
          microslip_model_add_static_load(model, draws_.text("mass"), draws_.number(0.1, 10.0)));
    }
  }

  void make_structure() {
    remake("structure", structure_, [&](microslip_structure** made) {
      return microslip_structure_create(some<microslip_model>(model_), draws_.pointer(made));
    });
    std::size_t count = 0;
    const double* values = nullptr;
    const char* name = nullptr;
    check_status(microslip_structure_stuck_frequencies(structure_, draws_.pointer(&values),
                                                       draws_.pointer(&count)));
    check_status(microslip_structure_point(structure_, draws_.size(0, 1), draws_.pointer(&name)));
    check_status(microslip_structure_joint(structure_, draws_.size(0, 1), draws_.pointer(&name)));
  }

  microslip_frf_options frf_options() {
    auto options = defaults(microslip_frf_options_defaults);
    options.harmonics = draws_.size(1, 4);
    options.samples = draws_.size(16, 64);
    options.tolerance = draws_.number(1e-13, 1e-6);
    options.max_iterations = draws_.whole(2, 40);
    options.largest_change = draws_.number(0.05, 0.5);
    options.least_points = draws_.whole(1, 5);
    options.max_points = draws_.whole(2, 50);
    options.response = draws_.any<microslip_response>(3);
    options.modal_forcing = draws_.chance(0.1) ? 1 : 0;
    options.judge = draws_.chance(0.1) ? 1 : 0;
    return options;
  }

  void respond() {
    auto options = frf_options();
    const std::vector<double> responses = draws_.rising(1e-6, 1e-4);
    remake("curve", curve_, [&](microslip_curve** made) {
      if (draws_.chance(0.5)) {
        return microslip_backbone(
            some<microslip_structure>(structure_),
            draws_.chance(0.5) ? nullptr : draws_.text("mass"), draws_.size(0, 1), draws_.count(),
            draws_.pointer(responses.data()), draws_.pointer(&options), draws_.pointer(made));
      }
      const std::vector<double> at = draws_.rising(1.0, 100.0);
      options.at_count = draws_.chance(0.8) ? 0 : draws_.count();
      options.at = at.data();
      return microslip_frf(some<microslip_structure>(structure_), nullptr,
                           draws_.any<microslip_kept>(2), draws_.number(0.01, 10.0),
                           draws_.number(1.0, 50.0), draws_.number(50.0, 200.0), &options,
                           draws_.pointer(made));
    });
  }

  void march() {
    auto options = defaults(microslip_march_options_defaults);
    options.step = draws_.chance(0.7) ? 0.0 : draws_.number(1e-4, 1e-2);
    options.every = draws_.size(1, 3);
    options.tolerance = draws_.number(1e-10, 1e-5);
    options.max_iterations = draws_.whole(2, 50);
    options.estimate_error = draws_.whole(0, 1);
    options.start_modes = draws_.chance(0.9) ? 0 : draws_.size(1, 2);
    const std::vector<double> time = draws_.rising(0.01, 1.0);
    const std::vector<double> load = draws_.rising(0.01, 10.0);
    const double* const loads[1] = {draws_.pointer(load.data())};
    const char* const places[1] = {draws_.text("mass")};
    options.start_velocity = draws_.chance(0.9) ? nullptr : load.data();
    remake("march", marched_, [&](microslip_marched** made) {
      return microslip_march(some<microslip_structure>(structure_), draws_.count(),
                             draws_.pointer(time.data()), draws_.chance(0.95) ? 1 : 0,
                             draws_.chance(0.5) ? nullptr : places, draws_.pointer(loads),
                             draws_.pointer(&options), draws_.pointer(made));
    });
  }

  void read_results() {
    const double* values = nullptr;
    const std::size_t* index = nullptr;
    std::size_t count = 0;
    double number = 0.0;
    const char* text = nullptr;
    microslip_curve* const curve = some<microslip_curve>(curve_);
    check_status(microslip_curve_values(curve, draws_.any<microslip_curve_values_of>(10),
                                        draws_.pointer(&values), draws_.pointer(&count)));
    check_status(microslip_curve_joint(curve, draws_.size(0, 1),
                                       draws_.any<microslip_curve_joint_of>(2),
                                       draws_.pointer(&values), draws_.pointer(&count)));
    std::vector<double> real(count);
    std::vector<double> imaginary(count);
    check_status(microslip_curve_harmonic(curve, draws_.text("mass"), draws_.size(0, 4), count,
                                          real.data(), imaginary.data()));
    check_status(microslip_curve_peaks(curve, draws_.pointer(&index), draws_.pointer(&count)));
    check_status(microslip_curve_warning(curve, draws_.size(0, 2), draws_.pointer(&text), &text));
    microslip_marched* const marched = some<microslip_marched>(marched_);
    check_status(microslip_marched_time(marched, draws_.pointer(&values), draws_.pointer(&count)));
    check_status(microslip_marched_point(marched, draws_.size(0, 1),
                                         draws_.any<microslip_response>(3), &values, &count));
    check_status(microslip_marched_joint(
        marched, draws_.size(0, 1), draws_.any<microslip_marched_joint_of>(2), &values, &count));
    check_status(microslip_marched_value(marched, draws_.any<microslip_marched_number>(11),
                                         draws_.pointer(&number)));
    check_status(
        microslip_marched_warning(marched, draws_.size(0, 2), &text, draws_.pointer(&text)));
  }

  Draws draws_;
  Made& made_;
  static constexpr std::array kNames{"mass", "tip", "end", "base", "left", "right"};
  std::size_t modes_ = 1;
  std::size_t added_ = 0;
  CJoint joint_;
  CMemory memory_;
  CLevels levels_;
  CIdentification found_;
  CModel model_;
  CStructure structure_;
  CCurve curve_;
  CMarched marched_;
};

TEST(CRandomCalls, EndWithAStatus) {
  constexpr int kCallsOfOne = 200;
  Made made;
  for (int i = 0; i < calls() && !::testing::Test::HasFailure(); i += kCallsOfOne) {
    SCOPED_TRACE(fmt::format("seed {}", i));
    Caller caller(static_cast<std::uint64_t>(i), made);
    for (int j = 0; j < kCallsOfOne && !::testing::Test::HasFailure(); ++j) caller.call();
  }
  for (const char* name : {"joint", "parsed joint", "memory", "copy", "levels", "identification",
                           "found joint", "model", "structure", "curve", "march"}) {
    EXPECT_GT(made[name], 0) << name;
  }
}

}  // namespace
}  // namespace microslip::test::random_calls
