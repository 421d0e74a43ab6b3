#pragma once

namespace zona::studies::bench {

/// Prints the tables of docs/verification/beam.md: how exact the beam's integrators are with their
/// elements and steps, and how fast. Takes a minute. Returns exit_ok.
int print_integrators_of_the_beam();

}  // namespace zona::studies::bench
