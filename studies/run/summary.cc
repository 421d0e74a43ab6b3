#include "studies/run/summary.h"

#include "mpm/step/instruction_set.h"
#include "studies/run/provenance.h"
#include "studies/run/version.h"

namespace zona::studies {

std::string summary_text(const Configuration& study, const RunOutcome& outcome,
                         const nlohmann::json& results) {
  nlohmann::ordered_json summary;
  summary["format"] = 1;  // of studies/report/summary.schema.json
  summary["study"] = study.kind();
  summary["study_file"] = study.file().string();
  summary["status"] = outcome.status;
  if (!outcome.message.empty()) summary["message"] = outcome.message;
  summary["units"] = "SI: m, kg, s, Pa, N, J, unless a name says otherwise";
  summary["results"] = results;
  summary["cost"] = {{"wall_time", outcome.wall_time}, {"threads", outcome.threads}};
  summary["started"] = outcome.started;
  summary["zona"] = zona_version();
  summary["commit"] = commit();
  summary["modified"] = is_modified();
  summary["compiler"] = compiler_version();
  summary["processor"] = processor_name();
  summary["instruction_set"] = mpm::instruction_set();
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;  // of invalid UTF-8
  return summary.dump(2, ' ', false, replace) + "\n";
}

}  // namespace zona::studies
