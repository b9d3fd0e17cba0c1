// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr std::string_view kSteps = ".([{";

/// field | (i) | {i} | [i], one after the other.
class Walk {
 public:
  Walk(MatValue& root, std::string_view path, const std::string& file)
      : place_{&root, std::nullopt}, path_(path), rest_(path), file_(file) {}

  MatPlace run() {
    if (!path_.empty()) take_field();
    while (!rest_.empty()) {
      if (rest_.front() == '.') {
        rest_.remove_prefix(1);
        take_field();
      } else {
        take_index();
      }
    }
    return place_;
  }

 private:
  [[noreturn]] void fail(std::string_view rule) const {
    throw InputError(fmt::format("{}: variable", file_), in_quotes(path_, 200), rule);
  }

  /// The path as far as it has been followed.
  [[nodiscard]] std::string here() const {
    const std::string_view done = path_.substr(0, path_.size() - rest_.size());
    return done.empty() ? "the file" : in_quotes(done, 200);
  }

  void take_field() {
    const std::string before = before_;
    const std::string_view name = rest_.substr(0, rest_.find_first_of(kSteps));
    MatValue& value = *place_.value;
    if (name.empty()) fail("must be written as in MATLAB: data.channel(2).force");
    if (value.kind != MatValue::Kind::kStruct) {
      fail(fmt::format("must exist; {} is {}", before, describe(value)));
    }
    if (!place_.element && value.count() != 1) {
      fail(fmt::format("must specify an element of {}: it has {}, ({}) to ({})", before,
                       value.count(), 1, value.count()));
    }
    MatValue* field = field_of(value, place_.element.value_or(0), name);
    if (field == nullptr) {
      fail(fmt::format("must exist; {} has {}", before, list_of_names(value.fields)));
    }
    rest_.remove_prefix(name.size());
    before_ = here();
    place_ = {field, std::nullopt};
  }

  void take_index() {
    const char open = rest_.front();
    const std::size_t end = rest_.find(open == '(' ? ')' : open == '{' ? '}' : ']');
    std::size_t index = 0;
    if (end == std::string_view::npos) fail("must close its brackets");
    const auto [stop, error] = std::from_chars(rest_.data() + 1, rest_.data() + end, index);
    if (error != std::errc() || stop != rest_.data() + end) {
      fail("must have a whole number in its brackets");
    }
    const std::size_t first = open == '[' ? 0 : 1;
    const std::size_t count = place_.value->count();
    if (index < first || index - first >= count || place_.element) {
      fail(place_.element ? std::string("must have one index at a time")
                          : fmt::format("must have an existing index; {} is {}", before_,
                                        describe(*place_.value)));
    }
    choose(index - first);
    rest_.remove_prefix(end + 1);
    before_ = here();
  }

  void choose(std::size_t element) {
    if (place_.value->kind == MatValue::Kind::kCell) {
      place_ = {&place_.value->children[element], std::nullopt};
    } else if (place_.value->kind == MatValue::Kind::kStruct) {
      place_.element = element;
    } else {
      fail(fmt::format("must have an index after structs and cells only; {} is {}", before_,
                       describe(*place_.value)));
    }
  }

  MatPlace place_;
  std::string_view path_;
  std::string_view rest_;
  const std::string& file_;
  std::string before_ = "the file";
};

}  // namespace

std::string_view first_name(std::string_view path) {
  return path.substr(0, path.find_first_of(kSteps));
}

MatPlace follow(MatValue& root, std::string_view path, const std::string& file) {
  return Walk(root, path, file).run();
}

MatValue* field_of(MatValue& value, std::size_t element, std::string_view name) {
  const auto found = std::ranges::find(value.fields, name);
  if (value.kind != MatValue::Kind::kStruct || found == value.fields.end()) return nullptr;
  return field_at(value, element,
                  static_cast<std::size_t>(std::distance(value.fields.begin(), found)));
}

MatValue* field_at(MatValue& value, std::size_t element, std::size_t index) {
  const std::size_t at = element * value.fields.size() + index;
  return at < value.children.size() ? &value.children[at] : nullptr;
}

}  // namespace microslip
