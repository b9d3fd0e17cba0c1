// SPDX-License-Identifier: MIT
// A joint as a functional mock-up unit: the archive by another reader of ZIP, its description by
// the schema of FMI 2.0.3 (tests/data/fmi2), and the shared object loaded as a simulator does.
#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/joint/equal_error_sliders.hpp"
#include "support/random_path.hpp"

namespace microslip::cli_test::fmu_test {
namespace {

const std::string kJoint =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 3e6, "density": [
  {"type": "uniform", "from_N": 10, "to_N": 400, "weight": 0.3},
  {"type": "power_law", "coefficient": 0.01, "exponent": -0.5, "from_N": 0, "to_N": 250},
  {"type": "atoms", "slip_force_N": [50, 600], "weight": [0.05, 0.1]}]})";
constexpr std::size_t kSliders = 29;
const Arguments kCall{"export", "joint.json", "--to", "fmu",   "--elements",
                      "29",     "--name",     "bolt", "--out", "bolt.fmu"};

bool run_in(const Sandbox& box, const std::string& command) {
  return std::system(fmt::format("cd '{}' && {} >log 2>&1", box.path(), command).c_str()) == 0;
}

/// The archive in a folder `fmu`, unpacked by Python, which checks each sum.
void unpack(const Sandbox& box) {
  expect_done(box, kCall);
  ASSERT_TRUE(run_in(box,
                     "python3 -m zipfile -t bolt.fmu && rm -rf fmu && "
                     "python3 -m zipfile -e bolt.fmu fmu"))
      << box.get("log");
}

JenkinsNetwork sliders() {
  return equal_error_sliders(parse_joint(kJoint, "joint.json").joint, kSliders).network;
}

// ---- An importer: what a simulator does with the shared object. ----

enum Status { kOk, kWarning, kDiscard, kFmuError };

struct Callbacks {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(std::size_t, std::size_t);
  void (*free)(void*);
  void (*finished)(void*, int);
  void* environment;
};
void log_nothing(void* /*environment*/, const char* /*name*/, int /*status*/,
                 const char* /*category*/, const char* /*message*/, ...) {}
const Callbacks kCallbacks{log_nothing, std::calloc, std::free, nullptr, nullptr};
enum class Kind { kModelExchange, kCoSimulation };

class Unit {
 public:
  Unit(const std::string& path, Kind kind, const std::string& guid)
      : library_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (library_ == nullptr) throw std::runtime_error(dlerror());
    component_ =
        function<void*(const char*, int, const char*, const char*, const Callbacks*, int, int)>(
            "fmi2Instantiate")("joint", static_cast<int>(kind), guid.c_str(), "", &kCallbacks, 0,
                               0);
  }
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  ~Unit() {
    function<void(void*)>("fmi2FreeInstance")(component_);
    dlclose(library_);
  }

  template <class Signature>
  Signature* function(const char* name) const {
    return reinterpret_cast<Signature*>(dlsym(library_, name));
  }
  /// A function of a component with more arguments.
  template <class... Arguments>
  int call(const char* name, Arguments... arguments) const {
    return function<int(void*, Arguments...)>(name)(component_, arguments...);
  }
  [[nodiscard]] bool exists() const { return component_ != nullptr; }
  [[nodiscard]] int set(double u, unsigned variable = 1) const {
    return call("fmi2SetReal", &variable, std::size_t{1}, &u);
  }
  [[nodiscard]] double get(unsigned variable = 2) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    call("fmi2GetReal", &variable, std::size_t{1}, &value);
    return value;
  }
  void start() const {
    call("fmi2SetupExperiment", 0, 0.0, 0.0, 0, 0.0);
    call("fmi2EnterInitializationMode");
    call("fmi2ExitInitializationMode");
  }
  void complete_step() const {
    int event = 1;
    int end = 1;
    ASSERT_EQ(call("fmi2CompletedIntegratorStep", 1, &event, &end), kOk);
    ASSERT_EQ(event + end, 0);
  }

 private:
  void* library_;
  void* component_;
};

// ---- ----

class fmu_export : public ::testing::Test {
 protected:
  void SetUp() override {
    unpack(box_);
    std::smatch found;
    const std::string text = box_.get("fmu/modelDescription.xml");
    ASSERT_TRUE(std::regex_search(text, found, std::regex("guid=\"([^\"]+)\"")));
    guid_ = found[1];
  }
  [[nodiscard]] std::string library() const { return box_.file("fmu/binaries/linux64/bolt.so"); }

  Sandbox box_{{"joint.json", kJoint}};
  std::string guid_;
};

