// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/dmig_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/matrices/bulk_data.hpp"
#include "microslip/io/matrices/degree_entries.hpp"

namespace microslip {
namespace {

constexpr std::size_t kDmigHead = 65536;
constexpr std::int64_t kSquare = 1;
constexpr std::int64_t kSymmetric = 6;
constexpr std::size_t kHeadFields = 3;  // of a column: name, point and component come before
constexpr std::size_t kLongestName =
    16;  // the wide field's; that of eight columns has shorter ones
constexpr std::size_t kNamesShown = 10;

struct DmigMatrix {
  std::string name;
  std::int64_t form = 0;  ///< 0 without a header
  std::vector<DegreeEntry> entries;
};

/// Of the fields i and i + 1.
DegreeOfFreedom degree_at(const BulkData& data, std::size_t i) {
  DegreeOfFreedom degree{.node = data.integer(i, "the number of a point")};
  const BulkData::Field component = data.field(i + 1);
  const std::int64_t number = component.text.empty() ? 0 : data.integer(i + 1, "a component");
  if (number < 0 || number > static_cast<std::int64_t>(kNodalDirections)) {
    throw FormatError(data.place(component), "a component from 0 to 6", in_quotes(component.text));
  }
  degree.direction = static_cast<NodalDirection>(std::max<std::int64_t>(number - 1, 0));
  return degree;
}

/// The entries of one column: point, component, real and imaginary part each.
void take_column(const BulkData& data, DmigMatrix& matrix) {
  const DegreeOfFreedom column = degree_at(data, 1);
  for (std::size_t i = kHeadFields + 1; i + 2 < data.size(); i += 4) {
    const auto is_blank = [&](std::size_t at) { return data.field(at).text.empty(); };
    if (is_blank(i) && is_blank(i + 1) && is_blank(i + 2) && is_blank(i + 3)) continue;
    const DegreeOfFreedom row = degree_at(data, i);
    const BulkData::Field imaginary = data.field(i + 3);
    if (!imaginary.text.empty() && data.number(i + 3, "a number") != 0.0) {
      throw FormatError(data.place(imaginary), "no imaginary part", in_quotes(imaginary.text));
    }
    matrix.entries.push_back({row, column, data.number(i + 2, "a number")});
  }
}

/// The matrix that is asked for, of a file that may have several; their names in order.
class DmigFile {
 public:
  explicit DmigFile(const DmigSource& source) : source_(source) {
    BulkData data(source.text, source.file);
    while (data.next()) {
      if (data.name() == "DMIG") take(data);
    }
    if (data.name() == "DMIG" && !source.text.ends_with('\n')) {
      throw FormatError(data.place({}), "an end of line after the last entry",
                        "the end of the file: is it truncated?");
    }
  }

  DmigMatrix chosen() {
    const std::vector<std::string> candidates = this->candidates();
    if (candidates.size() != 1) refuse(candidates.size());
    DmigMatrix& matrix = matrices_.at(candidates.front());
    matrix.name = candidates.front();
    if (!is_square(matrix)) {
      throw InputError(fmt::format("{}: {}", source_.file, matrix.name), form_text(matrix),
                       "must be of form 6, symmetric, or 1, square");
    }
    return std::move(matrix);
  }

 private:
  void take(const BulkData& data) {
    const BulkData::Field field = data.field(0);
    if (field.text.size() > kLongestName) {
      throw FormatError(data.place(field),
                        fmt::format("the name of a matrix, at most {} bytes", kLongestName),
                        in_quotes(field.text));
    }
    const std::string name = in_capitals(field.text);
    if (!wanted(name)) {
      others_.insert(name);
      return;
    }
    DmigMatrix& matrix = matrices_[name];
    const bool heads = data.field(1).text == "0";  // GJ of a column is above 0
    if (heads) {
      matrix.form = data.integer(2, "the form of the matrix");
      if (data.integer(3, "the type of the numbers") > 2) {
        throw FormatError(data.place(data.field(3)), "real numbers, of type 1 or 2",
                          in_quotes(data.field(3).text));
      }
    } else {
      take_column(data, matrix);
    }
  }

