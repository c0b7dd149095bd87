# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D CHROMIUM=<program> -D DIRECTORC=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P pages.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
begin(${FROM} pages)
file(GLOB scripts ${FROM}/*.mjs)
file(COPY ${scripts} DESTINATION ${into})
set(wide "behaviour: wide\nlanguage: 1\nroots:\n")
foreach(i RANGE 1 59)
  string(APPEND wide "  HaveALookAtThing${i}: {priority: ${i}}\n")
endforeach()
string(APPEND wide "  Play: {}\ngroups:\n  Head: {}\n  Play: {needs: [Head]}\n")
foreach(i RANGE 1 59)
  string(APPEND wide "  HaveALookAtThing${i}: {needs: [Head]}\n")
endforeach()
file(WRITE ${into}/wide.yaml "${wide}")
file(WRITE ${into}/exact.yaml "behaviour: exact\nlanguage: 1\nroots: [KickTo, Kick, kicks]\ngroups: {KickTo: {}, Kick: {}, kicks: {}}\n")
file(WRITE ${into}/alone.yaml "behaviour: alone\nlanguage: 1\nroots: [Only]\ngroups:\n  Only: {}\n")
file(WRITE ${into}/no_roots.yaml "behaviour: no_roots\nlanguage: 1\nroots: []\ngroups:\n  Only: {}\n")
file(WRITE ${into}/alike.yaml "behaviour: alike\nlanguage: 1\nroots: {Walkto: {priority: 10}, WalkTo: {priority: 30}, Sit: {priority: 20}}
groups: {Walkto: {needs: [Legs]}, WalkTo: {needs: [Legs]}, Sit: {needs: [Legs]}, Legs: {}}\n")
set(aside "behaviour: aside\nlanguage: 1\nroots: [Play]\ngroups:\n  Play: {tasks: [Thing1]}\n")
foreach(i RANGE 1 80)
  string(APPEND aside "  Thing${i}: {needs: [Part${i}]}\n  Part${i}: {}\n")
endforeach()
file(WRITE ${into}/aside.yaml "${aside}")
set(far "behaviour: far\nlanguage: 1\nroots: {Play: {priority: 2}, Guard: {priority: 1}}\ngroups:\n")
foreach(root Play Guard)
  string(APPEND far "  ${root}:\n    tasks:\n")
  foreach(i RANGE 1 40)
    string(APPEND far "      ${root}Thing${i}: {priority: ${i}}\n")
  endforeach()
  foreach(i RANGE 1 40)
    string(APPEND far "  ${root}Thing${i}: {}\n")
  endforeach()
endforeach()
file(WRITE ${into}/far.yaml "${far}")
set(flat "behaviour: flat\nlanguage: 1\nroots: [Play]\ngroups:\n  Play:\n    tasks:\n")
foreach(i RANGE 1 36)
  string(APPEND flat "      Leaf${i}: {priority: ${i}}\n")
endforeach()
foreach(i RANGE 1 36)
  string(APPEND flat "  Leaf${i}: {}\n")
endforeach()
file(WRITE ${into}/flat.yaml "${flat}")
string(REPEAT LookAtThisThing 5 name)
string(TOLOWER ${name} way)
file(WRITE ${into}/long_names.yaml "behaviour: long_${way}\nlanguage: 1
states: {${name}State: {values: [${way}, other], initial: other, external: true}}
roots: [${name}]
groups:
  ${name}: {providers: [{name: ${way}, when: [${name}State == ${way}], tasks: [${name}Below]}, {name: else_${way}, tasks: [${name}Below]}]}
  ${name}Below: {}\n")
file(WRITE ${into}/long_takes.yaml "behaviour: takes\nlanguage: 1\nroots: {${name}First: {priority: 20}, ${name}Second: {priority: 10}}
groups: {${name}First: {needs: [${name}Below]}, ${name}Second: {needs: [${name}Below]}, ${name}Below: {}}\n")
execute_process(COMMAND ${DIRECTORC} docs behaviours/soccer/soccer.yaml behaviours/robocup/robocup.yaml ${into}/wide.yaml ${into}/aside.yaml ${into}/flat.yaml ${into}/far.yaml ${into}/alone.yaml ${into}/no_roots.yaml ${into}/alike.yaml ${into}/exact.yaml ${into}/long_names.yaml ${into}/long_takes.yaml -o ${into}/out
                        "--link=https://git.example.org/{file}#L{line}"
                WORKING_DIRECTORY ${ROOT} COMMAND_ERROR_IS_FATAL ANY)
# An assertion of it is refuted, so this ends with 1.
execute_process(COMMAND ${DIRECTORC} docs tests/docs/explore/photo.yaml -o ${into}/out "--link=https://git.example.org/{file}#L{line}"
                WORKING_DIRECTORY ${ROOT} OUTPUT_QUIET ERROR_QUIET)
execute_process(COMMAND ${NODE} pages.mjs ${CHROMIUM} ${into}/out WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a page is not as it should be; pictures of the situations that failed are in ${into}/out")
endif()