TEST_F(fmu_export, IsDescribedByTheSchema) {
  if (std::system("command -v xmllint >/dev/null") != 0) GTEST_SKIP() << "no xmllint";
  EXPECT_TRUE(run_in(box_, fmt::format("xmllint --noout --schema {}/fmi2/fmi2ModelDescription.xsd "
                                       "fmu/modelDescription.xml",
                                       MICROSLIP_TEST_DATA)))
      << box_.get("log");
}

// So that a model that refers to it need not be made anew, and nothing tells where it was made.
TEST_F(fmu_export, IsTheSameFileAnywhere) {
  const std::string first = box_.get("bolt.fmu");
  const Sandbox other{{"joint.json", kJoint}};
  expect_done(other, kCall);
  EXPECT_EQ(other.get("bolt.fmu"), first);
  const std::string folder = box_.file("x");
  EXPECT_EQ(first.find(folder.substr(0, folder.rfind('/'))), std::string::npos);
  expect_done(other, with(kCall, {"--units", "in-lbf"}));
  EXPECT_EQ(other.get("bolt.fmu").find(guid_), std::string::npos);
}

// Base names alone, and nothing of the compiler: neither its name nor the hash of a build.
TEST_F(fmu_export, TellsNoPlace) {
  Arguments call = kCall;
  call[1] = box_.file("joint.json");
  call.back() = box_.file("other.fmu");
  expect_done(box_, call);
  EXPECT_EQ(box_.get("other.fmu"), box_.get("bolt.fmu"));
  const std::string source = box_.get("fmu/sources/bolt.c");
  EXPECT_NE(source.find("/* sha256[joint.json] = "), std::string::npos);
  EXPECT_EQ(source.find("--out"), std::string::npos);
  const std::string object = box_.get("fmu/binaries/linux64/bolt.so");
  for (const std::string trace : {"GCC", "clang", "build-id", "/tmp"}) {
    EXPECT_EQ(object.find(trace), std::string::npos) << trace;
  }
}

// Trials that a solver gives up leave no trace; the sums run in the order of the library.
TEST_F(fmu_export, IsExchangedAsAModel) {
  const JenkinsNetwork network = sliders();
  NetworkMemory memory(network, NormalLoadLaw::kTotal);
  const Unit unit(library(), Kind::kModelExchange, guid_);
  ASSERT_TRUE(unit.exists());
  unit.start();
  RandomStream random(5, 0);
  for (const double x : testing::random_path(7, 4000, 4e-4, 4)) {
    const NetworkMemory before = memory;
    const double trial = 1e-4 * (random.uniform() - 0.5);
    ASSERT_EQ(unit.set(x + trial), kOk);
    EXPECT_EQ(unit.get(), NetworkMemory(before).advance(x + trial));
    ASSERT_EQ(unit.set(x), kOk);
    ASSERT_EQ(unit.get(), memory.advance(x));
    unit.complete_step();
    ASSERT_EQ(unit.get(), memory.advance(x));
  }
}

// The derivative of a trial, against a difference within the same stretch between two slips: its
// error is that of rounding, 1e-13 N over 1e-10 m, of some 1e6 N/m.
TEST_F(fmu_export, HasTheDerivativeOfAStep) {
  const Unit unit(library(), Kind::kModelExchange, guid_);
  unit.start();
  const unsigned force = 2;
  const unsigned displacement = 1;
  const double change = 1.0;
  for (const double u : {1e-6, 3.1e-5, 1.7e-4, -4.4e-5}) {
    ASSERT_EQ(unit.set(u), kOk);
    double slope = 0.0;
    ASSERT_EQ(unit.call("fmi2GetDirectionalDerivative", &force, std::size_t{1}, &displacement,
                        std::size_t{1}, &change, &slope),
              kOk);
    constexpr double kStep = 1e-10;
    ASSERT_EQ(unit.set(u + kStep), kOk);
    const double above = unit.get();
    ASSERT_EQ(unit.set(u - kStep), kOk);
    EXPECT_NEAR((above - unit.get()) / (2 * kStep), slope, 1e-3 * slope) << u;
  }
}

