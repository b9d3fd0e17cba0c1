// SPDX-License-Identifier: MIT
// Joints as the input of other programs: the files read back by the rules of each program's manual,
// the C source compiled, the include file of CalculiX run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/dynamics/draws/drawn_joints.hpp"
#include "microslip/joint/equal_error_sliders.hpp"
#include "microslip/joint/memory.hpp"
#include "support/random_path.hpp"

namespace microslip::cli_test::export_test {
namespace {

/// All kinds of parts but the four-parameter one, which stands alone.
const std::string kParts =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 3e6, "density": [
  {"type": "uniform", "from_N": 10, "to_N": 400, "weight": 0.3},
  {"type": "power_law", "coefficient": 0.01, "exponent": -0.5, "from_N": 0, "to_N": 250},
  {"type": "piecewise_linear", "slip_force_N": [0, 300], "density_per_N": [0.001, 0]},
  {"type": "atoms", "slip_force_N": [50, 600], "weight": [0.05, 0.1]}]})";
const std::string kFourParameters =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e7, "density": [
  {"type": "four_parameter", "macroslip_force_N": 400, "chi": -0.5, "beta": 1}]})";
/// Sliders as they are, and a spring: exported without error.
const std::string kSliders =
    R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 2e6, "density": [
  {"type": "atoms", "slip_force_N": [10, 25, 70, 71, 200], "weight": [0.1, 0.2, 0.05, 0.3, 0.15]}]})";

/// What another program has of the joint: by its manual, in its units.
struct ReadBack {
  std::vector<double> stiffness;
  std::vector<double> slip_force;
  double spring = 0.0;

  void slider(double k, double f) {
    stiffness.push_back(k);
    slip_force.push_back(f);
  }
};

/// All numbers in the groups of each match.
std::vector<std::vector<double>> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::vector<double>> all;
  const std::regex regex(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    std::vector<double>& one = all.emplace_back();
    for (std::size_t g = 1; g < it->size(); ++g) one.push_back(std::atof((*it)[g].str().c_str()));
  }
  return all;
}

const std::string kNumber = "([-+0-9.e]+)";

/// A unit cube of a perfectly plastic material: E·A/L and σ_y·A.
ReadBack read_cubes(const std::string& text) {
  ReadBack read;
  for (const auto& m : matches(text, "\\*ELASTIC\n" + kNumber + ", 0.\n\\*PLASTIC\n" + kNumber)) {
    read.slider(m[0], m[1]);
  }
  for (const auto& m : matches(text, "\\*ELASTIC\n" + kNumber + ", 0.\n\\*DENSITY")) {
    read.spring += m[0];
  }
  return read;
}

ReadBack read_connectors(const std::string& text) {
  ReadBack read;
  for (const auto& m : matches(text, "\\*CONNECTOR ELASTICITY, COMPONENT=1\n" + kNumber +
                                         ",\n\\*CONNECTOR PLASTICITY, COMPONENT=1\n"
                                         "\\*CONNECTOR HARDENING, TYPE=ISOTROPIC, "
                                         "DEFINITION=TABULAR\n" +
                                         kNumber + ", 0\\.")) {
    read.slider(m[0], m[1]);
  }
  const auto last = matches(text, "COMPONENT=1\n" + kNumber + ",\n$");
  if (!last.empty()) read.spring = last.back()[0];
  return read;
}

/// COMBIN40: K1 in series with a slider of FSLIDE, K2 beside both; FSLIDE 0 takes the slider away.
ReadBack read_combin40(const std::string& text) {
  ReadBack read;
  for (const auto& m :
       matches(text, "\nR,[0-9]+," + kNumber + ",0,0,0," + kNumber + "," + kNumber + "\n")) {
    if (m[1] > 0.0) read.slider(m[0], m[1]);
    read.spring += m[2];
  }
  return read;
}

