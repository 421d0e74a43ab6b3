#include <filesystem>
#include <string>
#include <vector>

#include "studies/input/configuration.h"
#include "studies/kinds/comparison/schema.h"
#include "studies/kinds/material_point/schema.h"
#include "studies/kinds/piercing/schema.h"
#include "studies/kinds/scene/schema.h"
#include "studies/kinds/search/schema.h"
#include "studies/kinds/vibration/schema.h"
#include "studies/run/resolved_study.h"
#include "tests/fuzz/input_file.h"

using namespace zona;
using namespace zona::studies;

namespace {

const std::vector<const Schema*>& schemas() {
  static const std::vector<const Schema*> pointers{&vibration_schema(),  &piercing_schema(),
                                                   &comparison_schema(), &search_schema(),
                                                   &scene_schema(),      &material_point_schema()};
  return pointers;
}

/// The bundled studies stand next to the input, so that it can be based on them.
void copy_studies(const std::string& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(ZONA_SOURCE_DIR "/studies")) {
    const std::string ending = entry.path().extension();
    if (ending == ".toml" || ending == ".csv") std::filesystem::copy(entry.path(), folder);
  }
}

/// What follows "#set " in a line of the input is an override, as of --set.
std::vector<std::string> overrides_in(std::string_view text) {
  constexpr std::string_view mark = "\n#set ";
  std::vector<std::string> overrides;
  for (auto at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const std::size_t begin = at + mark.size();
    overrides.emplace_back(text.substr(begin, text.find('\n', begin) - begin));
  }
  return overrides;
}

void evaluate(const std::vector<Formula>& formulas) {
  for (const Formula& formula : formulas) {
    for (const double x : {0.0, 1e-6, -3.0}) {
      try {
        formula.at(Eigen::Vector3d(x, 2 * x, -x), x);
      } catch (const FormulaError&) {
      }
    }
  }
}

void evaluate_formulas(const Configuration& study) {
  for (const std::string& table : study.tables()) {
    for (const std::string& key : study.keys_of(table)) {
      const Parameter& parameter = *study.schema().find(key);
      if (parameter.kind != Parameter::Kind::formula || study.is_auto(key)) continue;
      evaluate(parameter.is_list ? study.formulas(key) : std::vector{study.formula(key)});
    }
  }
}

/// What `zona run` stores as study.toml is the same study again.
void check_resolved(const Configuration& study, const std::string& folder) {
  const std::filesystem::path copy = folder + "/resolved.toml";
  std::ofstream(copy, std::ios::binary) << resolved_study(study);
  try {
    const std::string difference = first_difference(study, load_configuration(copy, {}, schemas()));
    if (!difference.empty()) tests::broken("the resolved study differs: " + difference);
  } catch (const InputError& error) {
    tests::broken(std::string("the resolved study is valid: ") + error.what());
  }
}

}  // namespace

/// Any bytes are a study, or an InputError with its problems.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tests::InputFile file("study.toml");
  static const bool copied = (copy_studies(file.folder.path()), true);
  const std::string_view text = tests::as_text(data, size);
  file.write(text);
  try {
    const Configuration study = load_configuration(file.path(), overrides_in(text), schemas());
    evaluate_formulas(study);
    check_resolved(study, file.folder.path());
  } catch (const InputError& error) {
    if (error.problems().empty()) tests::broken("an InputError has problems");
    for (const Problem& problem : error.problems()) {
      if (problem.message.empty()) tests::broken("a problem has a message");
    }
  }
  return copied ? 0 : 1;
}
