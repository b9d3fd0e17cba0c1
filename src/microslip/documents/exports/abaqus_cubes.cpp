// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string_view>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// Corners of a hexahedron of these programs, in their order; x is the direction of the joint.
struct Corner {
  int x;
  int y;
  int z;
};
constexpr std::array<Corner, 8> kCorners{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// Of a material whose mass does not count. Dynamics need one above 0.
constexpr double kNextToNoDensity = 1e-15;

/// A unit cube under a uniaxial force is a spring of Young's modulus that yields at the yield
/// stress: in consistent units the numbers are those of the slider.
class Cubes {
 public:
  explicit Cubes(const ExportedJoint& joint) : joint_(joint), first_(joint.first_number) {}

  [[nodiscard]] std::string text(std::string_view target) const {
    std::string text = comment_lines(joint_, "** ", target);
    text += fmt::format(
        "** Tie your nodes to the nodes {0} and {1} (sets {2}_A, {2}_B) in direction 1, for "
        "instance "
        "by\n**   *EQUATION\n**   2\n**   {0}, 1, 1., YOUR_NODE, 1, -1.\n** The force of the joint "
        "is "
        "the total of RF over the set {2}_FORCE.\n",
        end_a(), end_b(), joint_.name);
    text += nodes() + elements() + materials() + ties();
    return text;
  }

 private:
  [[nodiscard]] std::size_t count() const {
    return joint_.sliders.size() + (joint_.spring > 0.0 ? 1 : 0);
  }
  [[nodiscard]] std::size_t end_a() const { return first_; }
  [[nodiscard]] std::size_t end_b() const { return first_ + 1; }
  [[nodiscard]] std::size_t node(std::size_t cube, std::size_t corner) const {
    return first_ + 2 + kCorners.size() * cube + corner;
  }

  /// A cube each at a place of its own.
  [[nodiscard]] std::string nodes() const {
    std::string text = fmt::format(
        "*NODE, NSET={0}_A\n{1}, 0., 0., 0.\n*NODE, NSET={0}_B\n{2}, 1., "
        "0., 0.\n*NODE, NSET={0}_CORNERS\n",
        joint_.name, end_a(), end_b());
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t c = 0; c < kCorners.size(); ++c) {
        text += fmt::format("{}, {}., {}., {}.\n", node(i, c), kCorners[c].x,
                            static_cast<std::size_t>(kCorners[c].y) + 2 * i, kCorners[c].z);
      }
    }
    text += fmt::format("*NSET, NSET={}_FORCE\n", joint_.name);
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t c = 0; c < kCorners.size(); ++c) {
        if (kCorners[c].x == 1) text += fmt::format("{},\n", node(i, c));
      }
    }
    return text;
  }

  [[nodiscard]] std::string elements() const {
    std::string text;
    for (std::size_t i = 0; i < count(); ++i) {
      text += fmt::format("*ELEMENT, TYPE=C3D8, ELSET={}_{}\n{}", joint_.name, i + 1, first_ + i);
      for (std::size_t c = 0; c < kCorners.size(); ++c) text += fmt::format(", {}", node(i, c));
      text += "\n";
    }
    return text;
  }

  /// CalculiX reads 20 characters of a number.
  [[nodiscard]] std::string materials() const {
    std::string text;
    for (std::size_t i = 0; i < count(); ++i) {
      const bool slips = i < joint_.sliders.size();
      const double stiffness = slips ? joint_.sliders[i].stiffness : joint_.spring;
      text += fmt::format("*MATERIAL, NAME={}_{}\n*ELASTIC\n{:.13e}, 0.\n", joint_.name, i + 1,
                          stiffness);
      if (slips) text += fmt::format("*PLASTIC\n{:.13e}, 0.\n", joint_.sliders[i].slip_force);
      text += fmt::format("*DENSITY\n{:g}\n*SOLID SECTION, ELSET={}_{}, MATERIAL={}_{}\n",
                          kNextToNoDensity, joint_.name, i + 1, joint_.name, i + 1);
    }
    return text;
  }

  /// Faces follow their node along x; across it a cube is free to contract.
  [[nodiscard]] std::string ties() const {
    std::string text;
    std::string held = "*BOUNDARY\n";
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t c = 0; c < kCorners.size(); ++c) {
        text += fmt::format("*EQUATION\n2\n{}, 1, 1., {}, 1, -1.\n", node(i, c),
                            kCorners[c].x == 0 ? end_a() : end_b());
        if (kCorners[c].y == 0) held += fmt::format("{}, 2, 2\n", node(i, c));
        if (kCorners[c].z == 0) held += fmt::format("{}, 3, 3\n", node(i, c));
      }
    }
    held += fmt::format("{}, 2, 3\n{}, 2, 3\n", end_a(), end_b());
    return text + held;
  }

  const ExportedJoint& joint_;
  std::size_t first_;
};

}  // namespace

std::string calculix_cubes(const ExportedJoint& joint) { return Cubes(joint).text("calculix"); }

std::string abaqus_cubes(const ExportedJoint& joint) { return Cubes(joint).text("abaqus-cubes"); }

}  // namespace microslip
