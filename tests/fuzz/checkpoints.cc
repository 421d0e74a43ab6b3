#include <xxhash.h>

#include <cstring>

#include "mpm/files/checkpoint.h"
#include "tests/fuzz/hdf5_handles.h"
#include "tests/fuzz/input_file.h"

using namespace zona;

namespace {

/// The state of the seeds.
void visit_state(mpm::StateVisitor& visitor) {
  static std::vector<double> stress(12);
  static std::vector<std::int32_t> order(4);
  static std::int64_t steps = 0;
  visitor.visit("body/stress", stress);
  visitor.visit("body/order", order);
  visitor.visit("steps", steps);
}

/// The end that a whole checkpoint has; without it, the reader behind the hash is not reached.
std::string with_hash(std::string_view image) {
  const XXH64_hash_t hash = XXH3_64bits(image.data(), image.size());
  std::string bytes(image);
  bytes += "ZONAHASH";
  bytes.append(reinterpret_cast<const char*>(&hash), sizeof hash);
  return bytes;
}

}  // namespace

/// A file with the right hash holds labels and a state, or is refused with CheckpointError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tests::InputFile file("checkpoint.h5");
  const tests::Hdf5Handles handles;
  file.write(with_hash(tests::as_text(data, size)));
  try {
    const mpm::Checkpoint checkpoint(file.path());
    checkpoint.restore(visit_state);
  } catch (const mpm::CheckpointError&) {
  }
  return 0;
}
