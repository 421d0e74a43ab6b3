#pragma once

#include "tests/studies/call.h"
#include "tests/studies/study_files.h"

namespace zona::studies::testing {

/// A beam and an egg, computed in a second; the weak zona fails at once.
inline const std::string reference_study = R"(
study = "piercing"
[motion]
kind = "beam"
window_length = "1 us"
auto_fraction = 0.4
[fill]
fluid = "mercury"
[beam]
length = "1 mm"
elements = 12
end = "500 us"
integrator = "transform"
[pulse]
duration = "60 us"
peak = "10 um"
[grid]
cell = "12 um"
domain = "168 um"
[zona]
level = 4
elastic_limit = 0.002
[cytoplasm]
points_per_cell = 1
[pipette]
points = [1, 12, 4]
)";

inline const std::string search_study = R"(
study = "search"
[search]
study = "reference.toml"
objectives = ["failed_area", "residual_motion"]
samples = 20
evaluations = 10
candidates = 4
refinements = 3
finalists = 2
uncertainty_samples = 2
[[variable]]
key = "fill.fluid"
values = ["water", "none"]
[[variable]]
key = "pulse.peak"
range = ["3 um", "20 um"]
[[variable]]
key = "pulse.duration"
range = ["20 us", "100 us"]
[[uncertain]]
key = "zona.youngs_modulus"
range = ["3 kPa", "23 kPa"]
source = "published values"
[[limit]]
measure = "tip_travel"
at_least = "0.25 um"
)";

/// Reference and search in a folder of their own.
class SearchFiles {
 public:
  explicit SearchFiles(const std::string& search = search_study,
                       const std::string& reference = reference_study) {
    scratch_.write("reference.toml", reference);
    file_ = scratch_.write("search.toml", search);
  }
  std::string file() const { return file_.string(); }
  std::filesystem::path path(const std::string& name) const { return scratch_.path() / name; }

 private:
  ScratchDirectory scratch_;
  std::filesystem::path file_;
};

}  // namespace zona::studies::testing
