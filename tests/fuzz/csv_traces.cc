#include "coupling/tip_trace.h"
#include "tests/fuzz/input_file.h"

using namespace zona;

/// Any bytes are a trace that can be used, or a TraceError that says where.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  beam::TipHistory history;
  try {
    history = coupling::parse_tip_trace_csv(tests::as_text(data, size), "trace.csv");
  } catch (const coupling::TraceError& error) {
    const std::string_view text = error.what();
    if (text.substr(0, 10) != "trace.csv:") tests::broken("errors begin with the file's name");
    return 0;
  }
  coupling::check_tip_history(history, "what was read");
  return 0;
}
