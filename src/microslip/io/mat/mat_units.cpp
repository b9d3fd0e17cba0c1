// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_path.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

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

/// Whether the file may mean this unit by that of the array. The name of a channel contradicts
/// where it is a word for another quantity; x may be the direction of an acceleration as well.
bool fits(const UnitOfArray& array, const std::string& unit) {
  if (array.channels == 0) return is_of_axis(unit);
  const std::optional<Unit> found = find_unit(unit);
  const std::optional<Dimension> named =
      array.name.size() > 2 ? quantity_of_name(array.name) : std::nullopt;
  if (found && named) return found->dimension == *named;
  return !is_of_axis(unit);
}

/// Hands out the units of a list, see the rule in the header. Each rule is applied as a whole,
/// where every unit of it fits, or not at all.
class UnitList {
 public:
  /// @param in_order  whether the arrays are in the order of the program that wrote them.
  UnitList(const Texts& list, std::vector<UnitOfArray>& arrays, bool in_order)
      : list_(list), arrays_(arrays) {
    std::size_t with_channels = 0;
    for (const UnitOfArray& array : arrays) {
      channels_ += array.channels;
      if (array.channels == 0) has_axis_ = true;
      if (array.channels > 0) ++with_channels;
    }
    in_order_ = in_order || with_channels < 2;
  }

  [[nodiscard]] bool in_order() const { return in_order_; }

  bool assign() {
    const std::size_t count = list_.size();
    const std::size_t axis = has_axis_ && count > 1 && is_of_axis(list_.front()) ? 1 : 0;
    if (!in_order_) return give_equal(axis) || give_by_name(axis);
    if (count == arrays_.size() && give_arrays()) return true;
    if (count == axis + channels_ && give_channels(axis)) return true;
    if (count == axis + 1 && give_all(axis)) return true;
    return give_by_name(axis);
  }

 private:
  /// Unit that an array would get.
  struct Gift {
    UnitOfArray* array;
    Texts units;  ///< one for all of its channels, or one for each
  };

  /// False where a unit does not fit.
  static bool give(const std::vector<Gift>& gifts) {
    for (const auto& [array, units] : gifts) {
      for (const std::string& unit : units) {
        if (array->unit.empty() && !fits(*array, unit)) return false;
      }
    }
    for (const auto& [array, units] : gifts) {
      if (!array->unit.empty()) continue;
      if (units.size() == 1) {
        array->unit = units.front();
      } else {
        array->of_channels = units;
      }
    }
    return !gifts.empty();
  }

  /// The first unit for the axis, where it is meant to be (`axis` is 1).
  [[nodiscard]] std::vector<Gift> of_axis(std::size_t axis) {
    std::vector<Gift> gifts;
    for (UnitOfArray& array : arrays_) {
      if (array.channels == 0 && axis > 0) gifts.push_back({&array, {list_.front()}});
    }
    return gifts;
  }

  bool give_arrays() {
    std::vector<Gift> gifts;
    for (std::size_t i = 0; i < arrays_.size(); ++i) gifts.push_back({&arrays_[i], {list_[i]}});
    return give(gifts);
  }

  bool give_channels(std::size_t axis) {
    std::vector<Gift> gifts = of_axis(axis);
    auto next = list_.begin() + static_cast<std::ptrdiff_t>(axis);
    for (UnitOfArray& array : arrays_) {
      if (array.channels == 0) continue;
      const auto end = next + static_cast<std::ptrdiff_t>(array.channels);
      gifts.push_back({&array, Texts(next, end)});
      next = end;
    }
    return give(gifts);
  }

  bool give_all(std::size_t axis) {
    std::vector<Gift> gifts = of_axis(axis);
    for (UnitOfArray& array : arrays_) {
      if (array.channels > 0) gifts.push_back({&array, {list_.back()}});
    }
    return give(gifts);
  }

  /// The order does not matter where the units of all channels are the same.
  bool give_equal(std::size_t axis) {
    const auto first = list_.begin() + static_cast<std::ptrdiff_t>(axis);
    const std::size_t count = list_.size() - axis;
    const std::size_t arrays = arrays_.size() - (has_axis_ ? 1 : 0);
    if (count != 1 && count != channels_ && count != arrays) return false;
    const bool equal = std::all_of(first, list_.end(), [&](const auto& u) { return u == *first; });
    return equal && give_all(axis);
  }

  bool give_by_name(std::size_t axis) {
    std::vector<Gift> gifts = of_axis(axis);
    for (UnitOfArray& array : arrays_) {
      if (array.channels == 0) continue;
      const std::optional<Dimension> dimension = quantity_of_name(array.name);
      const std::string* unit = dimension ? only_of(list_, *dimension) : nullptr;
      if (unit == nullptr) return false;
      gifts.push_back({&array, {*unit}});
    }
    return give(gifts);
  }

  const Texts& list_;
  std::vector<UnitOfArray>& arrays_;
  std::size_t channels_ = 0;
  bool has_axis_ = false;
  bool in_order_ = true;
};

std::string joined(const Texts& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

std::string names_of(const std::vector<UnitOfArray>& arrays) {
  Texts names;
  for (const UnitOfArray& array : arrays) names.push_back(array.name);
  return list_of_names(names);
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
  UnitList units(texts, arrays, value.in_order);
  if (texts.empty() || units.assign()) return;
  if (!units.in_order()) {
    const auto channel = std::ranges::find_if(arrays, [](const auto& a) { return a.channels > 0; });
    warnings.push_back(
        {"units_not_assigned",
         fmt::format("{}: units {} are not used: the file does not keep the order of {}; give one "
                     "unit for all of them, units.{} of a struct units, a text {}_unit, or "
                     "`assume_units`",
                     place, in_quotes(joined(texts), 120), names_of(arrays), channel->name,
                     channel->name)});
    return;
  }
  warnings.push_back(
      {"units_not_assigned",
       fmt::format("{}: units {} are not used: they are {} for {}; give one for each of these in "
                   "order, one for the time and one for all others, or `assume_units`",
                   place, in_quotes(joined(texts), 120), texts.size(), names_of(arrays))});
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
