// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/signature.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

using std::literals::operator""sv;

constexpr std::string_view kRight = "Is it the right file?";
constexpr std::string_view kUnpack = "Unpack it first.";
constexpr std::string_view kToWav = "Make it WAV: sndfile-convert IN OUT.wav, of libsndfile.";
constexpr std::string_view kFromPickle =
    "Save its table as CSV: pandas.read_pickle(FILE).to_csv(OUT).";
constexpr std::string_view kExport = "Export it to CSV, MATLAB (v7) or HDF5.";

/// A format that is not read has its way out.
struct Signature {
  std::string_view start;
  std::string_view name;
  std::string_view remedy = kRight;
};

constexpr std::array kBinary{
    Signature{"\x89PNG\r\n\x1A\n"sv, "a PNG picture"},
    Signature{"\x89HDF\r\n\x1A\n"sv, "an HDF5 file"},
    Signature{"MATLAB 7.3 MAT-file"sv, "a MATLAB file"},
    Signature{"MATLAB 5.0 MAT-file"sv, "a MATLAB file"},
    Signature{"%PDF-"sv, "a PDF document"},
    Signature{"fLaC"sv, "a FLAC sound file", kToWav},
    Signature{".snd"sv, "an AU sound file", kToWav},
    Signature{"caff\0"sv, "a CAF sound file", kToWav},
    Signature{"riff\x2E\x91\xCF\x11"sv, "a Wave64 sound file", kToWav},
    Signature{"\x80\x02}"sv, "a pickle of Python", kFromPickle},
    Signature{"\x80\x03}"sv, "a pickle of Python", kFromPickle},
    Signature{"\x80\x04\x95"sv, "a pickle of Python", kFromPickle},
    Signature{"\x80\x05\x95"sv, "a pickle of Python", kFromPickle},
    Signature{"PK\x03\x04"sv, kZipSignature, "Save a spreadsheet as CSV; unpack an archive."},
    Signature{"\x1F\x8B"sv, "a gzip archive", kUnpack},
    Signature{"\xFD\x37zXZ"sv, "an xz archive", kUnpack},
    Signature{"\x28\xB5\x2F\xFD"sv, "a Zstandard archive", kUnpack},
    Signature{"7z\xBC\xAF\x27\x1C"sv, "a 7z archive", kUnpack},
    Signature{"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "a spreadsheet or document of old Office",
              "Save it as CSV."},
    Signature{"\xFF\xFE"sv, "UTF-16 text", "Save it as UTF-8."},
    Signature{"\xFE\xFF"sv, "UTF-16 text", "Save it as UTF-8."},
    Signature{"TDSm"sv, "a TDMS file of LabVIEW"},
    Signature{"TDSh"sv, "an index of a TDMS file of LabVIEW", "Export the .tdms beside it."},
    Signature{"MDF     "sv, "an MDF file (ASAM)",
              "Export it to MATLAB (v7.3) or CSV, with asammdf for instance."},
    Signature{"UnFinMF "sv, "an MDF file (ASAM) that was not closed",
              "Repair it and export it to MATLAB (v7.3) or CSV, with asammdf for instance."},
    Signature{"|CF,"sv, "a FAMOS file of imc", kExport},
    Signature{"\x93NUMPY"sv, "an NPY file of NumPy",
              "Save it by scipy.io.savemat(FILE, {'fs': …, 'x': …}), or by h5py."},
    Signature{"CDF\x01"sv, "a netCDF-3 file", "Make it netCDF-4: nccopy -k nc4 IN OUT."},
    Signature{"CDF\x02"sv, "a netCDF-3 file", "Make it netCDF-4: nccopy -k nc4 IN OUT."},
    Signature{"CDF\x05"sv, "a netCDF file of CDF-5", "Make it netCDF-4: nccopy -k nc4 IN OUT."},
    Signature{"\x0E\x03\x13\x01"sv, "an HDF4 file", "Make it HDF5: h4toh5 IN OUT."},
    Signature{"PAR1\x15"sv, "a Parquet file",
              "pandas: read_parquet(FILE).to_csv(OUT, index=False)."},
    Signature{"ARROW1"sv, "an Arrow or Feather file",
              "pandas: read_feather(FILE).to_csv(OUT, index=False)."},
    Signature{"SQLite format 3"sv, "an SQLite database", "Export the table as CSV."},
    Signature{"# Created by Octave"sv, "a text file of Octave"},
    Signature{"Octave-1-"sv, "a binary file of Octave", "In Octave: load it, and save -v7 FILE."},
};

constexpr Signature kLvm{"LabVIEW Measurement"sv, "an LVM file of LabVIEW"};
constexpr Signature kWav{"", "a WAV file"};
constexpr Signature kAiff{"", "an AIFF sound file", kToWav};
constexpr Signature kNpz{
    "", "an NPZ archive of NumPy",
    "Save a recording by scipy.io.savemat(FILE, {'fs': …, 'x': …}), a matrix by "
    "scipy.io.mmwrite(FILE, A)."};
constexpr Signature kBzip2{"", "a bzip2 archive", kUnpack};
constexpr Signature kMat4{"", "a MAT file of version 4"};

/// After blanks and line breaks.
constexpr std::array kTextSignatures{
    Signature{"{"sv, "JSON"},
    Signature{"<svg"sv, "an SVG picture"},
    Signature{"<!doctype html"sv, "an HTML page"},
    Signature{"<!DOCTYPE html"sv, "an HTML page"},
    Signature{"<html"sv, "an HTML page"},
};

