#include "studies/program/check_study.h"

#include <fmt/format.h>
#include <omp.h>

#include <cstdio>
#include <iostream>

#include "studies/kinds/study_kinds.h"
#include "studies/program/compute_study.h"
#include "studies/program/exit_code.h"
#include "studies/run/resolved_study.h"

namespace zona::studies {

int check_study(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const Configuration study = load_configuration(file, overrides);
  const StudyKind& kind = find_study_kind(study.kind());
  kind.prepare(study);  // what a run would refuse, a check does as well
  fmt::print("{} is a valid {} study. Its parameters in SI:\n\n{}", file.string(), study.kind(),
             si_table(study));
  if (kind.estimate) fmt::print("\n{}\n", kind.estimate(study).text);
  std::cout << std::flush;
  if (kind.try_here) {
    const int threads = threads_for(study, 0);
    omp_set_num_threads(threads);
    fmt::print("{}", kind.try_here(study, threads));
  }
  return exit_ok;
}

}  // namespace zona::studies
