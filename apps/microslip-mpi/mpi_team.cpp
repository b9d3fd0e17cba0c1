// SPDX-License-Identifier: MIT
#include "mpi_team.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstring>
#include <numeric>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip::app {
namespace {

/// From rank 0: a block to do, or the end. To it: what a block gave, what went wrong, the end.
enum Tag : int { kBlock = 1, kEnd, kStop, kResult, kFailure, kLeft };

constexpr std::chrono::microseconds kPause{200};

void pause() { std::this_thread::sleep_for(kPause); }

struct Message {
  int tag;
  int rank;
  std::string bytes;
};

/// A message that has come, of any rank and kind.
std::optional<Message> take_message() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_TAG, status.MPI_SOURCE,
                  std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, message.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

Message wait_for_message() {
  for (;;) {
    if (std::optional<Message> message = take_message()) return *std::move(message);
    pause();
  }
}

/// A few bytes, which MPI takes at once.
void send_order(int rank, Tag tag, std::uint64_t block = 0) {
  std::array<char, sizeof block> bytes{};
  std::memcpy(bytes.data(), &block, sizeof block);
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

std::uint64_t block_of(const std::string& bytes) {
  std::uint64_t block = 0;
  std::memcpy(&block, bytes.data(), sizeof block);
  return block;
}

/// "rank 3 on node07".
std::string name_of_process(int rank) {
  std::array<char, MPI_MAX_PROCESSOR_NAME + 1> host{};
  int size = 0;
  MPI_Get_processor_name(host.data(), &size);
  return fmt::format("rank {} on {}", rank, host.data());
}

/// The first line of one text that the other has not.
std::string first_difference(const std::string& text, const std::string& other) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (("\n" + other).find("\n" + line + "\n") == std::string::npos) return line;
  }
  return "something that rank 0 does not have";
}

}  // namespace

/// Rank 0: deals blocks and collects their results.
class MpiTeam::Dealer {
 public:
  Dealer(int ranks, const std::vector<std::uint64_t>& blocks, const Receive& receive)
      : blocks_(blocks),
        receive_(receive),
        in_hand_(static_cast<std::size_t>(ranks), 0),
        ended_(static_cast<std::size_t>(ranks), false) {
    for (std::size_t rank = 1; rank < ended_.size(); ++rank) give(rank);
  }

  /// Does blocks and answers until all others have left.
  void run(const Work& work) {
    while (!stopped_ && next_ < blocks_.size()) {
      const std::uint64_t block = blocks_[next_++];
      const std::string done = work(block, [this] { answer(); });
      if (!stopped_ && !receive_(block, done)) stop();
      answer();
    }
    see_off();
    if (!failure_.empty()) throw Error(failure_);
  }

  /// Has all others leave, whatever they do: something went wrong here.
  void abandon() noexcept {
    stop();
    see_off();
  }

 private:
  /// A block in reserve while there is one for each and more to come.
  void give(std::size_t rank) {
    const std::size_t wanted = blocks_.size() - next_ > 2 * ended_.size() ? 2 : 1;
    for (; in_hand_[rank] < wanted && next_ < blocks_.size(); ++in_hand_[rank]) {
      send_order(static_cast<int>(rank), kBlock, blocks_[next_++]);
    }
    if (in_hand_[rank] == 0) end(rank, kEnd);
  }

  void end(std::size_t rank, Tag tag) {
    if (ended_[rank]) return;
    ended_[rank] = true;
    send_order(static_cast<int>(rank), tag);
  }

  void stop() {
    if (stopped_) return;
    stopped_ = true;
    for (std::size_t rank = 1; rank < ended_.size(); ++rank) end(rank, kStop);
  }

  /// Answers until all others have left.
  void see_off() {
    while (left_ < ended_.size()) {
      answer();
      pause();
    }
  }

  void answer() {
    while (const std::optional<Message> message = take_message()) {
      if (message->tag == kLeft) {
        ++left_;
      } else if (message->tag == kFailure) {
        if (failure_.empty()) failure_ = message->bytes;
        stop();
      } else {
        take_result(*message);
      }
    }
  }

  void take_result(const Message& message) {
    const auto rank = static_cast<std::size_t>(message.rank);
    --in_hand_[rank];
    if (stopped_) return;
    if (!receive_(block_of(message.bytes), message.bytes.substr(sizeof(std::uint64_t)))) {
      return stop();
    }
    give(rank);
  }

  const std::vector<std::uint64_t>& blocks_;
  const Receive& receive_;
  std::vector<std::size_t> in_hand_;  ///< blocks that a rank has, one in work among them
  std::vector<bool> ended_;           ///< one per rank: it was notified that nothing follows
  std::size_t next_ = 0;
  std::size_t left_ = 1;  ///< ranks that have left; this one stays to the end
  bool stopped_ = false;
  std::string failure_;
};