// A step moves by the velocity that was set for it; without one it holds the displacement.
TEST_F(fmu_export, IsCoSimulated) {
  const JenkinsNetwork network = sliders();
  NetworkMemory memory(network, NormalLoadLaw::kTotal);
  const Unit unit(library(), Kind::kCoSimulation, guid_);
  unit.start();
  constexpr double kStep = 1e-3;
  double time = 0.0;
  double x = 0.0;
  for (const double to : testing::random_path(8, 1000, 4e-4, 4)) {
    const unsigned displacement = 1;
    const int order = 1;
    const double velocity = (to - x) / kStep;
    ASSERT_EQ(unit.set(x), kOk);
    ASSERT_EQ(
        unit.call("fmi2SetRealInputDerivatives", &displacement, std::size_t{1}, &order, &velocity),
        kOk);
    ASSERT_EQ(unit.call("fmi2DoStep", time, kStep, 1), kOk);
    x += velocity * kStep;
    time += kStep;
    ASSERT_EQ(unit.get(), memory.advance(x));
    ASSERT_EQ(unit.get(1), x);
  }
  ASSERT_EQ(unit.call("fmi2DoStep", time, kStep, 1), kOk);
  EXPECT_EQ(unit.get(1), x);
  EXPECT_EQ(unit.call("fmi2DoStep", time, -kStep, 1), kFmuError);
}

// Within a loop: the state is kept, gone back to, and carried over to another instance as bytes.
TEST_F(fmu_export, KeepsItsState) {
  const Unit unit(library(), Kind::kModelExchange, guid_);
  unit.start();
  const std::vector<double> path = testing::random_path(9, 400, 4e-4, 4);
  const auto march = [&](const Unit& one) {
    std::vector<double> force;
    for (std::size_t i = path.size() / 2; i < path.size(); ++i) {
      EXPECT_EQ(one.set(path[i]), kOk);
      force.push_back(one.get());
      one.complete_step();
    }
    return force;
  };
  for (std::size_t i = 0; i < path.size() / 2; ++i) {
    ASSERT_EQ(unit.set(path[i]), kOk);
    unit.complete_step();
  }
  void* state = nullptr;
  ASSERT_EQ(unit.call("fmi2GetFMUstate", &state), kOk);
  const std::vector<double> force = march(unit);
  ASSERT_EQ(unit.call("fmi2SetFMUstate", state), kOk);
  EXPECT_EQ(march(unit), force);
  std::size_t size = 0;
  ASSERT_EQ(unit.call("fmi2SerializedFMUstateSize", state, &size), kOk);
  std::vector<char> bytes(size);
  ASSERT_EQ(unit.call("fmi2SerializeFMUstate", state, bytes.data(), size), kOk);
  ASSERT_EQ(unit.call("fmi2FreeFMUstate", &state), kOk);
  const Unit other(library(), Kind::kModelExchange, guid_);
  ASSERT_EQ(other.call("fmi2DeSerializeFMUstate", bytes.data(), size, &state), kOk);
  ASSERT_EQ(other.call("fmi2SetFMUstate", state), kOk);
  EXPECT_EQ(march(other), force);
  ASSERT_EQ(other.call("fmi2FreeFMUstate", &state), kOk);
  bytes[3] ^= 1;
  EXPECT_EQ(other.call("fmi2DeSerializeFMUstate", bytes.data(), size, &state), kFmuError);
  ASSERT_EQ(unit.call("fmi2Reset"), kOk);
  EXPECT_EQ(unit.get(), 0.0);
}

TEST_F(fmu_export, RefusesWhatNoSimulatorShouldDo) {
  EXPECT_FALSE(Unit(library(), Kind::kModelExchange, "{0}").exists());
  const Unit unit(library(), Kind::kCoSimulation, guid_);
  unit.start();
  EXPECT_EQ(unit.set(std::numeric_limits<double>::quiet_NaN()), kDiscard);
  EXPECT_EQ(unit.set(1.0, 2), kFmuError);
  EXPECT_TRUE(std::isnan(unit.get(3)));
  EXPECT_EQ(unit.get(), 0.0);
}

// What overflows is refused, and all is as it was before.
TEST_F(fmu_export, RefusesWhatOverflows) {
  const Unit unit(library(), Kind::kCoSimulation, guid_);
  unit.start();
  ASSERT_EQ(unit.set(1e-5), kOk);
  const double force = unit.get();
  EXPECT_EQ(unit.set(1e308), kDiscard);  // by the spring beside the sliders
  const std::vector<unsigned> both{1, 2};
  const std::vector<double> values{2e-5, 1.0};
  EXPECT_EQ(unit.call("fmi2SetReal", both.data(), both.size(), values.data()), kFmuError);
  const int order = 1;
  const double fast = 1e308;
  ASSERT_EQ(unit.call("fmi2SetRealInputDerivatives", both.data(), std::size_t{1}, &order, &fast),
            kOk);
  EXPECT_EQ(unit.call("fmi2DoStep", 0.0, 100.0, 1), kDiscard);
  EXPECT_EQ(unit.get(1), 1e-5);
  EXPECT_EQ(unit.get(), force);
  double time = 1.0;
  ASSERT_EQ(unit.call("fmi2GetRealStatus", 2, &time), kOk);
  EXPECT_EQ(time, 0.0);
}

