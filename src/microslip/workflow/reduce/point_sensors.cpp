// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/point_sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

std::string point_list(const ModalModel& linear) {
  std::string list;
  for (const ModalPoint& point : linear.points()) {
    list += (list.empty() ? "" : ", ") + point.name;
  }
  return list;
}

/// "CHANNEL=POINT".
PointSensor parse_sensor(const std::string& text, const ModalModel& linear) {
  const std::string name = fmt::format("`sensor {}`", text);
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) {
    throw InputError(name, "no channel and point", "must read CHANNEL=POINT",
                     "For instance acc1=drive.");
  }
  const std::string point = text.substr(sign + 1);
  std::vector<std::string_view> names;
  for (const ModalPoint& there : linear.points()) names.push_back(there.name);
  if (std::ranges::find(names, point) != names.end()) return {text.substr(0, sign), point};
  const std::string_view closest = closest_name(point, names);
  throw InputError(
      name, in_quotes(point),
      fmt::format("must be the name of a structure.point: {}", in_quotes(point_list(linear), 120)),
      closest.empty() ? "" : fmt::format("Did you mean {}?", in_quotes(closest)));
}

}  // namespace

std::vector<PointSensor> point_sensors(const std::vector<std::string>& texts,
                                       const ModelFile& model, const std::string& path) {
  const ModalModel& linear = model.structure.linear();
  std::vector<PointSensor> sensors;
  for (const std::string& text : texts) sensors.push_back(parse_sensor(text, linear));
  if (sensors.empty()) sensors = model.accelerometers;
  if (!sensors.empty()) return sensors;
  throw InputError(path + ": accelerometer", InputState{"missing"},
                   "must specify the points of the recorded channels",
                   fmt::format("Write [[accelerometer]] with channel and point, or give `sensor` "
                               "CHANNEL=POINT for each; the points are {}.",
                               in_quotes(point_list(linear), 120)));
}

}  // namespace microslip
