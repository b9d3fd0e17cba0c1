// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/dynamics/march_damper.hpp"

namespace microslip {
namespace {

using Kind = StepWeights::Kind;

/// Turns nearer to an end of a step than this share of it are at that end.
constexpr double kNear = 1e-9;
constexpr double kStepRounding = 1e-12;
/// Motion over a step below this share of the largest is rounding: no step is cut for it.
constexpr double kQuiet = 1e-13;
/// Growth of the contraction that is assumed, from one step to the next.
constexpr double kMistrust = 1.1;
/// The least that is believed without being measured in the step itself.
constexpr double kLeastContraction = 1e-3;
/// Turns and kinks in one step; where there are more the joint is at rest but for rounding.
constexpr int kMostChanges = 100;
/// Pieces of a step that are shorter than this share of it are not tried.
constexpr double kLeastPiece = 1e-6;
/// Rounds of Newton's method after which the tangents stay: the forces are continuous, so that they
/// converge where tangents jump between two values.
constexpr int kSettled = 8;

int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

/// Where `ahead`, above 0 at `low` and below at `high`, changes its sign, as a share of a step; next to
/// an end of the step, that end.
template <typename Ahead>
double share_of_sign_change(const Ahead& ahead, double low, double high) {
  for (int i = 0; i < 40; ++i) {
    const double x = 0.5 * (low + high);
    (ahead(x) > 0.0 ? low : high) = x;
  }
  const double share = 0.5 * (low + high);
  if (share > 1.0 - kNear) return 1.0;
  return share > kNear ? share : 0.0;
}

}  // namespace

MarchState::MarchState(const JointedStructure& structure, std::vector<MarchedJoint> hysteresis,
                       const MarchOptions& options)
    : tolerance_(options.tolerance),
      max_iterations_(options.max_iterations),
      groups_(padded(structure.linear().size()) / kLanes),
      shortens_(structure.shortens()),
      cut_(structure.linear().modes()) {
  const std::size_t lanes = groups_ * kLanes;
  for (auto* vector : {&stiffness_, &damping_, &q_, &v_, &load_, &load_slope_, &end_q_, &end_v_,
                       &end_load_, &end_load_slope_, &end_force_, &end_a_, &predicted_q_,
                       &predicted_v_, &loads_.force, &loads_.slope}) {
    vector->assign(lanes, 0.0);
  }
  for (std::size_t i = 0; i < structure.linear().size(); ++i) {
    const Mode& mode = structure.linear().modes()[i];
    stiffness_[i] = mode.angular_frequency * mode.angular_frequency;
    damping_[i] = mode.loss_factor * mode.angular_frequency;
  }
  for (std::size_t j = 0; j < hysteresis.size(); ++j) {
    add_joint(structure.joints()[j], damper_of_joint(structure, j), std::move(hysteresis[j]));
  }
  predicted_slide_.resize(joints_.size());
  loads_.normal.assign(joints_.size(), 1.0);
  loads_.normal_slope.assign(joints_.size(), 0.0);
}

void MarchState::add_joint(const StructuralJoint& joint, double damper, MarchedJoint hysteresis) {
  const std::size_t lanes = groups_ * kLanes;
  const std::size_t modes = joint.shape.size();
  Joint added{joint.shape,          {}, joint.spring_in_modes, joint.series_compliance, damper,
              std::move(hysteresis)};
  damped_ = damped_ || damper > 0.0;
  added.shape.resize(lanes, 0.0);
  added.g.assign(lanes, 0.0);
  added.g_dot.assign(lanes, 0.0);
  if (!joint.shortening.empty()) {
    added.gamma.assign(lanes * lanes, 0.0);
    for (std::size_t i = 0; i < modes; ++i) {
      for (std::size_t r = 0; r < modes; ++r) {
        added.gamma[i * lanes + r] = joint.shortening[i * modes + r];
      }
    }
  }
  joints_.push_back(std::move(added));
}

void MarchState::start(const InitialState& start) {
  std::copy(start.displacement.begin(), start.displacement.end(), end_q_.begin());
  std::copy(start.velocity.begin(), start.velocity.end(), end_v_.begin());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    const auto slide =
        march_loops::project(groups_, joint.shape.data(), end_q_.data(), end_v_.data());
    Kinematics& k = joint.end;
    k = {slide.q, slide.v, slide.q, slide.v};
    if (!joint.gamma.empty()) {
      const auto g = march_loops::shorten(groups_, joint.gamma.data(), end_q_.data(), end_v_.data(),
                                          joint.g.data(), joint.g_dot.data());
      k.gap -= 0.5 * g.q;
      k.gap_dot -= g.v;
    }
    const double load = loads_.normal[j];
    const double u = joint.hysteresis.displacement_at(k.gap, load);
    k.force = joint.hysteresis.advance(u, load);
    joint.hysteresis.begin_energy();
    const double tangent = k.gap_dot * k.gap < 0.0 ? load * joint.hysteresis.stuck_stiffness()
                                                   : joint.hysteresis.trial(u, load).tangent;
    k.force_dot = tangent * k.gap_dot / (1.0 + tangent * joint.compliance);
    joint.tangent = tangent;
    drive_damper(joint, tangent, k);
    k.force += joint.damper * k.u_dot;
    k.r = k.force - joint.spring * k.slide;
    k.r_dot = k.force_dot - joint.spring * k.slide_dot;
    joint.begin = k;
    set_off(joint);
    joint.largest_force = std::abs(k.force);
    joint.largest_gap = std::abs(k.gap);
  }
  load_modes();
  if (damped_) {  // the slopes of their forces take the accelerations
    accelerate(0.0);
    for (Joint& joint : joints_) {
      Kinematics& k = joint.end;
      drive_damper(joint, joint.tangent, k);
      const double slope = joint.damper * k.u_ddot;
      k.force_dot += slope;
      k.r_dot += slope;
      joint.begin = k;
    }
    load_modes();
  }
  load_ = end_load_;
  load_slope_ = end_load_slope_;
  q_ = end_q_;
  v_ = end_v_;
  const MarchEnergy energy = this->energy();
  initial_energy_ = energy.kinetic + energy.elastic + energy.joint_stored();
}

