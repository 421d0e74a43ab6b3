# What others do with Zona: install it, move it, build on it, run its program. Steps of ctest:
#
#   cmake -DSTEP=install|examples|headers|program -DBUILD=... -DSOURCE=... -DSCRATCH=... -P library.cmake
#
# The prefix is moved once it is installed, so that nothing works that knows where it was.
set(installed ${SCRATCH}/installed)
set(prefix ${SCRATCH}/moved)

# Runs a command, keeps what it prints in `output`, stops where it fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${printed}")
  endif()
  set(output "${printed}" PARENT_SCOPE)
endfunction()

# Stops if `text` names the source or the build tree.
function(refuse_trees what text)
  string(REPLACE ${SCRATCH} "" text "${text}")
  foreach(tree ${SOURCE} ${BUILD})
    string(FIND "${text}" ${tree}/ place)
    if(place GREATER_EQUAL 0)
      string(SUBSTRING "${text}" ${place} 200 excerpt)
      message(FATAL_ERROR "${what} refers to ${excerpt}")
    endif()
  endforeach()
endfunction()

function(require_text what text part)
  string(FIND "${text}" "${part}" place)
  if(place LESS 0)
    message(FATAL_ERROR "${what} lacks '${part}':\n${text}")
  endif()
endfunction()

if(STEP STREQUAL install)
  file(REMOVE_RECURSE ${SCRATCH})
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${installed})
  file(RENAME ${installed} ${prefix})
  file(GLOB_RECURSE package ${prefix}/*.cmake)
  foreach(file ${package})
    file(READ ${file} text)
    refuse_trees(${file} "${text}")
  endforeach()

elseif(STEP MATCHES "examples|headers")
  # Others need neither deal.II nor what the libraries link privately.
  foreach(unneeded deal.II SUNDIALS MPI HDF5 PkgConfig fmt)
    list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${unneeded}=ON)
  endforeach()
  set(options --fresh -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${prefix}
      "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Werror" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${without})
  if(STEP STREQUAL examples)
    set(folder ${SCRATCH}/examples)
    run(${CMAKE_COMMAND} -S ${prefix}/share/zona/examples -B ${folder} ${options})
    file(READ ${folder}/compile_commands.json commands)
    refuse_trees("a compiler command of the examples" "${commands}")
    run(${CMAKE_COMMAND} --build ${folder} -j 1)
    run(${CTEST} --test-dir ${folder} --output-on-failure --no-tests=error)
    message("${output}")
  else()
    # All headers at once, each of which must find what it includes.
    file(GLOB_RECURSE headers RELATIVE ${prefix}/include/zona ${prefix}/include/zona/*.h)
    list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
    list(JOIN headers "" source)
    file(WRITE ${SCRATCH}/headers/headers.cc "${source}")
    file(WRITE ${SCRATCH}/headers/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(headers LANGUAGES CXX)
find_package(zona REQUIRED COMPONENTS mpm beam coupling)
add_library(headers OBJECT headers.cc)
target_link_libraries(headers PRIVATE zona::coupling)
")
    run(${CMAKE_COMMAND} -S ${SCRATCH}/headers -B ${SCRATCH}/headers/build ${options})
    run(${CMAKE_COMMAND} --build ${SCRATCH}/headers/build)
  endif()

elseif(STEP STREQUAL program)
  set(zona ${prefix}/bin/zona)
  # Marks in the installed files tell them from those of the source tree.
  file(WRITE ${prefix}/share/zona/studies/marked.toml "# A study of the prefix.
study = \"vibration\"
fill.fluids = [\"mercury\"]
pulse.durations = [\"60 us\"]
time.end = \"1 ms\"
")
  file(APPEND ${prefix}/share/zona/report/page.css "/* the page of the prefix */\n")
  run(${zona} list)
  require_text("zona list" "${output}" "A study of the prefix.")
  run(${zona} check ${prefix}/share/zona/studies/marked.toml)

  set(directory ${SCRATCH}/run)
  run(${zona} run ${prefix}/share/zona/studies/marked.toml --quiet --out ${directory})
  run(${zona} report ${directory})
  file(READ ${directory}/report.html page)
  require_text("the report" "${page}" "the page of the prefix")

  # The figures of `zona verify` are drawn by a script.
  if(NOT EXISTS ${prefix}/share/zona/report/draw_verification.py)
    message(FATAL_ERROR "draw_verification.py is not installed")
  endif()
endif()
