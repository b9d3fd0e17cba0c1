// SPDX-License-Identifier: MIT

// binary_seeds FOLDER: writes, into a folder for each reader, the files that a fuzzer begins with
// and that are no text to keep in a repository: formats of other libraries, and texts as long and
// as deep as they may get.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/study/journal_file.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/uff/uff_recording.hpp"

namespace microslip::fuzz {
namespace {

constexpr std::size_t kLong = 60000;

Channel channel(const std::string& name, std::optional<Dimension> dimension, bool complex) {
  Channel made;
  made.name = name;
  made.dimension = dimension;
  for (const double x : {0.5, -1.0, 3e-300, 7.0}) {
    made.values.push_back(x);
    if (complex) made.imaginary.push_back(1.0 / x);
  }
  made.attributes = {{"serial_number", "0042"}};
  return made;
}

std::vector<Recording> recordings() {
  Recording even;
  even.source = "level_1.csv";
  even.axis.step = 1e-3;
  even.channels = {channel("force", kForce, false), channel("raw", std::nullopt, false)};
  even.attributes = {{"description", "left"}};
  Recording uneven;
  uneven.source = "sweep";
  uneven.axis = {.dimension = kFrequency, .values = {1.0, 2.0, 4.0, 8.0}};
  uneven.channels = {channel("frf", kAcceleration / kForce, true)};
  return {even, uneven};
}

JointSamples samples() {
  JointSamples draws;
  draws.method = "chain";
  draws.slip_displacement = {0.0, 1e-5, 2e-5};
  draws.stiffness_density = {1e9, 2e9, 0.0, 2e9, 1e9, 1e8};
  draws.stiffness = {1e5, 1.1e5};
  draws.linear_damping = {1.0, 2.0};
  return draws;
}

std::string repeated(std::string_view part, std::string end = {}) {
  std::string text;
  while (text.size() + part.size() + end.size() < kLong) text += part;
  return text + end;
}

class Seeds {
 public:
  explicit Seeds(std::string folder) : folder_(std::move(folder)) {}

  [[nodiscard]] std::string path(const std::string& reader, const std::string& name) const {
    std::filesystem::create_directories(folder_ + "/" + reader);
    return folder_ + "/" + reader + "/" + name;
  }

  void put(const std::string& reader, const std::string& name, const std::string& content) const {
    write_file(path(reader, name), content);
  }

 private:
  std::string folder_;
};

void write_formats(const Seeds& seeds) {
  const std::vector<Recording> all = recordings();
  write_recordings_uff(seeds.path("uff", "binary.uff"), all, true);
  write_recordings_uff(seeds.path("uff", "ascii.uff"), all, false);
  write_recordings_mat(seeds.path("mat", "recordings.mat"), all);
  write_recordings_hdf5(seeds.path("hdf5", "recordings.h5"), all);
  const std::string draws = seeds.path("hdf5", "joint_samples.h5");
  seeds.put("hdf5", "joint_samples.h5", joint_samples_bytes(samples(), draws));
  std::filesystem::remove(seeds.path("journal", "three.journal"));
  JournalWriter journal(seeds.path("journal", "three.journal"), "heading");
  for (const unsigned number : {2U, 0U, 1U})
    journal.append(number, "content " + std::to_string(number));
}

void write_long_texts(const Seeds& seeds) {
  seeds.put("json", "deep.json", repeated("["));
  seeds.put("json", "objects.json", repeated("{\"a\":"));
  seeds.put("json", "atoms.json",
            R"({"schema":"microslip.joint/1","stiffness_N_per_m":1,"density":[)" +
                repeated(R"({"type":"uniform","from_N":0,"to_N":1,"weight":1e-9},)",
                         R"({"type":"uniform","from_N":0,"to_N":1,"weight":0}]})"));
  seeds.put("toml", "deep.toml", "a = " + repeated("["));
  seeds.put("toml", "dots.toml", repeated("a.", "a = 1\n"));
  seeds.put("toml", "tables.toml", "schema = \"microslip.model/1\"\n" + repeated("[[joint]]\n"));
  seeds.put("tables", "columns.csv", "amplitude [m],dissipation [J]" + repeated(",x") + "\n1,2\n");
  seeds.put("tables", "rows.csv", "amplitude [m],dissipation [J]\n" + repeated("1,2\n"));
  seeds.put("tables", "quotes.csv", "amplitude [m],dissipation [J],a\n1,2,\"" + repeated("\"\""));
  seeds.put("csv", "columns.csv", "time [s]" + repeated(",x") + "\n0,1\n1,1\n");
  seeds.put("csv", "rows.csv", "time [s],a [N]\n" + repeated("1,2\n"));
  seeds.put("csv", "comments.csv", repeated("#\n", "time [s],a [N]\n0,1\n1,2\n"));
  seeds.put("mesh", "sets.inp", "*NODE\n1,0,0,0\n" + repeated("*NSET,NSET=A\n1\n"));
  seeds.put(
      "matrix", "entries.mtx",
      "%%MatrixMarket matrix coordinate real symmetric\n9999 9999 9000\n" + repeated("1 1 1\n"));
  seeds.put("words", "quotient", repeated("m/"));
  seeds.put("words", "brackets", repeated("("));
}

}  // namespace
}  // namespace microslip::fuzz

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    const microslip::fuzz::Seeds seeds(argv[1]);
    microslip::fuzz::write_formats(seeds);
    microslip::fuzz::write_long_texts(seeds);
  } catch (const std::exception& error) {
    fmt::print(stderr, "binary_seeds: {}\n", error.what());
    return 1;
  }
}
