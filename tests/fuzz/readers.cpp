// SPDX-License-Identifier: MIT
#include "fuzz/readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/levels/path_file.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/documents/response/power_density_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/documents/structure/structure_file.hpp"
#include "microslip/documents/study/about_file.hpp"
#include "microslip/documents/study/calibration_file.hpp"
#include "microslip/documents/study/campaign_file.hpp"
#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/documents/study/journal_file.hpp"
#include "microslip/io/config/changed_number.hpp"
#include "microslip/io/hdf5/hdf5_joint_samples.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/matrices/abaqus_matrices.hpp"
#include "microslip/io/matrices/calculix_matrices.hpp"
#include "microslip/io/matrices/coordinate_list.hpp"
#include "microslip/io/matrices/dmig_matrices.hpp"
#include "microslip/io/matrices/harwell_boeing.hpp"
#include "microslip/io/matrices/mat_entries.hpp"
#include "microslip/io/matrices/matrix_market.hpp"
#include "microslip/io/matrices/op4_matrices.hpp"
#include "microslip/io/open/mesh_file.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/recordings/assumed_units.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/responses/uff_responses.hpp"
#include "microslip/io/sandbox/parcel.hpp"
#include "microslip/io/sandbox/reading_messages.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/io/uff/uff55.hpp"
#include "microslip/io/uff/uff_recording.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::fuzz {
namespace {

constexpr const char* kName = "the file";
constexpr std::size_t kLongestMessage = 2000;

[[noreturn]] void fail(std::string_view what, std::string_view text) {
  fmt::print(stderr, "microslip_fuzz: {}: {}\n", what, text);
  std::abort();
}

void require(bool right, std::string_view rule) {
  if (!right) fail("what was read breaks a rule", rule);
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// One line, which can be shown.
void check_message(std::string_view message) {
  if (message.empty() || message.size() > kLongestMessage ||
      std::ranges::any_of(message, is_control)) {
    fail("an unclear message", message);
  }
}

/// An error that the readers throw on purpose is an answer, not a finding.
template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    check_message(error.what());
  }
}

/// The text that is written of what was read is read as what is written as the same text.
template <class Parse, class Format>
void read_again(std::string_view bytes, const Parse& parse, const Format& format) {
  std::optional<std::string> written;
  attempt([&] { written = format(parse(bytes)); });
  if (!written) return;
  try {
    require(format(parse(*written)) == *written, "it is read again as it is written");
  } catch (const Error& error) {
    fail("what was written is not read again", error.what());
  }
}

bool is_finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void check_warnings(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) check_message(warning.text);
}

void check_recordings(const Recordings& read) {
  check_warnings(read.warnings);
  for (const Recording& recording : read.recordings) {
    try {
      check_recording(recording);
    } catch (const Error& error) {
      fail("a recording that breaks the rules", error.what());
    }
  }
}

RecordingReadOptions options_for(const std::string& bytes) {
  RecordingReadOptions options{.allow_truncated = bytes.size() % 2 == 0};
  options.assumed_units.si = bytes.size() % 3 == 0;
  if (bytes.size() % 5 == 0) options.rate = 100.0;
  return options;
}

void read_recording(const std::string& bytes, MemoryFile& file) {
  file.put(bytes);
  attempt([&] {
    const Recordings read = read_recordings(file.path(), options_for(bytes));
    require(!read.recordings.empty(), "a file that is read holds a recording");
    check_recordings(read);
  });
}

JointedStructure loaded_structure() {
  return JointedStructure(ModalModel({{6.0, 0.01}}, {{"a", {1.0}}, {"b", {0.5}}}), {},
                          {{"a", {1.0}}, {"b", {1.0}}}, DampingLaw::kViscous);
}

void check_levels(const LevelsFile& file) {
  require(file.levels.size() > 0 && file.line.size() == file.levels.size(), "a line a level");
  require(is_finite(file.levels.amplitude) && is_finite(file.levels.dissipation), "finite levels");
}

void read_level_tables(const std::string& text) {
  attempt([&] { check_levels(parse_levels(text, kName)); });
  attempt([&] {
    check_levels(parse_levels(text, kName,
                              {.linear_dissipation = LinearLossColumn::kUsed, .assemblies = true}));
  });
  const std::vector<std::string> joints{"joint", "left"};
  attempt([&] { (void)parse_modal_levels(text, kName, joints, 3); });
}