/// Another rank: does the blocks it receives.
class MpiTeam::Worker {
 public:
  explicit Worker(int rank) : rank_(rank) {}

  void run(const Work& work) {
    while (!leaving_) {
      if (queue_.empty() && !last_) {
        obey(wait_for_message());
      } else if (queue_.empty()) {
        leaving_ = true;
      } else {
        do_next(work);
      }
    }
    wait_for_sends();
    send_order(0, kLeft);
  }

 private:
  struct Sending {
    MPI_Request request;
    std::string bytes;
  };

  void obey(const Message& order) {
    if (order.tag == kBlock) queue_.push_back(block_of(order.bytes));
    if (order.tag == kEnd) last_ = true;
    if (order.tag != kStop) return;
    queue_.clear();
    last_ = true;
  }

  /// Orders that have come, and results that have gone.
  void look() {
    while (const std::optional<Message> order = take_message()) obey(*order);
    while (!sending_.empty()) {
      int gone = 0;
      MPI_Test(&sending_.front().request, &gone, MPI_STATUS_IGNORE);
      if (gone == 0) return;
      sending_.pop_front();
    }
  }

  void do_next(const Work& work) {
    const std::uint64_t block = queue_.front();
    queue_.pop_front();
    std::string bytes(reinterpret_cast<const char*>(&block), sizeof block);
    try {
      bytes += work(block, [this] { look(); });
      send(kResult, std::move(bytes));
    } catch (const std::exception& error) {
      send(kFailure, fmt::format("{}: {}", name_of_process(rank_), error.what()));
      queue_.clear();
    }
    look();
  }

  void send(Tag tag, std::string bytes) {
    Sending& one = sending_.emplace_back(Sending{MPI_REQUEST_NULL, std::move(bytes)});
    MPI_Isend(one.bytes.data(), static_cast<int>(one.bytes.size()), MPI_BYTE, 0, tag,
              MPI_COMM_WORLD, &one.request);
  }

  void wait_for_sends() {
    while (!sending_.empty()) {
      look();
      if (!sending_.empty()) pause();
    }
  }

  int rank_;
  bool last_ = false;  ///< nothing follows what is in the queue
  bool leaving_ = false;
  std::deque<std::uint64_t> queue_;
  std::deque<Sending> sending_;
};

MpiTeam::MpiTeam() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

void MpiTeam::agree(const std::string& text, const std::string& failure) {
  // A rank sends "!" and why it cannot take part, or "=" and what differs from the text of rank 0,
  // if anything; after the name of the process. The message is short, however large the inputs.
  auto length = static_cast<std::uint64_t>(text.size());
  MPI_Bcast(&length, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  std::string first = text;
  first.resize(length);
  MPI_Bcast(first.data(), static_cast<int>(length), MPI_BYTE, 0, MPI_COMM_WORLD);
  std::string reply = "!" + failure;
  if (failure.empty())
    reply = "=" + (coordinates() || text == first ? "" : first_difference(text, first));
  constexpr std::size_t kLongestReply = 1000;
  const std::string sent = name_of_process(rank_) + "\n" + reply.substr(0, kLongestReply);
  const int size = static_cast<int>(sent.size());
  std::vector<int> sizes(static_cast<std::size_t>(size_));
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::vector<int> starts(sizes.size());
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::string all(coordinates() ? static_cast<std::size_t>(starts.back() + sizes.back()) : 0, '\0');
  MPI_Gatherv(sent.data(), size, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE, 0,
              MPI_COMM_WORLD);
  std::optional<InputError> fault;
  for (std::size_t rank = 1; coordinates() && failure.empty() && !fault && rank < sizes.size();
       ++rank) {
    const std::string one =
        all.substr(static_cast<std::size_t>(starts[rank]), static_cast<std::size_t>(sizes[rank]));
    const std::size_t end = one.find('\n');
    const std::string rest = one.substr(end + 2);
    if (one[end + 1] == '!') {
      fault.emplace(one.substr(0, end), in_quotes(rest, 400), "must be able to take part");
    } else if (!rest.empty()) {
      fault.emplace(one.substr(0, end), in_quotes(rest, 300), "must have the same inputs as rank 0",
                    "Have all ranks read the same files.");
    }
  }
  int go_on = failure.empty() && !fault ? 1 : 0;
  MPI_Bcast(&go_on, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if (fault) throw *fault;
  if (go_on == 0 && !coordinates()) throw StoppedElsewhere();
}

void MpiTeam::deal(const std::vector<std::uint64_t>& blocks, const Work& work,
                   const Receive& receive) {
  if (!coordinates()) return Worker(rank_).run(work);
  Dealer dealer(size_, blocks, receive);
  try {
    dealer.run(work);
  } catch (...) {
    dealer.abandon();
    throw;
  }
}

}  // namespace microslip::app
