#pragma once

namespace zona::studies::bench {

/// Prints the tables of docs/verification/beam.md: errors and run times of the beam's integrators
/// by elements and steps. Takes a minute. Returns exit_ok.
int print_integrators_of_the_beam();

}  // namespace zona::studies::bench
