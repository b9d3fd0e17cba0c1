// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

/// Calls that are at fault, on files that are not.

namespace microslip::cli_test::bad_call_test {
namespace {

using Parts = std::vector<std::string>;

Sandbox sandbox() {
  return Sandbox{{"levels.csv", sample_levels_text()},
                 {"joint.json", kJointText},
                 {"path.csv", "displacement [m]\n0\n1e-4\n"}};
}

struct BadCall {
  Arguments arguments;
  Parts parts;
};

void expect_all_refused(const Arguments& begin, const std::vector<BadCall>& calls) {
  const Sandbox box = sandbox();
  for (const BadCall& call : calls) {
    Arguments arguments = begin;
    arguments.insert(arguments.end(), call.arguments.begin(), call.arguments.end());
    expect_refused(box, arguments, call.parts);
  }
}

const Arguments kIdentify{"identify", "levels.csv", "--out", "new.json", "--stiffness", "1.7e5"};

TEST(BadCall, OfTheProgram) {
  expect_all_refused({}, {{{}, {"A subcommand is required", "microslip --help"}},
                          {{"guess"}, {"'guess'", "identify", "loop", "dissipation", "demo"}},
                          {{"Identify"}, {"'Identify'", "must be one of"}},
                          {{"identfy"}, {"'identfy'", "; did you mean identify?"}},
                          {{"--bogus"}, {"--bogus", "microslip --help"}},
                          {{""}, {"''"}}});
}

TEST(BadCall, MissingOrSuperfluous) {
  expect_all_refused(
      {}, {{{"identify"}, {"evidence is required", "microslip identify --help"}},
           {{"identify", "levels.csv"}, {"--out is required"}},
           {{"identify", "levels.csv", "--stiffness", "1"}, {"--out is required"}},
           {{"identify", "levels.csv", "--out"}, {"--out"}},
           {{"loop", "joint.json", "--out", "l.csv"}, {"--path or --amplitude is required"}},
           {{"loop", "joint.json", "--amplitude", "1um"}, {"--out is required"}},
           {{"loop", "joint.json", "--path", "path.csv", "--amplitude", "1um", "--out", "l.csv"},
            {"--path", "--amplitude"}},
           {{"dissipation", "joint.json", "--out", "c.csv"}, {"--amplitude is required"}},
           {{"plot", ".", "--figure", "denisty"},
            {"--figure = 'denisty'; must be one of energies, ", "; did you mean density?"}},
           {{"demo", "here"}, {"here", "microslip demo --help"}}});
  expect_all_refused(
      kIdentify, {{{"more.csv"}, {"more.csv"}},
                  {{"--bogus"}, {"--bogus", "microslip identify --help"}},
                  {{"--dissipation-gain", "5%"},
                   {"There is no option --dissipation-gain; did you mean --dissipation-gain-std?"}},
                  {{"--bands=20", "--loss-factr-std", "5%"},
                   {"There is no option --loss-factr-std; did you mean --loss-factor-std?"}},
                  {{"--stiffness", "2e5"}, {"--stiffness"}}});
}

TEST(BadCall, Stiffness) {
  expect_all_refused(
      {"identify", "levels.csv", "--out", "new.json", "--stiffness"},
      {{{"0"}, {"--stiffness = 0", "above 0 N/m"}},
       {{"-3"}, {"--stiffness = -3", "above 0 N/m", "Give the stiffness"}},
       {{"abc"}, {"--stiffness = 'abc'", "a finite number, in N/m"}},
       {{""}, {"--stiffness = ''"}},
       {{"nan"}, {"--stiffness = 'nan'"}},
       {{"1e999"}, {"--stiffness = '1e999'"}},
       {{"1e300"}, {"--stiffness = 1e+300", "1e15"}},
       {{"1um"}, {"--stiffness: unit = 'um'", "stiffness", "length", "N/mm"}},
       {{"1e5 N/furlong"}, {"--stiffness: unit = 'N/furlong'", "not known", "N/mm"}}});
}

TEST(BadCall, Smoothing) {
  expect_all_refused(
      kIdentify,
      {{{"--smoothing", "best"}, {"--smoothing = 'best'", "gcv, lambda=X or p=X"}},
       {{"--smoothing", ""}, {"--smoothing = ''"}},
       {{"--smoothing", "lambda=0"}, {"--smoothing lambda = 0", "above 0"}},
       {{"--smoothing", "lambda=-1"}, {"--smoothing lambda = -1", "above 0"}},
       {{"--smoothing", "lambda=much"}, {"--smoothing lambda = 'much'", "a finite number"}},
       {{"--smoothing", "p=nan"}, {"--smoothing p = 'nan'"}},
       {{"--smoothing", "p=0.9", "--smoothing-unit", "um"},
        {"--smoothing p = 0.9", "--method spline"}},
       {{"--smoothing", "lambda=1", "--smoothing-unit", "um"}, {"--smoothing-unit = um"}},
       {{"--method", "spline", "--smoothing", "p=1.5", "--smoothing-unit", "um"},
        {"--smoothing p = 1.5", "from 0", "to 1"}},
       {{"--method", "spline", "--smoothing", "p=-0.1", "--smoothing-unit", "um"},
        {"--smoothing p = -0.1"}},
       {{"--method", "spline", "--smoothing", "p=0.9"},
        {"--smoothing p = 0.9", "Add --smoothing-unit"}},
       {{"--method", "spline", "--smoothing", "lambda=1"},
        {"--smoothing lambda = 1", "Add --smoothing-unit"}},
       {{"--method", "spline", "--smoothing", "p=0.9", "--smoothing-unit", "N"},
        {"--smoothing-unit: unit = 'N'", "length", "mm"}},
       {{"--method", "differences", "--smoothing", "lambda=1"}, {"differences", "Leave it out."}}});
}

TEST(BadCall, Bands) {
  expect_all_refused(
      kIdentify,
      {{{"--bands", "5"}, {"--bands = '5'", "from 20 to 1000000", "0 gives none"}},
       {{"--bands", "-1"}, {"--bands = '-1'", "whole number"}},
       {{"--bands", "1.5"}, {"--bands = '1.5'", "whole number"}},
       {{"--bands", "1e3"}, {"--bands = '1e3'", "in digits"}},
       {{"--bands", "many"}, {"--bands = 'many'"}},
       {{"--bands", "99999999999999999999999"}, {"--bands = '99999999999999999999999'"}},
       {{"--bands", "20", "--seed", "-1"}, {"--seed = '-1'", "whole number", "from 0"}},
       {{"--bands", "20", "--seed", "18446744073709551616"}, {"--seed = '18446744073709551616'"}},
       {{"--bands", "20", "--dissipation-gain-std", "-0.1"}, {"--dissipation-gain-std = '-0.1'"}},
       {{"--bands", "20", "--amplitude-gain-std", "40%"}, {"--amplitude-gain-std", "below 0.3"}},
       {{"--amplitude-gain-std", "0.1"}, {"--amplitude-gain-std", "--bands"}}});
}

/// What a method cannot do is refused, not ignored.
TEST(BadCall, OptionsThatDoNotGoTogether) {
  for (const std::string method : {"spline", "differences"}) {
    for (const Arguments& option :
         {Arguments{"--bands", "20"}, Arguments{"--atom"}, Arguments{"--linear-damping", "fit"}}) {
      Arguments call{"--method", method};
      call.insert(call.end(), option.begin(), option.end());
      expect_all_refused(kIdentify, {{call, {"--method = '" + method + "'", option.front()}}});
    }
  }
  expect_all_refused(
      kIdentify,
      {{{"--fit", "power_law", "--bands", "20"}, {"--fit = 'power_law'", "--bands"}},
       {{"--fit", "uniform", "--atom"}, {"--fit = 'uniform'", "--atom"}},
       {{"--method", "magic"}, {"--method", "magic", "inversion", "spline", "differences"}},
       {{"--fit", "magic"}, {"--fit", "magic", "four_parameter", "power_law", "uniform"}},
       {{"--linear-damping", "yes"}, {"--linear-damping", "yes", "none", "fit"}}});
}

TEST(BadCall, RangeOfAmplitudes) {
  const std::string form = "FROM:TO:COUNT";
  expect_all_refused({"dissipation", "joint.json", "--out", "new.csv", "--amplitude"},
                     {{{"1:2"}, {"--amplitude = '1:2'", form, "For instance"}},
                      {{"nan"}, {"--amplitude = 'nan'", form}},
                      {{""}, {"--amplitude = ''", form}},
                      {{"1:2:3:4:5"}, {form}},
                      {{"1:2:3:linear"}, {"'1:2:3:linear'", form}},
                      {{"2:1:5"}, {"'2:1:5'", "FROM must be below TO", "Swap"}},
                      {{"1:1:5"}, {"'1:1:5'", "FROM must be below TO"}},
                      {{"1:2:0"}, {"COUNT of --amplitude = '0'", "from 2"}},
                      {{"1:2:1"}, {"COUNT of --amplitude = '1'", "from 2"}},
                      {{"1:2:abc"}, {"COUNT of --amplitude = 'abc'", "whole number"}},
                      {{"1:2:-5"}, {"COUNT of --amplitude = '-5'", "whole number"}},
                      {{"1:2:2.5"}, {"COUNT of --amplitude = '2.5'", "whole number"}},
                      {{"1:2:999999999"}, {"COUNT of --amplitude", "to 10000000"}},
                      {{"0:1:5:log"}, {"'0:1:5:log'", "above 0", "Leave out :log"}},
                      {{"nan:1:5"}, {"FROM of --amplitude = 'nan'", "finite number"}},
                      {{"1::5"}, {"TO of --amplitude = ''", "finite number"}},
                      {{"1um:1s:5"}, {"TO of --amplitude: unit = 's'", "length", "time", "mm"}},
                      {{"-1um:1um:5"}, {"--amplitude", "0 m or more"}}});
}

TEST(BadCall, Loop) {
  const Arguments begin{"loop", "joint.json", "--out", "new.csv"};
  expect_all_refused({"loop", "joint.json", "--out", "new.csv", "--amplitude"},
                     {{{"0"}, {"--amplitude = 0", "above 0 m"}},
                      {{"-1um"}, {"--amplitude", "above 0 m"}},
                      {{"inf"}, {"--amplitude = 'inf'", "finite number"}},
                      {{"3N"}, {"--amplitude: unit = 'N'", "length", "force"}},
                      {{"1um", "--points", "1"}, {"--points", "1", "2 to 1000000"}},
                      {{"1um", "--points", "-7"}, {"--points", "-7"}},
                      {{"1um", "--points", "99999999999999999999"}, {"--points"}},
                      {{"1um", "--elements", "0"}, {"--elements", "0", "1 to 1000000"}},
                      {{"1um", "--normal-load-law", "coulomb"},
                       {"--normal-load-law", "coulomb", "incremental", "total"}}});
  expect_all_refused({"loop", "joint.json", "--out", "new.csv", "--path"},
                     {{{"none.csv"}, {"none.csv", "No such file"}},
                      {{"levels.csv"}, {"levels.csv:1:1", "'displacement [m]'"}}});
  expect_all_refused({"loop", "levels.csv", "--out", "new.csv", "--amplitude", "1um"},
                     {{{}, {"levels.csv: expected JSON", "a table of levels (levels.csv)"}}});
}

}  // namespace
}  // namespace microslip::cli_test::bad_call_test
