// SPDX-License-Identifier: MIT
#include "arguments/picture_argument.hpp"

#include <algorithm>
#include <array>

#include "microslip/base/error.hpp"

namespace microslip::app {
namespace {

struct PictureKind {
  PictureFormat format;
  const char* ending;
  std::string_view name;
};

constexpr std::array<PictureKind, 3> kPictures = {{{PictureFormat::kSvg, "svg", "an SVG picture"},
                                                   {PictureFormat::kPng, "png", "a PNG picture"},
                                                   {PictureFormat::kPdf, "pdf", "a PDF document"}}};

const PictureKind& picture_of(PictureFormat format) {
  return *std::ranges::find(kPictures, format, &PictureKind::format);
}

}  // namespace

PictureFormat picture_format(std::string_view option, std::string_view path) {
  for (const PictureKind& kind : kPictures) {
    if (path.ends_with("." + std::string(kind.ending))) return kind.format;
  }
  throw InputError(option, "'" + std::string(path) + "'", "must end in .svg, .png or .pdf");
}

const char* ending_of(PictureFormat format) { return picture_of(format).ending; }

std::string_view kind_of(PictureFormat format) { return picture_of(format).name; }

}  // namespace microslip::app
