// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "microslip/io/config/named_values.hpp"

/// @file
/// The members of a record as named values, internal to io and documents.

namespace microslip {

/// Writes the members of a record under their keys in the order of the calls, or reads them by
/// their keys: a function that hands over each member with its key is the only place of the key.
/// Where it reads, a key that is missing, or whose value is of another kind, leaves its member as
/// it is, and is a list without entries.
class RecordValues {
 public:
  /// Writes.
  RecordValues() = default;
  /// Reads.
  /// @param values  kept by reference.
  /// @param object  as messages call it: "joint.json: identification".
  /// @param remedy  of a record that contradicts itself, a sentence.
  RecordValues(const NamedValues& values, std::string object, std::string remedy)
      : read_(&values), object_(std::move(object)), remedy_(std::move(remedy)) {}

  /// Whether it reads.
  [[nodiscard]] bool reads() const { return read_ != nullptr; }
  /// What was written.
  [[nodiscard]] NamedValues take() { return std::move(written_); }

  /// Whether a record has the members under a key: as `written` tells, or, where it is read, by
  /// a number or a list with entries under the key.
  [[nodiscard]] bool has(std::string_view key, bool written) const;
  /// As above, of a part that a record may lack; where it is read, the part is begun.
  template <typename Part>
  [[nodiscard]] bool has(std::string_view key, std::optional<Part>& part) const {
    if (has(key, part.has_value()) && !part) part.emplace();
    return part.has_value();
  }
  /// The names that numbers have after a prefix of their keys; none where it writes.
  [[nodiscard]] std::vector<std::string> names(std::string_view prefix) const;

  void one(const std::string& key, double& value);
  /// Not written where it is not known.
  void one(const std::string& key, std::optional<double>& value);
  /// Not written where it is empty.
  void one(const std::string& key, std::string& value);
  /// One of two words.
  void one(const std::string& key, bool& value, std::string_view yes, std::string_view no);
  /// one(). @throws InputError  where it is missing.
  template <typename... Value>
  void needed(const std::string& key, Value&&... value) {
    require(key);
    one(key, value...);
  }

  void list(const std::string& key, std::vector<double>& values);
  void list(const std::string& key, std::vector<std::string>& values);
  /// @throws InputError  where there are not as many.
  template <typename Value>
  void list(const std::string& key, std::vector<Value>& values, std::size_t count) {
    list(key, values);
    check_count(key, values.size(), count, std::is_same_v<Value, double> ? "numbers" : "texts");
  }
  void pair(const std::string& key, double& first, double& second);

  /// As many rows as the list under a key has entries. A column is a list with one for each row.
  template <typename Row>
  void rows(std::string_view key, std::vector<Row>& rows) const {
    if (reads()) rows.resize(count(key));
  }
  /// A number or a text of each row. @param member  of a row, or a function that refers to it.
  template <typename Row, typename Member>
  void column(const std::string& key, std::vector<Row>& rows, Member member) {
    std::vector<std::decay_t<std::invoke_result_t<Member, Row&>>> values;
    for (Row& row : rows) values.push_back(std::invoke(member, row));
    list(key, values, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) std::invoke(member, rows[i]) = values[i];
  }
  /// One of two words of each row.
  template <typename Row, typename Member>
  void column(const std::string& key, std::vector<Row>& rows, Member member, std::string_view yes,
              std::string_view no) {
    std::vector<std::string> words;
    for (Row& row : rows) words.emplace_back(std::invoke(member, row) ? yes : no);
    list(key, words, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) std::invoke(member, rows[i]) = words[i] == yes;
  }
  /// A place of each row among `count` of `what`: from 0 in the record, from 1 in the values.
  /// @throws InputError  where one is not a whole number from 1 to `count`.
  template <typename Row>
  void places(const std::string& key, std::vector<Row>& rows, std::size_t Row::*member,
              std::size_t count, std::string_view what) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(static_cast<double>(row.*member + 1));
    list(key, values, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].*member = place(key, values[i], count, what);
    }
  }

 private:
  [[nodiscard]] std::size_t count(std::string_view key) const;
  [[nodiscard]] std::size_t place(std::string_view key, double value, std::size_t count,
                                  std::string_view what) const;
  void require(std::string_view key) const;
  void check_count(std::string_view key, std::size_t found, std::size_t expected,
                   const char* items) const;

  const NamedValues* read_ = nullptr;  // null where it writes
  NamedValues written_;
  std::string object_;
  std::string remedy_;
};

}  // namespace microslip