// ---- The equations of a step. ----

void MarchState::couple(const StepWeights& weights, Couplings& couplings) const {
  if (couplings.length == weights.length()) return;
  couplings.length = weights.length();
  const std::size_t n = joints_.size();
  for (auto [matrix, kind] :
       {std::pair{&couplings.a, Kind::kA1}, std::pair{&couplings.b, Kind::kB1},
        std::pair{&couplings.c, Kind::kC1}, std::pair{&couplings.d, Kind::kD1}}) {
    matrix->assign(n * n, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t l = 0; l < n; ++l) {
        double sum = 0.0;
        for (std::size_t i = 0; i < groups_ * kLanes; ++i) {
          sum += joints_[j].shape[i] * weights(kind, i) * joints_[l].shape[i];
        }
        (*matrix)[j * n + l] = sum;
      }
    }
  }
}

/// From the second derivatives over the step before.
MarchState::Kinematics MarchState::extrapolated(const Kinematics& from, const Curvature& curvature,
                                                double length) {
  Kinematics to = from;
  to.force_dot += length * curvature.force;
  to.r_dot += length * curvature.r;
  to.force += 0.5 * length * (from.force_dot + to.force_dot);
  to.r += 0.5 * length * (from.r_dot + to.r_dot);
  return to;
}

