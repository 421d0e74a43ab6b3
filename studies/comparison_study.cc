#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <memory>

#include "studies/interrupt.h"
#include "studies/piercing_run.h"
#include "studies/piercing_study.h"
#include "studies/piercing_values.h"
#include "studies/run_directory.h"

namespace zona::studies {

namespace {

std::vector<PiercingCase> make_cases(const Configuration& study) {
  const auto names = study.texts("fill.fluids");
  const auto densities = study.quantities("fill.fluids");
  std::vector<PiercingCase> cases;
  for (std::size_t f = 0; f < names.size(); ++f) {
    cases.push_back(make_piercing_case(study, names[f], densities[f]));
  }
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

}  // namespace

Job prepare_comparison(const Configuration& study) {
  const auto cases = std::make_shared<std::vector<PiercingCase>>(make_cases(study));
  return [cases, plan = output_plan(study, simulation_end(study))](Session& session) {
    session.results = nlohmann::json::array();
    for (const auto& piercing : *cases) {
      if (Interrupt::requested()) break;
      const auto directory = session.directory.file(directory_name(piercing.fluid));
      std::filesystem::create_directories(directory);
      session.directory.log(fmt::format("{}: {}", piercing.fluid, piercing_cost(piercing).text));
      session.results.emplace_back();
      try {
        run_piercing(piercing, plan, directory, piercing.fluid, session, session.results.back());
      } catch (...) {
        write_table(session);  // what the other fills came to is not lost
        throw;
      }
    }
    write_table(session);
  };
}

StudyCost estimate_comparison(const Configuration& study) {
  StudyCost sum;
  for (const auto& piercing : make_cases(study)) {
    const StudyCost cost = piercing_cost(piercing);
    sum.text += fmt::format("{:<12} {}\n", piercing.fluid, cost.text);
    sum.point_steps += cost.point_steps;
  }
  return sum;
}

}  // namespace zona::studies
