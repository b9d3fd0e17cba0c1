// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "microslip/io/recordings/mat_tree.hpp"
#include "microslip/io/recordings/recordings.hpp"

/// @file
/// Contents of a file as bytes of this machine, one value after the other: how a process hands over
/// what it has read to the one that started it, see reading_process.hpp. Each type has one function
/// pass(), which serves both directions.

namespace microslip {

/// Takes values; they are moved from, so that what is large does not stay in both processes.
class ParcelWriter {
 public:
  static constexpr bool kWrites = true;
  using Sink = std::function<void(const char*, std::size_t)>;
  explicit ParcelWriter(Sink sink) : sink_(std::move(sink)) {}

  void bytes(const void* data, std::size_t size) {
    if (buffer_.size() + size > kBuffer) flush();
    if (size > kBuffer) return sink_(static_cast<const char*>(data), size);
    buffer_.append(static_cast<const char*>(data), size);
  }

  void flush() {
    sink_(buffer_.data(), buffer_.size());
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kBuffer = std::size_t{1} << 16U;
  Sink sink_;
  std::string buffer_;
};

/// Gives the values again, in the same order.
class ParcelReader {
 public:
  static constexpr bool kWrites = false;
  /// Fills all of the bytes, or throws.
  using Source = std::function<void(char*, std::size_t)>;
  explicit ParcelReader(Source source) : source_(std::move(source)) {}

  void bytes(void* data, std::size_t size) { source_(static_cast<char*>(data), size); }

 private:
  Source source_;
};

/// Numbers and plain structs of them.
template <class Parcel, class Plain>
requires std::is_trivially_copyable_v<Plain>
void pass(Parcel& parcel, Plain& value) { parcel.bytes(&value, sizeof value); }

/// Texts and vectors of plain values. Memory is taken as the bytes come, as much again as came
/// before: the sender may be out of its mind.
template <class Parcel, class Block>
void pass_block(Parcel& parcel, Block& block) {
  constexpr std::size_t kFirst = std::size_t{1} << 12U;
  std::size_t size = block.size();
  pass(parcel, size);
  for (std::size_t done = 0; done < size;) {
    const std::size_t count = std::min(std::max(kFirst, done), size - done);
    if constexpr (!Parcel::kWrites) {
      block.reserve(done + count);
      block.resize(done + count);
    }
    parcel.bytes(block.data() + done, count * sizeof block[0]);
    done += count;
  }
  if constexpr (Parcel::kWrites) Block().swap(block);
}

template <class Parcel>
void pass(Parcel& parcel, std::string& text) {
  pass_block(parcel, text);
}

template <class Parcel, class A, class B>
requires(!std::is_trivially_copyable_v<std::pair<A, B>>) void pass(Parcel& parcel,
                                                                   std::pair<A, B>& pair);
template <class Parcel>
void pass(Parcel& parcel, Warning& warning);
template <class Parcel>
void pass(Parcel& parcel, Channel& channel);
template <class Parcel>
void pass(Parcel& parcel, Recording& recording);
template <class Parcel>
void pass(Parcel& parcel, LeftOutChannel& channel);
template <class Parcel>
void pass(Parcel& parcel, MatValue& value);

template <class Parcel, class Value>
void pass(Parcel& parcel, std::vector<Value>& values) {
  if constexpr (std::is_trivially_copyable_v<Value>) {
    pass_block(parcel, values);
  } else {
    std::size_t size = values.size();
    pass(parcel, size);
    for (std::size_t i = 0; i < size; ++i) {
      if constexpr (!Parcel::kWrites) values.emplace_back();
      pass(parcel, values[i]);
    }
  }
}

template <class Parcel, class A, class B>
requires(!std::is_trivially_copyable_v<std::pair<A, B>>) void pass(Parcel& parcel,
                                                                   std::pair<A, B>& pair) {
  pass(parcel, pair.first);
  pass(parcel, pair.second);
}

template <class Parcel>
void pass(Parcel& parcel, Warning& warning) {
  pass(parcel, warning.code);
  pass(parcel, warning.text);
}

template <class Parcel>
void pass(Parcel& parcel, Channel& channel) {
  pass(parcel, channel.name);
  char has_dimension = channel.dimension ? 1 : 0;
  Dimension dimension = channel.dimension.value_or(Dimension{});
  pass(parcel, has_dimension);
  pass(parcel, dimension);
  if (has_dimension != 0) channel.dimension = dimension;
  pass(parcel, channel.values);
  pass(parcel, channel.imaginary);
  pass(parcel, channel.attributes);
}

template <class Parcel>
void pass(Parcel& parcel, Recording& recording) {
  pass(parcel, recording.source);
  pass(parcel, recording.axis.dimension);
  pass(parcel, recording.axis.start);
  pass(parcel, recording.axis.step);
  pass(parcel, recording.axis.values);
  pass(parcel, recording.channels);
  pass(parcel, recording.attributes);
  pass(parcel, recording.left_out);
}

template <class Parcel>
void pass(Parcel& parcel, LeftOutChannel& channel) {
  pass(parcel, channel.name);
  pass(parcel, channel.reason);
}

template <class Parcel>
void pass(Parcel& parcel, Recordings& recordings) {
  pass(parcel, recordings.recordings);
  pass(parcel, recordings.warnings);
  char rate_used = recordings.rate_used ? 1 : 0;
  pass(parcel, rate_used);
  recordings.rate_used = rate_used != 0;
}

template <class Parcel>
void pass(Parcel& parcel, MatValue& value) {
  pass(parcel, value.kind);
  pass(parcel, value.sizes);
  pass(parcel, value.real);
  pass(parcel, value.imaginary);
  pass(parcel, value.whole.bits);
  pass(parcel, value.whole.is_signed);
  pass(parcel, value.row);
  pass(parcel, value.column_start);
  pass(parcel, value.texts);
  pass(parcel, value.fields);
  char in_order = value.in_order ? 1 : 0;
  pass(parcel, in_order);
  value.in_order = in_order != 0;
  pass(parcel, value.children);
  pass(parcel, value.other);
}

template <class Parcel>
void pass(Parcel& parcel, MatTree& tree) {
  pass(parcel, tree.root);
  char truncated = tree.truncated ? 1 : 0;
  pass(parcel, truncated);
  tree.truncated = truncated != 0;
}

}  // namespace microslip
