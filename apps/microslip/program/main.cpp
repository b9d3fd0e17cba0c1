// SPDX-License-Identifier: MIT

#include "arguments/command.hpp"

int main(int argc, char** argv) {
  microslip::app::Call call;
  return microslip::app::run_program(argc, argv, call, microslip::app::make_program);
}
