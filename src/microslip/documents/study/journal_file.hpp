// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Journals: what a long computation has finished, block by block, so that an interruption costs
/// only the blocks in work.
///
///     microslip.journal/1\n
///     <length of the heading, decimal>\n<heading>
///     then blocks, one behind the other: number and size, 8 bytes each, least first;
///     the first 16 hexadecimal digits of the SHA-256 of both and the content; the content
///
/// A block whose check sum is wrong does not count; what follows a size that is beyond the file
/// does not either: a stop may have torn it. Of two blocks of one number, which are the same, the
/// first counts.

namespace microslip {

/// Where a block lies.
struct JournalBlock {
  std::uint64_t number = 0;  ///< as it was appended with
  std::uint64_t offset = 0;  ///< of its content, bytes
  std::uint64_t size = 0;    ///< of its content, bytes
};

/// A journal as it was when it was opened. Several threads may read its blocks.
class JournalReader {
 public:
  /// @throws FileError    where it cannot be read.
  /// @throws FormatError  where it is not a journal, or its heading is incomplete.
  explicit JournalReader(const std::string& path);
  ~JournalReader();
  /// Takes over the file of another one.
  JournalReader(JournalReader&& other) noexcept;
  JournalReader& operator=(JournalReader&&) = delete;

  /// Heading: what the blocks belong to.
  [[nodiscard]] const std::string& heading() const;
  /// The blocks that are whole, by rising number, each once.
  [[nodiscard]] const std::vector<JournalBlock>& blocks() const;
  /// Where the last whole block ends, bytes.
  [[nodiscard]] std::uint64_t end() const;
  /// Its path, as given.
  [[nodiscard]] const std::string& path() const;
  /// The content of one of blocks(). @throws FileError  where it cannot be read any more.
  [[nodiscard]] std::string content(const JournalBlock& block) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A journal to go on with. While it lives, no other process can open it so; nor do two that begin
/// at once, where the file system has locks.
class JournalWriter {
 public:
  /// Opens the journal and cuts off what is not whole at its end; makes it where it is not there or
  /// empty.
  /// @param path     of the file; it need not exist.
  /// @param heading  of a new one. That of an old one is not compared.
  /// @throws FileError    where it cannot be written, or another process has it.
  /// @throws FormatError  where something else stands there.
  JournalWriter(const std::string& path, std::string_view heading);
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// Whether other processes are kept from it; not where the file system has no locks.
  [[nodiscard]] bool is_locked() const;

  /// @param number   of the block. @param content  of it.
  /// @throws WriteError  where the disk does not take all of it: then nothing of it is left.
  void append(std::uint64_t number, std::string_view content);

  /// Brings what was appended to the disk, in case of a power cut. @throws WriteError
  void sync();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Name of the journal of a result: `OUT.journal`, of a share `OUT.SHARE.journal`.
/// @param out    path of the result. @param share  "3-of-20"; empty for one that is no share.
[[nodiscard]] std::string journal_path(const std::string& out, const std::string& share);

/// The journals of a result that are there, and not empty, by name.
/// @param out  path of the result.
[[nodiscard]] std::vector<std::string> journals_beside(const std::string& out);

/// Removes a journal that has served; one that cannot be removed stays.
void remove_journal(const std::string& path);

}  // namespace microslip
