// SPDX-License-Identifier: MIT
// In place of what needs the HDF5 library, see CMakeLists.txt.
#include "microslip/documents/study/ensemble_result_file.hpp"

#include "microslip/io/hdf5/hdf5_absent.hpp"

namespace microslip {

void add_ensemble_result(const EnsembleResult& /*result*/,
                         const std::function<RowPass(std::size_t group)>& /*rows_of*/,
                         const std::string& path, OutputFiles& /*outputs*/) {
  refuse_hdf5(path);
}

}  // namespace microslip
