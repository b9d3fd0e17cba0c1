// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace microslip {

/// Any other JSON value, as text.
struct JsonText {
  std::string text;  ///< of the value, as JSON writes it

  /// Member by member.
  friend bool operator==(const JsonText&, const JsonText&) = default;
};

/// One of NamedValues.
using NamedValue = std::variant<double, std::string, std::vector<double>, JsonText>;

/// Named values in their order. Names of quantities end in their unit, as in `covered_to_N`.
using NamedValues = std::vector<std::pair<std::string, NamedValue>>;

/// An input of a computation.
struct InputHash {
  std::string file;    ///< its name, as given
  std::string sha256;  ///< of its content, hexadecimal

  /// Member by member.
  friend bool operator==(const InputHash&, const InputHash&) = default;
};

/// How a file came to be. No clock time: the same call on the same inputs writes the same bytes.
struct Provenance {
  std::string program = "microslip";  ///< of the microslip that wrote it
  std::string version;                ///< that wrote the file
  std::string command;                ///< the call as it was typed
  std::vector<InputHash> inputs;      ///< the files that were read
  NamedValues options;                ///< what was in force, the defaults included
  std::optional<std::uint64_t> seed;  ///< of the random numbers; nothing where there are none
  NamedValues other;                  ///< what else a file says

  /// Member by member.
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

}  // namespace microslip
