// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// Of the force of a spring, which nothing reaches.
constexpr double kNoLimit = 1e30;
/// Columns of a line of a mesh in the format of the program are 80; a name has 8 of them.
constexpr std::size_t kNamesOnALine = 8;

/// The mesh: both ends, 1 apart along x, and between them an element for each slider.
class AsterMesh {
 public:
  explicit AsterMesh(const ExportedJoint& joint, std::size_t count)
      : joint_(joint), count_(count) {}

  [[nodiscard]] std::string text() const {
    const std::size_t a = joint_.first_number;
    std::string text =
        fmt::format("COOR_3D\nN{0} 0.0 0.0 0.0\nN{1} 1.0 0.0 0.0\nFINSF\nSEG2\n", a, a + 1);
    for (std::size_t i = 0; i < count_; ++i) {
      text += fmt::format("{} N{} N{}\n", element(i), a, a + 1);
    }
    text += "FINSF\n";
    text += fmt::format("GROUP_NO\n{0}_A N{1}\nFINSF\nGROUP_NO\n{0}_B N{2}\nFINSF\n", joint_.name,
                        a, a + 1);
    for (std::size_t i = 0; i < count_; ++i) {
      text += fmt::format("GROUP_MA\n{}_{} {}\nFINSF\n", joint_.name, i + 1, element(i));
    }
    text += fmt::format("GROUP_MA\n{}", joint_.name);
    for (std::size_t i = 0; i < count_; ++i) {
      text += i % kNamesOnALine == 0 ? "\n" : " ";
      text += element(i);
    }
    return text + "\nFINSF\nFIN\n";
  }

 private:
  [[nodiscard]] std::string element(std::size_t i) const {
    return fmt::format("M{}", joint_.first_number + i);
  }

  const ExportedJoint& joint_;
  std::size_t count_;
};

constexpr const char* kUseOfAster = R"(# In a command file, with your own mesh MINE:
#   from FILE import *
#   {0}_write_mesh('fort.21')
#   JOINT = LIRE_MAILLAGE(FORMAT='ASTER', UNITE=21)
#   MESH = ASSE_MAILLAGE(MAILLAGE_1=MINE, MAILLAGE_2=JOINT, OPERATION='SUPERPOSE')
#   AFFE_MODELE:    _F(GROUP_MA='{0}', PHENOMENE='MECANIQUE', MODELISATION='DIS_T')
#   AFFE_MATERIAU:  AFFE = [...] + {0}_materials(DEFI_MATERIAU, _F)
#   AFFE_CARA_ELEM: DISCRET = {0}_stiffness(_F)
#   STAT_NON_LINE or DYNA_NON_LINE, COMPORTEMENT: _F(RELATION='DIS_ECRO_CINE', GROUP_MA='{0}')
# Tie your nodes to the groups {0}_A and {0}_B in DX (LIAISON_DDL), and hold DY and DZ of both at 0.
# The joint is stretched where {0}_B moves ahead of {0}_A along x.
)";

constexpr const char* kFunctionsOfAster = R"(

def {0}_write_mesh(path):
    with open(path, 'w') as file:
        file.write({0}_mesh)


def {0}_materials(DEFI_MATERIAU, _F):
    return [_F(GROUP_MA='{0}_%d' % (i + 1),
               MATER=DEFI_MATERIAU(DIS_ECRO_CINE=_F(LIMY_DX=slip_force, KCIN_DX=0.0)))
            for i, (stiffness, slip_force) in enumerate({0}_sliders)]


def {0}_stiffness(_F):
    return [_F(GROUP_MA='{0}_%d' % (i + 1), CARA='K_T_D_L', REPERE='LOCAL',
               VALE=(stiffness, 0.0, 0.0))
            for i, (stiffness, slip_force) in enumerate({0}_sliders)]
)";

}  // namespace

/// Its law has the force F = k(u − u_an) and the limit |F − X| ≤ LIMY_DX. X = KCIN_DX·u_an is 0
/// without hardening, which makes it a Jenkins element. [Code_Aster R5.03.17, DIS_ECRO_CINE]
std::string code_aster_functions(const ExportedJoint& joint) {
  std::string sliders;
  const auto add = [&](double stiffness, double slip_force) {
    sliders += fmt::format("    ({:.16e}, {:.16e}),\n", stiffness, slip_force);
  };
  for (const ExportedSlider& slider : joint.sliders) add(slider.stiffness, slider.slip_force);
  if (joint.spring > 0.0) add(joint.spring, kNoLimit);
  const std::size_t count = joint.sliders.size() + (joint.spring > 0.0 ? 1 : 0);
  return comment_lines(joint, "# ", "code-aster") +
         fmt::format(fmt::runtime(kUseOfAster), joint.name) +
         fmt::format(
             "\n# Stiffness and slip force; a spring has one that nothing reaches.\n"
             "{0}_sliders = [\n{1}]\n\n{0}_mesh = '''{2}'''\n",
             joint.name, sliders, AsterMesh(joint, count).text()) +
         fmt::format(fmt::runtime(kFunctionsOfAster), joint.name);
}

}  // namespace microslip
