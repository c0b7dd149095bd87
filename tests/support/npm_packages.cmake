# SPDX-License-Identifier: MIT
# For scripts with -D NPM=<program> -D WORK=<folder>.
#
# install_packages(<folder with package.json> <folder to install in>): installs the npm packages in the pinned versions. Sets `installed` to YES or NO.
function(install_packages from into)
  foreach(file package.json package-lock.json .npmrc)
    file(COPY_FILE ${from}/${file} ${into}/${file} ONLY_IF_DIFFERENT)
  endforeach()
  set(installed YES PARENT_SCOPE)
  if(NOT EXISTS ${into}/node_modules OR ${from}/package-lock.json IS_NEWER_THAN ${into}/installed)
    execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error --fetch-retries=1 WORKING_DIRECTORY ${into}
                    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(failed)
      message("skipped: npm cannot install what the test needs:\n${said}")
      set(installed NO PARENT_SCOPE)
      return()
    endif()
    file(TOUCH ${into}/installed)
  endif()
endfunction()

# begin(<folder with package.json> <name>): sets `into` to the folder WORK/<name>, which then has these packages and a folder `out`. Ends the calling
# script if npm cannot install the packages. Tests with the same packages share one installation, because npm takes longer than some of the tests.
macro(begin from name)
  set(into ${WORK}/${name})
  file(MAKE_DIRECTORY ${into}/out)
  get_filename_component(packages ${from} NAME)
  set(packages ${WORK}/packages_of_${packages})
  file(MAKE_DIRECTORY ${packages})
  file(LOCK ${packages}/lock)
  install_packages(${from} ${packages})
  file(LOCK ${packages}/lock RELEASE)
  if(NOT installed)
    return()
  endif()
  if(NOT IS_SYMLINK ${into}/node_modules)
    file(REMOVE_RECURSE ${into}/node_modules)
  endif()
  file(CREATE_LINK ${packages}/node_modules ${into}/node_modules SYMBOLIC)
endmacro()