TEST_F(fmu_export, RefusesAStateThatIsNotFinite) {
  const Unit unit(library(), Kind::kModelExchange, guid_);
  unit.start();
  void* state = nullptr;
  ASSERT_EQ(unit.call("fmi2GetFMUstate", &state), kOk);
  std::size_t size = 0;
  ASSERT_EQ(unit.call("fmi2SerializedFMUstateSize", state, &size), kOk);
  std::vector<char> bytes(size);
  ASSERT_EQ(unit.call("fmi2SerializeFMUstate", state, bytes.data(), size), kOk);
  // The values are the last doubles: the time, the velocity, the displacement, then positions.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t place : {1U, 2U, 3U, 4U}) {
    std::vector<char> damaged = bytes;
    std::memcpy(damaged.data() + size - place * sizeof nan, &nan, sizeof nan);
    EXPECT_EQ(unit.call("fmi2DeSerializeFMUstate", damaged.data(), size, &state), kFmuError);
  }
  EXPECT_EQ(unit.call("fmi2DeSerializeFMUstate", bytes.data(), size, &state), kOk);
  ASSERT_EQ(unit.call("fmi2FreeFMUstate", &state), kOk);
}

// As the standard has it of sources that are linked: the names begin with that of the model.
TEST_F(fmu_export, HasSourcesForOtherMachines) {
  box_.put("main.c",
           "#include <string.h>\nconst char *bolt_fmi2GetVersion(void);\n"
           "int main(void) { return strcmp(bolt_fmi2GetVersion(), \"2.0\"); }\n");
  EXPECT_TRUE(run_in(box_,
                     "cc -std=c99 -pedantic -Wall -Werror main.c fmu/sources/bolt.c -o main && "
                     "./main"))
      << box_.get("log");
}

TEST_F(fmu_export, ReplacesItsOwnFilesAlone) {
  expect_done(box_, with(kCall, {"--up-to", "100um"}));
  ASSERT_TRUE(run_in(box_, "python3 -m zipfile -c bolt.zip log && mv bolt.zip bolt.fmu"));
  expect_refused(box_, kCall, {"bolt.fmu", "a ZIP archive", "a joint exported to fmu"});
}

TEST_F(fmu_export, NeedsACompiler) {
  const Outcome run = box_.run(kCall, {.environment = {"PATH=/nowhere"}});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("no C compiler"), std::string::npos) << run.err;
}

/// A program `cc` in the folder `fake`, before all others.
std::string fake_compiler(const Sandbox& box, const std::string& script) {
  EXPECT_TRUE(run_in(box, "mkdir -p fake scratch"));
  box.put("fake/cc", "#!/bin/sh\n" + script);
  EXPECT_TRUE(run_in(box, "chmod +x fake/cc"));
  return fmt::format("PATH={}:{}", box.file("fake"), std::getenv("PATH"));
}

TEST_F(fmu_export, NeedsAFileOfTheCompiler) {
  const Outcome run = box_.run(kCall, {.environment = {fake_compiler(box_, "exit 0\n")}});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("wrote no file"), std::string::npos) << run.err;
}

// The compiler ends with the program, and no temporary file stays.
TEST_F(fmu_export, EndsTheCompilerWithIt) {
  const std::string path = fake_compiler(
      box_, "trap 'touch ended; exit 1' TERM\ntouch started\nwhile :; do sleep 0.05; done\n");
  Running running(kCall, box_.path(), {.environment = {path, "TMPDIR=" + box_.file("scratch")}});
  while (!box_.has("started") && !running.has_ended()) ::usleep(1000);
  running.send(SIGTERM);
  EXPECT_EQ(running.wait().signal, SIGTERM);
  for (int i = 0; i < 10000 && !box_.has("ended"); ++i) ::usleep(1000);
  EXPECT_TRUE(box_.has("ended"));
  EXPECT_TRUE(run_in(box_, "rmdir scratch")) << box_.get("log");
}

TEST_F(fmu_export, IsNoTextForATerminal) {
  Arguments call = kCall;
  call.back() = "-";
  Running running(call, box_.path(), {.columns = 80});
  const std::string shown = running.read_terminal([](const std::string&) { return false; });
  EXPECT_EQ(running.wait().status, 2);
  EXPECT_NE(shown.find("Name a file."), std::string::npos) << shown;
}

}  // namespace
}  // namespace microslip::cli_test::fmu_test
