#include "beam/system/elements_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace zona::beam {

namespace {

template <class Function>
Function find_function(void* library, const char* name) {
  void* const function = library != nullptr ? dlsym(library, name) : nullptr;
  if (function == nullptr)
    throw std::runtime_error(
        fmt::format("the finite elements of the beam cannot be loaded: {}; reinstall Zona and "
                    "deal.II",
                    dlerror()));
  return reinterpret_cast<Function>(function);
}

/// Folder of the library that contains this function, with a slash; empty if unknown.
std::string own_folder() {
  Dl_info self{};
  if (dladdr(reinterpret_cast<void*>(&own_folder), &self) == 0 || self.dli_fname == nullptr)
    return "";
  const std::string file = self.dli_fname;
  return file.substr(0, file.rfind('/') + 1);
}

}  // namespace

const ElementsLibrary& elements_library() {
  static const ElementsLibrary functions = [] {
    void* const library =
        dlopen((own_folder() + "libzona_beam_elements.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    return ElementsLibrary{
        find_function<decltype(&zona_beam_assemble)>(library, "zona_beam_assemble"),
        find_function<decltype(&zona_beam_quadrature_points)>(library,
                                                              "zona_beam_quadrature_points")};
  }();
  return functions;
}

}  // namespace zona::beam
