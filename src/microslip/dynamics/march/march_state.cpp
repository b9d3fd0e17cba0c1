// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "microslip/dynamics/march/march_damper.hpp"

namespace microslip {
namespace {

/// Growth of the contraction that is assumed, from one step to the next.
constexpr double kMistrust = 1.1;
/// The least that is believed without being measured in the step itself.
constexpr double kLeastContraction = 1e-3;
/// Rounds of Newton's method after which the tangents stay: the forces are continuous, so that they
/// converge where tangents jump between two values.
constexpr int kSettled = 8;
/// A joint vibrates against all modes by no more than this in a step that goes over breakpoints,
/// rad: in longer ones its path is too far from a cubic, and cuts are more accurate.
constexpr double kLargestJointAngle = 0.5;
/// For more joints than these coupling each with each takes longer than placing them by the modes
/// in the two rounds of a piece of a step.
constexpr std::size_t kMostCoupled = 4;

}  // namespace

MarchState::MarchState(const JointedStructure& structure, std::vector<MarchedJoint> hysteresis,
                       const MarchOptions& options, double coarseness)
    : tolerance_(options.tolerance),
      max_iterations_(options.max_iterations),
      groups_(padded(structure.linear().size()) / kLanes),
      joint_groups_(padded(hysteresis.size()) / kLanes),
      shortens_(structure.shortens()),
      cut_(structure.linear().modes()),
      breakpoint_weights_({}, {}),
      quadrature_(structure.linear().modes()),
      breakpoints_inside_(kInnerPoints * padded(structure.linear().size()), 0.0) {
  const std::size_t lanes = groups_ * kLanes;
  for (auto* vector : {&stiffness_, &damping_, &q_, &v_, &load_, &load_slope_, &end_q_, &end_v_,
                       &end_load_, &end_load_slope_, &end_load_middle_, &end_force_, &end_a_,
                       &predicted_q_, &predicted_v_, &loads_.force, &loads_.slope}) {
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
  for (auto* vector : {&predicted_slide_, &predicted_slide_dot_, &slide_, &slide_dot_}) {
    vector->assign(joint_groups_ * kLanes, 0.0);
  }
  breakpoint_weights_ = BreakpointWeights(stiffness_, damping_);
  longest_over_breakpoints_ = coarseness * longest_step_over_breakpoints(options.estimate_error);
  couplings_.of_others = cut_couplings_.of_others = !shortens_ && !damped_;
  if (joints_.size() > kMostCoupled) cut_couplings_.of_others = false;
  loads_.normal.assign(joints_.size(), 1.0);
  loads_.normal_slope.assign(joints_.size(), 0.0);
}

void MarchState::add_joint(const StructuralJoint& joint, double damper, MarchedJoint hysteresis) {
  const std::size_t lanes = groups_ * kLanes;
  const std::size_t modes = joint.shape.size();
  Joint added{joint.shape,
              {},
              joint.spring_in_modes,
              joint.series_compliance,
              damper,
              std::move(hysteresis),
              JointPath(joint.joint)};
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

/// s; 0 where no step goes over breakpoints.
/// @param beside_longer  twice the step must, too.
double MarchState::longest_step_over_breakpoints(bool beside_longer) const {
  if (shortens_ || damped_) return 0.0;
  double longest = (beside_longer ? 0.5 : 1.0) * breakpoint_weights_.longest();
  for (const Joint& joint : joints_) {
    if (joint.hysteresis.is_network()) return 0.0;
    double square = 0.0;  // 1/kg
    for (const double psi : joint.shape) square += psi * psi;
    const double frequency = std::sqrt(square * joint.hysteresis.stuck_stiffness());
    longest = std::min(longest, kLargestJointAngle / frequency);
  }
  return longest;
}

/// Where a joint begins, by the modes that are set.
void MarchState::begin(std::size_t j) {
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

/// ÿ where a step begins, by the modes.
void MarchState::begin_accelerations() {
  if (longest_over_breakpoints_ == 0.0) return;
  march_loops::accelerate(groups_, stiffness_.data(), damping_.data(), load_.data(),
                          loads_.force.data(), q_.data(), v_.data(), end_a_.data());
  for (Joint& joint : joints_) {
    joint.begin.gap_ddot = march_loops::dot(groups_, joint.shape.data(), end_a_.data());
  }
}

/// The slopes of the forces of dampers take the accelerations.
void MarchState::begin_dampers() {
  accelerate(0.0);
  for (Joint& joint : joints_) {
    Kinematics& k = joint.end;
    drive_damper(joint, joint.tangent, k);
    const double slope = joint.damper * k.u_ddot;
    k.force_dot += slope;
    k.r_dot += slope;
    joint.begin = k;
  }
}

void MarchState::start(const InitialState& start) {
  std::copy(start.displacement.begin(), start.displacement.end(), end_q_.begin());
  std::copy(start.velocity.begin(), start.velocity.end(), end_v_.begin());
  for (std::size_t j = 0; j < joints_.size(); ++j) begin(j);
  load_modes();
  if (damped_) {
    begin_dampers();
    load_modes();
  }
  load_ = end_load_;
  load_slope_ = end_load_slope_;
  q_ = end_q_;
  v_ = end_v_;
  begin_accelerations();
  const MarchEnergy energy = this->energy();
  initial_energy_ = energy.kinetic + energy.elastic + energy.joint_stored();
}

// ---- The equations of a step. ----

void MarchState::couple(const StepWeights& weights, Couplings& couplings) const {
  if (couplings.length == weights.length()) return;
  couplings.length = weights.length();
  const std::size_t lanes = joint_groups_ * kLanes;
  couplings.ends.resize(joints_.size() * march_loops::kCouplings * lanes);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    for (std::size_t l = couplings.of_others ? 0 : j; l <= j; ++l) {
      const march_loops::Coupling both = march_loops::couple(
          groups_, weights.data(), joints_[j].shape.data(), joints_[l].shape.data());
      for (std::size_t kind = 0; kind < march_loops::kCouplings; ++kind) {
        couplings.ends[(j * march_loops::kCouplings + kind) * lanes + l] = both[kind];
        couplings.ends[(l * march_loops::kCouplings + kind) * lanes + j] = both[kind];
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

void MarchState::extrapolate(double length) {
  for (Joint& joint : joints_) joint.end = extrapolated(joint.begin, joint.curvature, length);
}

/// Over a step that was solved, up to this share of it.
void MarchState::interpolate(double share, double length) {
  for (Joint& joint : joints_) {
    const Kinematics& b = joint.begin;
    Kinematics& k = joint.end;
    const StepCubic force(b.force, b.force_dot, k.force, k.force_dot, length);
    const StepCubic r(b.r, b.r_dot, k.r, k.r_dot, length);
    k.force = force.value(share);
    k.force_dot = force.slope(share) / length;
    k.r = r.value(share);
    k.r_dot = r.slope(share) / length;
  }
}

/// R, Ṙ, F and Ḟ of the joints at the end of the step, from those predicted.
bool MarchState::solve(const StepWeights& weights, Couplings& couplings, Breakpoints breakpoints) {
  const double h = weights.length();
  march_loops::predict(
      groups_, weights.data(), h,
      {q_.data(), v_.data(), load_.data(), load_slope_.data(), loads_.force.data()},
      loads_.slope.data(), predicted_q_.data(), predicted_v_.data());
  couple(weights, couplings);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto slide = march_loops::project(groups_, joints_[j].shape.data(), predicted_q_.data(),
                                            predicted_v_.data());
    predicted_slide_[j] = slide.q;
    predicted_slide_dot_[j] = slide.v;
  }
  // Changes fall by about one factor: the remainder after one is their geometric series. The factor
  // is that of steps before, mistrusted more from step to step until it is measured again.
  double before = 0.0;
  for (Joint& joint : joints_) {
    joint.path.forget();
    joint.middle = 0.0;
  }
  for (int i = 0; i < max_iterations_ && !joints_.empty(); ++i) {
    place(weights, couplings);
    const Paths paths =
        breakpoints == Breakpoints::kAllowed ? find_paths(h, couplings) : Paths::kSame;
    if (paths == Paths::kUnclear) return false;
    double change = 0.0;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      change = std::max(change, update(j, couplings, h, i >= kSettled));
    }
    last_change_ = change;
    if (!std::isfinite(change)) return false;
    // The middle is far from its place in the first round.
    if (breakpoints == Breakpoints::kAllowed) {
      last_change_ = change = std::max(change, add_inner_forces(h, i > 0, couplings));
    }
    if (paths == Paths::kOthers &&
        i < kSettled) {  // what new breakpoints add is not in this change
      before = change;
      contraction_ = 1.0;
      continue;
    }
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
  if (shortens_ || damped_ || !couplings.of_others) {
    place_by_modes(weights);
    if (damped_) accelerate(weights.length());
    return;
  }
  const std::size_t lanes = joint_groups_ * kLanes;
  std::ranges::copy(predicted_slide_, slide_.begin());
  std::ranges::copy(predicted_slide_dot_, slide_dot_.begin());
  for (std::size_t l = 0; l < joints_.size(); ++l) {
    const Joint& joint = joints_[l];
    march_loops::move_slides(
        joint_groups_, couplings.ends.data() + l * march_loops::kCouplings * lanes, joint.end.r,
        joint.end.r_dot, joint.middle, slide_.data(), slide_dot_.data());
    if (joint.path.breakpoints().empty()) continue;
    march_loops::move_slides_by_breakpoints(
        joint_groups_,
        couplings.breakpoints.data() + l * kBreakpointTerms * BreakpointWeights::kKinds * lanes,
        moments_of(joint), slide_.data(), slide_dot_.data());
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Kinematics& k = joints_[j].end;
    k.slide = k.gap = slide_[j];
    k.slide_dot = k.gap_dot = slide_dot_[j];
  }
}

void MarchState::place_by_modes(const StepWeights& weights) {
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

/// Finds where the joints turn, and where their tangents jump, on the paths to their present
/// places.
MarchState::Paths MarchState::find_paths(double length, Couplings& couplings) {
  Paths paths = Paths::kSame;
  for (Joint& joint : joints_) {
    const Kinematics& b = joint.begin;
    const std::size_t breakpoints = joint.path.breakpoints().size();
    if (!joint.path.follow({joint.hysteresis.follower(), joint.direction, b.force, joint.kink,
                            joint.compliance, kQuiet * joint.largest_gap},
                           path(joint, length))) {
      return Paths::kUnclear;
    }
    if (joint.path.breakpoints().size() == breakpoints) continue;
    paths = Paths::kOthers;
    couple_breakpoints(length, couplings);
  }
  return paths;
}

void MarchState::couple_breakpoints(double length, Couplings& couplings) {
  breakpoint_weights_.set_length(length);
  if (!couplings.of_others || couplings.breakpoint_length == length) return;
  couplings.breakpoint_length = length;
  constexpr std::size_t kEach = kBreakpointTerms * BreakpointWeights::kKinds;
  const std::size_t lanes = joint_groups_ * kLanes;
  couplings.breakpoints.resize(joints_.size() * kEach * lanes);
  std::array<double, kEach> both;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    for (std::size_t l = 0; l <= j; ++l) {
      march_loops::couple_breakpoints(groups_, breakpoint_weights_.data(), joints_[j].shape.data(),
                                      joints_[l].shape.data(), both.data());
      for (std::size_t w = 0; w < kEach; ++w) {
        couplings.breakpoints[(j * kEach + w) * lanes + l] = both[w];
        couplings.breakpoints[(l * kEach + w) * lanes + j] = both[w];
      }
    }
  }
}

/// y over the step, up to where the joint was placed.
StepQuartic MarchState::path(const Joint& joint, double length) {
  const Kinematics& b = joint.begin;
  const Kinematics& k = joint.end;
  return {{b.gap, b.gap_dot, k.gap, k.gap_dot, length}, length * length * b.gap_ddot};
}

/// F over the step by its ends.
StepCubic MarchState::force_cubic(const Joint& joint, double length) {
  const Kinematics& b = joint.begin;
  const Kinematics& k = joint.end;
  return {b.force, b.force_dot, k.force, k.force_dot, length};
}

/// Adds the excess of the forces inside of the step over the cubics through those at its ends.
/// @return the change of the force of a joint by its own motion, relative.
double MarchState::add_inner_forces(double length, bool middles, const Couplings& couplings) {
  double change = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Joint& joint = joints_[j];
    const Kinematics& k = joint.end;
    const StepCubic force = force_cubic(joint, length);
    if (!joint.path.breakpoints().empty()) {
      joint.moments =
          breakpoint_moments(joint.path.breakpoints(), force, breakpoint_weights_.terms());
      joint.middle = 0.0;
    } else if (middles && joint.direction != 0) {
      const double before = joint.middle;
      joint.middle = middle_force(joint, force, length);
      const double moved =
          own_coupling(couplings, march_loops::kCoupledAM, j) * (joint.middle - before);
      const double scale = std::max(joint.largest_force, std::abs(k.force));
      if (moved != 0.0) change = std::max(change, std::abs(joint.tangent * moved) / scale);
    }
  }
  return change;
}

/// For a step without breakpoints: F(u) in the middle, with u + cF = y by one step of Newton's
/// method from the cubic, less the cubic.
double MarchState::middle_force(const Joint& joint, const StepCubic& force, double length) {
  const double cubic = force.value(0.5);
  const auto [found, tangent] = joint.hysteresis.follower().response(
      path(joint, length).value(0.5) - joint.compliance * cubic);
  return (found - cubic) / (1.0 + tangent * joint.compliance);
}

/// ÿ of the joints at the end of a step, after this length, from the loads on the modes there.
void MarchState::accelerate(double length) {
  for (std::size_t i = 0; i < end_a_.size(); ++i) {
    end_force_[i] = loads_.force[i] + length * loads_.slope[i];
  }
  march_loops::accelerate(groups_, stiffness_.data(), damping_.data(), end_load_.data(),
                          end_force_.data(), end_q_.data(), end_v_.data(), end_a_.data());
  for (Joint& joint : joints_) {
    double sum = march_loops::dot(groups_, joint.shape.data(), end_a_.data());
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
  if (joint.damper == 0.0) return;
  const double soft = 1.0 + joint.compliance * tangent;
  k.u_ddot = k.gap_ddot / soft;
  k.u_dot = (k.gap_dot - joint.compliance * joint.damper * k.u_ddot) / soft;
}

/// One step of Newton's method for R and Ṙ of a joint, its effect on others and by shortening is
/// left to the next round: that is small where the step is.
/// @return the relative change.
double MarchState::update(std::size_t j, const Couplings& couplings, double length, bool settled) {
  ++evaluations_;
  Joint& joint = joints_[j];
  Kinematics& k = joint.end;
  const double c = joint.compliance;
  const double load = normal_load(j, length);
  if (!std::isfinite(k.gap - c * k.force)) return HUGE_VAL;
  const double u = k.gap - c * k.force;
  const auto [force, new_tangent] = joint.path.breakpoints().empty()
                                        ? joint.hysteresis.trial(u, load)
                                        : joint.path.follower().response(u);
  if (!settled) joint.tangent = new_tangent;
  const double tangent = joint.tangent;
  // A division on the critical path, while most joints have nothing in series.
  const double soft = c == 0.0 ? 1.0 : 1.0 / (1.0 + tangent * c);
  const double stiffness = tangent * soft;  // with what is in series
  drive_damper(joint, tangent, k);
  const double damped = joint.damper * k.u_dot;
  const double damped_dot = joint.damper * k.u_ddot;
  const double in_series = (force + damped + tangent * c * k.force) * soft;
  const double beyond = stiffness - joint.spring;
  const double a = own_coupling(couplings, march_loops::kCoupledA1, j);
  const double d = own_coupling(couplings, march_loops::kCoupledD1, j);
  const double by_force = 1.0 / (1.0 + beyond * a);
  const double by_slope = 1.0 / (1.0 + beyond * d);
  const double dr = (in_series - joint.spring * k.slide - k.r) * by_force;
  const double dslide = -a * dr;
  const double kept_velocity = -own_coupling(couplings, march_loops::kCoupledC1, j) * dr;
  const double dr_dot = (stiffness * k.gap_dot + damped_dot - joint.spring * k.slide_dot - k.r_dot +
                         beyond * kept_velocity) *
                        by_slope;
  const double dvelocity = kept_velocity - d * dr_dot;
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

/// Loads of the joints on the modes at the end of the step.
void MarchState::load_modes() {
  double kept = 0.0;
  for (const Joint& joint : joints_) {
    const Kinematics& k = joint.end;
    if (joint.gamma.empty()) {
      march_loops::add_loads(groups_, kept, joint.shape.data(), k.r, k.r_dot, joint.middle,
                             end_load_.data(), end_load_slope_.data(), end_load_middle_.data());
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
                       end_load_.data(), end_load_slope_.data(), end_load_middle_.data(),
                       end_q_.data(), end_v_.data());
  for (const Joint& joint : joints_) {
    if (joint.path.breakpoints().empty()) continue;
    march_loops::add_breakpoints(groups_, breakpoint_weights_.data(), joint.shape.data(),
                                 moments_of(joint), end_q_.data(), end_v_.data());
  }
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
