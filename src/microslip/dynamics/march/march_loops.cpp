// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_loops.hpp"

#include "microslip/base/vector_clones.hpp"
#include "microslip/dynamics/march/march_weights.hpp"
#include "microslip/dynamics/march/step_breakpoints.hpp"
#include "microslip/dynamics/march/step_quadrature.hpp"

namespace microslip::march_loops {
namespace {

double sum_of(const double (&lanes)[kLanes]) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

constexpr std::size_t kGroup = StepWeights::kKinds * kLanes;

}  // namespace

MICROSLIP_VECTOR_CLONES
void predict(std::size_t groups, const double* weights, double length, const State& from,
             const double* slope, double* q, double* v) {
  using W = StepWeights;
  const State s = from;
  for (std::size_t group = 0; group < groups; ++group) {
    const double* w = weights + group * kGroup;
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      const double load = s.joint_load[i] + s.force[i];
      const double load_slope = s.joint_slope[i] + slope[i];
      const double end = s.force[i] + length * slope[i];
      // Pairs, which do not wait for each other.
      q[i] =
          ((w[W::kE11 * kLanes + j] * s.displacement[i] + w[W::kE12 * kLanes + j] * s.velocity[i]) +
           (w[W::kA0 * kLanes + j] * load + w[W::kB0 * kLanes + j] * load_slope)) +
          (w[W::kA1 * kLanes + j] * end + w[W::kB1 * kLanes + j] * slope[i]);
      v[i] =
          ((w[W::kE21 * kLanes + j] * s.displacement[i] + w[W::kE22 * kLanes + j] * s.velocity[i]) +
           (w[W::kC0 * kLanes + j] * load + w[W::kD0 * kLanes + j] * load_slope)) +
          (w[W::kC1 * kLanes + j] * end + w[W::kD1 * kLanes + j] * slope[i]);
    }
  }
}

MICROSLIP_VECTOR_CLONES
void add_force(std::size_t groups, double kept, const double* shape, double value, double slope,
               double* force, double* force_slope) {
#pragma omp simd
  for (std::size_t i = 0; i < groups * kLanes; ++i) {
    force[i] = kept * force[i] + value * shape[i];
    force_slope[i] = kept * force_slope[i] + slope * shape[i];
  }
}

MICROSLIP_VECTOR_CLONES
void add_loads(std::size_t groups, double kept, const double* shape, double r, double r_dot,
               double r_middle, double* load, double* slope, double* middle) {
#pragma omp simd
  for (std::size_t i = 0; i < groups * kLanes; ++i) {
    load[i] = kept * load[i] - r * shape[i];
    slope[i] = kept * slope[i] - r_dot * shape[i];
    middle[i] = kept * middle[i] - r_middle * shape[i];
  }
}

MICROSLIP_VECTOR_CLONES
void add_shortening_loads(std::size_t groups, double kept, const double* shape, double r,
                          double r_dot, const double* g, const double* g_dot, double force,
                          double force_dot, double* load, double* slope) {
#pragma omp simd
  for (std::size_t i = 0; i < groups * kLanes; ++i) {
    load[i] = kept * load[i] - r * shape[i] + g[i] * force;
    slope[i] = kept * slope[i] - r_dot * shape[i] + g[i] * force_dot + g_dot[i] * force;
  }
}

MICROSLIP_VECTOR_CLONES
void correct(std::size_t groups, const double* weights, const double* predicted_q,
             const double* predicted_v, const double* load, const double* slope,
             const double* middle, double* q, double* v) {
  using W = StepWeights;
  for (std::size_t group = 0; group < groups; ++group) {
    const double* w = weights + group * kGroup;
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      q[i] = predicted_q[i] + w[W::kA1 * kLanes + j] * load[i] + w[W::kB1 * kLanes + j] * slope[i] +
             w[W::kAM * kLanes + j] * middle[i];
      v[i] = predicted_v[i] + w[W::kC1 * kLanes + j] * load[i] + w[W::kD1 * kLanes + j] * slope[i] +
             w[W::kCM * kLanes + j] * middle[i];
    }
  }
}

MICROSLIP_VECTOR_CLONES
void accelerate(std::size_t groups, const double* stiffness, const double* damping,
                const double* load, const double* force, const double* q, const double* v,
                double* a) {
#pragma omp simd
  for (std::size_t i = 0; i < groups * kLanes; ++i) {
    a[i] = load[i] + force[i] - damping[i] * v[i] - stiffness[i] * q[i];
  }
}

MICROSLIP_VECTOR_CLONES
double dot(std::size_t groups, const double* shape, const double* a) {
  double lanes[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      lanes[j] += shape[group * kLanes + j] * a[group * kLanes + j];
    }
  }
  return sum_of(lanes);
}

