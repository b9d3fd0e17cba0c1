// SPDX-License-Identifier: MIT
// Steps of a joint as a functional mock-up unit, as a simulator makes them.
#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/workflow/predict/joint_export.hpp"

namespace microslip {
namespace {

constexpr const char* kJoint =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e7, "density": [
  {"type": "four_parameter", "macroslip_force_N": 400, "chi": -0.5, "beta": 1}]})";

/// The shared object, which is the last file of the archive, stored as it is.
class Unit {
 public:
  explicit Unit(std::size_t sliders) {
    const std::string archive =
        export_joint(parse_joint(kJoint, "joint.json"),
                     {.target = "fmu", .sliders = sliders, .name = "bolt"}, "")
            .text;
    const std::string path =
        (std::filesystem::temp_directory_path() / "microslip_fmu_bench.so").string();
    std::ofstream(path, std::ios::binary)
        << archive.substr(archive.find("\x7F"
                                       "ELF"));
    const std::size_t guid = archive.find("guid=\"") + 6;
    library_ = dlopen(path.c_str(), RTLD_NOW);
    std::filesystem::remove(path);
    void* callbacks[5] = {};
    component_ = function<void*(const char*, int, const char*, const char*, void*, int, int)>(
        "fmi2Instantiate")("joint", 1, archive.substr(guid, archive.find('"', guid) - guid).c_str(),
                           "", callbacks, 0, 0);
  }
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  ~Unit() { dlclose(library_); }

  template <class Signature>
  Signature* function(const char* name) const {
    return reinterpret_cast<Signature*>(dlsym(library_, name));
  }
  [[nodiscard]] void* component() const { return component_; }

 private:
  void* library_;
  void* component_;
};

/// A step of a co-simulation: displacement in, step, force out.
void fmu_steps(benchmark::State& state) {
  const Unit unit(static_cast<std::size_t>(state.range(0)));
  auto* const set =
      unit.function<int(void*, const unsigned*, std::size_t, const double*)>("fmi2SetReal");
  auto* const get = unit.function<int(void*, const unsigned*, std::size_t, double*)>("fmi2GetReal");
  auto* const step = unit.function<int(void*, double, double, int)>("fmi2DoStep");
  const unsigned displacement = 1;
  const unsigned force = 2;
  double time = 0.0;
  for (auto _ : state) {
    const double u = 5e-5 * std::sin(0.003 * time);
    double f = 0.0;
    set(unit.component(), &displacement, 1, &u);
    step(unit.component(), time, 1.0, 1);
    get(unit.component(), &force, 1, &f);
    benchmark::DoNotOptimize(f);
    time += 1.0;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(fmu_steps)->Arg(20)->Arg(50)->Arg(200);

}  // namespace
}  // namespace microslip
