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

}  // namespace microslip::app
