# SPDX-License-Identifier: MIT
# cmake -D DIRECTORC=<directorc> -D COMPILER=<compiler> -D CORE=<the runtime's library> -D SOURCE=<folder with runtime/> -D WORK=<folder> -P one_namespace.cmake
# Two static libraries, each with a behaviour, and one namespace for both: the symbols of the one would serve the other, with the wrong tables. So the
# linker must refuse the program, and link it if the namespaces are different.
file(REMOVE_RECURSE ${WORK})

function(build_library name namespace)
  file(WRITE ${WORK}/${name}.yaml "behaviour: ${name}\nlanguage: 1\ncpp: {namespace: ${namespace}}\nroots: [Go]\ngroups:\n  Go: {module: bodies}\n")
  file(WRITE ${WORK}/use_${name}.cpp "
#include \"${name}.hpp\"
namespace {
struct Bodies final : ${namespace}::Bodies {
  director::Outcome provide(${namespace}::Go::Default& run) override { return run.keep(); }
};
} // namespace
void play_${name}() {
  Bodies bodies;
  ${namespace}::Behaviour behaviour{bodies};
  (void)behaviour.request<${namespace}::Go>();
  behaviour.step();
}
")
  execute_process(COMMAND ${DIRECTORC} generate ${WORK}/${name}.yaml -o ${WORK}/generated COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  foreach(source ${WORK}/use_${name}.cpp ${WORK}/generated/${name}.cpp)
    cmake_path(GET source STEM stem)
    execute_process(COMMAND ${COMPILER} -std=c++20 -I${SOURCE} -I${WORK}/generated -c ${source} -o ${WORK}/${stem}.o COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(REMOVE ${WORK}/lib${name}.a)
  execute_process(COMMAND ar rcs ${WORK}/lib${name}.a ${WORK}/use_${name}.o ${WORK}/${name}.o COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(link_both)
  file(WRITE ${WORK}/main.cpp "void play_plain();\nvoid play_other();\nint main() {\n  play_plain();\n  play_other();\n}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} ${WORK}/main.cpp ${WORK}/libplain.a ${WORK}/libother.a ${CORE} -o ${WORK}/both
                  RESULT_VARIABLE result ERROR_VARIABLE said)
  set(result ${result} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

build_library(plain robot)
build_library(other robot)
link_both()
if(result EQUAL 0 OR NOT said MATCHES "multiple definition of [^\n]*robot::")
  message(FATAL_ERROR "two behaviours of one namespace must not be linked; said: ${said}")
endif()
build_library(other helper)
link_both()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "two behaviours of different namespaces must be linked:\n${said}")
endif()
execute_process(COMMAND ${WORK}/both COMMAND_ERROR_IS_FATAL ANY)
