#include <fmt/format.h>
#include <omp.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <memory>
#include <thread>

#include "studies/kinds/piercing/run.h"
#include "studies/kinds/piercing/study.h"
#include "studies/kinds/piercing/values.h"
#include "studies/parameters/beam_parameters.h"
#include "studies/run/interrupt.h"
#include "studies/run/run_directory.h"
#include "studies/run/session.h"
#include "studies/simulation/trial.h"

namespace zona::studies {

namespace {

std::vector<PiercingCase> make_cases(const Configuration& study) {
  std::vector<PiercingCase> cases;
  for (const beam::Fluid& fluid : fills_of(study))
    cases.push_back(make_piercing_case(study, fluid));
  return cases;
}

/// A directory's name for a fill: "mercury", "2500_kg_m_3".
std::string directory_name(const std::string& fluid) {
  std::string name;
  for (char c : fluid) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-';
    if (plain || (!name.empty() && name.back() != '_')) name += plain ? c : '_';
  }
  return name;
}

struct Cell {
  std::string header;
  std::string key;
  double factor;
  int digits;
};

const std::vector<Cell>& table_columns() {
  static const std::vector<Cell> columns{{"tip [um]", "tip_amplitude", 1e6, 2},
                                         {"in window [um]", "largest_excursion", 1e6, 2},
                                         {"first failure [us]", "time_of_first_failure", 1e6, 2},
                                         {"failed area [um^2]", "failed_area", 1e12, 1},
                                         {"hole/pipette", "hole_over_pipette", 1, 2},
                                         {"failed points", "failed_points", 1, 0},
                                         {"strain away", "largest_strain_away", 1, 4},
                                         {"deformation [um]", "largest_displacement_away", 1e6, 2},
                                         {"wall [s]", "wall_seconds", 1, 1}};
  return columns;
}

std::string comparison_table(const nlohmann::json& results) {
  std::string table = fmt::format("{:<14}", "fill");
  for (const auto& column : table_columns()) table += fmt::format("{:>20}", column.header);
  for (const auto& entry : results) {
    table += fmt::format("\n{:<14}", entry["fluid"].get<std::string>());
    for (const auto& column : table_columns()) {
      const auto& value = entry[column.key];
      table += value.is_null()
                   ? fmt::format("{:>20}", "none")
                   : fmt::format("{:>20.{}f}", value.get<double>() * column.factor, column.digits);
    }
  }
  return table + "\n";
}

void write_table(Session& session) {
  const std::string table = comparison_table(session.results);
  session.directory.write("comparison.txt", table);
  session.conclusion = table;
}

/// Fills that run side by side: small models use the threads better than one after the other.
struct Round {
  std::vector<const PiercingCase*> fills;
  int threads;  ///< of each
};

std::vector<Round> make_rounds(const std::vector<PiercingCase>& cases, int threads) {
  std::vector<Round> rounds;
  for (std::size_t first = 0; first < cases.size();) {
    const std::size_t count = std::min<std::size_t>(cases.size() - first, threads);
    rounds.push_back({{}, threads / static_cast<int>(count)});
    for (std::size_t f = 0; f < count; ++f) rounds.back().fills.push_back(&cases[first++]);
  }
  return rounds;
}

std::string label(const Round& round) {
  std::string names;
  for (const auto* fill : round.fills) names += (names.empty() ? "" : ", ") + fill->fluid.name;
  return names;
}

/// The fills of a round as entries of the results. Throws the first failure after all have ended.
void run_round(const Round& round, const Configuration& study, Session& session) {
  const OutputPlan plan = output_plan(study, simulation_end(study));
  const CheckpointPlan checkpoints = checkpoint_plan(study, session.resume);
  const int count = static_cast<int>(round.fills.size());
  std::vector<nlohmann::json> results(count);
  std::vector<std::exception_ptr> failures(count);
  std::vector<std::shared_ptr<spdlog::logger>> logs;
  std::vector<std::thread> runs;
  session.progress.start(label(round), round.fills.front()->end, count);
  for (int f = 0; f < count; ++f) {
    const PiercingCase& fill = *round.fills[f];
    logs.push_back(session.directory.log_of(fill.fluid.name));
    const PiercingWork work{study,
                            plan,
                            checkpoints,
                            session.directory.file(directory_name(fill.fluid.name)),
                            round.threads,
                            *logs.back(),
                            session.progress,
                            f};
    std::filesystem::create_directories(work.directory);
    logs.back()->info(piercing_cost(fill).text);
    runs.emplace_back([&fill, work, &entry = results[f], &failure = failures[f]] {
      omp_set_num_threads(work.threads);
      try {
        run_piercing(fill, work, entry);
      } catch (...) {
        failure = std::current_exception();
      }
    });
  }
  for (auto& run : runs) run.join();
  session.progress.finish();
  for (auto& entry : results) {
    if (!entry.is_null()) session.results.push_back(std::move(entry));
  }
  for (const auto& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace

Job prepare_comparison(const Configuration& study) {
  const auto cases = std::make_shared<std::vector<PiercingCase>>(make_cases(study));
  return [study, cases](Session& session) {
    session.results = nlohmann::json::array();
    try {
      for (const Round& round : make_rounds(*cases, session.threads)) {
        if (!Interrupt::requested()) run_round(round, study, session);
      }
    } catch (...) {
      write_table(session);  // what the other fills came to is not lost
      throw;
    }
    write_table(session);
  };
}

StudyCost estimate_comparison(const Configuration& study) {
  StudyCost sum;
  for (const auto& piercing : make_cases(study)) {
    const StudyCost cost = piercing_cost(piercing);
    sum.text += fmt::format("{:<12} {}\n", piercing.fluid.name, cost.text);
    sum.point_steps += cost.point_steps;
  }
  return sum;
}

std::string try_comparison(const Configuration& study, int threads) {
  const std::vector<PiercingCase> cases = make_cases(study);
  const std::vector<Round> rounds = make_rounds(cases, threads);
  const auto trial = [&] {
    const PiercingCase& first = cases.front();
    Trial one = try_simulation(build_piercing(first.setup), first.step, first.end,
                               output_plan(study, first.end), rounds.front().threads);
    one.seconds *= static_cast<double>(rounds.size());
    one.memory += one.own * static_cast<double>(rounds.front().fills.size() - 1);
    one.disk *= static_cast<double>(cases.size());
    return one;
  };
  return trial_text(trial, threads);
}

}  // namespace zona::studies
