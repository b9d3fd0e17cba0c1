// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_polarity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "support/messages.hpp"

namespace microslip::record_polarity_test {
namespace {

/// A slider of 30 N/m that slips at 9 N, beside a spring; with some noise of both.
class Bench {
 public:
  explicit Bench(double spring) : spring_(spring) {}

  void go(double to, int samples) {
    const double from = u_;
    for (int i = 1; i <= samples; ++i) put(from + (to - from) * i / samples);
  }
  void hold(int samples) {
    for (int i = 0; i < samples; ++i) put(u_);
  }
  [[nodiscard]] ForceRecord record() const { return record_; }

 private:
  void put(double u) {
    slider_ = std::clamp(slider_ + 30.0 * (u - u_), -9.0, 9.0);
    u_ = u;
    record_.displacement.push_back(u + 1e-4 * random_.normal());
    record_.force.push_back(slider_ + spring_ * u + 0.01 * random_.normal());
  }

  double spring_;
  double u_ = 0.0;
  double slider_ = 0.0;
  RandomStream random_{3, 1};
  ForceRecord record_;
};

/// Loops of gross slip; then back from the last by so much, to rest for so long.
ForceRecord gross_slip(double back, int hold) {
  Bench bench(0.0);
  for (const double amplitude : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}) {
    bench.go(amplitude, 40);
    bench.go(-amplitude, 80);
    bench.go(0.0, 40);
  }
  bench.go(3.0, 40);
  bench.go(3.0 - back, 20);
  bench.hold(hold);
  return bench.record();
}

ForceRecord spring(double stiffness) {
  ForceRecord record;
  for (int i = 0; i < 2000; ++i) {
    record.displacement.push_back(std::sin(0.02 * i));
    record.force.push_back(stiffness * record.displacement.back());
  }
  return record;
}

ForceRecord opposite(ForceRecord record) {
  for (double& f : record.force) f = -f;
  return record;
}

ForceRecord exchanged(ForceRecord record) {
  std::swap(record.force, record.displacement);
  return record;
}

std::string refusal(const ForceRecord& record, PathStart start = PathStart::kVirgin) {
  return test::message_or("taken", [&] {
    check_polarity(RecordEvidence(record, start));
    return 0;
  });
}

double covariance(const ForceRecord& record) {
  double mean = 0.0;
  for (const double f : record.force) mean += f / static_cast<double>(record.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    sum += (record.force[i] - mean) * (record.displacement[i] - record.displacement.front());
  }
  return sum;
}

// A hold where the joint has slid back weighs in any mean over samples, not in the work.
TEST(RecordPolarity, DoesNotDependOnHolds) {
  for (const int hold : {0, 400, 4000}) {
    for (const double back : {0.1, 0.7, 2.0}) {
      const ForceRecord record = gross_slip(back, hold);
      for (const PathStart start : {PathStart::kVirgin, PathStart::kUnknown}) {
        EXPECT_EQ(refusal(record, start), "taken") << hold << ' ' << back;
      }
      test::expect_message(refusal(opposite(record)), "sign of one channel");
      test::expect_message(refusal(opposite(record)), "work over the record, J = -");
      test::expect_message(refusal(exchanged(record)), "swapped");
    }
  }
  EXPECT_LT(covariance(gross_slip(0.7, 4000)), 0.0);  // what was asked before
}

// An offset of the force does no work over a closed path, and none is counted of an open one.
TEST(RecordPolarity, DoesNotDependOnOffsets) {
  for (const double offset : {-1e3, 1e3}) {
    ForceRecord record = gross_slip(0.7, 0);
    for (double& f : record.force) f += offset;
    EXPECT_EQ(refusal(record), "taken") << offset;
    test::expect_message(refusal(opposite(record)), "sign of one channel");
  }
}

/// A slider of 0.01 N beside a spring that stiffens, along straight lines through values, m.
ForceRecord stiffening(const std::vector<double>& turns) {
  ForceRecord record;
  double u = 0.0;
  double slider = 0.0;
  for (const double to : turns) {
    const double from = u;
    for (int i = 1; i <= 200; ++i) {
      const double next = from + (to - from) * i / 200.0;
      slider = std::clamp(slider + next - u, -0.01, 0.01);
      u = next;
      record.displacement.push_back(u);
      record.force.push_back(u * u * u + 0.02 * u + slider);
    }
  }
  return record;
}

// Every cycle dissipates, wherever the record ends. A straight line from there to its start does
// more work than the joint dissipates.
TEST(RecordPolarity, OfStiffeningJointsDoesNotDependOnTheEnd) {
  for (const std::vector<double>& turns :
       {std::vector<double>{1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0},
        {1.0, -1.0, 1.0, -1.0, 0.6},
        {1.0, 0.5},
        {1.0, 0.2, 1.2, 0.4, 1.4},
        {1.0}}) {
    const ForceRecord record = stiffening(turns);
    EXPECT_EQ(refusal(record), "taken") << turns.size();
    test::expect_message(refusal(opposite(record)), "sign of one channel");
  }
}

/// Of a spring, by an angle late in each cycle; it rests at its last top for so long.
ForceRecord late_spring(double angle, int hold) {
  constexpr int kTop = 1963;  // of the seventh cycle
  ForceRecord record;
  for (int i = 0; i <= kTop + hold; ++i) {
    const double phase = 0.02 * std::min(i, kTop);
    record.displacement.push_back(std::sin(phase));
    record.force.push_back(std::sin(phase - angle));
  }
  return record;
}

// A record of which the force lags behind the displacement gives energy, W = −π F₀u₀ sin φ a cycle.
TEST(RecordPolarity, OfALateForceIsNamed) {
  test::expect_message(refusal(late_spring(0.3, 0)), "the force may lag behind the displacement");
}

// 1.5 % of the work exchanged, 2 F₀u₀ a cycle: about the force of the rest it would be twice that.
TEST(RecordPolarity, IsMeasuredByThePath) {
  for (const int hold : {0, 20'000}) {
    test::expect_message(refusal(late_spring(0.0095, hold)), "work over the record, J = -");
  }
}

TEST(RecordPolarity, IsThatOfTheSpringWithoutWork) {
  EXPECT_EQ(refusal(spring(5.0)), "taken");
  test::expect_message(refusal(spring(-5.0)), "sign of one channel");
}

// The force of a damper neither rises nor falls with the displacement.
TEST(RecordPolarity, OfADamperIsThatOfItsWork) {
  ForceRecord damper = spring(1.0);
  for (int i = 0; i < 2000; ++i) damper.force[static_cast<std::size_t>(i)] = std::cos(0.02 * i);
  EXPECT_EQ(refusal(damper), "taken");
  test::expect_message(refusal(opposite(damper)), "Change the sign of one channel; or");
}

}  // namespace
}  // namespace microslip::record_polarity_test