void read_tables(const std::string& text, MemoryFile& file) {
  static const JointedStructure structure = loaded_structure();
  file.put(text);
  check_message(fmt::format("a kind: {}", file_kind(text)));
  (void)csv_column_names(text);
  read_level_tables(text);
  attempt([&] { (void)parse_density(text, kName); });
  attempt([&] { require(is_finite(parse_path(text, kName).displacement), "a finite path"); });
  attempt([&] { (void)parse_loads(text, kName, structure); });
  attempt([&] { (void)read_power_density(file.path(), kAcceleration); });
  attempt([&] {
    const TestFile opened = open_test(file.path());
    if (opened.content == TestContent::kSteppedSine) (void)read_stepped_sines(opened);
  });
  attempt([&] {
    const CsvTable table(text, kName);
    for (const CsvColumn& column : table.columns()) (void)table.text(column.name);
    for (const std::string& comment : table.comments()) (void)comment.size();
  });
}

void read_universal(const std::string& bytes, MemoryFile& file) {
  read_recording(bytes, file);
  attempt([&] { check_recordings(read_contents_uff(file.path(), options_for(bytes)).recordings); });
  attempt([&] {
    const UffModeShapes read = read_mode_shapes_uff(file.path());
    check_warnings(read.warnings);
    for (const UffModeShape& shape : read.shapes) {
      require(shape.values.size() == shape.nodes.size() * shape.values_per_node, "values of nodes");
      require(is_finite(shape.values), "finite shapes");
    }
  });
  attempt([&] { check_warnings(read_responses_uff(file.path(), UnitSystem{}).warnings); });
  attempt([&] { (void)read_mesh(file.path(), 1.0); });
}

void read_matlab(const std::string& bytes, MemoryFile& file) {
  read_recording(bytes, file);
  attempt([&] { check_recordings(read_recordings_mat(file.path(), "x", options_for(bytes))); });
  attempt([&] { (void)read_mat_entries(file.path(), "K"); });
  attempt([&] { (void)read_mat_array(file.path(), ""); });
  attempt([&] { (void)read_mat_text(file.path(), "text"); });
  attempt([&] { (void)mat_fields(file.path(), ""); });
}

void read_hdf5(const std::string& bytes, MemoryFile& file) {
  file.put(bytes);
  attempt([&] {
    switch (bytes.size() % 3) {
      case 0:
        return check_recordings(read_recordings_hdf5(file.path(), options_for(bytes)));
      case 1:
        return read_joint_samples(file.path()).check();
      default:
        (void)read_mat_array(file.path(), "");
    }
  });
}

/// What the program that reads HDF5 may send when it is out of its mind.
void read_parcel(const std::string& bytes, MemoryFile& /*file*/) {
  struct Ended {};
  const auto take = [&]<class Value>(Value value) {
    std::size_t done = 0;
    ParcelReader from([&](char* data, std::size_t size) {
      if (size > bytes.size() - done) throw Ended{};
      bytes.copy(data, size, done);
      done += size;
    });
    try {
      pass(from, value);
    } catch (const Ended&) {
    }
  };
  take(Recordings{});
  take(RawSamples{});
  take(MatTree{});
  take(ReadingError{});
}

void read_json(const std::string& text, MemoryFile& /*file*/) {
  read_again(
      text, [](std::string_view read) { return parse_joint(read, kName); },
      [](const JointFile& file) { return format_joint(file); });
  read_again(
      text, [](std::string_view read) { return parse_calibration(read, kName); },
      [](const CalibrationFile& file) { return format_calibration(file); });
  attempt([&] { (void)json_with_number(text, kName, "stiffness_N_per_m", 2.0); });
}

void read_model_file(const std::string& text) {
  attempt([&] { (void)parse_model(text, kName, JointsToFind::kAllowed); });
}

void read_rig_file(const std::string& text) {
  attempt([&] { check_rig(parse_rig(text, kName)); });
}

void read_structure_text(const std::string& text) {
  attempt([&] { (void)parse_structure(text, kName); });
}

void read_plan(const std::string& text) {
  attempt([&] { (void)parse_ensemble_plan(text, kName); });
}

