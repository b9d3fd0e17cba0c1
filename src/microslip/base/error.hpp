// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

/// @file
/// The errors of microslip. A message is one line that names the place, the value found, the rule
/// it breaks and, where there is one, the remedy. The library throws these and never prints or
/// aborts. Not converging is no error: a numerical method reports that in its Result.
///
/// A message quotes an option of the caller in back quotes, the name with underscores and a value
/// behind it: `assume_units force=N`. A program shows it as it spells its options.

namespace microslip {

/// Base of all errors that microslip throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The state of an argument that has no value to show: "missing", "complex".
struct InputState {
  std::string_view text;  ///< after "is"
};

/// A value given by the caller breaks a rule: "what = value; rule. remedy".
class InputError : public Error {
 public:
  /// @param what    the name of the argument or key as the caller knows it, for instance
  ///                `stiffness_N_per_m`.
  /// @param value   the offending value.
  /// @param rule    the rule it breaks, without a full stop: "must be positive and finite".
  /// @param remedy  what to do about it, a sentence; may be empty.
  InputError(std::string_view what, double value, std::string_view rule,
             std::string_view remedy = {});
  /// As above, for a value that is a text.
  InputError(std::string_view what, std::string_view value, std::string_view rule,
             std::string_view remedy = {});
  /// "what is missing; rule. remedy".
  InputError(std::string_view what, InputState state, std::string_view rule,
             std::string_view remedy = {});

  /// The name of the argument or key.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// The same error under another name: that of the key in a file, for instance.
  [[nodiscard]] InputError renamed(std::string_view name) const;

 private:
  std::string name_;
};

/// A place in a text: 1-based line and column; 0 where it is not known.
struct TextPlace {
  std::string file;        ///< its name; empty where it has none
  std::size_t line = 0;    ///< from 1
  std::size_t column = 0;  ///< from 1
};

/// The start of a message: "levels.csv:12:3", without the parts that are not known; "input" for a
/// text without name.
[[nodiscard]] std::string place_text(const TextPlace& place);

/// A text does not have the form it must have: "place: expected …, found …. remedy".
class FormatError : public Error {
 public:
  /// @param place     where it is.
  /// @param expected  the form expected: "a number".
  /// @param found     the text found.
  /// @param remedy    what to do about it, a sentence; may be empty.
  FormatError(const TextPlace& place, std::string_view expected, std::string_view found,
              std::string_view remedy = {});

  /// Where it is.
  [[nodiscard]] const TextPlace& place() const { return place_; }

 private:
  TextPlace place_;
};

/// A file cannot be opened, read or written.
class FileError : public Error {
 public:
  /// @param path    the file's path.
  /// @param reason  the error of the system, for instance "permission denied".
  /// @param remedy  what to do about it, a sentence; may be empty.
  FileError(std::string_view path, std::string_view reason, std::string_view remedy = {});
};

/// The caller's progress callback asked to stop.
class Cancelled : public Error {
 public:
  Cancelled();
};

}  // namespace microslip
