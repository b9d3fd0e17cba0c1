// SPDX-License-Identifier: MIT
#include "picture_argument.hpp"

#include "microslip/base/error.hpp"

namespace microslip::app {

PictureFormat picture_format(std::string_view option, std::string_view path) {
  if (path.ends_with(".svg")) return PictureFormat::kSvg;
  if (path.ends_with(".png")) return PictureFormat::kPng;
  if (path.ends_with(".pdf")) return PictureFormat::kPdf;
  throw InputError(option, "'" + std::string(path) + "'", "must end in .svg, .png or .pdf");
}

const char* ending_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::kPng:
      return "png";
    case PictureFormat::kPdf:
      return "pdf";
    case PictureFormat::kSvg:
      break;
  }
  return "svg";
}

std::string_view kind_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::kPng:
      return "a PNG picture";
    case PictureFormat::kPdf:
      return "a PDF document";
    case PictureFormat::kSvg:
      break;
  }
  return "an SVG picture";
}

}  // namespace microslip::app
