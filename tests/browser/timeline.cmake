# SPDX-License-Identifier: MIT
# cmake -D NODE=<program> -D NPM=<program> -D CHROMIUM=<program> -D DIRECTORC=<program> -D SOCCER=<program> -D FROM=<this folder> -D ROOT=<the project> -D WORK=<folder> -P timeline.cmake
# Writes twelve recordings as pages and tests them in a browser (timeline.mjs): a minute of soccer, the same with missing events and without its beginning, the rover, two tasks
# that are blocked, a request for a task that runs for another, a task with many others below it, a task with a long name that waits for another one
# with a long name, tasks with names of one letter, a task that chooses between packs, two that wait beside one that runs, and a robot in a warehouse.
include(${CMAKE_CURRENT_LIST_DIR}/../support/npm_packages.cmake)
begin(${FROM} timeline)
file(GLOB scripts ${FROM}/*.mjs)
file(COPY ${scripts} DESTINATION ${into})
execute_process(COMMAND ${SOCCER} --trace ${into}/minute.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${DIRECTORC} simulate tests/docs/rover/rover.scenario.yaml --trace ${into}/rover.jsonl
                WORKING_DIRECTORY ${ROOT} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/blocked.yaml "behaviour: blocked
language: 1
roots: {GetUp: {priority: 20}, Walk: {priority: 10}, Legs: {priority: 5}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs]}, Legs: {}}
")
file(WRITE ${into}/blocked.scenario.yaml "scenario: two wait for who gets up
behaviour: blocked.yaml
script:
  GetUp: [{wait: 2 s}]
steps:
  - inputs: [{request: GetUp}, {request: Walk}, {request: Legs}]
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/blocked.scenario.yaml --trace ${into}/blocked.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/eyes.yaml "behaviour: eyes
language: 1
roots: {Boss: {priority: 10}, Guard: {priority: 50}}
groups: {Boss: {tasks: [Look]}, Guard: {tasks: [Look]}, Look: {}}
")
file(WRITE ${into}/eyes.scenario.yaml "scenario: the guard takes what the boss requests too
behaviour: eyes.yaml
steps:
  - inputs: [{request: Boss}]
  - advance: 1 s
  - inputs: [{request: Guard}]
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/eyes.scenario.yaml --trace ${into}/eyes.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(tall "behaviour: tall\nlanguage: 1\nroots: [Play]\ngroups:\n")
set(leaves "")
foreach(i RANGE 1 44)
  string(APPEND tall "  Leaf${i}: {}\n")
  list(APPEND leaves Leaf${i})
endforeach()
list(JOIN leaves ", " leaves)
file(WRITE ${into}/tall.yaml "${tall}  Play: {tasks: [${leaves}]}\n")
file(WRITE ${into}/tall.scenario.yaml "scenario: all run
behaviour: tall.yaml
steps:
  - request: Play
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/tall.scenario.yaml --trace ${into}/tall.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/letters.yaml "behaviour: letters
language: 1
roots: [A]
groups: {A: {tasks: [B, C, D]}, B: {}, C: {tasks: [E]}, D: {}, E: {}}
")
file(WRITE ${into}/letters.scenario.yaml "scenario: all run
behaviour: letters.yaml
steps:
  - request: A
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/letters.scenario.yaml --trace ${into}/letters.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/wide.yaml "behaviour: wide
language: 1
roots: {TheOtherTaskThatHoldsAllOfTheSharedThing: {priority: 20}, WalkWithAllTheLegsThatThereAreInTheRobot: {priority: 10}}
groups:
  TheOtherTaskThatHoldsAllOfTheSharedThing: {needs: [SharedThingWithAnEvenLongerNameThanTheOthers]}
  WalkWithAllTheLegsThatThereAreInTheRobot: {needs: [SharedThingWithAnEvenLongerNameThanTheOthers], tasks: [LegsWithAllTheJointsThatThereAre]}
  LegsWithAllTheJointsThatThereAre: {}
  SharedThingWithAnEvenLongerNameThanTheOthers: {}
")
file(WRITE ${into}/wide.scenario.yaml "scenario: one waits for the other
behaviour: wide.yaml
steps:
  - request: TheOtherTaskThatHoldsAllOfTheSharedThing
  - request: WalkWithAllTheLegsThatThereAreInTheRobot
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/wide.scenario.yaml --trace ${into}/wide.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/fold.yaml "behaviour: fold
language: 1
states: {S: {values: [a, b], initial: a, external: true}}
roots: {Run: {priority: 1}, Wait: {priority: 2}, Other: {priority: 3}, Late: {priority: 4}}
groups:
  Run: {}
  Wait: {when: [S == b]}
  Other: {when: [S == b]}
  Late: {}
  Idle: {module: rest}
")
file(WRITE ${into}/fold.scenario.yaml "scenario: two wait
behaviour: fold.yaml
steps:
  - request: [Run, Wait, Other]
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/fold.scenario.yaml --trace ${into}/fold.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/packs.yaml "behaviour: packs
language: 1
roots: {Plan: {priority: 1}, Guard: {priority: 5}}
groups:
  Plan:
    packs:
      go: {Walk: {priority: 20}, Look: {priority: 5}}
      stroll: {Walk: {priority: 1, optional: true}}
      alike: {Walk: {priority: 1, optional: true}, Look: {}}
  Guard: {needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Look: {}
  Legs: {}
")
file(WRITE ${into}/packs.scenario.yaml "scenario: it strolls until the guard takes the legs
behaviour: packs.yaml
script: {Plan: {pack: stroll}}
steps:
  - request: Plan
  - advance: 1 s
  - request: Guard
  - advance: 1 s
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/packs.scenario.yaml --trace ${into}/packs.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${DIRECTORC} simulate behaviours/warehouse/scenarios/a_low_battery.scenario.yaml --trace ${into}/warehouse.jsonl
                WORKING_DIRECTORY ${ROOT} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${into}/broken.yaml "behaviour: broken
language: 1
states: {Arm: {values: [up, down], initial: up}}
roots: {ControlHydraulicValveBlockOfLeftArm: {priority: 1}, ControlHydraulicValveBlockOfRightArm: {priority: 5}}
groups:
  ControlHydraulicValveBlockOfLeftArm:
    providers:
      - {name: lifting, sets: [Arm == up]}
      - {name: folding, causing: [Arm == down within 1 s]}
  ControlHydraulicValveBlockOfRightArm: {when: [Arm == down]}
")
file(WRITE ${into}/broken.scenario.yaml "scenario: the arm does not fold
behaviour: broken.yaml
steps:
  - request: ControlHydraulicValveBlockOfLeftArm
  - request: ControlHydraulicValveBlockOfRightArm
  - advance: 2 s
  - cancel: ControlHydraulicValveBlockOfRightArm
")
execute_process(COMMAND ${DIRECTORC} simulate ${into}/broken.scenario.yaml --trace ${into}/broken.jsonl OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NODE} gap.mjs minute.jsonl gap.jsonl late.jsonl WORKING_DIRECTORY ${into} COMMAND_ERROR_IS_FATAL ANY)
foreach(page minute:behaviours/soccer/soccer.yaml gap:behaviours/soccer/soccer.yaml late:behaviours/soccer/soccer.yaml rover:tests/docs/rover/rover.yaml
             blocked:${into}/blocked.yaml eyes:${into}/eyes.yaml tall:${into}/tall.yaml letters:${into}/letters.yaml packs:${into}/packs.yaml fold:${into}/fold.yaml wide:${into}/wide.yaml broken:${into}/broken.yaml warehouse:behaviours/warehouse/warehouse.yaml)
  string(REPLACE ":" ";" page ${page})
  list(POP_FRONT page name)
  execute_process(COMMAND ${DIRECTORC} trace ${into}/${name}.jsonl --to=html --behaviour ${page} -o ${into}/out/${name}.html "--link=https://git.example.org/{file}#L{line}"
                  WORKING_DIRECTORY ${ROOT} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${NODE} timeline.mjs ${CHROMIUM} ${into}/out WORKING_DIRECTORY ${into} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a timeline is not as it should be; pictures of the situations that failed are in ${into}/out")
endif()
