// SPDX-License-Identifier: MIT
#include "microslip/io/mat_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/mat_path.hpp"
#include "microslip/io/text.hpp"
#include "microslip/signal/quantity_name.hpp"

namespace microslip {
namespace {

using Texts = std::vector<std::string>;

bool is_of_axis(const std::string& unit) {
  const std::optional<Unit> found = find_unit(unit);
  return found && (found->dimension == kTime || found->dimension == kFrequency ||
                   found->dimension == kAngularFrequency);
}

/// The one unit of the list that has the dimension.
const std::string* only_of(const Texts& list, const Dimension& dimension) {
  const std::string* only = nullptr;
  for (const std::string& text : list) {
    const std::optional<Unit> unit = find_unit(text);
    if (!unit || unit->dimension != dimension) continue;
    if (only != nullptr) return nullptr;
    only = &text;
  }
  return only;
}

/// Hands out the units of a list, see the rule in the header.
class UnitList {
 public:
  UnitList(const Texts& list, std::vector<UnitOfArray>& arrays) : list_(list), arrays_(arrays) {
    for (const UnitOfArray& array : arrays) {
      channels_ += array.channels;
      if (array.channels == 0) has_axis_ = true;
    }
  }

  bool assign() {
    const std::size_t count = list_.size();
    const bool axis_first = has_axis_ && is_of_axis(list_.front());
    if (count == 1) return give_all(list_.front()), true;
    if (count == arrays_.size()) return give_arrays(), true;
    if (count == channels_) return give_channels(0), true;
    if (axis_first && count == channels_ + 1) return give_channels(1), true;
    if (axis_first && count == 2) return give_all(list_[1]), true;
    return give_by_name();
  }

 private:
  static void give(std::string& to, const std::string& unit) {
    if (to.empty()) to = unit;
  }

  void give_axis() {
    for (UnitOfArray& array : arrays_) {
      if (array.channels == 0 && list_.size() > 1 && is_of_axis(list_.front())) {
        give(array.unit, list_.front());
      }
    }
  }

  void give_all(const std::string& unit) {
    give_axis();
    for (UnitOfArray& array : arrays_) {
      if (array.channels > 0) give(array.unit, unit);
    }
  }

  void give_arrays() {
    for (std::size_t i = 0; i < arrays_.size(); ++i) give(arrays_[i].unit, list_[i]);
  }

  void give_channels(std::size_t first) {
    if (first > 0) give_axis();
    for (UnitOfArray& array : arrays_) {
      for (std::size_t i = 0; i < array.channels; ++i) array.of_channels.push_back(list_[first++]);
    }
  }

  bool give_by_name() {
    std::vector<std::pair<UnitOfArray*, const std::string*>> found;
    for (UnitOfArray& array : arrays_) {
      if (array.channels == 0) continue;
      const std::optional<Dimension> dimension = quantity_of_name(array.name);
      const std::string* unit = dimension ? only_of(list_, *dimension) : nullptr;
      if (unit == nullptr) return false;
      found.emplace_back(&array, unit);
    }
    give_axis();
    for (auto& [array, unit] : found) give(array->unit, *unit);
    return !found.empty();
  }

  const Texts& list_;
  std::vector<UnitOfArray>& arrays_;
  std::size_t channels_ = 0;
  bool has_axis_ = false;
};

std::string joined(const Texts& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

void assign_own(MatValue& value, std::size_t element, std::vector<UnitOfArray>& arrays) {
  for (UnitOfArray& array : arrays) {
    for (const char* ending : {"_unit", "_units"}) {
      if (!array.unit.empty()) break;
      array.unit = mat_text(field_of(value, element, array.name + ending));
    }
  }
}

void assign_fields(const MatValue& list, std::vector<UnitOfArray>& arrays) {
  for (UnitOfArray& array : arrays) {
    const auto found = std::ranges::find(list.fields, array.name);
    if (found == list.fields.end() || !array.unit.empty()) continue;
    const auto index = static_cast<std::size_t>(found - list.fields.begin());
    if (index < list.children.size()) array.unit = mat_text(&list.children[index]);
  }
}

}  // namespace

void assign_units(MatValue& value, std::size_t element, const MatValue* list,
                  std::vector<UnitOfArray>& arrays, const std::string& place,
                  std::vector<Warning>& warnings) {
  assign_own(value, element, arrays);
  if (list == nullptr || arrays.empty()) return;
  if (list->kind == MatValue::Kind::kStruct && list->count() == 1) {
    return assign_fields(*list, arrays);
  }
  const Texts texts = mat_texts(list);
  if (texts.empty() || UnitList(texts, arrays).assign()) return;
  Texts names;
  for (const UnitOfArray& array : arrays) names.push_back(array.name);
  warnings.push_back(
      {"units_not_assigned",
       fmt::format("{}: units {} are not used: they are {} for {}; give one for each of these in "
                   "their order, one for the time and one for all others, or --assume-units",
                   place, in_quotes(joined(texts), 120), texts.size(), list_of_names(names))});
}

std::string mat_text(const MatValue* value) {
  const bool is_text =
      value != nullptr && value->kind == MatValue::Kind::kText && value->texts.size() == 1;
  return is_text ? value->texts.front() : std::string{};
}

std::vector<std::string> mat_texts(const MatValue* value) {
  Texts texts;
  if (value == nullptr) return texts;
  if (value->kind == MatValue::Kind::kCell) {
    for (const MatValue& child : value->children) texts.push_back(mat_text(&child));
  } else if (value->kind == MatValue::Kind::kText && value->texts.size() == 1) {
    for (std::string_view rest = value->texts.front();;) {
      const std::size_t end = rest.find_first_of(",;");
      texts.emplace_back(trimmed(rest.substr(0, end)));
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + 1);
    }
  } else if (value->kind == MatValue::Kind::kText) {
    texts = value->texts;
  }
  return texts;
}

}  // namespace microslip
