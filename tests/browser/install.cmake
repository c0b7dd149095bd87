# SPDX-License-Identifier: MIT
# install_packages(<folder with package.json> <folder to install in>): the pinned npm packages. Sets `installed`.
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

# begin(<folder with package.json> <name>): sets `into`, a folder of WORK with these packages and a folder `out`. Ends the script where npm cannot install.
macro(begin from name)
  set(into ${WORK}/${name})
  file(MAKE_DIRECTORY ${into}/out)
  install_packages(${from} ${into})
  if(NOT installed)
    return()
  endif()
endmacro()