/// ElasticPP: stiffness and the strain at which it yields.
ReadBack read_opensees(const std::string& text) {
  ReadBack read;
  for (const auto& m : matches(text, "ElasticPP'?,? [0-9]+,? " + kNumber + ",? " + kNumber)) {
    read.slider(m[0], m[0] * m[1]);
  }
  for (const auto& m : matches(text, "Elastic'?,? [0-9]+,? " + kNumber)) read.spring += m[0];
  return read;
}

/// Points of the backbone: MASTODON makes a slider of each change of slope, the last one slips too.
ReadBack read_backbone(const std::string& text) {
  ReadBack read;
  std::vector<std::vector<double>> points{{0.0, 0.0}};
  for (const auto& m : matches(text, kNumber + "," + kNumber + "\n")) points.push_back(m);
  points.erase(
      std::remove_if(points.begin() + 1, points.end(), [](const auto& p) { return p[0] == 0.0; }),
      points.end());
  const auto slope = [&](std::size_t i) {
    return i + 1 < points.size()
               ? (points[i + 1][1] - points[i][1]) / (points[i + 1][0] - points[i][0])
               : 0.0;
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double k = slope(i - 1) - slope(i);
    read.slider(k, k * points[i][0]);
  }
  return read;
}

std::vector<double> list_of(const std::string& text, const std::string& begin) {
  if (text.find(begin) == std::string::npos) return {};
  const std::size_t from = text.find('{', text.find(begin));
  std::vector<double> values;
  for (const auto& m :
       matches(text.substr(from, text.find('}', from) - from), "([-+]?[0-9][-+0-9.e]*)")) {
    values.push_back(m[0]);
  }
  return values;
}

ReadBack read_modelica(const std::string& text) {
  ReadBack read;
  const std::vector<double> k = list_of(text, "stiffness[");
  const std::vector<double> slip = list_of(text, "slip[");
  for (std::size_t i = 0; i < k.size(); ++i) read.slider(k[i], k[i] * slip.at(i));
  read.spring = matches(text, "spring\\(unit = \"N/m\"\\) = " + kNumber).at(0)[0];
  return read;
}

/// DIS_ECRO_CINE without hardening: stiffness and limit of a slider; nothing reaches a spring's.
ReadBack read_code_aster(const std::string& text) {
  ReadBack read;
  for (const auto& m : matches(text, "\n    \\(" + kNumber + ", " + kNumber + "\\)")) {
    read.slider(m[0], m[1]);
  }
  return read;
}

/// Sliders one by one, each followed by its position.
std::vector<double> forces_of(const ReadBack& read, const std::vector<double>& path) {
  std::vector<double> position(read.stiffness.size(), 0.0);
  std::vector<double> force;
  for (const double x : path) {
    double sum = read.spring * x;
    for (std::size_t i = 0; i < position.size(); ++i) {
      const double slip = read.slip_force[i] / read.stiffness[i];
      position[i] = std::clamp(position[i], x - slip, x + slip);
      sum += read.stiffness[i] * (x - position[i]);
    }
    force.push_back(sum);
  }
  return force;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Largest difference over the largest force.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most / largest(b);
}

struct Target {
  std::string name;
  ReadBack (*read)(const std::string& text);
};

const std::vector<Target> kTargets{
    {"calculix", read_cubes},    {"abaqus-cubes", read_cubes}, {"abaqus", read_connectors},
    {"ansys", read_combin40},    {"opensees", read_opensees},  {"openseespy", read_opensees},
    {"mastodon", read_backbone}, {"modelica", read_modelica},  {"code-aster", read_code_aster}};

// The numbers are written with 14 digits at least; a backbone's slopes lose four of them.
TEST(export_command, IsReadBackByTheRulesOfEachProgram) {
  const Sandbox box{{"joint.json", kSliders}};
  const Joint joint = parse_joint(kSliders, "joint.json").joint;
  const std::vector<double> path = testing::random_path(3, 400, 1.2e-4, 3);
  std::vector<double> expected(path.size());
  Memory(joint).march(path, expected);
  for (const Target& target : kTargets) {
    expect_done(box, {"export", "joint.json", "--to", target.name, "--elements", "5", "--out",
                      "o." + target.name});
    const ReadBack read = target.read(box.get("o." + target.name));
    EXPECT_LT(difference(forces_of(read, path), expected), 1e-9) << target.name;
  }
}

