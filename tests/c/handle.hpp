// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <microslip.h>

#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// @file What the tests of the C interface share: handles that destroy themselves.

namespace microslip::test {

/// A handle of one kind. `out()` is for the function that makes it.
template <typename T, void (*kDestroy)(T*)>
class Handle {
 public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { kDestroy(handle_); }
  operator T*() const { return handle_; }  // NOLINT: as C has it
  T** out() { return &handle_; }
  void destroy() {
    kDestroy(handle_);
    handle_ = nullptr;
  }

 private:
  T* handle_ = nullptr;
};

using CJoint = Handle<microslip_joint, microslip_joint_destroy>;
using CMemory = Handle<microslip_memory, microslip_memory_destroy>;
using CLevels = Handle<microslip_levels, microslip_levels_destroy>;
using CIdentification = Handle<microslip_identification, microslip_identification_destroy>;
using CModel = Handle<microslip_model, microslip_model_destroy>;
using CStructure = Handle<microslip_structure, microslip_structure_destroy>;
using CCurve = Handle<microslip_curve, microslip_curve_destroy>;
using CMarched = Handle<microslip_marched, microslip_marched_destroy>;

/// A struct of options with its defaults.
template <typename Options>
Options defaults(microslip_status (*fill)(Options*, std::size_t)) {
  Options options;
  EXPECT_EQ(fill(&options, sizeof options), MICROSLIP_OK) << microslip_last_error();
  return options;
}

inline std::string example(const std::string& file) {
  return std::string(MICROSLIP_EXAMPLES) + "/" + file;
}

/// Bit for bit.
inline void expect_same(const double* values, std::size_t count,
                        const std::vector<double>& expected) {
  ASSERT_EQ(count, expected.size());
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(values[i], expected[i]) << i;
}

}  // namespace microslip::test

#define EXPECT_OK(call) EXPECT_EQ(call, MICROSLIP_OK) << microslip_last_error()
#define ASSERT_OK(call) ASSERT_EQ(call, MICROSLIP_OK) << microslip_last_error()