/// R, Ṙ, F and Ḟ of the joints at the end of the step, from those extrapolated.
bool MarchState::solve(const StepWeights& weights, Couplings& couplings) {
  const double h = weights.length();
  march_loops::predict(
      groups_, weights.data(), h,
      {q_.data(), v_.data(), load_.data(), load_slope_.data(), loads_.force.data()},
      loads_.slope.data(), predicted_q_.data(), predicted_v_.data());
  couple(weights, couplings);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    predicted_slide_[j] =
        march_loops::project(groups_, joint.shape.data(), predicted_q_.data(), predicted_v_.data());
    joint.end = extrapolated(joint.begin, joint.curvature, h);
  }
  // Changes fall by about one factor: what is left after one is their geometric series. The factor
  // is that of steps before, mistrusted more from step to step until it is measured again.
  double before = 0.0;
  for (int i = 0; i < max_iterations_ && !joints_.empty(); ++i) {
    place(weights, couplings);
    double change = 0.0;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      change = std::max(change, update(j, couplings, h, i >= kSettled));
    }
    last_change_ = change;
    if (!std::isfinite(change)) return false;
    contraction_ = i == 0 ? kMistrust * std::max(contraction_, kLeastContraction) : change / before;
    const bool falls = contraction_ < 0.5;
    if (change <= tolerance_ || (falls && change * contraction_ <= 0.5 * tolerance_)) {
      correct(weights);
      return true;
    }
    before = change;
  }
  correct(weights);
  return joints_.empty();
}

/// The joints where the forces that were found put them.
void MarchState::place(const StepWeights& weights, const Couplings& couplings) {
  if (shortens_ || damped_) {
    place_shortened(weights);
    if (damped_) accelerate(weights.length());
    return;
  }
  const std::size_t n = joints_.size();
  for (std::size_t j = 0; j < n; ++j) {
    Kinematics& k = joints_[j].end;
    k.slide = predicted_slide_[j].q;
    k.slide_dot = predicted_slide_[j].v;
    for (std::size_t l = 0; l < n; ++l) {
      const Kinematics& other = joints_[l].end;
      k.slide -= couplings.a[j * n + l] * other.r + couplings.b[j * n + l] * other.r_dot;
      k.slide_dot -= couplings.c[j * n + l] * other.r + couplings.d[j * n + l] * other.r_dot;
    }
    k.gap = k.slide;
    k.gap_dot = k.slide_dot;
  }
}

void MarchState::place_shortened(const StepWeights& weights) {
  correct(weights);
  for (Joint& joint : joints_) {
    Kinematics& k = joint.end;
    const auto slide =
        march_loops::project(groups_, joint.shape.data(), end_q_.data(), end_v_.data());
    k.slide = slide.q;
    k.slide_dot = slide.v;
    k.gap = slide.q;
    k.gap_dot = slide.v;
    if (joint.gamma.empty()) continue;
    const auto g = march_loops::shorten(groups_, joint.gamma.data(), end_q_.data(), end_v_.data(),
                                        joint.g.data(), joint.g_dot.data());
    k.gap -= 0.5 * g.q;
    k.gap_dot -= g.v;
  }
}

/// ÿ of the joints at the end of a step, after this length, from what acts on the modes there.
void MarchState::accelerate(double length) {
  for (std::size_t i = 0; i < end_a_.size(); ++i) {
    end_a_[i] = end_load_[i] + loads_.force[i] + length * loads_.slope[i] -
                damping_[i] * end_v_[i] - stiffness_[i] * end_q_[i];
  }
  for (Joint& joint : joints_) {
    double sum = 0.0;
    for (std::size_t i = 0; i < end_a_.size(); ++i) sum += joint.shape[i] * end_a_[i];
    if (!joint.gamma.empty()) {
      for (std::size_t i = 0; i < end_a_.size(); ++i) {
        sum -= joint.g[i] * end_a_[i] + joint.g_dot[i] * end_v_[i];
      }
    }
    joint.end.gap_ddot = sum;
  }
}

/// u̇ and ü at the damper: ẏ = u̇ + c(Ku̇ + dü), with ü = ÿ/(1 + cK).
void MarchState::drive_damper(const Joint& joint, double tangent, Kinematics& k) {
  const double soft = 1.0 + joint.compliance * tangent;
  k.u_ddot = k.gap_ddot / soft;
  k.u_dot = (k.gap_dot - joint.compliance * joint.damper * k.u_ddot) / soft;
}

