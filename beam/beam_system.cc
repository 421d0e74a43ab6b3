#include "beam/beam_system.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

#include "beam/elements/elements.h"

namespace zona::beam {

namespace {

using Assemble = decltype(&zona_beam_assemble);

/// From the library that stands next to this one.
Assemble load_assembly() {
  void* const library = dlopen("libzona_beam_elements.so", RTLD_NOW | RTLD_LOCAL);
  void* const function = library != nullptr ? dlsym(library, "zona_beam_assemble") : nullptr;
  if (function == nullptr)
    throw std::runtime_error(
        fmt::format("the beam's finite elements cannot be loaded: {}; install Zona and deal.II "
                    "again",
                    dlerror()));
  return reinterpret_cast<Assemble>(function);
}

}  // namespace

BeamSystem assemble(const Section& section, const BeamLayout& layout) {
  static const Assemble assembly = load_assembly();
  BeamSystem system;
  assembly(section, layout, system);
  return system;
}

BeamSystem cantilever(const Pipette& pipette) {
  const UniformBeam beam = uniform_beam(pipette);
  BeamSystem system =
      assemble(section_of(beam), {pipette.elements, Supports::clamped_free, beam.length});
  system.damping_alpha = pipette.damping_alpha;
  system.damping_beta = pipette.damping_beta;
  return system;
}

BeamSystem simply_supported(const Pipette& pipette) {
  const UniformBeam beam = uniform_beam(pipette);
  BeamSystem system =
      assemble(section_of(beam), {pipette.elements, Supports::pinned_pinned, beam.length / 2});
  system.damping_alpha = pipette.damping_alpha;
  system.damping_beta = pipette.damping_beta;
  return system;
}

}  // namespace zona::beam
