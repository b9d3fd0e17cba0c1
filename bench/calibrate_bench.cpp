// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "microslip/calibrate/calibration.hpp"
#include "microslip/documents/levels/modal_levels_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/io/bytes/input_file.hpp"

namespace microslip::bench {
namespace {

/// Two joints of a structure of six masses from 75 levels of three modes, with their draws.
void calibrate_two_joints(benchmark::State& state) {
  const std::string folder = MICROSLIP_TEST_DATA "/two_joints/";
  const ModelFile model = read_model(folder + "model.toml", JointsToFind::kAllowed);
  const std::vector<std::string> joints{"joint1", "joint2"};
  const std::string file = folder + "modal_levels.csv";
  const ModalLevels levels =
      parse_modal_levels(read_file(file), file, joints, model.structure.linear().size());
  for (auto _ : state) {
    const CalibrationResult found =
        calibrate(model.structure, model.to_find, model.response, levels, {});
    benchmark::DoNotOptimize(found.joints.data());
  }
}
BENCHMARK(calibrate_two_joints)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace microslip::bench
