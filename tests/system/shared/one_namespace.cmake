# SPDX-License-Identifier: MIT
# cmake -D DIRECTORC=<directorc> -D COMPILER=<compiler> -D CORE=<the runtime's library> -D SOURCE=<folder with runtime/> -D WORK=<folder> -P one_namespace.cmake
# Two static libraries, each with a behaviour, and one namespace for both: the symbols of the one would serve the other, with the wrong tables. So the
# linker must refuse the program, also if both have one name, and link it if the namespaces are different.
file(REMOVE_RECURSE ${WORK})

# A library with a behaviour, whose root task is called as the library is, and a function that plays it.
function(build_library library behaviour namespace)
  set(folder ${WORK}/${library})
  file(WRITE ${folder}/it.yaml "behaviour: ${behaviour}
language: 1
cpp: {namespace: ${namespace}}
roots: [${library}]
groups:
  ${library}: {module: bodies}
")
  file(WRITE ${folder}/use.cpp "#include \"${behaviour}.hpp\"
namespace {
struct Bodies final : ${namespace}::Bodies {
  director::Outcome provide(${namespace}::${library}::Default& run) override { return run.keep(); }
};
} // namespace
void play_${library}() {
  Bodies bodies;
  ${namespace}::Behaviour behaviour{bodies};
  (void)behaviour.request<${namespace}::${library}>();
  behaviour.step();
}
")
  execute_process(COMMAND ${DIRECTORC} generate ${folder}/it.yaml -o ${folder} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  foreach(source use ${behaviour})
    execute_process(COMMAND ${COMPILER} -std=c++20 -I${SOURCE} -I${folder} -c ${folder}/${source}.cpp -o ${folder}/${source}.o COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(REMOVE ${WORK}/lib${library}.a)
  execute_process(COMMAND ar rcs ${WORK}/lib${library}.a ${folder}/use.o ${folder}/${behaviour}.o COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(link_both)
  file(WRITE ${WORK}/main.cpp "void play_One();\nvoid play_Other();\nint main() {\n  play_One();\n  play_Other();\n}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${COMPILER} ${WORK}/main.cpp ${WORK}/libOne.a ${WORK}/libOther.a ${CORE} -o ${WORK}/both
                  RESULT_VARIABLE result ERROR_VARIABLE said)
  set(result ${result} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

build_library(One one robot)
foreach(name other one)
  build_library(Other ${name} robot)
  link_both()
  if(result EQUAL 0 OR NOT said MATCHES "multiple definition of [^\n]*robot::")
    message(FATAL_ERROR "behaviours one and ${name} of one namespace must not be linked; said: ${said}")
  endif()
endforeach()
build_library(Other other helper)
link_both()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "two behaviours of different namespaces must be linked:\n${said}")
endif()
execute_process(COMMAND ${WORK}/both COMMAND_ERROR_IS_FATAL ANY)