// 1 lbf = 0.45359237 kg × 9.80665 m/s², 1 in = 0.0254 m, by definition.
TEST(export_command, WritesOtherUnits) {
  const Sandbox box{{"joint.json", kSliders}};
  const auto in_units = [&](const std::string& units) {
    return read_opensees(expect_done(box, {"export", "joint.json", "--to", "opensees", "--units",
                                           units, "--out", "-"})
                             .out);
  };
  const ReadBack si = in_units("SI");
  const ReadBack mm = in_units("mm-N-t");
  const ReadBack inches = in_units("in-lbf");
  constexpr double kLbf = 4.4482216152605;
  for (std::size_t i = 0; i < si.stiffness.size(); ++i) {
    EXPECT_NEAR(mm.stiffness[i], si.stiffness[i] / 1e3, 1e-12 * si.stiffness[i]);
    EXPECT_NEAR(mm.slip_force[i], si.slip_force[i], 1e-12 * si.slip_force[i]);
    EXPECT_NEAR(inches.stiffness[i], si.stiffness[i] * 0.0254 / kLbf, 1e-12 * si.stiffness[i]);
    EXPECT_NEAR(inches.slip_force[i], si.slip_force[i] / kLbf, 1e-12 * si.slip_force[i]);
  }
}

bool run_in(const Sandbox& box, const std::string& command) {
  return std::system(fmt::format("cd '{}' && {} >log 2>&1", box.path(), command).c_str()) == 0;
}

// 10⁴ steps, of which some are tried and given up as a solver does. The sums run in the same order.
TEST(export_command, WritesCWithTheBitsOfTheLibrary) {
  const Sandbox box{{"joint.json", kParts}};
  expect_done(box, {"export", "joint.json", "--to", "c", "--elements", "37", "--name", "bolt",
                    "--out", "bolt.c"});
  box.put("main.c",
          "#include <stdio.h>\n#include \"bolt.c\"\nint main(void) {\n"
          "  static bolt_state state, trial;\n  double x;\n  int keep;\n"
          "  while (scanf(\"%lf %d\", &x, &keep) == 2) {\n"
          "    double slope;\n    printf(\"%a\\n\", bolt_force(&state, x, &trial, &slope));\n"
          "    if (keep) state = trial;\n  }\n  return 0;\n}\n");
  const std::vector<double> path = testing::random_path(7, 3000, 4e-4, 4);
  const JenkinsNetwork network =
      equal_error_sliders(parse_joint(kParts, "joint.json").joint, 37).network;
  NetworkMemory memory(network, NormalLoadLaw::kTotal);
  RandomStream random(11, 0);
  std::string steps;
  std::vector<double> expected;
  for (std::size_t i = 0; i < 10000; ++i) {
    const bool keep = random.uniform() < 0.7;
    const double x = path[i % path.size()];
    steps += fmt::format("{:.17g} {}\n", x, keep ? 1 : 0);
    NetworkMemory trial = memory;
    expected.push_back(trial.advance(x));
    if (keep) memory = trial;
  }
  box.put("steps", steps);
  ASSERT_TRUE(
      run_in(box, "cc -std=c99 -pedantic -Wall -Werror -O2 -ffp-contract=off main.c -o main"))
      << box.get("log");
  ASSERT_TRUE(run_in(box, "(./main <steps >forces)")) << box.get("log");
  std::istringstream lines(box.get("forces"));
  std::size_t i = 0;
  for (std::string line; std::getline(lines, line); ++i) {
    ASSERT_EQ(std::strtod(line.c_str(), nullptr), expected.at(i)) << i;
  }
  EXPECT_EQ(i, expected.size());
}

