// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/version.hpp"
#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/fmu_code.hpp"
#include "microslip/documents/exports/target_texts.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/shared_object.hpp"
#include "microslip/io/output/zip_archive.hpp"

namespace microslip {
namespace {

/// The folder of the shared object that this machine makes, by the names of FMI 2.0; empty where it
/// has none for the machine.
#if defined(__linux__) && defined(__x86_64__)
constexpr std::string_view kBinaries = "binaries/linux64/";
#else
constexpr std::string_view kBinaries;
#endif

/// A GUID that the content determines.
std::string guid_of(std::string_view code) {
  const std::string hash = sha256(code);
  return fmt::format("{{{}-{}-{}-{}-{}}}", hash.substr(0, 8), hash.substr(8, 4), hash.substr(12, 4),
                     hash.substr(16, 4), hash.substr(20, 12));
}

/// A unit by its relation to those of SI.
std::string unit_of(std::string_view name, std::string_view base, double factor) {
  return fmt::format("    <Unit name=\"{}\"><BaseUnit {}{}/></Unit>\n", name, base,
                     factor == 1.0 ? "" : fmt::format(" factor=\"{:.17g}\"", factor));
}

/// An element for one of the two interfaces. @param more  attributes that it alone has.
std::string interface_of(std::string_view element, const ExportedJoint& joint,
                         std::string_view more) {
  return fmt::format(
      "  <{0} modelIdentifier=\"{1}\"{2} canNotUseMemoryManagementFunctions=\"true\"\n"
      "    canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\" "
      "providesDirectionalDerivative=\"true\">\n"
      "    <SourceFiles><File name=\"{1}.c\"/></SourceFiles>\n  </{0}>\n",
      element, joint.name, more);
}

/// modelDescription.xml. [FMI 2.0.3, 2.2, 3.3 and 4.3]
std::string description_of(const ExportedJoint& joint, std::string_view guid) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n"
      "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\"\n"
      "    description=\"Frictional joint: {} sliders{} in parallel\"\n"
      "    generationTool=\"microslip {}\" variableNamingConvention=\"flat\" "
      "numberOfEventIndicators=\"0\">\n",
      kFmuMark, joint.name, guid, joint.sliders.size(), joint.spring > 0.0 ? " and a spring" : "",
      kVersion);
  text += interface_of("ModelExchange", joint, "");
  text += interface_of("CoSimulation", joint,
                       " canHandleVariableCommunicationStepSize=\"true\" "
                       "canInterpolateInputs=\"true\"");
  text += "  <UnitDefinitions>\n" + unit_of(joint.units.length, "m=\"1\"", joint.units.metres) +
          unit_of(joint.units.force, "kg=\"1\" m=\"1\" s=\"-2\"", joint.units.newtons) +
          "  </UnitDefinitions>\n";
  text += fmt::format(
      "  <LogCategories><Category name=\"logStatusError\"/></LogCategories>\n"
      "  <ModelVariables>\n"
      "    <ScalarVariable name=\"u\" valueReference=\"1\" causality=\"input\" "
      "variability=\"continuous\"\n      description=\"displacement across the joint; 0 as it was "
      "put together\"><Real unit=\"{}\" start=\"0\"/></ScalarVariable>\n"
      "    <ScalarVariable name=\"F\" valueReference=\"2\" causality=\"output\" "
      "variability=\"continuous\"\n      description=\"force that the displacement needs\"><Real "
      "unit=\"{}\"/></ScalarVariable>\n"
      "  </ModelVariables>\n",
      joint.units.length, joint.units.force);
  return text +
         "  <ModelStructure>\n"
         "    <Outputs><Unknown index=\"2\" dependencies=\"1\"/></Outputs>\n"
         "    <InitialUnknowns><Unknown index=\"2\" dependencies=\"1\"/></InitialUnknowns>\n"
         "  </ModelStructure>\n</fmiModelDescription>\n";
}

}  // namespace

std::string fmu_archive(const ExportedJoint& joint) {
  const std::string code = c_code(joint) + fmt::format("\n#define JOINT(x) {}_##x\n", joint.name) +
                           std::string(fmu_code());
  const std::string guid = guid_of(code);
  const std::string source = comment_lines(joint, "/* ", "fmu", " */") +
                             fmt::format("\n#define FMU_GUID \"{}\"\n", guid) + code;
  std::vector<ArchiveFile> files{{"modelDescription.xml", description_of(joint, guid)},
                                 {fmt::format("sources/{}.c", joint.name), source}};
  if (!kBinaries.empty()) {
    files.push_back({fmt::format("{}{}.so", kBinaries, joint.name),
                     shared_object_of(source, {"FMI2_OVERRIDE_FUNCTION_PREFIX"})});
  }
  return zip_archive(files);
}

}  // namespace microslip