  [[nodiscard]] bool wanted(const std::string& name) const {
    if (!source_.name.empty()) return name == in_capitals(source_.name);
    return !name.empty() && name.front() == source_.initial;
  }

  static bool is_square(const DmigMatrix& matrix) {
    return matrix.form == kSquare || matrix.form == kSymmetric;
  }

  static std::string form_text(const DmigMatrix& matrix) {
    return matrix.form == 0 ? "without a header" : fmt::format("of form {}", matrix.form);
  }

  /// Of those that no name was given for the square ones alone.
  [[nodiscard]] std::vector<std::string> candidates() const {
    std::vector<std::string> names;
    for (const auto& [name, matrix] : matrices_) {
      if (!source_.name.empty() || is_square(matrix)) names.push_back(name);
    }
    return names;
  }

  [[noreturn]] void refuse(std::size_t found) const {
    std::set<std::string> names = others_;
    for (const auto& [name, matrix] : matrices_) {
      names.insert(is_square(matrix) ? name : fmt::format("{} ({})", name, form_text(matrix)));
    }
    const std::string there = first_texts({names.begin(), names.end()}, kNamesShown);
    throw InputError(source_.file,
                     source_.name.empty() ? fmt::format("{} matrices {}…", found, source_.initial)
                                          : fmt::format("no matrix {}", source_.name),
                     source_.name.empty()
                         ? "must have one whose name begins so, or be named after a colon"
                         : "must be one of the file",
                     fmt::format("It has {}.", there.empty() ? "no entries DMIG" : there));
  }

  const DmigSource& source_;
  std::map<std::string, DmigMatrix> matrices_;
  std::set<std::string> others_;
};

/// A symmetric one has each pair once, in whichever triangle.
DegreeMatrix degree_matrix(DmigMatrix matrix, const std::string& file) {
  using Triangles = DegreeMatrix::Triangles;
  return {.name = fmt::format("{}: {}", file, matrix.name),
          .triangles = matrix.form == kSquare ? Triangles::kBoth : Triangles::kOne,
          .entries = std::move(matrix.entries),
          .twice = "a matrix of form 6 has one triangle, and none is there twice",
          .lacks = "A matrix of one triangle has form 6."};
}

}  // namespace

bool is_dmig(std::string_view head) {
  BulkData data(head.substr(0, head.rfind('\n')), "");
  try {
    while (data.next()) {
      if (data.name() == "DMIG") return true;
    }
  } catch (const FormatError&) {  // of a tab, which is reported when all is read
    return data.name() == "DMIG";
  }
  return false;
}

bool is_dmig_file(const std::string& path) {
  const std::string file = part_of_file(path).file;
  const std::string head = read_file_head(file, kDmigHead);
  if (is_dmig(head)) return true;
  if (head.size() < kDmigHead || head.starts_with('%') || !signature(head).empty()) return false;
  return is_dmig(read_file(file));  // behind other bulk data
}

StructuralMatrices read_dmig_matrices(const std::string& stiffness, const std::string& mass) {
  const PartOfFile k = part_of_file(stiffness);
  const PartOfFile m = part_of_file(mass);
  const std::string text = read_text(k.file);
  const std::string other = m.file == k.file ? std::string() : read_text(m.file);
  return parse_dmig_matrices(
      {.text = text, .file = input_name(k.file), .name = k.variable, .initial = 'K'},
      {.text = m.file == k.file ? text : other,
       .file = input_name(m.file),
       .name = m.variable,
       .initial = 'M'});
}

StructuralMatrices parse_dmig_matrices(const DmigSource& stiffness, const DmigSource& mass) {
  const DegreeMatrix k = degree_matrix(DmigFile(stiffness).chosen(), stiffness.file);
  return matrices_of(k, degree_matrix(DmigFile(mass).chosen(), mass.file));
}

}  // namespace microslip
