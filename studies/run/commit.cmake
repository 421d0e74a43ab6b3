# Writes the git commit of the sources into OUTPUT, a header, at build time:
#
#   cmake -DSOURCE=... -DOUTPUT=... -P commit.cmake
#
# The file stays untouched while the commit is the same. Without git, or in a tree that is not the top of a
# repository, the commit is "unknown".
set(commit unknown)
set(is_modified false)
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 --show-prefix HEAD
  OUTPUT_VARIABLE found RESULT_VARIABLE failure ERROR_QUIET)
# The prefix, a line of its own, is empty at the top.
if(failure EQUAL 0 AND found MATCHES "^\n([0-9a-f]+)\n$")
  set(commit ${CMAKE_MATCH_1})
  execute_process(COMMAND git -C ${SOURCE} --no-optional-locks diff --quiet HEAD --
    RESULT_VARIABLE differs ERROR_QUIET)
  if(NOT differs EQUAL 0)
    set(is_modified true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[#define ZONA_COMMIT "@commit@"
#define ZONA_COMMIT_IS_MODIFIED @is_modified@
]] @ONLY)
