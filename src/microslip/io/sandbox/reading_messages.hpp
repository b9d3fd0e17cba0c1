// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/error.hpp"
#include "microslip/io/sandbox/parcel.hpp"

/// @file
/// Messages of a reading process, see reading_process.hpp. Internal to io.

namespace microslip {

/// Precedes each message: how far it is; what was read, then kEnd; an error, then kEnd.
enum class ReadingMessage : char { kProgress = 'p', kResult = 'r', kError = 'e', kEnd = 'd' };

enum class ReadingErrorKind : char { kOfInput, kOfFormat, kOfFile, kOfMemory, kOther };

/// An error of the reading process, to be thrown again by the one that started it.
struct ReadingError {
  ReadingErrorKind kind = ReadingErrorKind::kOther;
  std::string text = {};
  std::string name = {};  ///< of an InputError
  TextPlace place = {};   ///< of a FormatError
};

template <class Parcel>
void pass(Parcel& parcel, ReadingError& error) {
  pass(parcel, error.kind);
  pass(parcel, error.text);
  pass(parcel, error.name);
  pass(parcel, error.place.file);
  pass(parcel, error.place.line);
  pass(parcel, error.place.column);
}

}  // namespace microslip