/// Force of elements with the law DIS_ECRO_CINE, KCIN_DX = 0, by its increments: the anelastic
/// displacement grows where |k(u − u_an)| passes the limit, and rests where u does.
/// [Code_Aster R5.03.17]
std::vector<double> forces_by_increments(const ReadBack& read, const std::vector<double>& path) {
  std::vector<double> anelastic(read.stiffness.size(), 0.0);
  std::vector<double> forces;
  double before = 0.0;
  for (const double u : path) {
    double sum = 0.0;
    for (std::size_t i = 0; i < anelastic.size(); ++i) {
      const double k = read.stiffness[i];
      const double from = k * (before - anelastic[i]);
      const double to = k * (u - anelastic[i]);
      const double limit = u >= before ? read.slip_force[i] : -read.slip_force[i];
      if (u != before && std::abs(to) > read.slip_force[i]) {
        anelastic[i] += u - before - (limit - from) / k;
      }
      sum += k * (u - anelastic[i]);
    }
    before = u;
    forces.push_back(sum);
  }
  return forces;
}

// The functions run in Python, as in a command file, with operators that hand back what they get.
TEST(export_command, WritesFunctionsForCodeAster) {
  const Sandbox box{{"joint.json", kSliders}};
  expect_done(box, {"export", "joint.json", "--to", "code-aster", "--elements", "5", "--name",
                    "bolt", "--first-number", "11", "--out", "bolt.py"});
  box.put("main.py",
          "from bolt import *\nget = lambda **all: all\nbolt_write_mesh('fort.21')\n"
          "for m, s in zip(bolt_materials(get, get), bolt_stiffness(get)):\n"
          "    assert m['GROUP_MA'] == s['GROUP_MA'] and s['CARA'] == 'K_T_D_L'\n"
          "    law = m['MATER']['DIS_ECRO_CINE']\n"
          "    assert law['KCIN_DX'] == 0 and s['VALE'][1:] == (0, 0)\n"
          "    print('\\n    (%r, %r)' % (s['VALE'][0], law['LIMY_DX']), m['GROUP_MA'])\n");
  ASSERT_TRUE(run_in(box, "(python3 -B main.py >values)")) << box.get("log");
  const ReadBack read = read_code_aster("\n" + box.get("values"));
  ASSERT_EQ(read.stiffness.size(), 6U);
  const std::vector<double> path = testing::random_path(4, 400, 1.2e-4, 3);
  std::vector<double> expected(path.size());
  const Joint joint = parse_joint(kSliders, "joint.json").joint;
  Memory(joint).march(path, expected);
  EXPECT_LT(difference(forces_by_increments(read, path), expected), 1e-9);
  const std::string mesh = box.get("fort.21");
  EXPECT_NE(mesh.find("\nSEG2\nM11 N11 N12\n"), std::string::npos) << mesh;
  EXPECT_NE(mesh.find("\nGROUP_MA\nbolt_6 M16\nFINSF\n"), std::string::npos) << mesh;
  EXPECT_NE(mesh.find("\nGROUP_MA\nbolt\nM11 M12 M13 M14 M15 M16\n"), std::string::npos) << mesh;
}

/// Calls UEL for each line "displacement keep procedure", the increments of a solver, with two
/// right sides as the method of Riks has; then for the forces of a linear perturbation.
const std::string kElementDriver = R"(program main
  implicit none
  integer, parameter :: n = 42
  double precision rhs(2,2), k(2,2), state(n), trial(n), energy(8), u(2), du(2,2), two(2)
  double precision alpha(3), d, x, slope
  integer keep, procedure, end, flags(5), i
  state = 0; two = 0; du = 0; d = 0; energy = 0; alpha = (/ -0.05d0, 0d0, 0d0 /)
  do
    read (*, *, iostat=end) x, keep, procedure
    if (end /= 0) exit
    trial = state
    u = (/ 0d0, x /)
    flags = (/ procedure, 0, 1, 0, 0 /)
    call joint()
    write (*, '(2(Z16.16, 1X))') transfer(-rhs(2,1), 0_8), transfer(k(2,2), 0_8)
    if (rhs(1,1) /= -rhs(2,1) .or. k(1,2) /= -k(2,2)) stop 1
    if (any(rhs(:,2) /= 0)) stop 2
    if (keep == 1) state = trial
  end do
  trial = state
  flags = (/ 1, 0, 2, 1, 0 /)
  call joint()
  slope = k(2,2)
  du(2,1) = 1d-7
  flags(3) = 100
  call joint()
  if (any(rhs(:,1) /= (/ 1d0, -1d0 /)*(slope*1d-7)) .or. any(trial /= state)) stop 3
