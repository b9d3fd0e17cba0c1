// SPDX-License-Identifier: MIT

// microslip-hdf5-reader VERSION CONTENT FILE [MORE], of which CONTENT is recordings or
// untimed_recordings (MORE: a rate in Hz), joint_samples or matlab (MORE: a variable): the program
// that reads files of HDF5 for the library, see hdf5_reader.hpp.

#include <cstdio>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/hdf5/hdf5_contents.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_joint_samples.hpp"
#include "microslip/io/hdf5/reading_worker.hpp"

namespace microslip {
namespace {

constexpr int kWrongCall = 2;

/// Reads by `read` and sends the value that it returns.
template <class Read>
int serve(const std::string& version, const std::string& path, const Read& read) {
  decltype(read(Progress{})) result;
  const auto read_checked = [&](const Progress& on_progress) {
    if (version != kVersion) {
      throw FileError(path, "cannot be read: microslip-hdf5-reader is of another version",
                      "Reinstall microslip and its library together.");
    }
    const Hdf5Session session;
    result = read(on_progress);
  };
  return run_reading_worker(path, {read_checked, [&](ParcelWriter& to) { pass(to, result); }});
}

int run(const std::vector<std::string>& arguments) {
  const bool fits = arguments.size() == 3 || arguments.size() == 4;
  const bool has_more = arguments.size() == 4;
  const std::string content = fits ? arguments[1] : "";
  if (content == "recordings" || content == "untimed_recordings") {
    return serve(arguments[0], arguments[2], [&](const Progress& on_progress) {
      RecordingReadOptions options{.allow_untimed = content == "untimed_recordings",
                                   .progress = on_progress};
      if (has_more) options.rate = whole_number<double>(arguments[3]);
      return hdf5_recordings(arguments[2], options);
    });
  }
  if (content == "joint_samples") {
    return serve(arguments[0], arguments[2], [&](const Progress& on_progress) {
      return hdf5_joint_samples(arguments[2], on_progress);
    });
  }
  if (content == "matlab") {
    return serve(arguments[0], arguments[2], [&](const Progress& on_progress) {
      MatReadOptions options{.progress = on_progress};
      if (has_more) options.only = arguments[3];
      return mat73_tree(arguments[2], options);
    });
  }
  std::fputs("microslip-hdf5-reader is started by microslip and its library, not by hand.\n",
             stderr);
  return kWrongCall;
}

}  // namespace
}  // namespace microslip

int main(int argc, char** argv) { return microslip::run({argv + 1, argv + argc}); }
