# What decides how public types are laid out and passed (Eigen's alignment, vectors of eight doubles): all
# that link Zona must share it, so it is linked publicly and exported.
add_library(zona_abi INTERFACE)
target_compile_options(zona_abi INTERFACE -Wno-psabi)
target_compile_features(zona_abi INTERFACE cxx_std_17)
# The same for all levels of instructions, whatever Eigen could use.
target_compile_definitions(zona_abi INTERFACE EIGEN_MAX_ALIGN_BYTES=16)

# What every Zona target is compiled with besides; link it privately.
add_library(zona_compiler INTERFACE)
# sqrt of eight lanes is one instruction only where it need not set errno.
target_compile_options(zona_compiler INTERFACE -fno-math-errno)
target_compile_options(zona_compiler INTERFACE -Wall -Wextra -Wpedantic
  # g++ 12 takes the deliberately undefined lanes of its own AVX-512 intrinsics for a mistake.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
if(ZONA_WERROR)
  target_compile_options(zona_compiler INTERFACE -Werror)
endif()
if(ZONA_TRAP_FLOATING_POINT)
  target_compile_definitions(zona_compiler INTERFACE ZONA_TRAP_FLOATING_POINT)
endif()
if(ZONA_SANITIZE)
  target_compile_options(zona_compiler INTERFACE -fsanitize=${ZONA_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(zona_compiler INTERFACE -fsanitize=${ZONA_SANITIZE})
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
