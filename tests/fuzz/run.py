"""Runs the fuzzers, each for so many seconds, and tells what they found.

run.py FOLDER SECONDS: FOLDER holds the programs fuzz_*; it also gets `corpus`, the inputs that reach something
new, kept from run to run, and `findings`. Exit code 1 when there is a finding in Zona, 0 otherwise.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TARGETS = ("study_files", "csv_traces", "hdf5_traces", "checkpoints")
here = pathlib.Path(__file__).resolve().parent
folder = pathlib.Path(sys.argv[1]).resolve()
seconds = int(sys.argv[2])


# HDF5 copes with a malloc that fails; `new` stops the fuzzer all the same.
options = "quarantine_size_mb=64:allocator_may_return_null=1"


def environment(scratch):
    """Where inputs are written, and how the sanitizers report: with whole stacks."""
    return {**os.environ, "TMPDIR": scratch, "UBSAN_OPTIONS": "print_stacktrace=1",
            "ASAN_OPTIONS": options + ":fast_unwind_on_malloc=0:fast_unwind_on_check=0",
            "LSAN_OPTIONS": f"suppressions={here / 'leaks.txt'}:print_suppressions=0"}


def fuzz(target, scratch):
    """Leaves findings behind; returns what libFuzzer said."""
    corpus, findings = folder / "corpus" / target, folder / "findings" / target
    corpus.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(findings, ignore_errors=True)
    findings.mkdir(parents=True)
    dictionary = folder / f"{target}.dict"
    command = [folder / f"fuzz_{target}", "-fork=1", "-ignore_crashes=1", "-ignore_ooms=1",
               "-ignore_timeouts=1", "-timeout=10", "-rss_limit_mb=2048", f"-max_total_time={seconds}",
               f"-artifact_prefix={findings}/", *([f"-dict={dictionary}"] if dictionary.exists() else []),
               corpus, folder / "seeds" / target]
    environ = environment(scratch)
    environ["ASAN_OPTIONS"] = options  # whole stacks make it slow
    done = subprocess.run([str(part) for part in command], env=environ, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    return done.stdout.decode(errors="replace")


def replay(target, finding, scratch):
    try:
        done = subprocess.run([str(folder / f"fuzz_{target}"), "-timeout=10", "-rss_limit_mb=2048",
                               str(finding)], env=environment(scratch), stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        return 1, "hang"
    return done.returncode, done.stdout.decode(errors="replace")


def is_in_hdf5(report):
    """Whether libhdf5 fails by itself: in its own code, and not on memory that Zona gave it."""
    if "libFuzzer: timeout" in report or re.search(r"global variable '[^']*zona", report):
        return False  # who repeats the call cannot be told from one stack; the memory is Zona's
    stacks = re.split(r"\n\s*\n|allocated by thread.*|previously allocated.*", report)
    stacks = [[line for line in stack.splitlines() if re.match(r"\s*#\d+ ", line)] for stack in stacks]
    stacks = [stack for stack in stacks if stack]
    return bool(stacks) and all(owner(stack) == "hdf5" for stack in stacks)


def owner(stack):
    for line in stack:
        if "libhdf5" in line:
            return "hdf5"
        if " zona::" in line or "LLVMFuzzerTestOneInput" in line:
            return "zona"
    return "unknown"


def summary_of(report):
    lines = [line for line in report.splitlines()
             if re.search(r"runtime error|ERROR: |broken promise|terminate called|what\(\):", line)]
    return lines[0][:160] if lines else "no report"


def sort_findings(target, scratch):
    """Findings in Zona, the number of those in libhdf5, and of those that do not happen again."""
    ours, of_hdf5, gone = [], 0, 0
    for finding in sorted((folder / "findings" / target).iterdir()):
        code, report = replay(target, finding, scratch)
        if code == 0:
            gone += 1
        elif is_in_hdf5(report):
            of_hdf5 += 1
        else:
            ours.append((finding, summary_of(report)))
    return ours, of_hdf5, gone


def try_target(target):
    with tempfile.TemporaryDirectory(prefix="zona_fuzz_") as scratch:
        return fuzz(target, scratch), *sort_findings(target, scratch)


def main():
    failed = False
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as side_by_side:
        outcomes = list(side_by_side.map(try_target, TARGETS))
    for target, (said, ours, of_hdf5, gone) in zip(TARGETS, outcomes):
        rounds = re.findall(r"#(\d+): cov: (\d+) ft: (\d+) corp: (\d+)", said)
        if not rounds:
            print(f"{target}: did not run\n{said[-2000:]}")
            failed = True
            continue
        runs, edges, _, inputs = map(int, rounds[-1])
        print(f"{target}: {runs} executions, {runs / seconds:.0f} per s, {edges} edges, {inputs} inputs, "
              f"{len(ours)} findings" + (f", and {of_hdf5} inside libhdf5" if of_hdf5 else "") +
              (f", and {gone} that did not happen again" if gone else ""), flush=True)
        for finding, summary in ours:
            print(f"  {finding}\n    {summary}")
        failed |= bool(ours)
    return int(failed)


sys.exit(main())