contains
  subroutine joint()
    rhs = 9
    i = 1
    call UEL(rhs, k, trial, energy, 2, 2, n, two, 0, two, 1, 2, u, du, two, two, 1, two, d, 1, 1, &
             1, alpha, 0, i, two, two, 0, flags, 2, two, 0, d, flags, 0, d)
  end subroutine
end program
)";

// 10⁴ increments, of which some are given up and a few are of implicit dynamics, where the force of
// the increment before counts by α = −0.05 of Hilber, Hughes and Taylor.
TEST(export_command, WritesAnElementWithTheBitsOfTheLibrary) {
  if (std::system("command -v gfortran >/dev/null") != 0) GTEST_SKIP() << "no gfortran";
  const Sandbox box{{"joint.json", kParts}, {"main.f90", kElementDriver}};
  expect_done(box, {"export", "joint.json", "--to", "abaqus-uel", "--elements", "37", "--name",
                    "a_name_of_the_thirty_two_letters", "--out", "bolt.for"});
  box.put("ABA_PARAM.INC", "      IMPLICIT REAL*8(A-H,O-Z)\n      PARAMETER (NPRECD=2)\n");
  const JenkinsNetwork network =
      equal_error_sliders(parse_joint(kParts, "joint.json").joint, 37).network;
  NetworkMemory memory(network, NormalLoadLaw::kTotal);
  RandomStream random(12, 0);
  const std::vector<double> path = testing::random_path(7, 3000, 4e-4, 4);
  std::string steps;
  std::vector<double> expected;
  double kept = 0.0;
  for (std::size_t i = 0; i < 10000; ++i) {
    const bool keep = random.uniform() < 0.7;
    const bool dynamic = i % 50 == 49;
    steps += fmt::format("{:.17g} {} {}\n", path[i % path.size()], keep ? 1 : 0, dynamic ? 11 : 1);
    NetworkMemory trial = memory;
    const double force = trial.advance(path[i % path.size()]);
    const double alpha = dynamic ? -0.05 : 0.0;
    expected.push_back((1.0 + alpha) * force - alpha * kept);
    if (!keep) continue;
    memory = trial;
    kept = force;
  }
  box.put("steps", steps);
  ASSERT_TRUE(run_in(box,
                     "gfortran -O2 -ffp-contract=off -std=legacy -Wno-unused bolt.for main.f90 "
                     "-o main && (./main <steps >forces)"))
      << box.get("log");
  std::istringstream lines(box.get("forces"));
  std::size_t i = 0;
  for (std::string line; std::getline(lines, line); ++i) {
    const double force = std::bit_cast<double>(std::strtoull(line.c_str(), nullptr, 16));
    ASSERT_EQ(force, expected.at(i)) << i;
  }
  EXPECT_EQ(i, expected.size());
}

/// A deck that moves the end B along a path, mm, one increment a point.
std::string deck(const std::vector<double>& path) {
  std::string text = "*INCLUDE, INPUT=joint.inp\n*BOUNDARY\n101, 1, 1\n*AMPLITUDE, NAME=PATH\n";
  for (std::size_t i = 0; i < path.size(); ++i)
    text += fmt::format("{}., {:.12e}\n", i, 1e3 * path[i]);
  const std::size_t steps = path.size() - 1;
  return text + fmt::format(
                    "*STEP, INC={}\n*STATIC, DIRECT\n1., {}.\n*BOUNDARY, AMPLITUDE=PATH\n"
                    "102, 1, 1, 1.\n*NODE PRINT, NSET=bolt_FORCE, TOTALS=ONLY\nRF\n"
                    "*END STEP\n",
                    steps + 5, steps);
}

