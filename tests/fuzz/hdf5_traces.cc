#include "coupling/tip_trace.h"
#include "mpm/files/hdf5_file.h"
#include "tests/fuzz/hdf5_handles.h"
#include "tests/fuzz/input_file.h"

using namespace zona;

/// Any file is a trace that can be used, or refused with TraceError or Hdf5Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tests::InputFile file("trace.h5");
  const tests::Hdf5Handles handles;
  file.write(tests::as_text(data, size));
  beam::TipHistory history;
  try {
    history = coupling::read_tip_trace(file.path());
  } catch (const coupling::TraceError&) {
    return 0;
  } catch (const mpm::Hdf5Error&) {
    return 0;
  }
  coupling::check_tip_history(history, "what was read");
  return 0;
}
