// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <microslip.h>
#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/model_parts.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"

/// @file
/// The handles of the C interface. Each owns or shares what it needs, so that the order in which
/// they are destroyed does not matter.

/// A joint, shared by memories and structures; its provenance goes into its file.
struct microslip_joint {
  explicit microslip_joint(std::shared_ptr<const microslip::JointFile> given)
      : file(std::move(given)) {}
  std::shared_ptr<const microslip::JointFile> file;
  mutable std::once_flag written;  ///< the text is made when it is requested
  mutable std::string text;
};

struct microslip_memory {
  std::shared_ptr<const microslip::JointFile> file;  ///< of the joint that `memory` refers to
  microslip::Memory memory;
};

/// Levels: of a file with their origin in `table`, else with their values alone.
struct microslip_levels {
  microslip::LevelTable table;
  bool of_file = false;
  bool changed = false;  ///< since they were read: the file is then not the input
};

namespace microslip::c {

/// Outcome of a method, as texts that live with the result.
struct Ending {
  Ending(const Summary& given, std::vector<Warning> issued, std::string text);
  Summary summary;
  std::vector<Warning> warnings;
  std::string lines;  ///< of the summary
};

/// @throws InputError  for a struct of another size.
void write_outcome(const Ending& ending, microslip_outcome* outcome);

/// @throws InputError  where there is no such warning.
void write_warning(const Ending& ending, std::size_t index, const char** code, const char** text);

/// Returns an array that belongs to a handle; `count` may be NULL.
void hand_out(const std::vector<double>& from, const double** values, std::size_t* count);

/// MICROSLIP_OK, or MICROSLIP_NOT_CONVERGED with the reason as last error.
[[nodiscard]] microslip_status status_of(const Summary& summary);

}  // namespace microslip::c

struct microslip_identification {
  microslip::Identification found;
  std::shared_ptr<const microslip::JointFile> file;
  microslip::c::Ending ending;
};

/// The parts of a structure, not yet checked against each other.
struct microslip_model {
  std::vector<microslip::Mode> modes;
  microslip::DampingLaw law;
  std::vector<microslip::ModalPoint> points = {};
  std::vector<microslip::StructuralJoint> joints = {};
  std::vector<microslip::JointSource> sources = {};
  std::vector<microslip::Excitation> excitations = {};
  std::vector<microslip::StaticLoad> static_loads = {};
};

struct microslip_structure {
  std::shared_ptr<const microslip::ModelFile> model;
  std::vector<double> stuck_frequencies;  ///< Hz
};

struct microslip_curve {
  std::shared_ptr<const microslip::ModelFile> model;
  microslip::ResponseCurve curve;
  microslip::c::Ending ending;
  std::array<std::vector<double>, MICROSLIP_CURVE_IMBALANCE + 1> columns = {};
  std::array<std::vector<std::vector<double>>, MICROSLIP_CURVE_JOINT_DISSIPATION + 1> joints = {};
};

struct microslip_marched {
  microslip::MarchResult result;
  microslip::c::Ending ending;
};