/// From 0 through turns that are not those of which `--error` speaks, in 100 points.
std::vector<double> path_to(double amplitude) {
  std::vector<double> path{0.0};
  for (const double turn : {0.8, -0.9, 0.6, -0.2, 0.3, -0.7, 1.0, -1.0, 0.1, -0.4}) {
    const double from = path.back();
    for (int i = 1; i <= 10; ++i) path.push_back(from + (turn * amplitude - from) * i / 10.0);
  }
  return path;
}

struct Exported {
  std::string name;
  std::string joint;
  double amplitude;  // m: all slips
};

class calculix_export : public ::testing::TestWithParam<Exported> {};

// As exact as asked for, in a program that has never seen the joint. The total of RF over the faces
// of the cubes is printed with 7 digits.
TEST_P(calculix_export, HasTheForceOfTheJoint) {
  if (std::system("command -v ccx >/dev/null") != 0) GTEST_SKIP() << "ccx is not installed";
  const Exported& given = GetParam();
  constexpr double kError = 1e-4;
  const Sandbox box{{"joint.json", given.joint}};
  expect_done(box, {"export", "joint.json", "--to", "calculix", "--units", "mm-N-t", "--error",
                    "1e-4", "--name", "bolt", "--first-number", "101", "--out", "joint.inp"});
  const std::vector<double> path = path_to(given.amplitude);
  box.put("deck.inp", deck(path));
  ASSERT_TRUE(run_in(box, "ccx deck")) << box.get("log");
  std::vector<double> force{0.0};
  for (const auto& m :
       matches(box.get("deck.dat"), "\n +([-+0-9.E]+) +[-+0-9.E]+ +[-+0-9.E]+(?=\n)")) {
    force.push_back(m[0]);
  }
  std::vector<double> expected(path.size());
  const Joint joint = parse_joint(given.joint, "joint.json").joint;
  Memory(joint).march(path, expected);
  ASSERT_EQ(force.size(), expected.size()) << box.get("log");
  EXPECT_LT(difference(force, expected), kError);
}

INSTANTIATE_TEST_SUITE_P(Of, calculix_export,
                         ::testing::Values(Exported{"Parts", kParts, 2.2e-4},
                                           Exported{"FourParameters", kFourParameters, 7e-5},
                                           Exported{"Sliders", kSliders, 1.5e-4}),
                         [](const auto& tested) { return tested.param.name; });

