# What every Zona target is compiled with; link it privately.
add_library(zona_compiler INTERFACE)
# sqrt of eight lanes is one instruction only where it need not set errno.
target_compile_options(zona_compiler INTERFACE -fno-math-errno)
target_compile_options(zona_compiler INTERFACE -Wall -Wextra -Wpedantic
  # Vectors of eight doubles are passed only between inlined functions, so their ABI never matters.
  -Wno-psabi
  # g++ 12 takes the deliberately undefined lanes of its own AVX-512 intrinsics for a mistake.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
if(ZONA_WERROR)
  target_compile_options(zona_compiler INTERFACE -Werror)
endif()
if(ZONA_NATIVE)
  target_compile_options(zona_compiler INTERFACE -march=native)
endif()
if(ZONA_TRAP_FLOATING_POINT)
  target_compile_definitions(zona_compiler INTERFACE ZONA_TRAP_FLOATING_POINT)
endif()
if(ZONA_SANITIZE)
  target_compile_options(zona_compiler INTERFACE -fsanitize=${ZONA_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(zona_compiler INTERFACE -fsanitize=${ZONA_SANITIZE})
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