MICROSLIP_VECTOR_CLONES
Pair project(std::size_t groups, const double* shape, const double* q, const double* v) {
  double q_lanes[kLanes] = {};
  double v_lanes[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      q_lanes[j] += shape[i] * q[i];
      v_lanes[j] += shape[i] * v[i];
    }
  }
  return {sum_of(q_lanes), sum_of(v_lanes)};
}

MICROSLIP_VECTOR_CLONES
Pair shorten(std::size_t groups, const double* gamma, const double* q, const double* v, double* g,
             double* g_dot) {
  const std::size_t modes = groups * kLanes;
  double q_lanes[kLanes] = {};
  double v_lanes[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
    double sum[kLanes] = {};
    double sum_dot[kLanes] = {};
    for (std::size_t r = 0; r < modes; ++r) {
      const double* row = gamma + r * modes + group * kLanes;
#pragma omp simd
      for (std::size_t j = 0; j < kLanes; ++j) {
        sum[j] += row[j] * q[r];
        sum_dot[j] += row[j] * v[r];
      }
    }
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      g[i] = sum[j];
      g_dot[i] = sum_dot[j];
      q_lanes[j] += sum[j] * q[i];
      v_lanes[j] += sum[j] * v[i];
    }
  }
  return {sum_of(q_lanes), sum_of(v_lanes)};
}

MICROSLIP_VECTOR_CLONES
Coupling couple(std::size_t groups, const double* weights, const double* shape,
                const double* other) {
  using W = StepWeights;
  double a[kLanes] = {};
  double b[kLanes] = {};
  double a_middle[kLanes] = {};
  double c[kLanes] = {};
  double d[kLanes] = {};
  double c_middle[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
    const double* w = weights + group * kGroup;
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      const double product = shape[i] * other[i];
      a[j] += w[W::kA1 * kLanes + j] * product;
      b[j] += w[W::kB1 * kLanes + j] * product;
      c[j] += w[W::kC1 * kLanes + j] * product;
      d[j] += w[W::kD1 * kLanes + j] * product;
      a_middle[j] += w[W::kAM * kLanes + j] * product;
      c_middle[j] += w[W::kCM * kLanes + j] * product;
    }
  }
  return {sum_of(a), sum_of(b), sum_of(a_middle), sum_of(c), sum_of(d), sum_of(c_middle)};
}

MICROSLIP_VECTOR_CLONES
void move_slides(std::size_t groups, const double* coupling, double r, double r_dot,
                 double r_middle, double* slide, double* slide_dot) {
  const std::size_t lanes = groups * kLanes;
#pragma omp simd
  for (std::size_t j = 0; j < lanes; ++j) {
    slide[j] -= coupling[kCoupledA1 * lanes + j] * r + coupling[kCoupledB1 * lanes + j] * r_dot +
                coupling[kCoupledAM * lanes + j] * r_middle;
    slide_dot[j] -= coupling[kCoupledC1 * lanes + j] * r +
                    coupling[kCoupledD1 * lanes + j] * r_dot +
                    coupling[kCoupledCM * lanes + j] * r_middle;
  }
}

MICROSLIP_VECTOR_CLONES
void move_slides_by_breakpoints(std::size_t groups, const double* coupling,
                                std::span<const double> moments, double* slide, double* slide_dot) {
  const std::size_t lanes = groups * kLanes;
  for (std::size_t group = 0; group < groups; ++group) {
    double sum[kLanes] = {};
    double sum_dot[kLanes] = {};
    for (std::size_t m = 0; m < moments.size(); ++m) {
      const double* by = coupling + m * BreakpointWeights::kKinds * lanes + group * kLanes;
      const double moment = moments[m];
#pragma omp simd
      for (std::size_t j = 0; j < kLanes; ++j) {
        sum[j] += moment * by[BreakpointWeights::kOfDisplacement * lanes + j];
        sum_dot[j] += moment * by[BreakpointWeights::kOfVelocity * lanes + j];
      }
    }
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      slide[group * kLanes + j] -= sum[j];
      slide_dot[group * kLanes + j] -= sum_dot[j];
    }
  }
}

MICROSLIP_VECTOR_CLONES
void add_breakpoints(std::size_t groups, const double* weights, const double* shape,
                     std::span<const double> moments, double* q, double* v) {
  for (std::size_t group = 0; group < groups; ++group) {
    double q_sum[kLanes] = {};
    double v_sum[kLanes] = {};
    for (std::size_t m = 0; m < moments.size(); ++m) {
      const double* w =
          weights + (group * kBreakpointTerms + m) * BreakpointWeights::kKinds * kLanes;
      const double moment = moments[m];
#pragma omp simd
      for (std::size_t j = 0; j < kLanes; ++j) {
        q_sum[j] += moment * w[BreakpointWeights::kOfDisplacement * kLanes + j];
        v_sum[j] += moment * w[BreakpointWeights::kOfVelocity * kLanes + j];
      }
    }
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      q[i] -= shape[i] * q_sum[j];
      v[i] -= shape[i] * v_sum[j];
    }
  }
}

