#include <iostream>

#include "studies/input/input_error.h"
#include "studies/program/bundled_studies.h"
#include "studies/program/exit_code.h"
#include "studies/program/python_script.h"
#include "studies/report/report.h"

namespace zona::studies {

int write_report(const std::filesystem::path& directory) {
  for (const char* file : {"study.toml", "summary.json"}) {
    if (!std::filesystem::exists(directory / file)) {
      throw InputError(directory.string(),
                       std::string("holds no ") + file +
                           "; give the directory of a run that has ended or was interrupted");
    }
  }
  const auto outcome = run_script(report_directory() / "report.py", {directory});
  if (!outcome.succeeded) throw RunError("no report was written: " + end_of(outcome.output));
  std::cout << outcome.output;
  return exit_ok;
}

}  // namespace zona::studies
