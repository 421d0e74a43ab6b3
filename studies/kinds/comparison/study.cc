#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "studies/kinds/piercing/run.h"
#include "studies/kinds/piercing/scheme_tables.h"
#include "studies/kinds/piercing/study.h"
#include "studies/parameters/fill_table.h"
#include "studies/run/interrupt.h"
#include "studies/run/parallel.h"
#include "studies/run/run_directory.h"
#include "studies/run/session.h"
#include "studies/simulation/cost_forecast.h"

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

/// A column of the table: a result of each fill.
struct ResultColumn {
  std::string header;
  std::string key;  ///< in the results
  double factor;    ///< from SI
  int digits;
};

const std::vector<ResultColumn>& table_columns() {
  static const std::vector<ResultColumn> columns{
      {"tip [um]", "tip_amplitude", 1e6, 2},
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

/// Fills that run side by side, which uses the threads better for small models.
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

/// Runs a fill in its own directory, as a part of the current stage.
void run_fill(const PiercingCase& fill, int part, int threads, const Configuration& study,
              Session& session, nlohmann::json& results) {
  const std::shared_ptr<spdlog::logger> log = session.directory.log_of(fill.fluid.name);
  const SimulationContext context{study,
                                  output_plan(study, simulation_end(study)),
                                  checkpoint_plan(study, session.resume),
                                  session.directory.file(directory_name(fill.fluid.name)),
                                  threads,
                                  *log,
                                  session.progress,
                                  part};
  std::filesystem::create_directories(context.directory);
  log->info(piercing_cost(fill).text);
  run_piercing(fill, context, results);
}

/// Adds the fills of a round to the results. Throws the first failure after all have ended.
void run_round(const Round& round, const Configuration& study, Session& session) {
  const std::size_t count = round.fills.size();
  std::vector<nlohmann::json> results(count);
  session.progress.start(label(round), round.fills.front()->end, static_cast<int>(count));
  ParallelLoop loop(count, {static_cast<int>(count), round.threads}, [&](std::size_t f) {
    run_fill(*round.fills[f], static_cast<int>(f), round.threads, study, session, results[f]);
  });
  loop.join();
  session.progress.finish();
  for (auto& entry : results) {
    if (!entry.is_null()) session.results.push_back(std::move(entry));
  }
  loop.rethrow();
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
      write_table(session);  // keeps the results of the other fills
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
  const auto forecast = [&] {
    const PiercingCase& first = cases.front();
    CostForecast cost = forecast_cost(build_piercing(first.setup), first.step, first.end,
                                      output_plan(study, first.end), rounds.front().threads);
    cost.seconds *= static_cast<double>(rounds.size());
    cost.memory += cost.own_memory * static_cast<double>(rounds.front().fills.size() - 1);
    cost.disk *= static_cast<double>(cases.size());
    return cost;
  };
  return forecast_text(forecast, threads);
}

}  // namespace zona::studies
