#include "studies/program/commands.h"

#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <iostream>

#include "studies/parameters/run_table.h"
#include "studies/program/bundled_studies.h"
#include "studies/run/resolved_study.h"

namespace zona::studies {

namespace {

std::string shorter_path(const std::filesystem::path& path) {
  std::error_code failure;
  const std::string relative = std::filesystem::proximate(path, failure).string();
  return !failure && relative.size() < path.string().size() ? relative : path.string();
}

}  // namespace

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

int threads_for(const Configuration& study, long wanted) {
  if (wanted == 0 && study.schema().binds<Run>()) wanted = study.value(&Run::threads);
  return wanted > 0 ? static_cast<int>(wanted) : omp_get_num_procs();
}

int list_studies() {
  fmt::print("Study kinds:\n");
  for (const StudyKind& kind : study_kinds()) {
    fmt::print("  {:<14} {}\n", kind.schema->kind(), kind.schema->summary());
  }
  fmt::print("\nBundled study files:\n");
  for (const BundledStudy& study : bundled_studies()) {
    fmt::print("  {}\n      {}\n", shorter_path(study.file), study.description);
  }
  return exit_ok;
}

int with_messages(const std::function<int()>& command) {
  try {
    const int code = command();
    std::cout.flush();
    return code;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    const std::size_t count = error.problems().size();
    if (count > 1) std::cerr << count << " problems\n";
    return exit_bad_input;
  } catch (const std::filesystem::filesystem_error& error) {  // before a run begins
    std::cerr << printable(error.path1().string(), 400) << ": cannot be used ("
              << error.code().message() << ")\n";
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::cerr << "zona: " << error.what() << '\n';
    return exit_failed;
  }
}

}  // namespace zona::studies
