// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/model_contents.hpp"
#include "microslip/documents/structure/model_parts.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/toml_input.hpp"

/// @file
/// Tables that model.toml and STRUCTURE.toml have in common: joints and their origin, excitations
/// and measured points. Internal to documents.

namespace microslip {

// Beyond all that vibrates, and far from where squares overflow.
inline constexpr double kHighestFrequency = 1e9;    // Hz, of a mode
inline constexpr double kLargestLossFactor = 1e3;   // 1
inline constexpr double kLargestStiffness = 1e15;   // N/m, that of a joint
inline constexpr double kSmallestStiffness = 1e-6;  // N/m, of a joint to be identified
inline constexpr double kLargestSpread = StructureDraws::kLargestSpread;

inline constexpr std::string_view kStiffnessKey = "stiffness_N_per_m";
inline constexpr std::string_view kSamplesKey = "samples";
inline constexpr std::string_view kNormalLoadSpreadKey = "normal_load_std";

[[nodiscard]] inline bool is_zero(double value) { return value == 0.0; }

/// The numbers of a key, each from 0 to `most`.
[[nodiscard]] std::vector<double> read_positive(const TomlTable& table, std::string_view key,
                                                double most);
/// The numbers of a key, each from -`most` to `most`.
[[nodiscard]] std::vector<double> read_signed(const TomlTable& table, std::string_view key,
                                              double most);
/// The number of a key, from 0 to `most`; `otherwise` without the key.
[[nodiscard]] double read_optional(const TomlTable& table, std::string_view key, double most,
                                   double otherwise = 0.0);
/// For the values of a key that are too few or too many.
[[nodiscard]] InputError wrong_count(const TomlTable& table, std::string_view key,
                                     std::size_t found, const std::string& rule);

/// Not empty, and other than those of the tables `others` before it.
template <class Named>
void check_name(const TomlTable& table, const std::string& name, const std::vector<Named>& before,
                std::string_view others) {
  // It stands in the header of tables.
  if (name.empty() || name.find_first_of("[],;\"#\t\r\n") != std::string::npos) {
    throw InputError(table.name("name"), in_quotes(name),
                     "must be a text, without [ ] , ; \" # and tabs");
  }
  const auto same = std::ranges::find(before, name, &Named::name);
  if (same == before.end()) return;
  throw InputError(table.name("name"), in_quotes(name),
                   fmt::format("must differ from {}[{}].name", others, same - before.begin()));
}

/// Of a joint's table with `name` or without: "joint", or its number where there are several.
[[nodiscard]] std::string joint_name(const TomlTable& table, std::size_t number, std::size_t count);

/// Relative to the folder of the model. A file that is called - is no standard input.
[[nodiscard]] std::string path_beside(const TomlTable& table, std::string_view key,
                                      std::string_view what, std::string_view model);

/// Reads a file that a key names; messages on the file itself name the key, too.
/// @param read  of a path. @throws FileError  and what `read` throws.
template <class Read>
auto read_named(const TomlTable& table, std::string_view key, const std::string& path,
                const Read& read) {
  try {
    return read(path);
  } catch (const FileError& error) {
    throw FileError(table.name(key), error.what());
  }
}

/// The loss factors of modes, as given in a table.
struct ModalDamping {
  std::vector<double> loss_factor;  ///< η = 2ζ, as many as the key has
  DampingLaw law;                   ///< viscous by damping_ratio, hysteretic by loss_factor
  std::string_view key;             ///< which of the two it was
};

/// Of the keys damping_ratio and loss_factor.
/// @param section  the table, for messages. @param beside  a key where one of the two is missed.
/// @throws FormatError  where it is not one of them. @throws InputError  as read_positive().
[[nodiscard]] ModalDamping read_damping(const TomlTable& table, std::string_view section,
                                        std::string_view beside);

/// By the keys file or stiffness_N_per_m, samples, normal_load_std and linear_damping_J_per_m2.
/// @param model  whose folder files are relative to.
[[nodiscard]] JointSource read_joint_source(const TomlTable& table, std::string_view model,
                                            JointsToFind to_find);

/// The tables excitation, static_load, response and accelerometer.
/// @param points  names of the points. @param bases  names of the bases.
[[nodiscard]] DrivenPoints read_driven_points(const TomlTable& top,
                                              std::span<const std::string> points,
                                              std::span<const std::string> bases);

}  // namespace microslip
