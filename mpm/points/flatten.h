#pragma once

/// Marks a kernel: the compiler inlines everything that it calls, whatever the size of the file.
/// Without it g++ leaves the loads of point groups out of line and a step takes a quarter more
/// time. CMake defines it as nothing where compile time matters more: with sanitizers, and for the
/// baseline instruction set.
#ifndef ZONA_FLATTEN
#define ZONA_FLATTEN [[gnu::flatten]]
#endif