void read_campaign(const std::string& text) {
  attempt([&] {
    const CampaignFile plan = parse_campaign(text, kName);
    require(!plan.tests.empty(), "tests");
    for (const std::string& name : plan.conditions()) require(!name.empty(), "names of conditions");
  });
}

void read_about_file(const std::string& text) {
  attempt([&] { (void)parse_about(text, kName); });
}

/// By the schema, where the text names one, and by all readers where it names none.
void read_toml(const std::string& text, MemoryFile& /*file*/) {
  using Read = void (*)(const std::string&);
  static constexpr std::array<std::pair<std::string_view, Read>, 6> kSchemas{{
      {"microslip.model/", read_model_file},
      {"microslip.rig/", read_rig_file},
      {"microslip.structure/", read_structure_text},
      {"microslip.ensemble/", read_plan},
      {"microslip.campaign/", read_campaign},
      {"microslip.about/", read_about_file},
  }};
  const auto is_named = [&](const auto& schema) {
    return text.find(schema.first) != std::string::npos;
  };
  const bool any = std::ranges::any_of(kSchemas, is_named);
  for (const auto& schema : kSchemas) {
    if (!any || is_named(schema)) schema.second(text);
  }
  attempt([&] { (void)toml_with_number(text, kName, "structure.frequency_Hz[1]", 2.0); });
}

void read_matrices(const std::string& text, MemoryFile& /*file*/) {
  attempt([&] { (void)parse_matrix_market(text, kName); });
  attempt([&] { (void)parse_triangle(text, kName, 6); });
  attempt([&] { (void)parse_degrees(text, kName); });
  if (is_harwell_boeing(text)) attempt([&] { (void)parse_harwell_boeing(text, kName); });
  if (is_op4(text)) attempt([&] { (void)parse_op4(text, "KAA", kName); });
  if (is_coordinate_list(text)) attempt([&] { (void)parse_coordinate_list(text, kName); });
  if (is_abaqus_matrix(text)) {
    attempt([&] { (void)parse_abaqus_matrices({text, kName}, {text, kName}); });
  }
  if (is_dmig(text)) {
    const DmigSource mass{.text = text, .file = kName, .initial = 'M'};
    attempt([&] { (void)parse_dmig_matrices({.text = text, .file = kName}, mass); });
  }
}

void read_mesh_file(const std::string& text, MemoryFile& file) {
  file.put(text);
  attempt([&] {
    for (const MeshNode& node : read_mesh(file.path(), 1e-3).nodes) {
      require(std::ranges::all_of(node.position, [](double x) { return std::isfinite(x); }),
              "finite places");
    }
  });
}

void read_journal(const std::string& bytes, MemoryFile& file) {
  file.put(bytes);
  attempt([&] {
    const JournalReader journal(file.path());
    for (const JournalBlock& block : journal.blocks()) {
      require(journal.content(block).size() == block.size, "a block of its size");
    }
    require(journal.end() <= bytes.size(), "an end in the file");
  });
}

/// What stands behind options: numbers, units, ranges.
void read_words(const std::string& text, MemoryFile& /*file*/) {
  (void)find_unit(text);
  attempt([&] { (void)parse_unit(text, kAcceleration); });
  const std::vector<std::string> arguments{text};
  attempt([&] { (void)parse_assumed_units(arguments); });
  attempt([&] {
    require(std::isfinite(parse_quantity("`amplitude`", text, kLength)), "a finite quantity");
  });
  attempt([&] { (void)parse_whole_number("`count`", text, 1, 100); });
  attempt([&] { (void)parse_ends("`frequency`", text, kFrequency); });
  attempt([&] { require(is_finite(parse_values("`v`", text, kLength)), "finite values"); });
}

constexpr std::array kReaders{
    Reader{"csv", read_recording},     Reader{"tables", read_tables},
    Reader{"uff", read_universal},     Reader{"mat", read_matlab},
    Reader{"hdf5", read_hdf5},         Reader{"parcel", read_parcel},
    Reader{"json", read_json},         Reader{"toml", read_toml},
    Reader{"matrix", read_matrices},   Reader{"mesh", read_mesh_file},
    Reader{"journal", read_journal},   Reader{"words", read_words},
    Reader{"loggers", read_recording},
};

}  // namespace

std::span<const Reader> readers() { return kReaders; }

}  // namespace microslip::fuzz
