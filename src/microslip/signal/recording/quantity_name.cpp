// SPDX-License-Identifier: MIT
#include "microslip/signal/recording/quantity_name.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace microslip {
namespace {

struct Word {
  std::string_view text;
  Dimension dimension;
};

constexpr std::array kWords{
    Word{"force", kForce},         Word{"acceleration", kAcceleration},
    Word{"accel", kAcceleration},  Word{"acc", kAcceleration},
    Word{"velocity", kVelocity},   Word{"vel", kVelocity},
    Word{"displacement", kLength}, Word{"displ", kLength},
    Word{"disp", kLength},         Word{"pressure", kPressure},
    Word{"time", kTime},           Word{"frequency", kFrequency},
    Word{"freq", kFrequency},
};

/// Symbols of the field. Only by themselves: with another word they are a direction, an index or a
/// unit.
constexpr std::array kLetters{
    Word{"x", kLength},       Word{"y", kLength}, Word{"u", kLength}, Word{"v", kVelocity},
    Word{"a", kAcceleration}, Word{"f", kForce},  Word{"t", kTime},
};

template <class Words>
std::optional<Dimension> find_word(const Words& words, std::string_view text) {
  const auto found = std::ranges::find(words, text, &Word::text);
  if (found == words.end()) return std::nullopt;
  return found->dimension;
}

/// The runs of letters, in small.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : name) {
    const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool letter = small >= 'a' && small <= 'z';
    if (letter && !inside) words.emplace_back();
    if (letter) words.back() += small;
    inside = letter;
  }
  return words;
}

}  // namespace

std::optional<Dimension> quantity_of_name(std::string_view name) {
  const std::vector<std::string> words = words_of(name);
  std::optional<Dimension> found;
  for (const std::string& word : words) {
    const std::optional<Dimension> dimension = find_word(kWords, word);
    if (!dimension) continue;
    if (found && found != dimension) return std::nullopt;
    found = dimension;
  }
  return found || words.size() != 1 ? found : find_word(kLetters, words.front());
}

}  // namespace microslip