/// One step of Newton's method for R and Ṙ of a joint, what it does to others and by shortening left
/// to the next round: that is small where the step is.
/// @return what changed, relative.
double MarchState::update(std::size_t j, const Couplings& couplings, double length, bool settled) {
  ++evaluations_;
  Joint& joint = joints_[j];
  Kinematics& k = joint.end;
  const std::size_t own = j * joints_.size() + j;
  const double c = joint.compliance;
  const double load = loads_.normal[j] + length * loads_.normal_slope[j];
  if (!std::isfinite(k.gap - c * k.force)) return HUGE_VAL;
  const auto [force, new_tangent] = joint.hysteresis.trial(k.gap - c * k.force, load);
  if (!settled) joint.tangent = new_tangent;
  const double tangent = joint.tangent;
  const double stiffness = tangent / (1.0 + tangent * c);  // with what is in series
  drive_damper(joint, tangent, k);
  const double damped = joint.damper * k.u_dot;
  const double damped_dot = joint.damper * k.u_ddot;
  const double in_series = (force + damped + tangent * c * k.force) / (1.0 + tangent * c);
  const double beyond = stiffness - joint.spring;
  const double dr = (in_series - joint.spring * k.slide - k.r) / (1.0 + beyond * couplings.a[own]);
  const double dslide = -couplings.a[own] * dr;
  const double kept_velocity = -couplings.c[own] * dr;
  const double dr_dot = (stiffness * k.gap_dot + damped_dot - joint.spring * k.slide_dot - k.r_dot +
                         beyond * kept_velocity) /
                        (1.0 + beyond * couplings.d[own]);
  const double dvelocity = kept_velocity - couplings.d[own] * dr_dot;
  k.r += dr;
  k.r_dot += dr_dot;
  k.slide += dslide;
  k.gap += dslide;
  k.slide_dot += dvelocity;
  k.gap_dot += dvelocity;
  k.force = in_series + stiffness * dslide;
  k.force_dot = stiffness * k.gap_dot + damped_dot;
  const double scale = std::max(joint.largest_force, std::abs(force));
  const double change = std::max(std::abs(dr), length * std::abs(dr_dot));
  return change == 0.0 ? 0.0 : change / scale;
}

/// What the joints at the end of the step do to the modes.
void MarchState::load_modes() {
  double kept = 0.0;
  for (const Joint& joint : joints_) {
    const Kinematics& k = joint.end;
    if (joint.gamma.empty()) {
      march_loops::add_loads(groups_, kept, joint.shape.data(), k.r, k.r_dot, end_load_.data(),
                             end_load_slope_.data());
    } else {
      march_loops::add_shortening_loads(groups_, kept, joint.shape.data(), k.r, k.r_dot,
                                        joint.g.data(), joint.g_dot.data(), k.force, k.force_dot,
                                        end_load_.data(), end_load_slope_.data());
    }
    kept = 1.0;
  }
}

void MarchState::correct(const StepWeights& weights) {
  load_modes();
  march_loops::correct(groups_, weights.data(), predicted_q_.data(), predicted_v_.data(),
                       end_load_.data(), end_load_slope_.data(), end_q_.data(), end_v_.data());
}

// ---- Steps and their cuts. ----

/// In pieces that end where a joint turns or its tangent jumps. Where the equations of a piece do not
/// converge, a shorter one is tried.
bool MarchState::step(const StepWeights& weights) {
  double left = weights.length();
  double piece = left;
  int changes = 0;
  for (;;) {
    if (!solve_piece(piece, weights)) {
      if (piece <= kLeastPiece * weights.length()) return false;
      piece *= 0.5;
      continue;
    }
    const Change next = changes < kMostChanges ? first_change(piece) : Change{};
    if (next.share <= 0.0) {
      change(next);
      ++changes;
      continue;
    }
    if (next.share < 1.0) {
      piece *= next.share;
      if (!solve_piece(piece, weights)) continue;
      accept(piece);
      change(next);
      ++changes;
    } else {
      accept(piece);
    }
    pass_kinks();
    left -= piece;
    if (left <= kStepRounding * weights.length()) return true;
    piece = left;
  }
}

