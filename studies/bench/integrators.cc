#include "studies/bench/integrators.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "beam/exact/cantilever.h"
#include "beam/pipette/fluid.h"
#include "beam/system/beam_system.h"
#include "beam/time/integrate.h"
#include "studies/program/exit_code.h"

namespace zona::studies::bench {

using namespace beam;

namespace {

const Sampling run{5e-3, 0.6e-6};
constexpr int levels[] = {20, 40, 80, 160};

/// One point of Figure 5.28.
struct PulseCase {
  std::string fluid;
  double duration;  ///< [s]
};

std::vector<PulseCase> figure_5_28() {
  std::vector<PulseCase> cases;
  for (const char* fluid : {"none", "water", "fluorinert", "mercury"})
    for (int duration = 60; duration <= 600; duration += 60)
      cases.push_back({fluid, duration * 1e-6});
  return cases;
}

/// Table 5.7 by name.
Pipette pipette_with(const std::string& fluid, int elements = 20) {
  Pipette pipette;
  pipette.fill_density = named_fluid(fluid).density;
  pipette.fill_viscosity = named_fluid(fluid).viscosity;
  pipette.elements = elements;
  return pipette;
}

double exact_ratio(const PulseCase& pulse_case) {
  const ExactCantilever exact(uniform_beam(pipette_with(pulse_case.fluid)), 1000);
  return amplitude_ratio(exact.tip_history(triangular_pulse(1, pulse_case.duration), run), 1);
}

double ratio(const PulseCase& pulse_case, int elements, const Integrator& integrator) {
  const BeamSystem system = cantilever(pipette_with(pulse_case.fluid, elements));
  const auto pulse = triangular_pulse(1, pulse_case.duration);
  return amplitude_ratio(integrate(system, pulse, run, integrator), 1);
}

std::string start_of_row(const PulseCase& pulse_case, double exact) {
  return fmt::format("| {} | {:.0f} | {:.4f} |", pulse_case.fluid, pulse_case.duration * 1e6,
                     exact);
}

/// Greatest and mean magnitude of the errors of a column.
struct Errors {
  double greatest = 0, sum = 0;
  int count = 0;
  void add(double error) {
    greatest = std::max(greatest, std::abs(error));
    sum += std::abs(error);
    ++count;
  }
  std::string text() const { return fmt::format(" {:.4f} / {:.4f} |", greatest, sum / count); }
};

/// Integrators on twenty elements.
void print_integrators() {
  fmt::print(
      "| fluid | us | exact | Newmark | error | modal | error | ARKODE | ARKODE - modal |\n"
      "| --- | --: | --: | --: | --: | --: | --: | --: | --: |\n");
  Errors newmark_errors, modal_errors, arkode_errors;
  for (const auto& pulse_case : figure_5_28()) {
    const double exact = exact_ratio(pulse_case);
    const double newmark = ratio(pulse_case, 20, Newmark{});
    const double modal = ratio(pulse_case, 20, Modal{});
    const double arkode = ratio(pulse_case, 20, Arkode{1e-5, 1e-7});
    newmark_errors.add(newmark - exact);
    modal_errors.add(modal - exact);
    arkode_errors.add(arkode - modal);
    fmt::print("{} {:.4f} | {:+.4f} | {:.4f} | {:+.4f} | {:.4f} | {:+.1e} |\n",
               start_of_row(pulse_case, exact), newmark, newmark - exact, modal, modal - exact,
               arkode, arkode - modal);
  }
  fmt::print("| greatest / mean | | | |{} |{} |{}\n", newmark_errors.text(), modal_errors.text(),
             arkode_errors.text());
}

/// Convergence with the elements.
void print_elements() {
  fmt::print(
      "| fluid | us | exact | 20 | 40 | 80 | 160 |\n"
      "| --- | --: | --: | --: | --: | --: | --: |\n");
  Errors errors[4];
  for (const auto& pulse_case : figure_5_28()) {
    const double exact = exact_ratio(pulse_case);
    std::string row = start_of_row(pulse_case, exact);
    for (int level = 0; level < 4; ++level) {
      const double error = ratio(pulse_case, levels[level], Modal{}) - exact;
      errors[level].add(error);
      row += fmt::format(" {:+.4f} |", error);
    }
    fmt::print("{}\n", row);
  }
  std::string row = "| greatest / mean | | |";
  for (const Errors& level : errors) row += level.text();
  fmt::print("{}\n", row);
}

/// Newmark's errors with elements and steps.
void print_steps() {
  fmt::print("| step | 20 | 40 | 80 | 160 |\n| --- | --: | --: | --: | --: |\n");
  for (const int substeps : {1, 4, 16}) {
    std::string row = fmt::format("| {:.4g} us |", 0.6 / substeps);
    for (const int elements : levels) {
      Errors errors;
      for (const auto& pulse_case : figure_5_28())
        errors.add(ratio(pulse_case, elements, Newmark{substeps}) - exact_ratio(pulse_case));
      row += errors.text();
    }
    fmt::print("{}\n", row);
  }
}

/// Run times.
void print_times() {
  fmt::print("| elements | Newmark | modal | ARKODE |\n| --: | --: | --: | --: |\n");
  for (const int elements : {20, 80}) {
    std::string row = fmt::format("| {} |", elements);
    for (const Integrator integrator :
         {Integrator(Newmark{}), Integrator(Modal{}), Integrator(Arkode{1e-4, 1e-6})}) {
      double best = 1e9;
      for (int repeat = 0; repeat < 3; ++repeat) {
        const auto started = std::chrono::steady_clock::now();
        ratio({"mercury", 60e-6}, elements, integrator);
        const std::chrono::duration<double> span = std::chrono::steady_clock::now() - started;
        best = std::min(best, span.count());
      }
      row += fmt::format(" {:.1f} ms |", 1e3 * best);
    }
    fmt::print("{}\n", row);
  }
}

}  // namespace

int print_integrators_of_the_beam() {
  print_integrators();
  fmt::print("\n");
  print_elements();
  fmt::print("\n");
  print_steps();
  fmt::print("\n");
  print_times();
  return exit_ok;
}

}  // namespace zona::studies::bench