/// The sound of Microsoft's RIFF; RIFX has its bytes in the other order, RF64 and BW64 sizes of 64
/// bits.
bool is_wav(std::string_view head) {
  constexpr std::array kStarts{"RIFF"sv, "RIFX"sv, "RF64"sv, "BW64"sv};
  const bool starts = std::ranges::find(kStarts, head.substr(0, 4)) != kStarts.end();
  return starts && head.size() >= 12 && head.substr(8, 4) == "WAVE";
}

/// The sound of Apple, in the form of IFF.
bool is_aiff(std::string_view head) {
  return head.starts_with("FORM") && head.size() >= 12 &&
         (head.substr(8, 4) == "AIFF" || head.substr(8, 4) == "AIFC");
}

/// A ZIP archive whose first file is an NPY file; its name stands behind 30 bytes.
bool is_npz(std::string_view head) {
  constexpr std::size_t kName = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() <= kName) return false;
  const auto low = static_cast<unsigned char>(head[26]);
  const auto high = static_cast<unsigned char>(head[27]);
  return head.substr(kName, low + 256U * high).ends_with(".npy");
}

/// The digit is the size of its blocks, in 100 kB; π follows in decimal digits of four bits.
bool is_bzip2(std::string_view head) {
  return head.starts_with("BZh") && head.size() > 3 && head[3] >= '1' && head[3] <= '9' &&
         head.substr(4).starts_with("1AY&SY");
}

/// MATLAB: MAT-File Format, "Level 4". It has no mark: the type of a matrix, its rows, columns and
/// whether it is complex, then the length of its name and the name, which ends in a zero.
/// Behind an empty matrix the next one follows at once, or the end of the file.
bool is_mat4(std::string_view head, int matrices = 0) {
  constexpr std::size_t kHeader = 20;
  constexpr int kMostMatrices = 64;
  if (matrices > kMostMatrices) return true;
  constexpr std::uint32_t kLongestName = 64;
  if (head.size() <= kHeader) return false;
  for (const bool big : {false, true}) {
    std::array<std::uint32_t, 5> field{};
    for (std::size_t i = 0; i < kHeader; ++i) {
      const std::size_t byte = big ? 3 - i % 4 : i % 4;
      field[i / 4] |= std::uint32_t{static_cast<unsigned char>(head[i])} << (8 * byte);
    }
    const auto [type, rows, columns, imaginary, length] = field;
    const std::uint32_t digits = type % 1000;
    const bool order = type / 1000 == (big ? 1U : 0U);
    if (!order || digits / 100 != 0 || digits / 10 % 10 > 5 || digits % 10 > 2) continue;
    if (imaginary > 1 || length < 2 || length > kLongestName) continue;
    const std::string_view name = head.substr(kHeader, length);
    const bool ends = name.size() == length && name.find('\0') == length - 1;
    const bool sized = rows < (1U << 30U) && columns < (1U << 30U);
    if (!ends || !sized || std::isalpha(static_cast<unsigned char>(name[0])) == 0) continue;
    const std::string_view behind = head.substr(kHeader + length);
    const bool empty = rows == 0 || columns == 0;
    if (!empty || behind.empty() || is_mat4(behind, matrices + 1)) return true;
  }
  return false;
}

/// A universal file: the first line is -1, right-adjusted in six columns.
bool is_universal_file(std::string_view head) {
  if (!head.starts_with("    -1")) return false;
  const std::string_view rest = head.substr(6, head.find('\n') - 6);
  return head.find('\n') != std::string_view::npos &&
         rest.find_first_not_of(" \r") == std::string_view::npos;
}

}  // namespace

std::string_view signature(std::string_view head) {
  if (is_npz(head)) return kNpz.name;
  if (is_aiff(head)) return kAiff.name;
  for (const Signature& s : kBinary) {
    if (head.starts_with(s.start)) return s.name;
  }
  if (is_wav(head)) return kWav.name;
  if (is_bzip2(head)) return kBzip2.name;
  if (is_mat4(head)) return kMat4.name;
  if (is_universal_file(head)) return "a universal file";
  if (head.starts_with(kByteOrderMark)) head.remove_prefix(kByteOrderMark.size());
  if (head.starts_with(kLvm.start)) return kLvm.name;
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  head.remove_prefix(first);
  for (const Signature& s : kTextSignatures) {
    if (head.starts_with(s.start)) return s.name;
  }
  const bool is_xml =
      head.starts_with("<?xml") || head.starts_with("<!--") || head.starts_with("<!DOCTYPE svg");
  const bool has_html = head.find("<html") != std::string_view::npos;
  if (is_xml && !has_html && head.find("<svg") != std::string_view::npos) return "an SVG picture";
  return {};
}

bool is_mat_signature(std::string_view signature) {
  return signature == "a MATLAB file" || signature == kMat4.name ||
         signature == "a text file of Octave";
}

std::string_view remedy_for_signature(std::string_view signature) {
  for (const Signature& s : {kLvm, kWav, kBzip2, kMat4, kAiff, kNpz}) {
    if (s.name == signature) return s.remedy;
  }
  const auto* const found = std::ranges::find(kBinary, signature, &Signature::name);
  return found == kBinary.end() ? kRight : found->remedy;
}

}  // namespace microslip