bool MarchState::solve_piece(double length, const StepWeights& whole) {
  if (length == whole.length()) return solve(whole, couplings_);
  cut_.set_length(length);
  return solve(cut_, cut_couplings_);
}

void MarchState::accept(double length) {
  for (std::size_t i = 0; i < end_force_.size(); ++i) {
    end_force_[i] = loads_.force[i] + length * loads_.slope[i];
  }
  const auto [input, loss] = march_loops::step_energies(
      groups_, length, stiffness_.data(), damping_.data(),
      {q_.data(), v_.data(), load_.data(), load_slope_.data(), loads_.force.data()},
      {end_q_.data(), end_v_.data(), end_load_.data(), end_load_slope_.data(), end_force_.data()},
      loads_.slope.data());
  input_ += input;
  loss_ += loss;
  std::swap(q_, end_q_);
  std::swap(v_, end_v_);
  std::swap(load_, end_load_);
  std::swap(load_slope_, end_load_slope_);
  std::swap(loads_.force, end_force_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    Kinematics& k = joint.end;
    loads_.normal[j] += length * loads_.normal_slope[j];
    k.force = joint.hysteresis.advance(k.gap - joint.compliance * k.force, loads_.normal[j]) +
              joint.damper * k.u_dot;
    const Kinematics& b = joint.begin;
    joint.damped += joint.damper * length *
                    (0.5 * (b.u_dot * b.u_dot + k.u_dot * k.u_dot) +
                     length / 6.0 * (b.u_dot * b.u_ddot - k.u_dot * k.u_ddot));
    joint.curvature = {(k.force_dot - joint.begin.force_dot) / length,
                       (k.r_dot - joint.begin.r_dot) / length};
    joint.begin = k;
    joint.turned_here = false;
    joint.largest_force = std::max(joint.largest_force, std::abs(k.force));
    joint.largest_gap = std::max(joint.largest_gap, std::abs(k.gap));
    if (joint.direction == 0) set_off(joint);
  }
  ++steps_;
}

void MarchState::set_off(Joint& joint) {
  joint.direction = sign_of(joint.begin.gap_dot);
  if (joint.direction == 0) return;
  joint.hysteresis.turn(joint.direction);
  find_kink(joint);
}

// ---- Where joints turn, and where their tangents jump. ----

void MarchState::change(const Change& change) {
  contraction_ = 1.0;  // on another curve
  Joint& joint = joints_[change.joint];
  if (change.turns) {
    turn(joint);
    joint.turned_here = change.share <= 0.0;
  } else {
    pass_kink(joint);
  }
}

void MarchState::turn(Joint& joint) {
  joint.direction = -joint.direction;
  joint.hysteresis.turn(joint.direction);
  find_kink(joint);
  ++reversals_;
}

/// The tangent jumps here, and with it the slopes of the loads.
void MarchState::pass_kink(Joint& joint) {
  const auto stiffness = [&] {
    const double tangent = joint.hysteresis.tangent();
    return tangent / (1.0 + tangent * joint.compliance);
  };
  const double before = stiffness();
  joint.hysteresis.pass_kink();
  find_kink(joint);
  ++kinks_;
  Kinematics& k = joint.begin;
  const double jump = (stiffness() - before) * k.gap_dot;
  k.force_dot += jump;
  k.r_dot += jump;
  for (std::size_t i = 0; i < load_slope_.size(); ++i) load_slope_[i] -= jump * joint.shape[i];
  if (joint.gamma.empty()) return;
  march_loops::shorten(groups_, joint.gamma.data(), q_.data(), v_.data(), joint.g.data(),
                       joint.g_dot.data());
  for (std::size_t i = 0; i < load_slope_.size(); ++i) load_slope_[i] += jump * joint.g[i];
}

