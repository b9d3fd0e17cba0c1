// SPDX-License-Identifier: MIT
#include "microslip/io/config/json_texts.hpp"

#include "microslip/io/config/json_input.hpp"

namespace microslip {

std::vector<std::string> texts_of(const JsonText& list) {
  std::vector<std::string> texts;
  const Json json = Json::parse(list.text, nullptr, false);
  if (!json.is_array()) return texts;
  for (const Json& item : json) {
    if (item.is_string()) texts.push_back(item.get<std::string>());
  }
  return texts;
}

JsonText list_of_texts(const std::vector<std::string>& texts) {
  return {Json(texts).dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace microslip
