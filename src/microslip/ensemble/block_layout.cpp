// SPDX-License-Identifier: MIT
#include "microslip/ensemble/block_layout.hpp"

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

#include "microslip/base/little_endian.hpp"

namespace microslip {
namespace {

/// Takes pieces off the front of a block.
class BlockReader {
 public:
  explicit BlockReader(std::string_view bytes) : left_(bytes) {}

  bool take_whole(std::uint64_t& value) {
    if (left_.size() < kLittleEndianSize) return false;
    value = from_little_endian(left_);
    left_.remove_prefix(kLittleEndianSize);
    return true;
  }

  bool take_text(std::string& text, std::uint64_t size) {
    if (left_.size() < size) return false;
    text = left_.substr(0, size);
    left_.remove_prefix(size);
    return true;
  }

  [[nodiscard]] bool at_end() const { return left_.empty(); }

 private:
  std::string_view left_;
};

bool take_result(BlockReader& reader, std::size_t width, JobResult& result) {
  std::string failed;
  if (!reader.take_text(failed, 1)) return false;
  std::uint64_t bits = 0;
  if (failed[0] != '\0') return reader.take_whole(bits) && reader.take_text(result.failure, bits);
  result.values.reserve(width);
  for (std::size_t i = 0; i < width; ++i) {
    if (!reader.take_whole(bits)) return false;
    result.values.push_back(std::bit_cast<double>(bits));
  }
  return true;
}

}  // namespace

BlockLayout::BlockLayout(const std::vector<EnsembleGroup>& groups, std::uint64_t block)
    : begin_{0}, block_(block) {
  for (const EnsembleGroup& group : groups) {
    jobs_.push_back(group.jobs);
    begin_.push_back(begin_.back() + (group.jobs + block - 1) / block);
  }
}

JobRange BlockLayout::jobs_of(std::uint64_t block) const {
  const auto after = std::ranges::upper_bound(begin_, block);
  const auto group = static_cast<std::size_t>(after - begin_.begin()) - 1;
  const std::uint64_t first = (block - begin_[group]) * block_;
  return {group, first, std::min(block_, jobs_[group] - first)};
}

std::pair<std::uint64_t, std::uint64_t> BlockLayout::blocks_of(std::size_t group) const {
  return {begin_[group], begin_[group + 1]};
}

std::uint64_t usual_block(const std::vector<EnsembleGroup>& groups) {
  constexpr std::uint64_t kBlocks = 1000;
  constexpr std::uint64_t kMostJobs = 256;
  std::uint64_t jobs = 0;
  for (const EnsembleGroup& group : groups) jobs += group.jobs;
  return std::clamp<std::uint64_t>(jobs / kBlocks, 1, kMostJobs);
}

std::string block_bytes(const std::vector<JobResult>& results) {
  std::string bytes;
  for (const JobResult& result : results) {
    bytes += result.failure.empty() ? '\0' : '\1';
    if (result.failure.empty()) {
      for (const double value : result.values) {
        append_little_endian(bytes, std::bit_cast<std::uint64_t>(value));
      }
    } else {
      append_little_endian(bytes, result.failure.size());
      bytes += result.failure;
    }
  }
  return bytes;
}

std::optional<std::vector<JobResult>> block_results(const std::string& bytes, std::uint64_t jobs,
                                                    std::size_t width) {
  BlockReader reader(bytes);
  std::vector<JobResult> results(jobs);
  for (JobResult& result : results) {
    if (!take_result(reader, width, result)) return std::nullopt;
  }
  if (!reader.at_end()) return std::nullopt;
  return results;
}

}  // namespace microslip