/// The kinks that the joints have come to.
void MarchState::pass_kinks() {
  for (Joint& joint : joints_) {
    for (int i = 0; i < kMostChanges && joint.direction * (joint.kink - joint.begin.gap) < 0.0;
         ++i) {
      pass_kink(joint);
    }
  }
}

void MarchState::find_kink(Joint& joint) {
  const MarchedJoint::Kink& kink = joint.hysteresis.next_kink();
  joint.kink = std::isfinite(kink.displacement) ? kink.displacement + joint.compliance * kink.force
                                                : joint.direction * HUGE_VAL;
}

MarchState::Change MarchState::first_change(double length) {
  Change first;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const Cubic y(joint.begin.gap, joint.begin.gap_dot, joint.end.gap, joint.end.gap_dot, length);
    // It turns once at one place: what turns back at once is at rest but for rounding.
    const double turn = joint.turned_here ? 1.0 : turning_share(joint, y, length);
    if (turn < first.share) first = {turn, j, true};
    const double kink = kink_share(joint, y, std::min(turn, 1.0));
    if (kink < first.share) first = {kink, j, false};
  }
  return first;
}

/// Where in the step a joint turns, by the cubic through y and ẏ at its ends: ẏ there is of the order
/// h³ and y off its extreme by h⁶. 1 where it does not, 0 where it has turned already.
double MarchState::turning_share(const Joint& joint, const Cubic& y, double length) {
  const auto ahead = [&](double share) { return joint.direction * y.slope(share); };
  if (length * std::max(std::abs(joint.begin.gap_dot), std::abs(joint.end.gap_dot)) <=
      kQuiet * joint.largest_gap) {
    return ahead(1.0) < 0.0 ? 0.0 : 1.0;
  }
  // The slope is a parabola: it may dip below 0 and come back within the step, or rise above and fall.
  const double vertex = y.c == 0.0 ? -1.0 : -y.b / (3.0 * y.c);
  const bool bends = vertex > 0.0 && vertex < 1.0;
  double low = 0.0;
  double high = 1.0;
  if (bends && ahead(vertex) > 0.0) low = vertex;
  if (ahead(low) <= 0.0) return ahead(0.5) >= 0.0 ? 1.0 : 0.0;
  if (bends && ahead(vertex) < 0.0) high = vertex;
  if (ahead(high) >= 0.0) return 1.0;
  return share_of_sign_change(ahead, low, high);
}

/// Where y comes to the next kink, before the share `until`, up to which it does not turn.
double MarchState::kink_share(const Joint& joint, const Cubic& y, double until) {
  // What is in series gives way to the damper, too.
  const double kink = joint.kink + joint.compliance * joint.damper * joint.begin.u_dot;
  const auto ahead = [&](double share) { return joint.direction * (kink - y.value(share)); };
  if (joint.direction == 0 || !(ahead(until) < 0.0)) return 1.0;
  return share_of_sign_change(ahead, 0.0, until);
}

// ---- What came out. ----

double MarchState::acceleration(std::size_t mode) const {
  return load_[mode] + loads_.force[mode] - damping_[mode] * v_[mode] - stiffness_[mode] * q_[mode];
}

MarchEnergy MarchState::energy() const {
  MarchEnergy energy;
  energy.initial = initial_energy_;
  energy.input = input_;
  energy.linear_dissipation = loss_;
  for (std::size_t i = 0; i < q_.size(); ++i) {
    energy.kinetic += 0.5 * v_[i] * v_[i];
    energy.elastic += 0.5 * stiffness_[i] * q_[i] * q_[i];
  }
  for (const Joint& joint : joints_) {
    const double slide = joint.begin.slide;
    const double force = joint.begin.force;
    energy.elastic -= 0.5 * joint.spring * slide * slide;
    energy.joints.push_back(
        {{},
         joint.hysteresis.dissipation(),
         joint.hysteresis.stored_energy() + 0.5 * joint.compliance * force * force,
         joint.damped});
  }
  return energy;
}

}  // namespace microslip
