// SPDX-License-Identifier: MIT
#include "microslip/documents/study/calibration_file.hpp"

#include <fmt/format.h>

#include "microslip/io/config/json_input.hpp"
#include "microslip/io/config/named_values_json.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {

CalibrationFile parse_calibration(std::string_view text, std::string_view file) {
  const Json json = parse_json(text, file);
  const JsonObject top(json, file, "");
  check_schema({std::string(file), 0, 0}, top.text("schema"), kCalibrationFileKind,
               "a calibration");
  top.allow_only({"schema", "provenance", "calibration"});
  (void)JsonObject(top.at("calibration"), file, "calibration");  // throws where it is no object
  CalibrationFile result{.calibration = read_named_values(top.at("calibration"))};
  if (top.has("provenance")) {
    (void)JsonObject(top.at("provenance"), file, "provenance");
    result.provenance = read_provenance(top.at("provenance"));
  }
  return result;
}

std::string format_calibration(const CalibrationFile& file) {
  std::string text = fmt::format("{{\n  \"schema\": \"{}\"", kCalibrationFileKind);
  if (file.provenance) {
    text += ",\n  \"provenance\": ";
    append_named_values(text, provenance_values(*file.provenance), "  ");
  }
  text += ",\n  \"calibration\": ";
  append_named_values(text, file.calibration, "  ");
  return text + "\n}\n";
}

}  // namespace microslip
