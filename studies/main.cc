#include <fenv.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "studies/bench/bench.h"
#include "studies/program/check_study.h"
#include "studies/program/exit_code.h"
#include "studies/program/list_studies.h"
#include "studies/program/reference.h"
#include "studies/program/run_study.h"
#include "studies/program/status.h"
#include "studies/report/report.h"
#include "studies/run/provenance.h"
#include "studies/verification/verify.h"

namespace {

using namespace zona::studies;

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command
      .add_option("--set", overrides,
                  "Override a parameter with a TOML value, e.g. --set 'grid.cell=\"4 um\"'")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_run(CLI::App& program, RunOptions& options, int& code) {
  CLI::App& command = *program.add_subcommand("run", "Compute a study");
  command.add_option("FILE", options.file, "Study file")->required();
  CLI::Option* out = command.add_option(
      "--out", options.out, "New directory for the results (default: runs/<name of FILE>)");
  add_overrides(command, options.overrides);
  command
      .add_option("--threads", options.threads, "Number of threads (default: as the study says)")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--quiet", options.quiet, "Show no progress");
  command.add_flag("--resume", options.resume,
                   "Go on with an interrupted run: that of --out, else the last of this FILE; FILE "
                   "may also be the run's directory");
  command.callback([&options, &code, out] {
    options.out_given = out->count() > 0;
    code = with_messages([&] { return run_study(options); });
  });
}

void add_check(CLI::App& program, RunOptions& options, int& code) {
  CLI::App& command =
      *program.add_subcommand("check", "Validate a study and print its parameters in SI");
  command.add_option("FILE", options.file, "Study file")->required();
  add_overrides(command, options.overrides);
  command.callback(
      [&] { code = with_messages([&] { return check_study(options.file, options.overrides); }); });
}

void add_verify(CLI::App& program, VerifyOptions& options, int& code) {
  CLI::App& command = *program.add_subcommand(
      "verify", "Compute the verification cases and hold them against their references");
  command.add_option("CASE", options.cases, "Cases (default: all)");
  command.add_flag("--quick", options.quick, "Smaller runs, within minutes");
  command.add_flag("--list", options.list, "Only list the cases and what they would cost");
  command.add_option("--out", options.out, "Directory of the runs (default: runs/verification)");
  command.add_option("--page", options.page,
                     "Write the page here, its figures beside it (default: into the directory)");
  command
      .add_option("--threads", options.threads,
                  "Number of threads of all runs together (default: all)")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--quiet", options.quiet, "Show no progress");
  command.callback([&] { code = with_messages([&] { return verify(options); }); });
}

void add_bench(CLI::App& program, bench::BenchOptions& options, int& code) {
  CLI::App& command = *program.add_subcommand(
      "bench", "Measure how fast the steps run and what the memory would allow");
  command.add_option("SCENE", options.scenes,
                     "Scenes (default: those that --list does not bracket)");
  command.add_flag("--list", options.list, "Only list the scenes");
  command.add_option("--seconds", options.seconds, "Time for each scene and number of threads")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  command.add_option("--threads", options.threads, "Number of threads next to one (default: all)")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--json", options.json, "Print JSON");
  command.add_flag("--beam", options.beam,
                   "Instead print how exact and how fast the integrators of the beam are");
  command.callback([&] { code = with_messages([&] { return bench::run_bench(options); }); });
}

void add_report(CLI::App& program, RunOptions& options, int& code) {
  CLI::App& command =
      *program.add_subcommand("report", "Write a page with charts, pictures and a replay of a run");
  command.add_option("DIRECTORY", options.file, "Directory of a run")->required();
  command.callback([&] { code = with_messages([&] { return write_report(options.file); }); });
}

void add_status(CLI::App& program, RunOptions& options, int& code) {
  CLI::App& command = *program.add_subcommand("status", "Tell how far a run is, from any terminal");
  command.add_option("DIRECTORY", options.file, "Directory of a run")->required();
  command.callback([&] { code = with_messages([&] { return show_status(options.file); }); });
}

int print(const std::string& text) {
  std::cout << text;
  return exit_ok;
}

void add_references(CLI::App& program, std::string& key, int& code) {
  program.add_subcommand("list", "List the study kinds and the bundled study files")->callback([&] {
    code = with_messages(list_studies);
  });
  CLI::App& help = *program.add_subcommand("help", "Explain a parameter, a table or a study kind");
  help.add_option("KEY", key, "E.g. grid.cell, grid or piercing");
  help.callback([&] {
    code =
        with_messages([&] { return print(key.empty() ? help_overview() : parameter_help(key)); });
  });
  program.add_subcommand("reference", "Write the reference of all parameters as Markdown")
      ->callback([&] { code = with_messages([] { return print(parameter_reference()); }); });
}

}  // namespace

int main(int argc, char** argv) {
#ifdef ZONA_TRAP_FLOATING_POINT
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
  CLI::App program("Piezo-ICSI from the voltage pulse to the pierced zona pellucida.", "zona");
  program.set_version_flag("--version", std::function<std::string()>(provenance));
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 done, 2 the input is wrong, 3 the run failed, 4 a check of zona verify "
      "failed, 130 interrupted.");
  RunOptions options;
  VerifyOptions verification;
  bench::BenchOptions bench_options;
  std::string key;
  int code = exit_ok;
  add_run(program, options, code);
  add_check(program, options, code);
  add_status(program, options, code);
  add_report(program, options, code);
  add_verify(program, verification, code);
  add_bench(program, bench_options, code);
  add_references(program, key, code);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_ok : exit_bad_input;
  }
  return code;
}
