// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "microslip/base/error.hpp"

/// @file Messages of calls that fail.

namespace microslip::test {

/// The message of the error of class E that the call throws; `none` where it throws none.
template <class E = InputError, class Call>
std::string message_or(const std::string& none, const Call& call) {
  try {
    (void)call();
  } catch (const E& error) {
    return error.what();
  }
  return none;
}

inline void expect_message(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "'" << message << "' has no '" << part << "'";
}

}  // namespace microslip::test
