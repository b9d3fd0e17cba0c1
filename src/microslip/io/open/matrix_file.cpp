// SPDX-License-Identifier: MIT
#include "microslip/io/open/matrix_file.hpp"

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/part_of_file.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/matrices/coordinate_list.hpp"
#include "microslip/io/matrices/harwell_boeing.hpp"
#include "microslip/io/matrices/mat_entries.hpp"
#include "microslip/io/matrices/matrix_market.hpp"
#include "microslip/io/matrices/op4_matrices.hpp"
#include "microslip/io/matrices/symmetric_entries.hpp"

namespace microslip {
namespace {

constexpr std::size_t kSignatureSize = 65536;  // comments may fill much of it

}  // namespace

SymmetricEntries read_matrix_file(const std::string& path) {
  const PartOfFile part = part_of_file(path);
  const std::string head = read_file_head(part.file, kSignatureSize);
  const std::string_view kind = signature(head);
  if (is_mat_signature(kind) || kind == "an HDF5 file") {
    return symmetric_of_both(read_mat_entries(part.file, part.variable), path,
                             "If only one triangle is stored, store both.");
  }
  if (kind.ends_with("of NumPy")) {
    throw FormatError({part.file, 0, 0},
                      "a matrix of Matrix Market, MATLAB, HDF5, OP4 or Harwell-Boeing", kind,
                      "scipy.io.mmwrite(FILE, A) writes it as Matrix Market.");
  }
  if (is_op4(head)) return read_op4(part.file, part.variable);
  if (!part.variable.empty()) {
    throw InputError(part.file, in_quotes(":" + part.variable),
                     "must follow a file of MATLAB, HDF5, OP4 or DMIG entries, to name a matrix in "
                     "it; this file is none of them");
  }
  if (is_harwell_boeing(head)) return read_harwell_boeing(path);
  if (is_coordinate_list(head)) return read_coordinate_list(path);
  return read_matrix_market(path);
}

}  // namespace microslip
