# SPDX-License-Identifier: MIT
# cmake -D DIRECTORC=<directorc> -D COMPILER=<compiler> -D CORE=<the runtime's library> -D SOURCE=<folder with runtime/> -D WORK=<folder> -P small_index.cmake
# A program of which some files are compiled with DIRECTOR_SMALL_INDEX has objects of two sizes for one type. So the linker must refuse it, and name
# the definition: also if only the runtime's library is compiled without.
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/it.yaml "behaviour: it\nlanguage: 1\nroots: [One]\ngroups:\n  One: {module: bodies}\n")
file(WRITE ${WORK}/main.cpp "#include \"it.hpp\"
namespace {
struct Bodies final : it::Bodies {
  director::Outcome provide(it::One::Default& run) override { return run.keep(); }
};
} // namespace
int main() {
  Bodies bodies;
  it::Behaviour behaviour{bodies};
  (void)behaviour.request<it::One>();
  behaviour.step();
}
")
execute_process(COMMAND ${DIRECTORC} generate ${WORK}/it.yaml -o ${WORK} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
foreach(source main it)
  execute_process(COMMAND ${COMPILER} -std=c++20 -I${SOURCE} -I${WORK} -c ${WORK}/${source}.cpp -o ${WORK}/${source}.large.o COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${COMPILER} -std=c++20 -DDIRECTOR_SMALL_INDEX -I${SOURCE} -I${WORK} -c ${WORK}/${source}.cpp -o ${WORK}/${source}.small.o
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(main large small)
  foreach(it large small)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} ${WORK}/main.${main}.o ${WORK}/it.${it}.o ${CORE} -o ${WORK}/linked
                    RESULT_VARIABLE result ERROR_VARIABLE said)
    if(main STREQUAL large AND it STREQUAL large)
      if(NOT result EQUAL 0)
        message(FATAL_ERROR "all files without DIRECTOR_SMALL_INDEX must be linked; said: ${said}")
      endif()
      execute_process(COMMAND ${WORK}/linked COMMAND_ERROR_IS_FATAL ANY)
    elseif(result EQUAL 0 OR NOT said MATCHES "undefined reference to [^\n]*with(out)?_DIRECTOR_SMALL_INDEX")
      message(FATAL_ERROR "the program is ${main}, the generated file ${it}, the runtime large: they must not be linked; said: ${said}")
    endif()
  endforeach()
endforeach()