TEST(export_command, SaysHowExactItIs) {
  const Sandbox box{{"joint.json", kFourParameters}};
  const Outcome run = expect_done(box, {"export", "joint.json", "--to", "calculix", "--elements",
                                        "12", "--errors-csv", "e.csv", "--out", "j.inp"});
  EXPECT_NE(run.out.find("12 sliders, in N and m"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("% of the largest on first loading"), std::string::npos) << run.out;
  EXPECT_NE(box.get("j.inp").find("** microslip export: calculix"), std::string::npos);
  EXPECT_NE(box.get("e.csv").find("amplitude [m],dissipation_error [1],secant_stiffness_error [1]"),
            std::string::npos);
}

TEST(export_command, WritesASpringOfAJointThatNeverSlips) {
  const Sandbox box{
      {"joint.json",
       R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e6, "density": []})"}};
  for (const Target& target : kTargets) {
    const ReadBack read = target.read(
        expect_done(box, {"export", "joint.json", "--to", target.name, "--out", "-"}).out);
    EXPECT_NEAR(forces_of(read, {1e-3}).front(), 1e3, 1e-9) << target.name;
  }
}

// Draw i of a seed is the same as in a loop with draws: the files read back, against the table.
TEST(export_command, WritesDraws) {
  const Sandbox box{{"joint.json", kSliders}};
  const Arguments call{"export", "joint.json",        "--to", "opensees", "--draws", "12", "--seed",
                       "3",      "--normal-load-std", "10%",  "--out",    "draws"};
  const Outcome run = expect_done(box, call);
  EXPECT_NE(run.out.find("12 draws of joint for opensees"), std::string::npos) << run.out;
  const auto rows =
      matches(box.get("draws/draws.csv"), "\n" + kNumber + ",joint_[0-9]+.tcl," + kNumber + "," +
                                              kNumber + "," + kNumber + "," + kNumber);
  ASSERT_EQ(rows.size(), 12U);
  const Joint nominal = parse_joint(kSliders, "joint.json").joint;
  const DrawnJoints draws({JointDraws{}}, {0.1}, JointPairing::kIndependent, 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Joint joint = draws.draw({&nominal, 1}, i).front().joint;
    const ReadBack read = read_opensees(box.get(fmt::format("draws/joint_{:02}.tcl", i + 1)));
    double total = read.spring;
    double force = 0.0;
    for (std::size_t j = 0; j < read.stiffness.size(); ++j) {
      total += read.stiffness[j];
      force += read.slip_force[j];
    }
    EXPECT_EQ(rows[i][0], static_cast<double>(i + 1));
    EXPECT_NEAR(total, joint.stiffness(), 1e-9 * joint.stiffness());
    EXPECT_NEAR(force, joint.macroslip_force(), 1e-9 * force);
    EXPECT_NEAR(rows[i][1], joint.stiffness(), 1e-9 * joint.stiffness());
    EXPECT_NEAR(rows[i][2], force, 1e-9 * force);
    EXPECT_NEAR(rows[i][3], read.spring, 1e-9 * joint.stiffness());
    EXPECT_EQ(rows[i][4], 5.0);
  }
  expect_done(box, call);
  expect_refused(box, with(call, {"--errors-csv", "e.csv"}), {"--errors-csv", "--draws"});
  expect_refused(box, {"export", "joint.json", "--to", "c", "--draws", "3", "--out", "d"},
                 {"uncertainty"});
  expect_refused(box,
                 {"export", "joint.json", "--to", "c", "--draws", "3", "--normal-load-std", "0.1",
                  "--out", "-"},
                 {"--out", "must be a folder"});
}

TEST(export_command, TakesAnErrorInPercent) {
  const Sandbox box{{"joint.json", kParts}};
  const auto sliders = [&](const std::string& error) {
    return read_opensees(expect_done(box, {"export", "joint.json", "--to", "opensees", "--error",
                                           error, "--out", "-"})
                             .out)
        .stiffness;
  };
  EXPECT_EQ(sliders("5%"), sliders("0.05"));
}

// Of a file whose name is a word of the language.
TEST(export_command, NamesTheJointByItsFile) {
  const Sandbox box{{"class.json", kSliders}};
  expect_done(box, {"export", "class.json", "--to", "openseespy", "--out", "o.py"});
  EXPECT_NE(box.get("o.py").find("def class_joint(ops):"), std::string::npos);
}

// A path may hold anything but must not become code.
TEST(export_command, KeepsPathsInComments) {
  const std::string name = "a\rimport nothing\xFF.json";
  const Sandbox box{{name, kSliders}};
  for (const std::string target : {"code-aster", "openseespy"}) {
    expect_done(box, {"export", name, "--to", target, "--name", "bolt", "--out", target});
    EXPECT_NE(box.get(target).find("a import nothing\\xFF.json"), std::string::npos) << target;
    EXPECT_TRUE(run_in(box, fmt::format("python3 -c 'exec(open(\"{}\").read())'", target)))
        << box.get("log");
  }
}

// Draws of another call would stand beside these, and nothing would tell them apart.
TEST(export_command, RefusesAFolderWithOtherDraws) {
  const Sandbox box{{"joint.json", kSliders}};
  const auto call = [](const std::string& target, const std::string& draws) {
    return Arguments{"export", "joint.json",        "--to", target,  "--draws",
                     draws,    "--normal-load-std", "10%",  "--out", "draws"};
  };
  expect_done(box, call("opensees", "3"));
  box.put("draws/mine_4.tcl", "puts mine\n");
  expect_done(box, call("opensees", "3"));
  expect_refused(box, call("opensees", "2"), {"draws", "draws of another call", "joint_3.tcl"});
  expect_refused(box, call("c", "3"), {"joint_1.tcl", "another folder"});
}

// A macro of APDL is called by the name of its file, which has 32 letters at most, as parameters.
TEST(export_command, KeepsNamesShortForAnsys) {
  const std::string thirty(30, 'a');
  const Sandbox box{{"joint.json", kSliders}};
  const Arguments call{"export", "joint.json", "--to", "ansys", "--normal-load-std",
                       "10%",    "--name",     thirty, "--out", "o",
                       "--draws"};
  expect_done(box, with(call, {"2"}));
  EXPECT_NE(box.get("o/" + thirty + "_1.mac").find("! Use it by the name of this file"),
            std::string::npos);
  expect_refused(box, with(call, {"10"}), {"--name", "at most 29 letters", "calls a file by its"});
  expect_refused(box,
                 {"export", "joint.json", "--to", "ansys", "--name", thirty + "a", "--out", "p"},
                 {"--name", "at most 30 letters"});
}

// An export is replaced by one to the same target, and nothing else is.
TEST(export_command, ReplacesItsOwnFilesAlone) {
  const Sandbox box{{"joint.json", kSliders},
                    {"mine.inp", "** my own deck\n*NODE\n1, 0., 0., 0.\n"}};
  const Arguments call{"export", "joint.json", "--to", "calculix", "--out", "j.inp"};
  expect_done(box, call);
  expect_done(box, with(call, {"--first-number", "7"}));
  expect_refused(box, {"export", "joint.json", "--to", "ansys", "--out", "j.inp"},
                 {"j.inp", "would be replaced by a joint exported to ansys."});
  expect_refused(box, {"export", "joint.json", "--to", "calculix", "--out", "mine.inp"},
                 {"mine.inp"});
}

TEST(export_command, RefusesWhatNoTargetHolds) {
  const std::string viscous =
      R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1e6, "density": [
  {"type": "uniform", "from_N": 0, "to_N": 5, "weight": 1}], "identification": {"viscous_N_s_per_m": 3.5}})";
  const Sandbox box{{"joint.json", kParts}, {"viscous.json", viscous}};
  const auto refused = [&](const Arguments& more, const std::vector<std::string>& parts) {
    expect_refused(box, with({"export"}, with(more, {"--out", "o"})), parts);
  };
  refused({"viscous.json", "--to", "c"}, {"viscous part of 3.5 N s/m", "damper of this value"});
  refused({"joint.json", "--to", "nastran"}, {"CBUSH1D", "Targets are abaqus"});
  refused({"joint.json", "--to", "adina"}, {"adina", "is no target", "calculix"});
  refused({"joint.json", "--to", "modelica", "--units", "mm-N-t"}, {"must be SI for modelica"});
  refused({"joint.json", "--to", "c", "--units", "cgs"}, {"--units"});
  refused({"joint.json", "--to", "c", "--name", "2bolts"}, {"--name", "must be a letter"});
  refused({"joint.json", "--to", "openseespy", "--name", "lambda"},
          {"--name = lambda", "word of the language", "Take lambda_joint"});
  refused({"joint.json", "--to", "modelica", "--name", "model"}, {"Take model_joint"});
  refused({"joint.json", "--to", "modelica", "--name", "Modelica"}, {"Take Modelica_joint"});
  refused({"joint.json", "--to", "modelica", "--name", "flange_a"}, {"Take flange_a_joint"});
  refused({"joint.json", "--to", "c", "--draws", ""}, {"--draws = ''", "Leave it out"});
  refused({"joint.json", "--to", "code-aster", "--name", "a_bolt_of_the_second_flange"},
          {"at most 19 letters"});
  refused({"joint.json", "--to", "abaqus-uel", "--first-number", "10000"},
          {"--first-number = 10000", "at most 9999"});
  refused({"joint.json", "--to", "c", "--error", "60%"}, {"--error = 0.6", "from 1e-07 to 0.5"});
  refused({"joint.json", "--to", "c", "--elements", "2"}, {"number of sliders", "from 3"});
  refused({"joint.json", "--to", "c", "--up-to", "0 um"}, {"--up-to = 0", "must be above 0 m"});
}

}  // namespace
}  // namespace microslip::cli_test::export_test