MICROSLIP_VECTOR_CLONES
void couple_breakpoints(std::size_t groups, const double* weights, const double* shape,
                        const double* other, double* coupling) {
  constexpr std::size_t kEach = kBreakpointTerms * BreakpointWeights::kKinds;
  for (std::size_t w = 0; w < kEach; ++w) {
    double lanes[kLanes] = {};
    for (std::size_t group = 0; group < groups; ++group) {
#pragma omp simd
      for (std::size_t j = 0; j < kLanes; ++j) {
        const std::size_t i = group * kLanes + j;
        lanes[j] += weights[(group * kEach + w) * kLanes + j] * shape[i] * other[i];
      }
    }
    coupling[w] = sum_of(lanes);
  }
}

MICROSLIP_VECTOR_CLONES
Energies inner_energies(std::size_t groups, double length, const double* weights,
                        const double* damping, const State& from, const State& to,
                        const double* slope, const double* middle, const double* breakpoints) {
  using Q = StepQuadrature;
  const State a = from;
  const State b = to;
  double input[kLanes] = {};
  double loss[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
    const double* w = weights + group * kInnerPoints * Q::kKinds * kLanes;
    double work[kLanes];
    double square[kLanes];
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      const double v0 = a.velocity[i];
      const double v1 = b.velocity[i];
      work[j] = kEndWeight * (a.force[i] * v0 + b.force[i] * v1);
      square[j] = kEndWeight * (v0 * v0 + v1 * v1);
    }
    for (std::size_t point = 0; point < kInnerPoints; ++point, w += Q::kKinds * kLanes) {
      const double time = length * kInnerPoint[point];
      const double weight = kInnerWeight[point];
#pragma omp simd
      for (std::size_t j = 0; j < kLanes; ++j) {
        const std::size_t i = group * kLanes + j;
        // Pairs, which do not wait for each other.
        const double v =
            ((w[Q::kE21 * kLanes + j] * a.displacement[i] +
              w[Q::kE22 * kLanes + j] * a.velocity[i]) +
             (w[Q::kC0 * kLanes + j] * (a.joint_load[i] + a.force[i]) +
              w[Q::kD0 * kLanes + j] * (a.joint_slope[i] + slope[i]))) +
            ((w[Q::kC1 * kLanes + j] * (b.joint_load[i] + b.force[i]) +
              w[Q::kD1 * kLanes + j] * (b.joint_slope[i] + slope[i])) +
             (w[Q::kCM * kLanes + j] * middle[i] +
              w[Q::kOfBreakpoints * kLanes + j] * breakpoints[point * groups * kLanes + i]));
        work[j] += weight * v * (a.force[i] + time * slope[i]);
        square[j] += weight * v * v;
      }
    }
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      input[j] += length * work[j];
      loss[j] += length * damping[group * kLanes + j] * square[j];
    }
  }
  return {sum_of(input), sum_of(loss)};
}

MICROSLIP_VECTOR_CLONES
Energies step_energies(std::size_t groups, double length, const double* stiffness,
                       const double* damping, const State& from, const State& to,
                       const double* slope) {
  const State a = from;
  const State b = to;
  const double half = 0.5 * length;
  const double twelfth = length * length / 12.0;
  double input[kLanes] = {};
  double loss[kLanes] = {};
  for (std::size_t group = 0; group < groups; ++group) {
#pragma omp simd
    for (std::size_t j = 0; j < kLanes; ++j) {
      const std::size_t i = group * kLanes + j;
      const double v0 = a.velocity[i];
      const double v1 = b.velocity[i];
      const double q0 = a.displacement[i];
      const double q1 = b.displacement[i];
      const double a0 = a.joint_load[i] + a.force[i] - damping[i] * v0 - stiffness[i] * q0;
      const double a1 = b.joint_load[i] + b.force[i] - damping[i] * v1 - stiffness[i] * q1;
      loss[j] += damping[i] * (half * (v0 * v0 + v1 * v1) + 2.0 * twelfth * (v0 * a0 - v1 * a1));
      input[j] +=
          b.force[i] * q1 - a.force[i] * q0 - slope[i] * (half * (q0 + q1) + twelfth * (v0 - v1));
    }
  }
  return {sum_of(input), sum_of(loss)};
}

}  // namespace microslip::march_loops
